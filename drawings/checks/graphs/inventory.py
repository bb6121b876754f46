"""A figure's strokes ticked off one by one: each that must be there, none beside those (опись линий фигуры)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TypeVar

from drawings.checks.graphs.figure_strokes import FLUSH
from drawings.checks.letters import along, leaders, off
from drawings.checks.wrong import Wrong, on
from drawings.layout.labels import NEAR
from drawings.lettering.extent import bounds
from drawings.paper.strokes import Arc, Circle, Fill, Group, Line, Stroke, Text
from drawings.paper.walk import flat

Kind = TypeVar("Kind", bound=Stroke)
BESIDE = 4.0 + NEAR[-1]  # mm from a spot to its letter, or to the beginning of its leader
TICKED = 2.5  # mm: so far from the axis at most goes a tick
SLANT = 1e-3  # of its length by which an arrowhead may look aside


class Inventory:
    """The strokes of a figure that nothing has asked for yet, and what was asked for in vain."""

    def __init__(self, plan: str, strokes: Sequence[Group], near: float = FLUSH) -> None:
        self.plan, self.near, self.wrong = plan, near, list[Wrong]()
        self._left = list(flat(strokes))
        self._leaders = {id(text): line for line, text in leaders(strokes)}

    def faults(self) -> Iterator[Wrong]:
        """Give what was missed, then what nothing asked for."""
        yield from self.wrong
        leaders = {id(line) for line in self._leaders.values()}
        yield from (self._stray(one) for one in self._left if id(one) not in leaders)

    def left(self, kind: type[Kind]) -> list[Kind]:
        """Give the strokes of a kind that nothing has asked for."""
        return [one for one in self._left if isinstance(one, kind)]

    def take(self, kind: type[Kind], holds: Callable[[Kind], bool], wrong: Wrong | None = None) -> Kind | None:
        """Tick off the first stroke of a kind that holds; where there is none say so, unless it may be missing."""
        for k, one in enumerate(self._left):
            if isinstance(one, kind) and holds(one):
                del self._left[k]
                return one
        if wrong is not None:
            self.wrong.append(wrong)
        return None

    def every(self, kind: type[Kind], holds: Callable[[Kind], bool]) -> list[Kind]:
        """Tick off all strokes of a kind that hold."""
        found = [one for one in self.left(kind) if holds(one)]
        gone = set(map(id, found))
        self._left = [one for one in self._left if id(one) not in gone]
        return found

    def line(self, start: complex, end: complex, wrong: Wrong | None = None) -> Line | None:
        """Tick off a line between two places."""
        return self.take(Line, lambda one: self._joins(one, start, end), wrong)

    def _joins(self, one: Line, start: complex, end: complex) -> bool:
        there = abs(one.start - start) <= self.near and abs(one.end - end) <= self.near
        return there or (abs(one.start - end) <= self.near and abs(one.end - start) <= self.near)

    def tick(self, foot: complex, wrong: Wrong | None = None) -> None:
        """Tick off a tick (засечка) across a level axis."""
        self.take(Line, lambda one: self._upright(one, foot), wrong)

    def _upright(self, one: Line, foot: complex) -> bool:
        half = (one.end - one.start) / 2
        return self.at((one.start + one.end) / 2, foot) and abs(half.real) <= self.near < abs(half) < TICKED

    def circle(self, centre: complex, wrong: Wrong | None = None, radius: float | None = None) -> Circle | None:
        """Tick off a circle about a place, of any radius or of one."""
        return self.take(Circle, lambda one: self.at(one.centre, centre) and self._sized(one.radius, radius), wrong)

    def _sized(self, seen: float, radius: float | None) -> bool:
        return radius is None or abs(seen - radius) <= self.near

    def head(self, tip: complex, way: complex, wrong: Wrong | None = None) -> Fill | None:
        """Tick off an arrowhead by its tip and the way that it points."""
        return self.take(Fill, lambda one: self.at(one.points[0], tip) and _points(one, way), wrong)

    def arrow(self, start: complex, holds: Callable[[complex], bool], wrong: Wrong) -> complex | None:
        """Tick off a line from a place to a tip that holds, with its head; give the tip."""
        line = self.take(Line, lambda one: self.at(one.start, start) and holds(one.end), wrong)
        if line is not None:
            self.head(line.end, line.end - line.start, wrong)
        return None if line is None else line.end

    def turning(self, centre: complex, sense: float, wrong: Wrong) -> complex | None:
        """Tick off an arc about a place with a head at the end that its sense leads to; give the middle of the arc."""
        arc = self.take(Arc, lambda one: self.at(one.centre, centre), wrong)
        if arc is None:
            return None
        tip = arc.at(1.0 if sense > 0 else 0.0)
        way = math.copysign(1.0, sense) * 1j * (tip - centre)
        head = self.take(Fill, lambda one: _ahead(one, tip, way, arc.radius), wrong)
        return arc.at(0.5) if head is not None else None

    def dimension(self, start: complex, end: complex, wrong: Wrong) -> Line | None:
        """Tick off a dimension of a distance: its line beside it, what leads to that, its two heads."""
        line = self.take(Line, lambda one: self._beside(one, start, end))
        line = line or self.take(Line, lambda one: self._offset(one, start, end), wrong)
        if line is None:
            return None
        off = line.start - start
        for spot in (start, end) if off else ():
            self.take(Line, lambda one, spot=spot: self._leads(one, spot, off), wrong)  # type: ignore[misc]
        self.heads(line.start, line.end, wrong)
        return line

    def _beside(self, one: Line, start: complex, end: complex) -> bool:
        """Tell whether a line is one of a dimension beside what it measures, not another on it."""
        return self._offset(one, start, end) and abs(one.start - start) > 2 * self.near

    def _offset(self, one: Line, start: complex, end: complex) -> bool:
        off = one.start - start
        return self.at(one.end - end, off) and abs((off / (end - start)).real) * abs(end - start) <= self.near

    def _leads(self, one: Line, spot: complex, off: complex) -> bool:
        """Tell whether a line leads from a place to the line of a dimension and past it."""
        over = (one.end - one.start) / off
        return self.at(one.start, spot) and abs(over.imag) * abs(off) <= self.near and over.real > 1

    def heads(self, start: complex, end: complex, wrong: Wrong) -> None:
        """Tick off the heads at both ends of a dimension line: both within, or both outside with a longer line."""
        way = end - start
        if self.head(start, -way) is not None:
            self.head(end, way, wrong)
        elif self.head(start, way, wrong) is not None:
            self.head(end, -way, wrong)
            self.take(Line, lambda one: self._holds(one, start, end), wrong)

    def _holds(self, one: Line, start: complex, end: complex) -> bool:
        """Tell whether a line goes on beyond both ends of another one."""
        way = (end - start) / abs(end - start)
        ends = sorted(((spot - start) / way for spot in (one.start, one.end)), key=lambda spot: spot.real)
        level = max(abs(spot.imag) for spot in ends) <= self.near
        return level and ends[0].real < 0 and ends[1].real > abs(end - start)

    def text(self, plain: str, wrong: Wrong | None = None) -> Text | None:
        """Tick off a text wherever it stands."""
        return self.take(Text, lambda one: one.plain == plain, wrong)

    def letter(self, plain: str, spots: Iterable[complex], wrong: Wrong | None = None) -> Text | None:
        """Tick off a text beside one of some places."""
        places = tuple(spots)
        return self.take(Text, lambda one: one.plain == plain and self.beside(one, places), wrong)

    def letter_along(self, plain: str, start: complex, end: complex, wrong: Wrong | None = None) -> Text | None:
        """Tick off a text beside a line."""
        return self.letter(plain, along(start, end), wrong)

    def beside(self, text: Text, spots: Sequence[complex]) -> bool:
        """Tell whether a text, or the beginning of its leader, is beside one of some places."""
        leader, box = self._leaders.get(id(text)), bounds(text)
        if leader is not None:
            led, box = off(leader.end, box) <= BESIDE, (leader.start.real, leader.start.imag) * 2
            return led and any(off(spot, box) <= BESIDE for spot in spots)
        return any(off(spot, box) <= BESIDE for spot in spots)

    def at(self, one: complex, other: complex) -> bool:
        """Tell whether two places are one."""
        return abs(one - other) <= self.near

    def _stray(self, one: Stroke) -> Wrong:
        if isinstance(one, Text):
            return on("stranger_on", self.plan, name=one.plain)
        spot = _spot(one)
        return on("stray", self.plan, x=f"{spot.real:.1f}", y=f"{spot.imag:.1f}")


def _points(head: Fill, way: complex) -> bool:
    """Tell whether a head points along a way."""
    tip, *back = head.points
    own = tip - sum(back) / len(back)
    return abs(cmath.phase(own / way)) <= SLANT if own and way else False


def _ahead(head: Fill, tip: complex, way: complex, radius: float) -> bool:
    """Tell whether a head goes on from the end of an arc: its tip is further on the circle, its back at the end."""
    back = sum(head.points[1:]) / max(len(head.points) - 1, 1)
    return abs(back - tip) <= SLANT * radius and ((head.points[0] - tip) / way).real > 0


def _spot(one: Stroke) -> complex:
    """Give a place of a stroke, mm."""
    left, bottom, right, top = bounds(one)
    return complex(left + right, bottom + top) / 2
