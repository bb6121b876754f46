"""A bank of equal mechanisms on one shaft (блок одинаковых механизмов): its harmonics and compensators.

Values alone, SI; angles and places exact, so that a multiple of an angle is rounded once. A harmonic of order n of a
vector is two vectors that turn with n times the crank's speed, one with it and one against it:
F_n = ahead*e^(i n phi) + back*e^(-i n phi); of a force along one line both are of one size.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from plans.model.motion import Complexes, Floats, Gap

CONSTRUCTION, ANALYSIS = "construction", "analysis"
ORDERS = (1, 2, 4, 6)  # the orders that are told unless the scene names others
STEPS = 360  # even positions of a turn at which the whole force is told
EPS = 2.0**-52
ROUNDING = 8.0  # a polygon closes within so many eps of the sum of its vectors
HARMONIC = 64.0  # a harmonic is found within so many eps of the forces that it is part of: 1e-14; what is less is none


class Unit(NamedTuple):
    """A slider-crank of the bank by its sizes: crank m, rod m, rotating mass kg at the crank pin, reciprocating kg."""

    crank: float
    rod: float
    rotating: float
    reciprocating: float

    @property
    def ratio(self) -> float:
        """Crank over rod, lambda."""
        return self.crank / self.rod


class Member(NamedTuple):
    """One mechanism of the bank: where its crank stands degrees, its place along the shaft m, direction of its guide.

    `crank` is counted from the reference crank at the same moment; `axis` in degrees turns the whole mechanism about
    the shaft from the reference guide.
    """

    name: str
    crank: Fraction
    place: Fraction
    axis: Fraction

    @property
    def phase(self) -> Fraction:
        """How far its crank is ahead of the reference crank, each counted from its own guide, degrees."""
        return self.crank - self.axis


class Asked(NamedTuple):
    """Compensators that are asked of an order: mass kg of each or none, offset m of their line from the guide.

    `shafts` m is the distance of the two shafts of the compensator of the couple; None: none is asked for.
    """

    order: int
    mass: float | None = None
    offset: float = 0.0
    shafts: float | None = None


class BankTask(NamedTuple):
    """The bank: its mechanism by sizes, or None of the scene's linkage; members, speed rad/s, orders, compensators."""

    unit: Unit | None
    members: tuple[Member, ...]
    speed: float
    orders: tuple[int, ...] = ORDERS
    asked: tuple[Asked, ...] = ()
    axis: float = 0.0  # rad: direction of the reference guide from the shaft, away from it, on the sheet


class Harmonic(NamedTuple):
    """A harmonic of a vector: the vectors that turn with the crank and against it, and how far rounding moved each."""

    order: int
    ahead: complex
    back: complex
    slack: float

    @property
    def size(self) -> float:
        """The largest that it comes to over a turn: the larger half axis of its ellipse; 0 where rounding is left."""
        return 0.0 if self.vanishes else abs(self.ahead) + abs(self.back)

    @property
    def vanishes(self) -> bool:
        """Whether nothing is left but rounding."""
        return max(abs(self.ahead), abs(self.back)) <= self.slack

    def at(self, phi: Floats) -> Complexes:
        """Give it at crank angles rad."""
        turned = np.exp(1j * self.order * np.asarray(phi))
        return np.asarray(self.ahead * turned + self.back * turned.conj())


def plain_angle(angle: float) -> float:
    """Give an angle rad in (-pi, pi]; what is within rounding of -pi is pi."""
    return math.pi if angle <= -math.pi * (1 - ROUNDING * EPS) else angle


class Compensator(NamedTuple):
    """Two masses that turn against each other at n times the crank's speed: m*r kg*m and angle rad at phi = 0 of each.

    `with_crank` turns with the crank, `against` against it; None is the angle of a mass that is not needed. `residual`
    N*m is the largest couple that their offset gives, `couple` kg*m the m*r of each mass of its compensator: two masses
    in antiphase on shafts whose line is along the largest force of the order, `couple_angle` of the one farther on it;
    of a force that goes round the line is the reference guide. They turn with the crank. Both count the offset alone,
    not how far from one another and from the crank the two shafts are: equal masses make no couple by that.
    """

    asked: Asked
    with_crank: float
    with_angle: float | None
    against: float
    against_angle: float | None
    residual: float = 0.0
    couple: float | None = None
    couple_angle: float | None = None

    @property
    def masses(self) -> tuple[tuple[int, float, float], ...]:
        """The masses that are needed: order, negative against the crank, static moment kg*m and angle rad of each."""
        order = self.asked.order
        pairs = (order, self.with_crank, self.with_angle), (-order, self.against, self.against_angle)
        return tuple((signed, moment, angle) for signed, moment, angle in pairs if angle is not None)

    @property
    def on_crank(self) -> bool:
        """Whether it is one mass that turns as the crank does, which is a counterweight on the crank itself."""
        return self.asked.order == 1 and self.with_angle is not None and self.against_angle is None


@dataclass(frozen=True)
class BankBalance:
    """The bank by one road: harmonics of one mechanism, of the bank's force N and longitudinal moment N*m.

    The moment is told as the vector sum of h_k*F_k; `force` and `left` are the whole force over STEPS + 1 even
    positions of a turn, before and after the compensators.
    """

    by: str
    task: BankTask
    single: Mapping[int, Harmonic]
    forces: Mapping[int, Harmonic]
    moments: Mapping[int, Harmonic]
    compensators: tuple[Compensator, ...]
    phi: Floats
    force: Complexes
    left: Complexes
    moment: Complexes  # of the bank about the plane of place 0, N*m
    force_slack: float  # N: how far rounding can have moved `force` anywhere
    moment_slack: float  # N*m

    @property
    def left_slack(self) -> float:
        """How far rounding can have moved `left` anywhere, N."""
        taken = (self.forces[compensator.asked.order] for compensator in self.compensators)
        return self.force_slack + sum(2 * harmonic.slack + ROUNDING * EPS * harmonic.size for harmonic in taken)

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """The gaps, as a comparison asks for them: every bank has an answer."""
        return ()
