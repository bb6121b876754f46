"""Friction by construction: what rubs, what locks itself, powers lost, efficiency, wear, jams (chapter 7)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.meet import cross, dot
from plans.forces.loading import carried
from plans.model.dyad import Assur, pair
from plans.model.kinetostatics import CENTRAL, SLANTED, TILTED, Friction, Jam, Kinetostatics, Loading, Reaction
from plans.model.machine import Machine, Rubbing
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Complexes, Floats, Motion
from plans.words.words import Message


def rate(mechanism: Mechanism, motion: Motion, reaction: Reaction) -> Floats:
    """Give how fast the taker moves over the giver: rad/s in a hinge, m/s along the line of a slide (относительная)."""
    giver, taker = reaction.giver, reaction.taker
    if reaction.along is None:
        return _omega(motion, taker) - _omega(motion, giver)
    slip = _velocity(mechanism, motion, taker, reaction.r) - _velocity(mechanism, motion, giver, reaction.r)
    return np.asarray(dot(reaction.along, slip))


def lost_power(rubbing: Rubbing, reaction: Reaction, rate: Floats) -> Floats:
    """Give the power W lost in a pair: f |R| r |omega| in a hinge, f (sum of normal reactions) |v| in a slide."""
    if reaction.along is None:
        return np.asarray(rubbing.coefficient * rubbing.radius * np.abs(reaction.force) * np.abs(rate))
    across = np.asarray(cross(reaction.along, reaction.force))
    moment = np.zeros_like(across) if reaction.moment is None else reaction.moment
    return rubbing.coefficient * pressing(across, moment, rubbing.length) * np.abs(rate)


def edges(across: Floats, moment: Floats, length: float) -> tuple[Floats, Floats]:
    """Share a slide's reaction N and its moment N*m about the middle out to the two edges of the contact (figure 7.3).

    With the line of action x = moment/across from the middle they are P(1/2 + x/a) and P(1/2 - x/a): on one side while
    it stays within the contact, on opposite sides beyond. Without a length the contact is as long as it has to be, and
    bears a couple, too, without pressing.

    >>> [float(edge) for edge in edges(np.float64(800), np.float64(800 * 0.09), 0.12)]
    [1000.0, -200.0]
    """
    couple = moment / length if length else np.zeros_like(moment)
    return across / 2 + couple, across / 2 - couple


def pressing(across: Floats, moment: Floats, length: float) -> Floats:
    """Give the sum N of the normal reactions of a slide: |P|, or of two edges on opposite sides 2 |P| |x|/a."""
    near, far = edges(across, moment, length)
    return np.asarray(np.abs(near) + np.abs(far))


def useful_power(mechanism: Mechanism, motion: Motion, loading: Loading) -> Floats:
    """Give the power W that the useful loads take; 0 where together they drive, or do no work (холостой ход)."""
    given = np.zeros(len(motion.phi))
    for load in loading.forces:
        if load.useful and load.link != FRAME:
            given += dot(load.force, carried(mechanism, motion, load.link, load.at).v)
    for twist in loading.moments:
        if twist.useful:
            given += twist.moment * _omega(motion, twist.link)
    return np.maximum(0.0, -given)


def _velocity(mechanism: Mechanism, motion: Motion, link: int, r: Complexes) -> Complexes:
    """Give the velocity m/s of that point of a link which is at r."""
    point = motion.points[next(iter(mechanism.links[link].points))]
    return np.asarray(point.v + 1j * _omega(motion, link) * (r - point.r))


def _omega(motion: Motion, link: int) -> Floats:
    if link == FRAME:
        return np.zeros(len(motion.phi))
    return motion.links[link].omega


class DrivenLink(NamedTuple):
    """A link that a group drives over the frame: the reaction of its pair there, that of the inner pair, and the ray.

    The ray goes through `through` in the direction of `ray`, a vector of any length.
    """

    outer: Reaction
    inner: Reaction
    through: Complexes
    ray: Complexes

    @property
    def effect(self) -> Floats:
        """What a force equal to `ray` drives with: its part along the guide, or its moment about the hinge."""
        if self.outer.along is None:
            return np.asarray(cross(self.through - self.outer.r, self.ray))
        return np.asarray(dot(self.outer.along, self.ray))

    @property
    def brought(self) -> Floats:
        """What the inner reaction drives with: N along the guide, or N*m about the hinge."""
        sign = 1.0 if self.inner.taker == self.outer.taker else -1.0
        if self.outer.along is not None:
            return np.asarray(sign * dot(self.outer.along, self.inner.force))
        turning = cross(self.inner.r - self.outer.r, self.inner.force)
        return np.asarray(sign * (turning if self.inner.moment is None else turning + self.inner.moment))

    @property
    def rest(self) -> Reaction:
        """The reaction of the driven pair without what answers the force along the ray."""
        grown = self.brought / self.effect
        moment = self.outer.moment
        if moment is not None:
            moment = moment + grown * cross(self.through - self.outer.r, self.ray)
        return self.outer._replace(force=self.outer.force + grown * self.ray, moment=moment)

    def ratio(self, rubbing: Rubbing) -> Floats:
        """Give the friction that a force along the ray causes, over what it drives with; 1 and more jams."""
        if self.outer.along is None:
            caused = rubbing.radius * np.abs(self.ray)
        else:
            moment = np.asarray(cross(self.through - self.outer.r, self.ray))
            caused = pressing(np.asarray(cross(self.outer.along, self.ray)), moment, rubbing.length)
        return np.asarray(rubbing.coefficient * caused / np.abs(self.effect))

    def power(self, rubbing: Rubbing, rate: Floats) -> Floats:
        """Give the power W that the group brings to the link, and that friction would take without it.

        Where it is above zero the group moves the link; elsewhere the link stands, or drives the group.
        """
        return np.asarray(self.brought * rate + lost_power(rubbing, self.rest, rate))

    def advice(self, rubbing: Rubbing, position: int) -> Message:
        """Say what would free the pair."""
        if self.outer.along is None:
            return CENTRAL
        ray = complex(self.ray[position] / self.outer.along[position])
        return SLANTED if rubbing.coefficient * abs(ray.imag) >= abs(ray.real) else TILTED


def drives(groups: Sequence[Assur], reactions: Mapping[str, Reaction]) -> Iterator[tuple[str, DrivenLink]]:
    """Find the pairs of the frame whose links are driven by a group that hangs on a moving link."""
    for group in groups:
        outer = group.outer_pairs
        fixed, moving = ([bond for bond in outer if (bond.giver == FRAME) == still] for still in (True, False))
        if not len(fixed) == len(moving) == len(group.inner_pairs) == 1:
            continue
        driven, driving, inner = (reactions[pair(*bond).key] for bond in (*fixed, *moving, *group.inner_pairs))
        if driving.along is not None and inner.along is not None:
            continue  # two slides bring a couple alone, which presses nothing
        found = f"{driven.giver}-{driven.taker}"
        if inner.along is not None:
            yield found, DrivenLink(driven, inner, driving.r, 1j * inner.along)
        else:
            ray = inner.r - driving.r if driving.along is None else 1j * driving.along
            yield found, DrivenLink(driven, inner, inner.r, ray)


def jams_of(driven: DrivenLink, rubbing: Rubbing, rate: Floats, phi: Floats) -> list[Jam]:
    """Find the positions in which a driven link jams; `rate` is its own over the frame."""
    key, ratio = f"{driven.outer.giver}-{driven.outer.taker}", driven.ratio(rubbing)
    jammed = np.flatnonzero((driven.power(rubbing, rate) > 0) & (ratio >= 1)).tolist()
    return [Jam(key, k, float(phi[k]), float(ratio[k]), driven.advice(rubbing, k)) for k in jammed]


EPS = float(np.finfo(float).eps)
# Two angles of a turn, each rounded once where it was divided, once where it was started and once as radians.
ROUNDINGS = 6


@np.errstate(divide="ignore", invalid="ignore")  # a gap is NaN inside; a ray without effect is a dead centre
def friction(
    mechanism: Mechanism,
    groups: Sequence[Assur],
    machine: Machine,
    motion: Motion,
    loading: Loading,
    statics: Kinetostatics,
    times: Floats | float = 1.0,
) -> Friction:
    """Find what friction takes from a machine: `motion` and `statics` are of one road, at the same positions (M6).

    `times` are what the positions take of even ones over a turn, in one measure.
    """
    # A hinge of several links has more pairs than those on which the groups hang, and whose reactions are told.
    pairs = {key: rubbing for key, rubbing in machine.friction.items() if key in statics.reactions}
    rates = {key: rate(mechanism, motion, statics.reactions[key]) for key in pairs}
    gone = ~np.isfinite(statics.balancing.moment)
    powers = {k: np.where(gone, np.nan, lost_power(rubs, statics.reactions[k], rates[k])) for k, rubs in pairs.items()}
    useful = np.where(gone, np.nan, useful_power(mechanism, motion, loading))
    lost = np.asarray(sum(powers.values(), np.where(np.isnan(useful), np.nan, 0.0)))
    driven = {key: drive for key, drive in drives(groups, statics.reactions) if key in pairs}
    jams = [jam for key, drive in driven.items() for jam in jams_of(drive, pairs[key], rates[key], motion.phi)]
    return Friction(
        by=statics.by,
        phi=motion.phi,
        powers=powers,
        useful=useful,
        lost=lost,
        efficiency=useful / (useful + lost) if loading.served else np.full(len(lost), np.nan),
        cycle=_cycle(motion.phi, times * useful, times * lost) if loading.served else None,
        wear=_wear({key: times * power for key, power in powers.items()}, times * lost),
        locking={key: drive.ratio(pairs[key]) for key, drive in driven.items()},
        driving={key: drive.power(pairs[key], rates[key]) for key, drive in driven.items()},
        jams=tuple(sorted(jams, key=lambda jam: jam.position)),
    )


def whole(phi: Floats, known: npt.NDArray[np.bool_]) -> bool:
    """Tell whether positions divide a full turn evenly and none is a gap."""
    if len(phi) < 2 or not known.all():
        return False
    steps = np.diff(phi)
    off = np.abs(steps - np.copysign(2 * np.pi / len(phi), steps[0])).max()
    return bool(off <= ROUNDINGS * EPS * (np.abs(phi).max() + 2 * np.pi))


def _cycle(phi: Floats, useful: Floats, lost: Floats) -> float | None:
    used, all_power = float(useful.sum()), float((useful + lost).sum())
    return used / all_power if whole(phi, np.isfinite(useful + lost)) and all_power > 0 else None


def _wear(powers: Mapping[str, Floats], lost: Floats) -> dict[str, float]:
    known = np.isfinite(lost)
    total = float(lost[known].sum())
    parts = {key: float(power[known].sum()) / total for key, power in powers.items()} if total > 0 else {}
    return dict(sorted(parts.items(), key=lambda part: -part[1]))
