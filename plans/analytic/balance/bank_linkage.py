"""A linkage as one mechanism of a bank: its shaking force by direct sums, its harmonics by their transform (M7.8)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from functools import cached_property

import numpy as np

from plans.analytic.balance.mass_centre import mass_centre
from plans.analytic.kinematics import Analysis
from plans.analytic.points import acceleration
from plans.model.balance.bank import EPS, ROUNDING, STEPS, Harmonic
from plans.model.machine import Body
from plans.model.motion import Complexes, Floats
from plans.model.rates import Rates

FEWEST, MOST = 256, 2**16  # samples of a turn: what orders up to 6 need at the least, and where doubling ends


def even(count: int) -> Floats:
    """Give crank angles rad that divide a turn evenly, from 0 on, the end left out."""
    return 2 * np.pi * np.arange(count) / count


def harmonics(vector: Callable[[Floats], Complexes], orders: Iterable[int], scale: float = 0.0) -> dict[int, Harmonic]:
    """Give harmonics of a vector of crank angles rad (N,): samples are doubled until the transform settles.

    `scale` is the size of what the vector is the sum of: where all but nothing is left of it, rounding counts by that.
    """
    told = sorted(set(orders))
    samples = vector(even(FEWEST))
    before, now = np.fft.fft(samples) / FEWEST, _finer(vector, samples)
    while not _settled(before, now, told, scale) and len(now[0]) < MOST:
        before, now = np.fft.fft(now[0]) / len(now[0]), _finer(vector, now[0])
    samples = now[0]
    row = np.fft.fft(samples) / len(samples)
    slack = ROUNDING * EPS * max(float(np.abs(samples).max()), scale)
    return {n: _harmonic(n, row, before, slack) for n in told}


def _finer(vector: Callable[[Floats], Complexes], samples: Complexes) -> tuple[Complexes, Complexes]:
    """Double the samples of a turn by those half way between them; give them, and their transform."""
    count = 2 * len(samples)
    finer = np.empty(count, dtype=np.complex128)
    finer[::2], finer[1::2] = samples, vector(even(count)[1::2])
    return finer, np.fft.fft(finer) / count


def _settled(before: Complexes, now: tuple[Complexes, Complexes], orders: Iterable[int], scale: float) -> bool:
    """Tell whether doubling moves the harmonics by rounding alone."""
    samples, row = now
    rounding = ROUNDING * EPS * max(float(np.abs(samples).max()), scale)
    return all(abs(row[n] - before[n]) <= rounding for order in orders for n in (order, -order))


def _harmonic(order: int, row: Complexes, before: Complexes, slack: float) -> Harmonic:
    moved = max(abs(row[n] - before[n]) for n in (order, -order))
    return Harmonic(order, complex(row[order]), complex(row[-order]), max(slack, float(moved)))


LOOKS = 72  # positions of a turn over which the size of the forces is taken


class Linkage:
    """A linkage by analysis whose crank turns evenly at an angular speed rad/s, with all that has mass."""

    def __init__(
        self, road: Analysis, bodies: Sequence[Body], speed: float, phi: Floats, orders: Sequence[int]
    ) -> None:
        self.mechanism, self.bodies, self.orders = road.mechanism, bodies, orders
        self.road = Analysis(road.mechanism, road.tolerance, road.first, road.looks, lambda _: Rates(speed, 0.0))
        self.road.motion(phi, 0)  # by which the way round is marched

    @cached_property
    def scale(self) -> float:
        """The largest sum of the sizes of all inertia forces, N."""
        motion = self.road.around(2 * np.pi * np.arange(LOOKS) / LOOKS)
        rows = [np.abs(one.mass * acceleration(self.mechanism, motion, one.link, one.centre)) for one in self.bodies]
        return float(np.max(np.sum(rows, axis=0)))

    def harmonic(self, signed: int) -> complex:
        """Give the vector of a signed order, N."""
        one = self._harmonics[abs(signed)]
        return one.ahead if signed > 0 else one.back

    @cached_property
    def _harmonics(self) -> dict[int, Harmonic]:
        return harmonics(self._force, self.orders, self.scale)

    def shaking(self, phase: Fraction) -> Complexes:
        """Give the shaking force over the turn from a phase on, N."""
        start = float(phase) * np.pi / 180
        return self._force(start + 2 * np.pi * np.arange(STEPS + 1) / STEPS)

    def _force(self, phi: Floats) -> Complexes:
        motion = self.road.around(np.mod(phi, 2 * np.pi))
        return mass_centre(self.mechanism, self.bodies, motion).force
