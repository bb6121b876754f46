"""A tangent of Wittenbauer's loop: broken off towards the origin, its angle, what it cuts off (касательная к петле)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass

from drawings.figures.graphs.axes import BEYOND, Axes
from drawings.figures.graphs.part import LEFT, OVER, UNDER, Letter
from drawings.page.scale import Scale
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import INK, Arc, Circle, Group, Line, Polyline, Stroke
from drawings.paper.walk import stating
from drawings.symbols.dimension import Dimension
from drawings.symbols.figure import Subject
from plans.model.dynamics import Flywheel

LOOP = "loop"
PAPER = Scale(1.0, "l", "mm")  # of points whose axes have different scales: they are measured in mm
DOT = 0.6  # mm, radius of a point of the loop
TAIL = 6.0  # sizes of a letter that a tangent goes beyond the axis of energy, towards the origin
DROP = 1.6  # sizes of a letter that it goes below what it cuts off at most
BREAK = 1.4  # mm, half the zigzag where it is broken off
OFFS = (2.0, 3.6)  # sizes of a letter from the axis to the dimensions of o1l and o1k
ARM = 4.0  # sizes of a letter, radius of the arcs of the angles
CUTS, ANGLES = ("l", "k"), ("ψ_{min}", "ψ_{max}")


@dataclass(frozen=True)
class Tangent:
    """A tangent of the loop: that at psi_min, which touches from below, or that at psi_max from above."""

    across: tuple[float, float]  # kg*m2: the least and the greatest inertia of the loop, zero among them
    top: float  # J: the greatest energy
    wheel: Flywheel
    axes: Axes
    hand: Hand
    which: int

    @property
    def cut(self) -> complex:
        """Where it cuts the axis of energy, on paper."""
        return self.axes.on(0.0, self.wheel.cuts[self.which])

    @property
    def slope(self) -> float:
        """Tangent of its angle on paper."""
        return self.wheel.slopes[self.which] * self.axes.across.mu / self.axes.up.mu

    @property
    def along(self) -> complex:
        """Its direction on paper."""
        return complex(1.0, self.slope) / abs(complex(1.0, self.slope))

    @property
    def end(self) -> complex:
        """Its right end: beyond the loop, but its angle not beyond the row that the loop stands in."""
        length = self.across[1] / self.axes.across.mu + BEYOND
        above = (self.top - self.wheel.cuts[self.which]) / self.axes.up.mu + BEYOND - self.arm * self.along.imag
        return self.cut + min(length, above / self.slope) * complex(1.0, self.slope)

    @property
    def arm(self) -> float:
        """How far it is drawn beyond its right end, mm: for the arc of its angle, no farther than the axis goes."""
        return min(ARM * self.hand.letter + BREAK, BEYOND / self.along.imag)

    @property
    def start(self) -> complex:
        """Where the loop begins on it, from the left."""
        return self.cut + self.across[0] / self.axes.across.mu * complex(1.0, self.slope)

    @property
    def right(self) -> bool:
        """Whether the more of it lies on the right of the axis of energy: the longer piece is measured."""
        return abs(self.end - self.cut) >= abs(self.start - self.cut)

    @property
    def tail(self) -> complex:
        """Its left end, where it is broken off: some way beyond axis and loop, little below."""
        size = self.hand.letter
        return self.start - min(TAIL * size, DROP * size / self.slope) * complex(1.0, self.slope)

    @property
    def lines(self) -> Iterator[Stroke]:
        """The tangent from its break on, measurable from the axis on; angle, dimension."""
        hand, name = self.hand, ANGLES[self.which]
        far, near = (self.end, self.start) if self.right else (self.start, self.end)
        yield _broken_off(self.tail, self.start, self.along, hand)
        data = Subject(LOOP, PAPER.letter, None).data("vector", _plain(name), far - self.cut, PAPER)
        yield Group((Line(self.cut, far, hand.relative),), "", data, name)
        yield Line(self.cut, near, hand.relative)
        yield from self._angle()
        yield from self._segment()
        yield stating(Statement(Kind.POINT, LOOP, CUTS[self.which]), Circle(self.cut, DOT * hand.symbol, INK))

    def _angle(self) -> Iterator[Stroke]:
        """Draw the angle to the axis of inertia at the right end."""
        hand = self.hand
        yield Line(self.end, self.end + self.arm * self.along, hand.relative)
        yield Line(self.end, self.end + self.arm, hand.drafted)
        arc = Arc(self.end, self.arm - BREAK, 0.0, cmath.phase(self.along), hand.other)
        yield stating(Statement(Kind.ANGLE, LOOP, ANGLES[self.which]), arc)

    @property
    def dimension(self) -> Dimension | None:
        """The segment from o1 to the cut, dimensioned beside the axis of energy; None where it is a point."""
        off = self.across[0] / self.axes.across.mu - OFFS[self.which] * self.hand.letter + 0j
        short = abs(self.cut - self.axes.zero) < 1.0
        return None if short else Dimension(f"o_{{1}}{CUTS[self.which]}", self.axes.zero, self.cut, off)

    def _segment(self) -> Iterator[Stroke]:
        size = self.dimension
        if size is None:
            return
        line, *rest = size.draw(self.hand)
        cut = self.wheel.cuts[self.which]
        data = Subject(LOOP, self.axes.up.letter, None).data("vector", _plain(size.letter), 1j * cut, self.axes.up)
        yield Group((line,), "", data, size.letter)
        yield from rest

    @property
    def letters(self) -> Iterator[Letter]:
        """The angle, the cut and the segment, lettered."""
        size, side = self.hand.letter, OVER if self.which else UNDER
        yield Letter(self.end if self.right else self.cut, ANGLES[self.which], size, side)
        yield Letter(self.cut, CUTS[self.which], size, math.pi / 4 if self.which else -math.pi / 4)
        if self.dimension is not None:
            yield Letter(self.dimension.middle, self.dimension.letter, size, LEFT)


def _broken_off(tail: complex, start: complex, along: complex, hand: Hand) -> Stroke:
    """Draw a line to a place where it is broken off: a zigzag across it, and a little more of it."""
    step, off = BREAK * along, BREAK * 1.4j * along
    return Polyline(
        (start, tail, tail - step / 2 + off, tail - 1.5 * step - off, tail - 2 * step, tail - 5 * step),
        False,
        hand.relative,
    )


def _plain(name: str) -> str:
    return name.replace("_", "").replace("{", "").replace("}", "")
