"""Angles at which the reduced moment jumps or bends, by roots (изломы нагрузки).

Ends of strokes; places of a stroke at which a load sets in, rests or changes its law; reversals of a point or a link
against whose motion a load acts.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, Protocol

import numpy as np

from plans.analytic.closure import EPS, Flags
from plans.analytic.dynamics.reduction import ExactReduction, pieces
from plans.model.dynamics import TURN
from plans.model.machine import ALWAYS, BACKWARD, FORWARD, WORKING, Force, Machine, Track
from plans.model.motion import Complexes, Floats, Motion

ROUNDINGS = 4.0  # of the largest ordinate: what summing harmonics leaves
LOOKS = 4  # places to a harmonic, among which no zero of the sum lies hidden


@dataclass(frozen=True)
class Wave:
    """Mean and harmonics (m,) of a quantity; `error` is the share of the largest that the highest of them still has."""

    mean: float
    harmonics: Complexes
    error: float

    @property
    def looks(self) -> Floats:
        """Angles rad among which every change of sign shows."""
        return np.linspace(0.0, TURN, max(LOOKS * len(self.harmonics), 16) + 1)

    def at(self, turned: Floats, _side: int = 1) -> Floats:
        """Give the quantity at angles turned rad, (N,); both sides are alike."""
        return self.mean + _sum(self.harmonics, turned)

    @property
    def slope(self) -> Wave:
        """Its derivative by the angle turned."""
        return Wave(0.0, 1j * np.arange(1, len(self.harmonics) + 1) * self.harmonics, self.error)

    @cached_property
    def value(self) -> Callable[[float], float]:
        """The quantity at one angle turned rad: for a solver that asks for one at a time (Horner's rule in e^(i q))."""
        mean, harmonics = self.mean, self.harmonics[::-1].tolist()

        def at_angle(turned: float) -> float:
            step, total = complex(math.cos(turned), math.sin(turned)), 0j
            for harmonic in harmonics:
                total = (total + harmonic) * step
            return mean + 2.0 * total.real

        return at_angle

    def since(self, turned: Floats) -> Floats:
        """Give its integral from 0."""
        waves = self.harmonics / (1j * np.arange(1, len(self.harmonics) + 1))
        return self.mean * turned + _sum(waves, turned) - 2.0 * float(waves.real.sum())


def wave(ordinates: Floats, size: float) -> Wave:
    """Find the harmonics of even ordinates over a turn, (N,), the first at 0; `size`: largest of what they sum up."""
    count = len(ordinates)
    if not np.isfinite(ordinates).all():
        return Wave(np.nan, np.zeros(0, complex), np.inf)
    found = np.fft.rfft(ordinates) / count
    inner = found[1 : (count + 1) // 2]
    error = float(np.abs(inner[-(count // 6) :]).max()) / size if size else 0.0
    heard = np.flatnonzero(np.abs(inner) > EPS * size / ROUNDINGS)
    return Wave(float(found[0].real), inner[: heard[-1] + 1 if heard.size else 0], error)


def _sum(harmonics: Complexes, turned: Floats) -> Floats:
    """Add harmonics 1, 2, ... at angles turned (Horner's rule in e^(i q))."""
    step, total = np.exp(1j * np.asarray(turned)), np.zeros(np.shape(turned), complex)
    for harmonic in harmonics[::-1]:
        total += harmonic
        total *= step
    return np.asarray(2.0 * total.real)


# A motion of N positions to several quantities there, (k, N), and to the largest of what each of them sums up, (k,).
Sample = Callable[[Motion], tuple[Floats, Floats]]

LEAST, MOST = 36, 1152  # ordinates of a turn


class TurnQuantity(Protocol):
    """A quantity that can be asked for at any angle turned, and for its integral from 0."""

    @property
    def looks(self) -> Floats:
        """Angles rad among which every change of sign shows."""

    @property
    def error(self) -> float:
        """Share of the largest by which it may be off."""

    @property
    def value(self) -> Callable[[float], float]:
        """The quantity at one angle turned rad, of any turn: for a solver that asks for one at a time."""

    def at(self, turned: Floats, side: int = 1, /) -> Floats:
        """Give it at angles turned rad, (N,): at a jump as it is beyond, or before it if side < 0."""

    @property
    def slope(self) -> TurnQuantity:
        """Its derivative by the angle turned."""

    def since(self, turned: Floats) -> Floats:
        """Give its integral from 0."""


def smooth(reduction: ExactReduction, sample: Sample, noise: float) -> list[TurnQuantity]:
    """Fit smooth quantities by harmonics, twice as many ordinates as long as the last of these are heard.

    Where they do not die away, because the quantities change too fast somewhere, they are fitted on pieces.
    """
    count = LEAST
    while count <= MOST:
        rows, sizes = sample(reduction.even(count))
        found = [wave(row, float(size)) for row, size in zip(rows, sizes, strict=True)]
        worst = max((curve.error for curve in found), default=0.0)
        if worst <= ROUNDINGS * EPS or (count == MOST and worst <= noise):
            return list(found)
        if not np.isfinite(worst):
            break
        count *= 2
    return broken(reduction, sample, np.zeros(0), noise)


def broken(reduction: ExactReduction, sample: Sample, breaks: Floats, noise: float) -> list[TurnQuantity]:
    """Fit quantities that jump or bend at `breaks`, rad."""
    knots = np.unique(np.concatenate(([0.0], breaks, [TURN])))
    return list(pieces(lambda turned: sample(reduction.motion(turned)), knots, noise))


def looks(curves: Sequence[TurnQuantity], *more: float) -> Floats:
    """Give the angles among which every change of sign of a combination of curves shows."""
    return np.unique(np.concatenate([np.array((0.0, *more, TURN)), *(curve.looks for curve in curves)]))


HALVINGS = 54  # of a stretch of the turn: its last place

Sided = Callable[[Floats, int], Floats]  # angles turned (N,), and a side of them, to the quantity


def roots(quantity: Sided, looks: Floats) -> Floats:
    """Give the angles rad at which a quantity changes its sign within stretches between looks, where it is smooth."""
    low, high = looks[:-1], looks[1:]
    rising = quantity(high, -1) >= 0.0
    changes = (quantity(low, 1) >= 0.0) != rising
    low, high, rising = low[changes], high[changes], rising[changes]
    for _ in range(HALVINGS if low.size else 0):
        middle = (low + high) / 2.0
        beyond = (quantity(middle, 1) >= 0.0) == rising
        low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
    return np.asarray((low + high) / 2.0)


class StrokeRun(Protocol):
    """A stroke: crank angles rad at which it begins and ends, and the share of it that is gone (ход)."""

    @property
    def begin(self) -> float:
        """Crank where the working stroke begins."""

    @property
    def end(self) -> float:
        """Crank where it ends."""

    def working(self, phi: Floats, /) -> Flags:
        """Tell the crank angles of the working stroke."""

    def share(self, motion: Motion, /) -> Floats:
        """Give the share of the stroke that is gone at the positions of a motion."""


def breaks(reduction: ExactReduction, strokes: Mapping[Track, StrokeRun], noise: float) -> Floats:
    """Give the angles turned, rad in [0, 2 pi), at which the moment of the loads jumps or bends, rising.

    Angles that differ by less than the rounding of a root, `noise` of a turn, are one.
    """
    ends = [reduction.turned(phi) for run in strokes.values() for phi in (run.begin, run.end)]
    crossed = _crossings(reduction, strokes, noise)
    turned = _reversals(reduction, noise)
    least = noise * TURN
    within = np.mod(np.concatenate((ends, crossed, turned)), TURN)
    within = np.sort(np.where(np.minimum(within, TURN - within) < least, 0.0, within))
    return np.asarray(within[np.diff(within, prepend=-1.0) >= least])


def _crossings(reduction: ExactReduction, strokes: Mapping[Track, StrokeRun], noise: float) -> Floats:
    """Give the angles at which a load over a stroke changes its law: at shares of it, and where it turns back."""
    counted = [track for track in strokes if any(_laws(reduction.machine, track))]

    def sample(motion: Motion) -> tuple[Floats, Floats]:
        return np.array([strokes[track].share(motion) for track in counted]), np.ones(len(counted))

    curves = smooth(reduction, sample, noise) if counted else []
    found = [np.zeros(0)]
    for track, curve in zip(counted, curves, strict=True):
        for law in sorted(set(_laws(reduction.machine, track))):
            found += _changes(reduction, strokes[track], curve, law)
    return np.concatenate(found)


class LoadLaw(NamedTuple):
    """A share of a stroke at which a load over it changes, and when that load acts."""

    share: float
    during: str

    @property
    def directed(self) -> bool:
        """Whether the load acts by the way in which its stroke goes, on reversals within it too."""
        return self.during in (FORWARD, BACKWARD)


def _changes(reduction: ExactReduction, run: StrokeRun, curve: TurnQuantity, law: LoadLaw) -> Iterator[Floats]:
    """Give where a stroke is gone by a share while the load acts and, of a load by its way, where it turns back."""
    if 0.0 < law.share < 1.0:
        at = roots(lambda turned, side: curve.at(turned, side) - law.share, looks([curve]))
        yield at[_acts(reduction, run, curve, law, at)]
    if law.directed:
        yield roots(curve.slope.at, looks([curve]))


def _acts(reduction: ExactReduction, run: StrokeRun, curve: TurnQuantity, law: LoadLaw, turned: Floats) -> Flags:
    """Tell at which angles turned a load may act: not on the stroke, or the way, on which it rests."""
    if law.during == ALWAYS:
        return np.ones(len(turned), dtype=bool)
    if law.directed:
        return np.asarray((curve.slope.at(turned) > 0.0) == (law.during == FORWARD))
    return np.asarray(run.working(reduction.start + reduction.sense * turned) == (law.during == WORKING))


def _laws(machine: Machine, track: Track) -> Iterator[LoadLaw]:
    for load in machine.loads:
        if load.stroke == track:
            places = load.diagram.travel if isinstance(load, Force) and load.diagram is not None else ()
            first, last = load.overrun
            laws = [LoadLaw(share, load.during) for share in (*places, first, 1.0 - last)]
            yield from (law for law in laws if law.directed or 0.0 < law.share < 1.0)


def _reversals(reduction: ExactReduction, noise: float) -> Floats:
    """Give the angles at which a point or a link with a load against its motion turns back."""
    machine = reduction.machine
    moving = [force for force in machine.forces if force.direction is None and force.size]
    points = sorted({force.point for force in moving if force.line is None})
    partings = [force for force in moving if force.resists and force.other is not None]
    links = sorted({moment.link for moment in machine.moments if moment.against and moment.size})
    if not points and not links and not partings:
        return np.zeros(0)

    def sample(motion: Motion) -> tuple[Floats, Floats]:
        moved = [motion.points[point] for point in points]
        rows = [(point.v * point.a.conj()).real for point in moved]
        rows += [_turning(motion.links[link].omega, noise) for link in links]
        rows += [_turning(_parting(motion, force), noise) for force in partings]
        sizes = [np.abs(point.v).max() * np.abs(point.a).max() for point in moved] + [1.0] * len(links)
        sizes += [np.abs(row).max() or 1.0 for row in rows[len(sizes) :]]
        return np.array(rows), np.array(sizes)

    curves = smooth(reduction, sample, noise)
    found = [roots(curve.at, looks([curve])) for curve in curves]
    rests = [_rests(reduction, point, at, noise) for point, at in zip(points, found, strict=False)]
    return np.concatenate([*rests, *found[len(points) :]])


def _parting(motion: Motion, force: Force) -> Floats:
    """Give the speed at which the point of a force goes away from the other's, times their line's length."""
    assert force.line is not None and force.other is not None  # asked before
    start, end = (motion.points[point].r for point in force.line)
    apart = motion.points[force.point].v - motion.points[force.other.point].v
    return np.asarray(((end - start).conj() * apart).real)


def _turning(omega: Floats, noise: float) -> Floats:
    """Give no angular velocity at all to a link that only slides, beside the crank's of 1 rad/s."""
    return omega if (np.abs(omega) > noise).any() else np.zeros_like(omega)


def _rests(reduction: ExactReduction, point: str, turned: Floats, noise: float) -> Floats:
    """Keep the angles at which a point is at rest, and not only slowest: there is nothing left of its velocity."""
    if not turned.size:
        return turned
    speeds = np.abs(reduction.motion(np.append(turned, np.arange(12) * (TURN / 12))).points[point].v)
    return np.asarray(turned[speeds[: len(turned)] <= noise * speeds.max()])
