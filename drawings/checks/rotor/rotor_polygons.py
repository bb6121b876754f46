"""The self-check of a rotor's polygons: sides one after another, heads, letters, lanes (проверка полигонов)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from drawings.checks.graphs.figure_strokes import FLUSH, FigureStrokes, figure, read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.rotor.rotor_bodies import DOUBTED, letter, origin
from drawings.checks.wrong import Wrong, on
from drawings.lettering.rotor_letters import lowered
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Leaf, Line, Text
from plans.rotor.balancing import COUPLES

HEADED = 0.1  # mm: a shorter vector has no head
TITLES = {True: "polygon of moments", False: "polygon of static moments"}
SCALES = {True: ("{mDh}", "kg*m2"), False: ("{mD}", "kg*m")}


@dataclass(frozen=True)
class RotorChain:
    """A polygon on paper, and its sides in their order by the analysis, kg*m or kg*m2."""

    plan: str
    strokes: FigureStrokes
    sides: Mapping[str, complex]
    closed: bool
    measured: Sequence[MeasuredVector]
    drafting: Drafting
    loose: float  # kg*m or kg*m2 that rounding may have moved a corner by

    @cached_property
    def inventory(self) -> Inventory:
        """What is drawn."""
        return Inventory(self.plan, (self.strokes.group,), FLUSH + min(self.loose / self.mu, SEEN))

    @cached_property
    def mu(self) -> float:
        """The scale, kg*m or kg*m2 a mm."""
        return origin(self.strokes)[0]

    @cached_property
    def zero(self) -> complex:
        """Where it begins on paper, mm."""
        return origin(self.strokes)[1]

    def faults(self) -> Iterator[Wrong]:
        """Hold its heading, its beginning, every side."""
        own = self.inventory
        self._heading()
        own.circle(self.zero, on("missing_on", self.plan, name="0"))
        own.letter("0", [self.zero], on("letter", self.plan, name="0"))
        at = self.zero
        for name, value in self.sides.items():
            self._side(name, at, at + value / self.mu)
            at += value / self.mu
        return own.faults()

    def _heading(self) -> None:
        word, couples = self.drafting.word, self.plan == COUPLES
        title = word(TITLES[couples])
        self.inventory.text(title, on("title", self.plan, text=title))
        parts = [word("no vectors")]
        if self.sides:
            faint = [name for name, value in self.sides.items() if abs(value) < SEEN * self.mu]
            parts = [scale_line(self.mu, *SCALES[couples], self.drafting).replace("{", "").replace("}", "")]
            parts += [word("closes by itself")] if self.closed else []
            names = ", ".join(read(lowered(one, self.drafting.language)) for one in faint)
            parts += [word("unlettered", names=names)] if faint else []
        under, wrong = ";  ".join(parts), on("scale_missing", self.plan, text=";  ".join(parts))
        if self.doubted:
            self.inventory.take(Text, lambda one: one.plain.startswith(parts[0]), wrong)
        else:
            self.inventory.text(under, wrong)

    @property
    def doubted(self) -> bool:
        """Whether rounding may make a side of what is none, or hide one that is."""
        return any(abs(value) <= DOUBTED * self.loose for value in self.sides.values()) or self.loose > FLUSH * self.mu

    def _side(self, name: str, start: complex, end: complex) -> None:
        """Hold a side: between its corners, or in a lane beside them to which thin lines carry it."""
        own, wrong = self.inventory, on("corner_of", self.plan, name=name)
        seen = next((one for one in self.measured if one.name == name), None)
        if seen is None:
            return
        if own.line(seen.start, seen.end, wrong) is None:
            return
        for corner, there in ((start, seen.start), (end, seen.end)):
            if not own.at(corner, there):
                self._carried(corner, there, end - start, wrong)
        if abs(seen.end - seen.start) > HEADED:
            own.head(seen.end, seen.end - seen.start, on("head", self.plan, name=name))
        if abs(end - start) >= SEEN:
            text = letter(name, len(self.sides), self.drafting) if "_" in name else read(name)
            own.letter_along(text, seen.start, seen.end, on("letter", self.plan, name=name))

    def _carried(self, corner: complex, there: complex, way: complex, wrong: Wrong) -> None:
        """Hold the thin line that carries a corner over to a lane, square to the side and a little past it."""
        own, shift = self.inventory, there - corner

        def holds(one: Line) -> bool:
            over = (one.end - one.start) / shift
            return own.at(one.start, corner) and abs(over.imag) * abs(shift) <= own.near and over.real > 1

        if abs((shift / way).real) * abs(way) > own.near:
            own.wrong.append(wrong)
        own.take(Line, holds, wrong)


def polygon(
    leaf: Leaf,
    plan: str,
    sides: Mapping[str, complex],
    closed: bool,
    measured: Sequence[MeasuredVector],
    drafting: Drafting,
    loose: float,
) -> Iterator[Wrong]:
    """Hold a polygon that a sheet bears."""
    strokes = figure(leaf, plan)
    if strokes is not None:
        yield from RotorChain(plan, strokes, sides, closed, measured, drafting, loose).faults()
