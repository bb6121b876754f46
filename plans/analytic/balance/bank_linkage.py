"""A linkage as one mechanism of a bank: its shaking force by direct sums, its harmonics by their transform (M7.8)."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property

import numpy as np

from plans.analytic.balance.harmonics import harmonics
from plans.analytic.balance.mass_centre import mass_centre
from plans.analytic.kinematics import Analysis
from plans.analytic.points import acceleration
from plans.model.balance.bank import STEPS, Harmonic
from plans.model.machine import Body
from plans.model.motion import Complexes, Floats
from plans.model.rates import Rates

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
