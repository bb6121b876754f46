"""Friction by analysis: powers lost, efficiency, wear and jams from the reactions and rates of this road alone (M6).

Nothing is read off rays and arms: where a pair jams is found by the reactions of a massless machine to a unit load
that resists its link. All forces are those of the machine without friction, the first order of the theory.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from plans.analytic.closure import EPS
from plans.analytic.kinematics import Analysis
from plans.analytic.kinetostatics import kinetostatics
from plans.analytic.points import TURN, place, speed
from plans.analytic.power import reduced_moment, transfers
from plans.model.dyad import Pair
from plans.model.kinetostatics import (
    CENTRAL,
    SLANTED,
    TILTED,
    Applied,
    Friction,
    Jam,
    Kinetostatics,
    Loading,
    Reaction,
    Twist,
)
from plans.model.machine import Machine, Rubbing, Transmission
from plans.model.mechanism import FRAME
from plans.model.motion import Floats, Motion

ANGLES = 6.0 * EPS  # an angle of a turn is divided, started from and told in radians; two of them make a step


class Driven(NamedTuple):
    """A pair with the frame whose link a group moves, and the pair within the group by which it does so."""

    outer: Pair
    inner: Pair


@np.errstate(divide="ignore", invalid="ignore")  # a gap is NaN; where nothing is used or lost there is no efficiency
def friction(
    road: Analysis, machine: Machine, motion: Motion, loading: Loading, statics: Kinetostatics, pairs: tuple[Pair, ...]
) -> Friction:
    """Find what friction takes from a machine over a motion of order 2, with the reactions of the same road."""
    rubs = [pair for key in machine.friction for pair in pairs if pair.key == key]
    first = transfers(road.constraints, road.poses(motion))
    rates = {pair.key: _rate(road, motion, first, pair) for pair in rubs}
    none = np.where(np.isfinite(statics.balancing.moment), 0.0, np.nan)  # NaN at gaps
    powers = {
        pair.key: _lost(machine.friction[pair.key], statics.reactions[pair.key], rates[pair.key]) + none
        for pair in rubs
    }
    useful, lost = _useful(road, motion, loading, first) + none, np.sum([*powers.values(), none], axis=0)
    times = road.rates(motion.phi).times
    driven = (link for link in _driven(pairs) if link.outer in rubs)
    locks = {link.outer.key: _Lock(road, motion, statics, pairs, link) for link in driven}
    jams = [jam for key, lock in locks.items() for jam in lock.jams(machine.friction[key], rates[key])]
    return Friction(
        by="analysis",
        phi=motion.phi,
        powers=powers,
        useful=useful,
        lost=lost,
        efficiency=useful / (useful + lost) if loading.served else none * np.nan,
        cycle=_cycle(motion.phi, times * useful, times * lost) if loading.served else None,
        wear=_wear({key: times * power for key, power in powers.items()}),
        locking={key: lock.ratio(machine.friction[key]) for key, lock in locks.items()},
        driving={key: lock.power(machine.friction[key], rates[key]) for key, lock in locks.items()},
        jams=tuple(sorted(jams, key=lambda jam: jam.position)),
    )


def _rate(road: Analysis, motion: Motion, first: Floats, pair: Pair) -> Floats:
    """Give how fast the taker of a pair moves over the giver: rad/s, or of a slide m/s along its line, (N,)."""
    constraints, rates = road.constraints, road.rates(motion.phi).against(2).omega * first
    spins = [rates[:, constraints.numbers.index(link), TURN] for link in (pair.taker, pair.giver)]
    if isinstance(pair.joint, str):
        return spins[0] - spins[1]
    k, poses = road.mechanism.slides.index(pair.joint), road.poses(motion)
    feet = constraints.size * constraints.points[:, constraints.hinges + k]
    links = pair.joint.slider, pair.joint.owner
    spots = zip(links, feet, strict=True)
    slider, owner = (speed(constraints, poses, rates, link, complex(foot)) for link, foot in spots)
    # Both feet lie on the common line: that it turns moves neither along it.
    slip = (constraints.place(poses).ways[:, 1, k].conj() * (slider - owner)).real
    return slip if pair.taker == pair.joint.slider else -slip


def _lost(rubs: Rubbing, reaction: Reaction, rate: Floats) -> Floats:
    """Give the power W lost in a pair: its moment or force of friction times its rate, (N,)."""
    return np.asarray(rubs.coefficient * _pressed(rubs, reaction) * np.abs(rate))


def _pressed(rubs: Rubbing, reaction: Reaction) -> Floats:
    """Give what the coefficient of friction multiplies: N of a slide, N*m of a journal, (N,).

    Two edges `length` apart that bear a force and a moment press with the larger of the force and of twice the moment
    over the length.
    """
    pressure = np.abs(reaction.force)
    if reaction.moment is None:
        return rubs.radius * pressure
    return np.fmax(pressure, 2.0 * np.abs(reaction.moment) / rubs.length) if rubs.length else pressure


def _useful(road: Analysis, motion: Motion, loading: Loading, first: Floats) -> Floats:
    """Give the power W that the useful loads take together, by their moment on the crank, (N,)."""
    forces = tuple(load for load in loading.forces if load.useful)
    moments = tuple(twist for twist in loading.moments if twist.useful)
    given = road.rates(motion.phi).omega * reduced_moment(road, motion, Loading(forces, moments), first)
    return np.where(given < 0, -given, 0.0)


def _cycle(phi: Floats, useful: Floats, lost: Floats) -> float | None:
    """Give the efficiency of a whole turn of even positions, where something is used or lost in it."""
    count = len(phi)
    if count < 2 or not np.isfinite(useful + lost).all():
        return None
    even = np.copysign(2.0 * np.pi / count, phi[1] - phi[0]) * np.arange(count)
    if np.abs(phi - phi[0] - even).max() > ANGLES * (np.abs(phi).max() + 2.0 * np.pi):
        return None
    mean, wasted = float(useful.mean()), float(lost.mean())
    return mean / (mean + wasted) if mean + wasted > 0 else None


def _wear(powers: Mapping[str, Floats]) -> dict[str, float]:
    """Share the work of friction out to the pairs, the most worn first; nothing where there is none."""
    works = {key: float(np.nansum(power)) for key, power in powers.items()}
    whole = sum(works.values())
    return {key: works[key] / whole for key in sorted(works, key=lambda key: -works[key])} if whole > 0 else {}


def _driven(pairs: Sequence[Pair]) -> Iterator[Driven]:
    """Find the links that a group moves over the frame; after the crank's pair each group has its two outer, its inner.

    A group whose other two pairs slide brings a couple alone, which presses nothing.
    """
    for first, second, inner in zip(pairs[1::3], pairs[2::3], pairs[3::3], strict=True):
        if (first.giver == FRAME) != (second.giver == FRAME):
            outer, driving = (first, second) if first.giver == FRAME else (second, first)
            if isinstance(driving.joint, str) or isinstance(inner.joint, str):
                yield Driven(outer, inner)


class _Lock:
    """Whether friction holds a driven link: its reactions, and those of a massless machine that it alone resists."""

    def __init__(
        self, road: Analysis, motion: Motion, statics: Kinetostatics, pairs: tuple[Pair, ...], driven: Driven
    ) -> None:
        self.outer, self.inner = statics.reactions[driven.outer.key], statics.reactions[driven.inner.key]
        self.phi, self.link = motion.phi, driven.outer.taker
        bare = Machine({}, 0j, (), (), (), Transmission(), {})
        resisting = self._resistance(road, motion)
        self.unit = kinetostatics(road, bare, motion, resisting, pairs).reactions[driven.outer.key]

    def _resistance(self, road: Analysis, motion: Motion) -> Loading:
        """Resist the link by 1 N along its guide at the point of its slide, or by 1 N*m."""
        if self.outer.along is None:
            return Loading((), (Twist("", self.link, -np.ones_like(self.phi)),))
        force = -self.outer.along
        origin = place(road.constraints, road.poses(motion), self.link, 0j)
        turning = ((self.outer.r - origin).conj() * force).imag
        return Loading((Applied("", self.link, "", 0j, force),), (Twist("", self.link, turning),))

    @property
    def brought(self) -> Floats:
        """What the inner reaction drives the link with: N along its guide, or N*m about its hinge, (N,)."""
        force, moment = self.inner.force, 0.0 if self.inner.moment is None else self.inner.moment
        if self.outer.along is None:
            driving = ((self.inner.r - self.outer.r).conj() * force).imag + moment
        else:
            driving = (self.outer.along.conj() * force).real
        return driving if self.inner.taker == self.link else -driving

    def ratio(self, rubs: Rubbing) -> Floats:
        """Give the friction that a unit of driving causes in the pair; 1 and more jams, (N,)."""
        return np.asarray(rubs.coefficient * _pressed(rubs, self.unit))

    def power(self, rubs: Rubbing, rate: Floats) -> Floats:
        """Give the power W that drives the link, with that lost in its pair by all that does not answer it, (N,)."""
        moment = None if self.unit.moment is None else self._rest(self.outer.moment, self.unit.moment)
        rest = self.outer._replace(force=self._rest(self.outer.force, self.unit.force), moment=moment)
        return self.brought * rate + _lost(rubs, rest, rate)

    def _rest(self, whole: Any, unit: Any) -> Any:
        return whole - self.brought * unit

    def jams(self, rubs: Rubbing, rate: Floats) -> Iterator[Jam]:
        """Name the positions in which the link is driven, and friction takes all of it."""
        key, ratio = f"{self.outer.giver}-{self.outer.taker}", self.ratio(rubs)
        steep = rubs.coefficient * np.abs(self.unit.force) >= 1
        for k in np.flatnonzero((ratio >= 1) & (self.power(rubs, rate) > 0)).tolist():
            advice = CENTRAL if self.outer.along is None else SLANTED if steep[k] else TILTED
            yield Jam(key, k, float(self.phi[k]), float(ratio[k]), advice)
