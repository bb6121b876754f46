"""What the figures of a bank show: its members about the shaft, its polygons as they stand at phi = 0 (вид блока)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from drawings.report.balance.bank_notes import (
    mirrored,
    slight_force,
    slight_left,
    slight_moment,
    slight_order,
    straight,
)
from drawings.symbols.polygon import ShownVector
from plans.bank.letters import FORCE, MOMENT
from plans.bank.polygons import Total
from plans.model.balance.bank import BankBalance, BankTask, Member
from plans.model.motion import Complexes
from plans.rotor.heading import heading

ALIKE = 0.1  # degrees: vectors whose directions differ by less are laid off as if they had one
SIDE, RESULT = "side", "result"  # what a vector is: of one member, or of all together


class ShownOrder(NamedTuple):
    """A polygon of an order, with the crank or against it: its vectors end to end, their sum last unless they close."""

    kind: str  # FORCE or MOMENT
    signed: int
    vectors: tuple[ShownVector, ...]
    closed: bool

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [0j, *(one.end for one in self.vectors)]


def fanned(sides: Sequence[tuple[str, complex]]) -> list[tuple[str, complex]]:
    """Order the sides of a polygon by their directions, from that of the first one on: no side crosses another then.

    >>> [name for name, _ in fanned([("1", 1 + 0j), ("2", -1j), ("3", 2j), ("4", 3 + 0j)])]
    ['1', '4', '3', '2']
    """
    first = next((value for _, value in sides if value), 1 + 0j)
    return sorted(
        sides, key=lambda side: round(math.degrees(cmath.phase(side[1] / first)) / ALIKE) % round(360 / ALIKE)
    )


class BankView(NamedTuple):
    """A bank and what the construction found of it; `crank` m is the crank's length, if it is known."""

    balance: BankBalance
    polygons: Mapping[str, Mapping[int, Total]]  # of forces and of moments, by signed order
    crank: float | None = None

    @property
    def task(self) -> BankTask:
        """What is asked."""
        return self.balance.task

    @property
    def members(self) -> tuple[Member, ...]:
        """The mechanisms."""
        return self.task.members

    @property
    def turn(self) -> complex:
        """The direction of the reference guide on the sheet."""
        return heading(Fraction(float(np.degrees(self.task.axis))))

    def shown(self) -> Iterator[ShownOrder]:
        """Give the polygons of every order that can be seen.

        The mirror image of one is left out, and what has a single side, which is its sum.
        """
        for order in (one for one in self.balance.single if not slight_order(self.balance, one)):
            for kind in (FORCE, MOMENT):
                for signed in (order,) if mirrored(self.balance, order) else (order, -order):
                    if self.acts(kind, signed):
                        yield self._shown(kind, signed)

    def acts(self, kind: str, signed: int) -> bool:
        """Tell whether several mechanisms of the bank have something to lay off in a polygon."""
        single = self.balance.single[abs(signed)]
        several = sum(1 for one in self.task.members if one.place or kind == FORCE) > 1
        return several and abs(single.ahead if signed > 0 else single.back) > single.slack

    def _shown(self, kind: str, signed: int) -> ShownOrder:
        found, vectors, end = self.polygons[kind][signed], list[ShownVector](), 0j
        for name, point in fanned([(side.vector.name, complex(side.vector.point)) for side in found.polygon.sides]):
            vectors.append(ShownVector(name, SIDE, end, point * self.turn))
            end += point * self.turn
        whole = (self.balance.forces if kind == FORCE else self.balance.moments)[abs(signed)]
        closed = found.vanishes or abs(complex(found.vector.point)) <= whole.slack
        if not closed:
            vectors.append(ShownVector(found.vector.name, RESULT, 0j, complex(found.vector.point) * self.turn))
        return ShownOrder(kind, signed, tuple(vectors), closed)

    @property
    def straight(self) -> bool:
        """Whether the force of the bank, before and after, keeps to the line of the reference guide."""
        return all(straight(one, self.balance.force) for one in (self.balance.force, self.balance.left))

    @property
    def lasting(self) -> bool:
        """Whether the compensators leave some force that can be seen."""
        left = bool(np.abs(self.balance.left).max() > self.balance.left_slack)
        return left and not slight_left(self.balance)

    @property
    def compensated(self) -> bool:
        """Whether some compensator has a mass."""
        angles = ((one.with_angle, one.against_angle) for one in self.balance.compensators)
        return any(angle is not None for pair in angles for angle in pair)

    @property
    def shaken(self) -> bool:
        """Whether a force of the bank is left that can be seen."""
        left = bool(np.abs(self.balance.force).max() > self.balance.force_slack)
        return left and not slight_force(self.balance)

    @property
    def rocked(self) -> bool:
        """Whether a moment of the bank is left that can be seen."""
        left = bool(np.abs(self.balance.moment).max() > self.balance.moment_slack)
        return left and not slight_moment(self.balance)

    def crank_at(self, one: Member) -> complex:
        """Give the direction of the crank of a member at phi = 0 on the sheet."""
        return heading(one.crank) * self.turn

    def guide_at(self, one: Member) -> complex:
        """Give the direction of the guide of a member on the sheet."""
        return heading(one.axis) * self.turn

    def on_sheet(self, values: Complexes) -> Complexes:
        """Turn vectors as the sheet shows them."""
        return np.asarray(values * self.turn)
