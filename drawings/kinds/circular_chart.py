"""The circular chart: a ring for each mechanism about the main shaft (круговая циклограмма)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

from drawings.kinds import course
from drawings.kinds.bar_chart import Chart, ChartFigure
from drawings.layout.ink import LETTERED
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.page.page import Drafting
from drawings.paper.strokes import INK, Arc, Circle, Group, Line, LineStyle, Stroke, Text
from drawings.paper.walk import tied
from drawings.symbols.figure import around, heading
from drawings.symbols.symbols import TICK, TurnArrow
from plans.model.cyclogram import BarRow, Period

NAME, TITLE, RING_NAME = "circle", "cyclogram circle", "ring"
BESIDE_RINGS = f"{RING_NAME}-names"  # the names that have no room in their rings
SYMBOL, UNIT = "φ", "rad"  # it has no scale: its angles are true
HUB, RING = 0.5, 0.3  # the innermost circle, and the breadth of a ring
BAND = 0.12  # of a ring: how far over its inner circle the line of what is done stands
MARGINS = Margins(3.0, 2.4, 2.4)  # paper around it in sizes of its letters
LETTERS, MOST = 24.0, 60.0  # it is drawn at least so many of its letters wide, and at most so many
BESIDE = 0.8  # mm
DOT = 0.6  # mm, radius of the dot that a leader ends with in its ring
SHARES = (0.25, 0.75, 0.15, 0.85, 0.35, 0.65)  # of a span, where it may end
ARROW = (0.6, math.radians(20), math.radians(100))  # of the hub: radius; start and sweep of the arrow of rotation


def measure(chart: Chart, drafting: Drafting) -> Picture:
    """Measure the room that it needs."""
    hand, outer = drafting.hand, HUB + RING * len(chart.rows)
    title = text_width(Text(0j, drafting.word(TITLE), hand.title))
    corners = [complex(x, y) for x in (-outer, outer) for y in (-outer, outer)]
    least = LETTERS * hand.letter
    return picture(NAME, corners, (SYMBOL, UNIT), around(MARGINS, hand), title, least)._replace(most=MOST * hand.letter)


def draw(chart: Chart, room: Picture, spot: Spot, drafting: Drafting) -> CircleFigure:
    """Draw it in its spot."""
    title = heading(spot.box, drafting.word(TITLE), drafting.word("cyclogram counted"), drafting.hand)
    return CircleFigure(chart, room.place(*spot), title, drafting)


class Ring(NamedTuple):
    """A row as a ring of the chart: its middle radius; the part of its longest span that bears its name, if any."""

    row: BarRow
    radius: float
    named: Period | None

    @property
    def bare(self) -> Iterator[float]:
        """Turns off the middles of its spans, which bear letters; of the longest span first."""
        for span in sorted(self.row.spans, key=lambda span: span.start - span.end):
            yield from (span.start + share * (span.end - span.start) for share in SHARES)

    def stated(self, span: Period) -> Period:
        """Give the part of a span that bears its angle: what the name of the ring leaves."""
        return span if self.named is None or self.named.start != span.start else span._replace(start=self.named.end)


class CircleFigure(ChartFigure):
    """The circular chart placed on paper."""

    @cached_property
    def lines(self) -> tuple[Group, ...]:
        """All that is drawn before any letter is placed: where angles are counted from, the sense, the rings."""
        rings = (Group(tuple(self._ring(ring)), f"{RING_NAME}-{k}") for k, ring in enumerate(self._rings))
        return (Group((self.title, *self._still(), *rings), NAME),)

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole chart: positions numbered outside, what is too long for its ring lettered beside it."""
        stations = enumerate(self.chart.numbered)
        numbers = [self._beside(labels, str(k), self._outer, turned, TICK) for k, turned in stations]
        names = tuple(self._names(labels))
        beside = [Group(names, BESIDE_RINGS)] if names else []
        return *self.lines, Group((*numbers, *beside, *self._long(labels), self._speed(labels)), f"{NAME}-letters")

    @cached_property
    def _rings(self) -> tuple[Ring, ...]:
        """The rings from the outermost one."""
        count = len(self.chart.rows)
        radii = (HUB + RING * (count - k - 0.5) for k in range(count))
        return tuple(Ring(row, far, self._named(row, far)) for row, far in zip(self.chart.rows, radii, strict=True))

    @property
    def _outer(self) -> float:
        return HUB + RING * len(self.chart.rows)

    def _ray(self, turned: float) -> complex:
        """Give the direction of a turn of the shaft on the sheet."""
        return cmath.rect(1.0, self.chart.sense * turned)

    def _named(self, row: BarRow, radius: float) -> Period | None:
        """Give the part of the longest span that bears the name of a row; None: it has no room for it."""
        longest = max(row.spans, key=lambda span: span.end - span.start)
        half = longest._replace(end=(longest.start + longest.end) / 2)
        return half if self._fits(half, course.name(row, self.drafting), radius) else None

    def _fits(self, span: Period, text: str, radius: float) -> bool:
        """Tell whether a text has room along a ring: between the ends of a span, straight though the ring is round."""
        size, far = self.hand.number, self.place.length(radius)
        wide = text_width(Text(0j, text, size, "middle", True))
        room = 2 * far * math.sin(min(span.end - span.start, math.pi) / 2)
        off = wide**2 / (8 * far)  # of the middle of a chord from its arc
        return wide + 4 * BESIDE <= room and off + size / 2 <= self.place.length(RING) / 2 - 2 * BESIDE

    def _still(self) -> Iterator[Stroke]:
        """Draw the circles, where angles are counted from, the arrow of rotation, the ticks of the positions."""
        centre, hand, sense = self.place.on(0j), self.hand, self.chart.sense
        for k in range(len(self.chart.rows) + 1):
            yield Circle(centre, self.place.length(HUB + RING * k), LineStyle(hand.construction))
        yield Line(centre, self.place.on(complex(HUB)), hand.axis)
        radius, start, sweep = ARROW
        yield from TurnArrow(centre, self.place.length(HUB * radius), sense * start, sense * sweep).draw(hand)
        for ray in map(self._ray, self.chart.numbered):
            spot = self.place.on(self._outer * ray)
            yield Line(spot - TICK * ray, spot + TICK * ray, hand.other)

    def _ring(self, ring: Ring) -> Iterator[Stroke]:
        """Draw the spans of a ring: a line where each begins, the line of what is done, its letters along it."""
        inner, sense = ring.radius - RING / 2, self.chart.sense
        for span in ring.row.spans:
            ray = self._ray(span.start)
            yield Line(self.place.on(inner * ray), self.place.on((inner + RING) * ray), self.hand.other)
            low, high = sorted((sense * span.start, sense * span.end))
            style = self.hand.result if course.moves(span) else self.hand.drafted
            yield Arc(self.place.on(0j), self.place.length(inner + BAND * RING), low, high, style)
            text, shown = course.doing(span, self.drafting), ring.stated(span)
            if self._fits(shown, text, ring.radius):
                yield self._along(text, shown, ring.radius)
        if ring.named is not None:
            yield self._along(course.name(ring.row, self.drafting), ring.named, ring.radius)

    def _along(self, text: str, span: Period, radius: float) -> Text:
        """Write along a ring in the middle of a span, upright as it is read."""
        turn, size = self.chart.sense * (span.start + span.end) / 2, self.hand.number
        way = turn - math.pi / 2 if tied(math.sin(turn)) >= 0 else turn + math.pi / 2
        spot = self.place.on(0j) + cmath.rect(self.place.length(radius), turn)
        return Text(spot - cmath.rect(0.35 * size, way + math.pi / 2), text, size, "middle", True, math.degrees(way))

    def _beside(self, labels: Labels, text: str, radius: float, turned: float, off: float = 0.0) -> Stroke:
        """Letter a place of the chart outward."""
        ray = self._ray(turned)
        spot = self.place.on(radius * ray) + off * ray
        return labels.beside(spot, text, self.hand.number, BESIDE, self.chart.sense * turned)

    def _names(self, labels: Labels) -> Iterator[Stroke]:
        """Name outside the chart the rings that have no room for it, with leaders that end in their middles."""
        for ring in self._rings:
            if ring.named is None:
                name = course.name(ring.row, self.drafting)
                ways = (self._led(labels, name, ring, turned) for turned in ring.bare)
                led = next((way for way in ways if way is not None), None)
                yield led or self._beside(labels, name, ring.radius, ring.row.spans[0].start)

    def _led(self, labels: Labels, name: str, ring: Ring, turned: float) -> Stroke | None:
        """Name a ring at the end of a ray from its middle; None where that crosses letters or has no room."""
        ray, size = self._ray(turned), self.hand.number
        start, end = self.place.on(ring.radius * ray), self.place.on(self._outer * ray) + (TICK + size) * ray
        sides = (0.5j * size * ray, -0.5j * size * ray)  # beside its letters it would be read as theirs
        if any(labels.ink.along(start + off, end + off)[0] >= LETTERED for off in sides):
            return None
        label = labels.close(end, name, size, BESIDE, self.chart.sense * turned)
        dot = Circle(start, DOT * self.hand.symbol, INK)
        return label and Group((Line(start, end, self.hand.drafted), dot, label))

    def _long(self, labels: Labels) -> Iterator[Stroke]:
        """Letter the spans whose letters have no room along their ring."""
        for ring in self._rings:
            for span in ring.row.spans:
                text = course.doing(span, self.drafting)
                if not self._fits(ring.stated(span), text, ring.radius):
                    yield self._beside(labels, text, ring.radius, (span.start + span.end) / 2)

    def _speed(self, labels: Labels) -> Stroke:
        """Letter the arrow of rotation."""
        radius, start, sweep = ARROW
        middle = self.chart.sense * (start + sweep / 2)
        spot = self.place.on(cmath.rect(HUB * radius, middle))
        return labels.beside(spot, "ω", self.hand.letter, BESIDE, middle)
