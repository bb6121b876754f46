"""The self-check of a force polygon on paper: side after side, heads at their ends, directions (проверка плана сил)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.checks.forces.drawn_lines import DrawnLines
from drawings.checks.forces.laid_scheme import FINE
from drawings.checks.graphs.figure_strokes import FigureStrokes
from drawings.checks.wrong import Wrong, on
from drawings.measure.measured import MeasuredVector
from drawings.paper.hand import HANDS, hand_of
from drawings.paper.strokes import Line
from drawings.symbols.symbols import ARROW_LENGTH
from plans.checks.force_bill import ForceBill

HEADED = 0.1  # mm: a shorter vector has no head
LEAST = 0.5  # mm: a shorter line of known direction is not drawn
OVER = (4.5, 9.0)  # mm on A1 that such a line is drawn before a side, and past it
SIZES = sorted(
    {hand_of(name, how).symbol for how, own in HANDS.items() for name in own}
)  # factors of symbols on any paper


class Corners(NamedTuple):
    """The places that the ends of a vector may stand for: its own, or those that thin lines carry over to it."""

    start: tuple[complex, ...]
    end: tuple[complex, ...]


def heads(strokes: FigureStrokes, vectors: Sequence[MeasuredVector]) -> Iterator[Wrong]:
    """Hold that each vector has its arrowhead at its end."""
    for one in vectors:
        found = (
            abs(arrow.tip - one.end) <= FINE and abs(arrow.start - one.start) <= FINE for arrow in strokes.pointings
        )
        if abs(one.end - one.start) > HEADED + FINE and not (any(found) and _ahead(strokes, one)):
            yield on("head", one.plan, name=one.name)


def _ahead(strokes: FigureStrokes, one: MeasuredVector) -> bool:
    """Tell whether a head with its tip at the end of a vector lies on its line, before the tip."""
    back = [sum(head.points[1:]) / 2 for head in strokes.heads if abs(head.points[0] - one.end) <= FINE]
    return any(((one.end - spot) / (one.end - one.start)).real > 0 for spot in back)


@dataclass(frozen=True)
class PolygonChain:
    """The written vectors of one force plan, the bill of its group, and its scale N/mm."""

    strokes: FigureStrokes
    bill: ForceBill
    vectors: Sequence[MeasuredVector]
    order: Sequence[str]  # of the equation of forces, if it is on the sheet
    nothing: float  # N

    @property
    def plan(self) -> str:
        """The name of the plan."""
        return f"forces-{'-'.join(map(str, self.bill.links))}"

    def faults(self) -> Iterator[Wrong]:
        """Hold heads, corners, diagonals, lines of known direction."""
        yield from heads(self.strokes, self.vectors)
        for name, vector in self._drawn.items():
            for here, there in ((self._corners[name].start, "end"), (self._corners[name].end, "start")):
                if not any(self._meet(here, getattr(self._corners[other], there)) for other in self._others(name)):
                    yield on("corner_of", self.plan, name=vector.name)
                    break
        yield from self._consecutive()
        corners = [spot for one in self._drawn for ends in self._corners[one] for spot in ends]
        for one in (one for one in self.vectors if one.name not in self._sides):
            ends = self._carried(one)
            if not (self._meet(ends.start, corners) and self._meet(ends.end, corners)):
                yield on("corner_of", self.plan, name=one.name)
        yield from self._directions()
        yield from self._strays()

    def _strays(self) -> Iterator[Wrong]:
        """Hold that each thin line goes through a corner, or carries one over to the lane of its side."""
        drawn = DrawnLines(self.strokes)
        ends = [self._carried(one) for one in self.vectors]
        corners = dict.fromkeys(spot for one in ends for spot in (*one.start, *one.end))
        known = [drawn.along(spot, None, self._loose) for spot in corners]
        yield from drawn.strays(self.plan, np.asarray(np.any([drawn.none, *known], axis=0)))

    @cached_property
    def _sides(self) -> dict[str, complex]:
        """Give the sides that the polygon must have: of a reaction its parts where these are drawn."""
        names = {one.name for one in self.vectors}
        due = {one.name: one.value for one in self.bill.known}
        if self.bill.driving is not None:
            due[self.bill.driving.name] = self.bill.driving.value
        for one in self.bill.bearings:
            split = any(part.name in names for part in one.parts)
            due |= {part.name: part.value for part in one.parts} if split else {one.name: one.value}
        return due

    @cached_property
    def _drawn(self) -> dict[str, MeasuredVector]:
        return {one.name: one for one in self.vectors if one.name in self._sides}

    @cached_property
    def _corners(self) -> dict[str, Corners]:
        return {name: self._carried(one) for name, one in self._drawn.items()}

    @cached_property
    def _loose(self) -> float:
        """Give how far apart two sides may be on paper for those between them that are too short to be drawn, mm."""
        scale = max((one.scale for one in self.vectors), default=1.0)
        return FINE + sum(abs(value) for name, value in self._sides.items() if name not in self._drawn) / scale

    def _others(self, name: str) -> Iterator[str]:
        return (one for one in self._drawn if one != name or len(self._drawn) == 1)

    def _meet(self, some: Sequence[complex], others: Sequence[complex]) -> bool:
        return any(abs(one - other) <= self._loose for one in some for other in others)

    def _carried(self, one: MeasuredVector) -> Corners:
        way = 1j * (one.end - one.start)
        return Corners(*((end, *self._carriers(end, way)) for end in (one.start, one.end)))

    def _carriers(self, end: complex, way: complex) -> Iterator[complex]:
        """Give where thin lines square to a vector come from that run over its end."""
        for line in self.strokes.through(end, way, FINE) if way else ():
            yield from (spot for spot in (line.start, line.end) if abs(spot - end) > FINE)

    def _consecutive(self) -> Iterator[Wrong]:
        """Hold that sides follow one another as the equation has them."""
        yield from (on("corner_of", self.plan, name=name) for name in self.out_of_turn())

    def out_of_turn(self) -> Iterator[str]:
        """Give the sides that do not follow those before them in the equation, the first after the last."""
        told = [name for name in self.order if name in self._drawn]
        for one, after in zip(told, (*told[1:], *told[:1]), strict=True):
            if len(told) > 1 and not self._meet(self._corners[one].end, self._corners[after].start):
                yield after

    def _directions(self) -> Iterator[Wrong]:
        """Hold the lines of known direction: along each of two sides that close the polygon, past their meeting."""
        for name in self.closing:
            one = self._drawn.get(name)
            if one is None or abs(one.end - one.start) < ARROW_LENGTH:
                continue
            ends = self._carried(one)
            if not any(
                self._passes(line, start, end)
                for line in self.strokes.lines
                for start in ends.start
                for end in ends.end
            ):
                yield on("line_of", self.plan, name=name)

    @property
    def closing(self) -> Mapping[str, complex]:
        """The two sides of known direction that close the polygon, by their names; none where one closes it alone."""
        if self.bill.group is not None and self.bill.group.kind == "RPR":
            return {}
        found: dict[str, complex] = {}
        for one in self.bill.bearings:
            part = next((part for part in one.parts if part.name in self._drawn and "^n" in part.name), None)
            found |= {one.name: one.value} if part is None else {part.name: part.value}
        if self.bill.group is None:
            drive = self.bill.expected.mechanism.drive
            return found | {self.bill.driving.name: 0j} if drive.guide is not None and self.bill.driving else {}
        return found

    def _passes(self, line: Line, start: complex, end: complex) -> bool:
        """Tell whether a line runs through both ends of a side, and past them as far as such lines are drawn."""
        run = end - start
        if abs(run) < LEAST or abs(line.end - line.start) <= abs(run) + FINE:
            return False
        off = max(abs(((spot - start) / run).imag) * abs(run) for spot in (line.start, line.end))
        along = sorted((((spot - start) / run).real) for spot in (line.start, line.end))
        over = sorted((-along[0] * abs(run), (along[1] - 1) * abs(run)))
        beyond = any(np.allclose(over, [size * one for one in OVER], rtol=0.0, atol=2 * FINE) for size in SIZES)
        return off <= FINE and beyond
