"""The diagrams of a cam's law one under another over its turn: S'', S' by a pole, S by another (диаграммы движения)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import pairwise

import numpy as np

from drawings.cam.law_frame import LEVEL, LawPlate, LawRow, name_of
from drawings.cam.notes import ACCELERATION, letters, phase_letter
from drawings.kinds.axes import Axes, Letter, Part, Parts, Plot
from drawings.kinds.graph import LEAST, Graph
from drawings.kinds.row_frame import RowFrame
from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Picture, Spot
from drawings.lettering.lettering import every, spaced, text_width
from drawings.lettering.words import Slot, telling
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Kind, Line, LineStyle, Polyline, Statement, Stroke, Text
from drawings.paper.walk import apart, stating
from drawings.symbols.figure import Dimension
from drawings.symbols.symbols import arrowhead, fit_dashes
from drawings.symbols.trimming import around, trim
from plans.cam.diagrams import LawDiagrams
from plans.model.cam import RATIO

DOT = 0.6  # mm, radius of a point of a curve
GIVEN, GRAPH_CLEAR = 1.1, 2.5  # mm, radius of a given point; least distance of two, in radii
APART = 1.9  # sizes of a number from one numbered edge to the next
MARKED = 72  # strips: of more only the numbered edges have a point and a tick
INFINITE = "∞"
CLEAR = 1.5  # mm around a caption
ABOVE = 1.4  # mm from a dimension line to its letters: they are felt free of it
TALLER = 2.1  # times the height that the rows may have where there is room


@dataclass(frozen=True)
class LawFrame(RowFrame[LawRow]):
    """The diagrams at their scale, to be drawn."""

    plate: LawPlate
    spot: Spot

    @cached_property
    def numbered(self) -> tuple[int, ...]:
        """The edges that have room for their numbers: the ends, those of phases, jumps, then every so many."""
        strips, cam, size = self.plate.shown.strips, self.plate.cam, APART * self.plate.hand.number
        places = strips.edges / cam.turn * self.length
        ends = np.flatnonzero(np.isin(strips.edges, [phase.start for phase in cam.phases])).tolist()
        step = every(size / max(float(np.diff(places).min()), LEAST), cam.divisions)
        rest = [k for k, name in enumerate(strips.names) if name.isdigit() and int(name) % step == 0]
        order = (0, len(places) - 1, *ends, *strips.jumps, *rest, *range(len(places)))
        return tuple(sorted(spaced(places.tolist(), size, order)))

    def scales_of(self, row: LawRow) -> Iterator[str]:
        """Write the scale of a row, with that of the turn or with the pole distance that it comes from."""
        yield from super().scales_of(row)
        if row.key == ACCELERATION:
            yield self.plate.drafting.scale(self.spot.scale)

    def pole_size(self, distance: float) -> str:
        """Write a pole distance, mm."""
        return self.plate.drafting.slot(Slot("H", distance))

    def drawn(self, row: LawRow) -> Part:
        """Draw a row on its axes, each ordinate that is numbered measurable."""
        plate, hand, axes = self.plate, self.plate.hand, self.axes(row)
        graph = Graph(plate.named(row.key), axes, hand)
        lines = (
            *axes.lines((0.0, plate.cam.turn), row.span, hand, graph.name),
            *self._edges(row, graph),
            *(_polyline(chord, axes, hand.drafted) for chord in row.chords),
            *_exact(row, axes, hand),
            graph.stated(row.letter, [_polyline(row.result, axes, hand.result)]),
            *_given(row, axes, hand),
            *self._impulses(row, graph),
        )
        unit = "" if row.unit == RATIO else f", {plate.drafting.word(row.unit)}"
        ends = graph.ends((plate.cam.turn, letters(plate.cam)[1]), (row.span[1], f"{row.letter}{unit}"))
        return Part(graph.name, lines, (*ends, *self._infinite(row, axes), *self._numbers(row, graph)))

    def _edges(self, row: LawRow, graph: Graph) -> Iterator[Stroke]:
        strips = self.plate.shown.strips
        for k in range(len(strips.edges)) if len(strips.edges) <= MARKED + 1 else self.numbered:
            sides = float(row.after[k]), float(row.before[k])
            yield from graph.station(float(strips.edges[k]), sides, strips.names[k], k, k in self.numbered, DOT)

    def _impulses(self, row: LawRow, graph: Graph) -> Iterator[Stroke]:
        """Draw an arrow up or down to infinity for each impulse."""
        hand, names = graph.hand, self.plate.shown.strips.names
        for k, sense in row.impulses:
            start, tip = self._impulse(row, graph.axes, k, sense)
            head, line = arrowhead(start, tip, hand.symbol), Line(start, tip, hand.result)
            said = Statement(Kind.DIRECTION, graph.name, names[k], k)
            yield line if head is None else stating(said, line, head)

    def _impulse(self, row: LawRow, axes: Axes, k: int, sense: int) -> tuple[complex, complex]:
        at, (low, high) = float(self.plate.shown.strips.edges[k]), row.span
        return axes.on(at), axes.on(at, high if sense > 0 else low)

    def _infinite(self, row: LawRow, axes: Axes) -> Iterator[Letter]:
        for k, sense in row.impulses:
            tip = self._impulse(row, axes, k, sense)[1]
            yield Letter(tip, INFINITE, self.plate.hand.number, 0.0 if sense > 0 else math.pi)

    def _numbers(self, row: LawRow, graph: Graph) -> Iterator[Letter]:
        """Number the edges at the axis, each on the side away from its ordinate or its impulse."""
        strips, impulses = self.plate.shown.strips, dict(row.impulses)
        for k in self.numbered:
            value = -math.inf if impulses.get(k, 1) < 0 else float(row.after[k] + row.before[k])
            yield graph.number(float(strips.edges[k]), strips.names[k], value)

    def bounds(self) -> Iterator[Line]:
        """Draw the bounds of the phases through all the rows."""
        first, last = self.plate.rows[0], self.plate.rows[-1]
        high, low = self.fields[first.key].top, self.fields[last.key].bottom
        for phase in self.plate.cam.phases[1:]:
            at = self.axes(first).on(phase.start).real
            yield Line(complex(at, high), complex(at, low), self.plate.hand.axis)

    def phases(self) -> Iterator[Dimension]:
        """Dimension the phases under the last row."""
        plate, axes = self.plate, self.axes(self.plate.rows[-1])
        level = -1j * LEVEL * plate.hand.number
        for number, phase in enumerate(plate.cam.phases):
            if phase.angle > 0:
                text = phase_letter(plate.cam, number, plate.drafting)
                said = Statement(Kind.LENGTH, plate.named("phases"), f"φ_{number}", scale=axes.across.mu)
                yield Dimension(text, axes.on(phase.start), axes.on(phase.end), level, said)


def _exact(row: LawRow, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Draw the exact curve where it comes out from under the one that is drawn."""
    if row.exact is not None:
        drawn = row.result.y[1:-1] if len(row.result.y) > len(row.exact.y) else row.result.y
        if np.abs(drawn - row.exact.y).max() / axes.up.mu > hand.main / 2:
            yield _polyline(row.exact, axes, hand.other)


def _given(row: LawRow, axes: Axes, hand: Hand) -> Iterator[Circle]:
    """Draw the points of tables, where they can be told apart."""
    radius, spots = GIVEN * hand.symbol, [axes.on(x, y) for x, y in row.given]
    if all(abs(other - spot) > GRAPH_CLEAR * radius for spot, other in pairwise(spots)):
        yield from (Circle(spot, radius, hand.other) for spot in spots)


def _polyline(curve: Plot, axes: Axes, style: LineStyle) -> Polyline:
    points = zip(curve.x.tolist(), curve.y.tolist(), strict=True)
    return Polyline(tuple(apart(axes.on(x, y) for x, y in points)), False, style)


def measure(shown: LawDiagrams, drafting: Drafting) -> Picture:
    """Measure the room of the diagrams."""
    plate = LawPlate(shown, drafting)
    return plate.room(name_of(plate.cam), plate.axis)._replace(open=False, taller=TALLER)


def draw(shown: LawDiagrams, room: Picture, spot: Spot, drafting: Drafting) -> Parts:
    """Draw the diagrams in their spot, the bounds of the phases through them, these dimensioned under them."""
    plate = LawPlate(shown, drafting)
    frame, name = LawFrame(plate, spot), plate.named("phases")
    masks = [around(part.lines[0], CLEAR) for part in frame.parts[: len(plate.rows)]]
    joining = Group(tuple(fit_dashes(trim(frame.bounds(), masks))), plate.named("bounds"))
    sizes = tuple(frame.phases())
    drawn = tuple(line for size in sizes for line in size.draw(drafting.hand))
    phases = LetteredFigure(name, drawn, partial(_lettered, sizes, name, drafting.hand), False)
    return Parts((joining,), (phases, *frame.parts))


def _lettered(sizes: Sequence[Dimension], name: str, hand: Hand, labels: Labels) -> Iterator[Stroke]:
    """Letter the dimensions of the phases over their lines, or under those that are shorter than their letters."""
    for size in sizes:
        if text_width(Text(0j, size.letter, hand.number)) <= size.length:
            label = labels.along(*size.lines[0], size.letter, hand.number, ABOVE, 1.5)
        else:
            label = labels.beside(size.middle, size.letter, hand.number, ABOVE, -math.pi / 2)
        yield telling(name, label)
