"""The circular chart: a ring for each mechanism about the main shaft (круговая циклограмма)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass

from drawings.cyclogram import course
from drawings.cyclogram.bar_chart import LARGER, Chart
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.page.scale import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Circle, Group, Line, LineStyle, Stroke, Text
from drawings.paper.walk import tied
from drawings.symbols.figure import heading
from drawings.symbols.symbols import TICK, turning_arrow
from plans.model.cyclogram import Row, Span

NAME, TITLE, RING_NAME = "circle", "cyclogram circle", "ring"
BESIDE_RINGS = f"{RING_NAME}-names"  # the names that have no room in their rings
SYMBOL, UNIT = "φ", "rad"  # it has no scale: its angles are true
HUB, RING = 0.5, 0.3  # the innermost circle, and the breadth of a ring
BAND = 0.12  # of a ring: how far over its inner circle the line of what is done stands
MARGINS = Margins(3.0, 2.4, 2.4)  # paper around it in sizes of its letters
LETTERS = 24.0  # it is drawn at least so many of its letters wide
BESIDE = 0.8  # mm
ARROW = (0.6, math.radians(20), math.radians(100))  # of the hub: radius; start and sweep of the arrow of rotation


@dataclass(frozen=True)
class CircleFigure:
    """The circular chart placed on paper."""

    chart: Chart
    sense: int
    place: Place
    lines: tuple[Group, ...]
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole chart: positions numbered outside, what is too long for its ring lettered beside it."""
        numbers, names = tuple(self._numbers(labels)), tuple(self._names(labels))
        beside = [Group(names, BESIDE_RINGS)] if names else []
        letters = (*numbers, *beside, *self._long(labels), *self._centre(labels))
        return *self.lines, Group(letters, f"{NAME}-letters")

    def _numbers(self, labels: Labels) -> Iterator[Stroke]:
        outer = HUB + RING * len(self.chart.rows)
        for number, turned in enumerate(self.chart.numbered):
            ray = cmath.rect(1.0, self.sense * turned)
            spot = self.place.on(outer * ray) + TICK * ray
            yield labels.beside(spot, str(number), self.drafting.hand.number, BESIDE, self.sense * turned)

    def _names(self, labels: Labels) -> Iterator[Stroke]:
        """Name the rings that have no room for their names where they begin."""
        for k, row in enumerate(self.chart.rows):
            if _named(row, _radius(self.chart, k), self.place, self.drafting) is None:
                turn = self.sense * row.spans[0].start
                spot, name = (
                    self.place.on(cmath.rect(_radius(self.chart, k), turn)),
                    course.name(row, self.drafting),
                )
                yield labels.beside(spot, name, self.drafting.hand.number, BESIDE, turn)

    def _long(self, labels: Labels) -> Iterator[Stroke]:
        for k, row in enumerate(self.chart.rows):
            for span in row.spans:
                text = course.label(span, self.drafting)
                shown = _told(row, span, _radius(self.chart, k), self.place, self.drafting)
                if not _fits(shown, text, _radius(self.chart, k), self.place, self.drafting.hand):
                    middle = self.sense * (span.start + span.end) / 2
                    spot = self.place.on(cmath.rect(_radius(self.chart, k), middle))
                    yield labels.beside(spot, text, self.drafting.hand.number, BESIDE, middle)

    def _centre(self, labels: Labels) -> Iterator[Stroke]:
        radius, start, sweep = ARROW
        spot = self.place.on(cmath.rect(HUB * radius, self.sense * (start + sweep / 2)))
        yield labels.beside(spot, "ω", self.drafting.hand.letter, BESIDE, self.sense * (start + sweep / 2))


def measure(chart: Chart, drafting: Drafting) -> Picture:
    """Measure the room that it needs."""
    hand, outer = drafting.hand, HUB + RING * len(chart.rows)
    title = text_width(Text(0j, drafting.word(TITLE), hand.title))
    side, below, above = (share * hand.letter for share in MARGINS)
    margins = Margins(side, below, above + 2 * hand.title + hand.text)
    corners = [complex(x, y) for x in (-outer, outer) for y in (-outer, outer)]
    least = LETTERS * hand.letter
    return picture(NAME, corners, (SYMBOL, UNIT), margins, title, least)._replace(most=LARGER * least)


def draw(chart: Chart, sense: int, room: Picture, spot: Spot, drafting: Drafting) -> CircleFigure:
    """Draw it in its spot: circles, the rings' spans, where angles are counted from, the sense of rotation."""
    place, hand = room.place(*spot), drafting.hand
    title = heading(spot.box, drafting.word(TITLE), drafting.word("cyclogram counted"), hand)
    rings = tuple(
        Group(tuple(_ring(row, _radius(chart, k), sense, place, drafting)), f"{RING_NAME}-{k}")
        for k, row in enumerate(chart.rows)
    )
    return CircleFigure(
        chart, sense, place, (Group((title, *_still(chart, sense, place, hand), *rings), NAME),), drafting
    )


def _radius(chart: Chart, k: int) -> float:
    """Give the middle radius of a row's ring; the first is the outermost."""
    return HUB + RING * (len(chart.rows) - k - 0.5)


def _fits(span: Span, text: str, radius: float, place: Place, hand: Hand) -> bool:
    """Tell whether a text has room along its ring: between the ends of its span, straight though the ring is round."""
    wide, far = text_width(Text(0j, text, hand.number, "middle", True)), place.length(radius)
    room = 2 * far * math.sin(min(span.end - span.start, math.pi) / 2)
    off = wide**2 / (8 * far)  # of the middle of a chord from its arc
    return wide + 4 * BESIDE <= room and off + hand.number / 2 <= place.length(RING) / 2 - 2 * BESIDE


def _named(row: Row, radius: float, place: Place, drafting: Drafting) -> Span | None:
    """Give the part of the longest span that bears the name of its ring; None: it has no room for it."""
    longest = max(row.spans, key=lambda span: span.end - span.start)
    half = longest._replace(end=(longest.start + longest.end) / 2)
    name = course.name(row, drafting)
    return half if _fits(half, name, radius, place, drafting.hand) else None


def _told(row: Row, span: Span, radius: float, place: Place, drafting: Drafting) -> Span:
    """Give the part of a span that bears its angle: what the name of its ring leaves."""
    named = _named(row, radius, place, drafting)
    return span._replace(start=named.end) if named is not None and named.start == span.start else span


def _still(chart: Chart, sense: int, place: Place, hand: Hand) -> Iterator[Stroke]:
    centre, outer = place.on(0j), HUB + RING * len(chart.rows)
    for k in range(len(chart.rows) + 1):
        yield Circle(centre, place.length(HUB + RING * k), LineStyle(hand.construction))
    yield Line(centre, place.on(complex(HUB)), hand.axis)
    radius, start, sweep = ARROW
    yield from turning_arrow(centre, place.length(HUB * radius), sense * start, sense * sweep, hand)
    for turned in chart.numbered:
        ray = cmath.rect(1.0, sense * turned)
        yield Line(place.on(outer * ray) - TICK * ray, place.on(outer * ray) + TICK * ray, hand.other)


def _ring(row: Row, radius: float, sense: int, place: Place, drafting: Drafting) -> Iterator[Stroke]:
    """Draw the spans of a ring: a line where each begins, the line of what is done, its letters along it."""
    hand, centre = drafting.hand, place.on(0j)
    inner = radius - RING / 2
    for span in row.spans:
        ray = cmath.rect(1.0, sense * span.start)
        yield Line(place.on(inner * ray), place.on((inner + RING) * ray), hand.other)
        low, high = sorted((sense * span.start, sense * span.end))
        style = hand.result if course.moves(span) else hand.drafted
        yield Arc(centre, place.length(inner + BAND * RING), low, high, style)
        text, own = course.label(span, drafting), _told(row, span, radius, place, drafting)
        if _fits(own, text, radius, place, hand):
            yield _along(text, sense * (own.start + own.end) / 2, place.length(radius), centre, hand)
    named = _named(row, radius, place, drafting)
    if named is not None:
        yield _along(
            course.name(row, drafting),
            sense * (named.start + named.end) / 2,
            place.length(radius),
            centre,
            hand,
        )


def _along(text: str, turn: float, radius: float, centre: complex, hand: Hand) -> Text:
    """Write along a ring, upright as it is read."""
    up = tied(math.sin(turn)) >= 0
    way = turn - math.pi / 2 if up else turn + math.pi / 2
    spot = centre + cmath.rect(radius, turn) - cmath.rect(0.35 * hand.number, way + math.pi / 2)
    return Text(spot, text, hand.number, "middle", True, math.degrees(way))
