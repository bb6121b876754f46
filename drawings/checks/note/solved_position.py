"""One position of a linkage by analysis, for what a note says of it: rates of spots and of legs, and what is none."""

from __future__ import annotations

import math
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.checks.note.due_math import Quantity
from drawings.checks.note.motion_legs import Leg, Spot
from plans.checks.compare import MOST_ALLOWED, MotionComparison
from plans.model.kinetostatics import NOTHING
from plans.model.mechanism import FRAME, Mechanism
from plans.model.order import ACCELERATIONS, VELOCITIES


class Floors(NamedTuple):
    """What is none of a place m, a velocity m/s and an acceleration m/s2, beside what the two roads differ by."""

    place: float
    velocity: float
    acceleration: float


class SolvedPosition:
    """The motion of a mechanism in position k."""

    def __init__(self, mechanism: Mechanism, comparison: MotionComparison, k: int) -> None:
        self.mechanism, self.comparison, self.motion, self.k = mechanism, comparison, comparison.analysis, k

    @cached_property
    def floors(self) -> Floors:
        """What is none here."""
        place, velocity, acceleration = map(self._floor, range(3))
        return Floors(place, velocity, acceleration)

    def _floor(self, order: int) -> float:
        rows = [np.abs(one[order]) for one in self.motion.points.values()]
        largest = max((float(np.nanmax(one)) for one in rows if np.isfinite(one).any()), default=0.0)
        drawn = self.comparison.construction.points
        pairs = ((drawn[name][order][self.k], one[order][self.k]) for name, one in self.motion.points.items())
        return NOTHING * largest + 2 * max((abs(one - other) for one, other in pairs), default=0.0)

    def speed(self, value: complex) -> Quantity:
        """Give the size of a velocity, m/s."""
        return Quantity(abs(value), self.floors.velocity + MOST_ALLOWED * abs(value))

    def push(self, value: complex) -> Quantity:
        """Give the size of an acceleration, m/s2."""
        return Quantity(abs(value), self.floors.acceleration + MOST_ALLOWED * abs(value))

    def length(self, leg: Leg) -> Quantity:
        """Give the length of a leg's arm, m."""
        value = abs(self.place(leg.point) - self.place(leg.base))
        return Quantity(value, self.floors.place + MOST_ALLOWED * value)

    def spin(self, leg: Leg) -> Quantity:
        """Give the size of the angular velocity of a leg's link, rad/s; it is none where its velocity is none."""
        value, length = abs(self.omega(leg.link)), self._reach(leg)
        return Quantity(value, self.floors.velocity / length + MOST_ALLOWED * value)

    def gain(self, leg: Leg) -> Quantity:
        """Give the size of the angular acceleration of a leg's link, rad/s2."""
        value, length = abs(self.epsilon(leg.link)), self._reach(leg)
        return Quantity(value, self.floors.acceleration / length + MOST_ALLOWED * value)

    def _reach(self, leg: Leg) -> float:
        """Give the arm of a leg that turns, or of a link along which is slid the greatest one that it has."""
        if leg.slide is None:
            return self.length(leg).value or math.inf
        own = [self.place(Spot(name)) for name in self.mechanism.links[leg.link].points]
        return max((abs(one - self.place(leg.point)) for one in own), default=0.0) or math.inf

    def parts(self, leg: Leg) -> tuple[complex, complex, complex]:
        """Give a point's velocity over its base, its normal or Coriolis part, and the rest of its acceleration."""
        velocity = self.v(leg.point) - self.v(leg.base)
        omega = self.omega(leg.link)
        arm = self.place(leg.point) - self.place(leg.base)
        known = -(omega**2) * arm if leg.slide is None else 2j * omega * velocity
        return velocity, known, self.a(leg.point) - self.a(leg.base) - known

    def place(self, spot: Spot) -> complex:
        """Give the place of a spot, m."""
        return complex(self.motion.points[spot.name].r[self.k])

    def v(self, spot: Spot) -> complex:
        """Give the velocity of a spot, m/s."""
        if spot.link is None:
            return self._rate(spot.name, VELOCITIES.number)
        name, arm = self._carrier(spot)
        return self._rate(name, VELOCITIES.number) + 1j * self.omega(spot.link) * arm

    def a(self, spot: Spot) -> complex:
        """Give the acceleration of a spot, m/s2."""
        if spot.link is None:
            return self._rate(spot.name, ACCELERATIONS.number)
        name, arm = self._carrier(spot)
        spun = 1j * self.epsilon(spot.link) - self.omega(spot.link) ** 2
        return self._rate(name, ACCELERATIONS.number) + spun * arm

    def _carrier(self, spot: Spot) -> tuple[str, complex]:
        """Give a named point of a spot's link, and how far from there the spot is."""
        name = next(iter(self.mechanism.links[spot.link or FRAME].points))
        return name, self.place(spot) - self.place(Spot(name))

    def _rate(self, name: str, order: int) -> complex:
        fixed = name in self.mechanism.links[FRAME].points
        return 0j if fixed else complex(self.motion.points[name][order][self.k])

    def omega(self, link: int) -> float:
        """Give the angular velocity of a link, rad/s."""
        return 0.0 if link == FRAME else float(self.motion.links[link].omega[self.k])

    def epsilon(self, link: int) -> float:
        """Give the angular acceleration of a link, rad/s2."""
        return 0.0 if link == FRAME else float(self.motion.links[link].epsilon[self.k])
