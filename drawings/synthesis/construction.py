"""A construction of synthesis on paper: chord, loci, barred arcs, and the mechanism in both extreme places (синтез)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from functools import cached_property

from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.words import Phrase, telling, with_index
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Arc, Circle, Kind, Line, LineStyle, Polyline, Statement, Stroke
from drawings.paper.walk import stating
from drawings.symbols.figure import ROOM, Dimension, Subject, around, heading, heading_width, point
from drawings.symbols.symbols import HEAD, HINGE, STAND, TurnArrow, arrowhead, block, fit_dashes, fixed_hinge, hinge
from drawings.synthesis.due import dimensioned
from drawings.synthesis.due_shown import ShownSynthesis

SYMBOL, UNIT = "l", "m"
MARGINS = Margins(4.0, 2.5, 2.0)
LETTERS = 22.0  # it is drawn at least so many letters high
DOT, BESIDE = 0.9, 1.2  # mm: radius of a point, from it to its letter
OFF, SPARE = 9.0, 0.1  # mm to a dimension line; its share that stays free beyond it
SHARE, NEAR = 0.6, 0.3  # of its shorter leg to an angle, to one about the centre of a circle
APART_BY = 0.75  # of the radius of an angle to that of the next about its vertex
HATCH, APART = 3.0, 2.5  # mm: a stroke of the hatching of an arc, and how far apart they are


def measure(found: ShownSynthesis, drafting: Drafting) -> Picture:
    """Measure the room that a construction needs."""
    hand, title = drafting.hand, _title(found, drafting)
    room = 2 * OFF * hand.symbol
    margins = around(MARGINS, hand, room, room, room)
    width = heading_width(title, hand)
    return picture(found.name, found.known, (SYMBOL, UNIT), margins, width, LETTERS * hand.letter)


def _title(found: ShownSynthesis, drafting: Drafting) -> str:
    return f"{drafting.word('synthesis construction')} {found.letter}".rstrip()


def draw(found: ShownSynthesis, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw a construction in its spot."""
    drawing = _DrawnSynthesis(found, room.place(*spot), drafting)
    head = heading(spot.box, _title(found, drafting), drafting.scale(spot.scale), drafting.hand)
    return LetteredFigure(found.name, (head, *drawing.lines()), drawing.letters)


class _DrawnSynthesis:
    """A construction at its place on paper."""

    def __init__(self, found: ShownSynthesis, place: Place, drafting: Drafting) -> None:
        self.found, self.place, self.hand, self.drafting = found, place, drafting.hand, drafting
        self.spots = {name: place.on(spot) for name, spot in found.places.items()}

    def lines(self) -> Iterator[Stroke]:
        """Draw loci, lines, the mechanism in its other places and in its first, then the points."""
        found, hand, spots = self.found, self.hand, self.found.design.places
        for name, curve in found.circles.items():
            yield stating(Statement(Kind.CURVE, found.name, name), self._chain(curve.tolist(), hand.other))
        for name, curve in found.design.curves.items():
            yield stating(Statement(Kind.CURVE, found.name, name), self._chain(curve.tolist(), hand.path))
        for name, arc in found.barred.items():
            hatched = self._hatched(arc.tolist())
            yield stating(Statement(Kind.CURVE, found.name, name), self._chain(arc.tolist(), hand.other))
            yield from hatched
        for line in found.figure.lines:
            start, end = map(self.place.on, found.cut(*(spots[name] for name in line)))
            yield Line(start, end, hand.drafted)
            if line[1] not in found.places and (head := arrowhead(start, end, hand.symbol)):
                yield head
        for axis in found.figure.axes:
            yield from fit_dashes([self._chain([spots[name] for name in axis], hand.axis)])
        for chain in found.figure.others:
            yield from fit_dashes([self._chain([spots[name] for name in chain], hand.extreme)])
        yield self._chain([spots[name] for name in found.figure.first], hand.result)
        yield from (block(self.place.on(spots[name]), way, hand) for name, way in found.figure.blocks.items())
        yield from (stroke for size in self.sizes.values() for stroke in size.draw(hand))
        for letter, angle in self.angles.items():
            yield stating(Statement(Kind.ANGLE, found.name, letter), *_angle(angle, hand))
        yield from self._points()

    @cached_property
    def sizes(self) -> dict[str, Dimension]:
        """The dimensioned lengths, each beside the mechanism where no point of it stands between."""
        found = self.found
        pairs = ((letter, (self.spots[one], self.spots[other])) for letter, one, other in found.lengths)
        scale = self.place.scale.mu
        return {
            letter: Dimension(
                self._said(letter), *ends, self._off(*ends), Statement(Kind.LENGTH, found.name, letter, scale=scale)
            )
            for letter, ends in pairs
        }

    def _off(self, start: complex, end: complex) -> complex:
        """Give the way to a dimension line: away from the mechanism, past what stands between, or on its other side."""
        along = (end - start) / abs(end - start)
        across = OFF * self.hand.symbol * 1j * along
        middle = self.place.on(self.found.view.centre)
        away = across if ((start - middle) * across.conjugate()).real > 0 else -across
        stands = (self.spots[name] - 1j * STAND[0] * self.hand.symbol for name in self.found.figure.fixed)
        others = [(spot - start) / along for spot in (*self.spots.values(), *stands) if spot not in (start, end)]
        for off in (times * side for times in (1, 2, 3) for side in (away, -away)):
            reach = (off / along).imag
            if not any(0 < spot.imag / reach < 1 + SPARE and 0 < spot.real / abs(end - start) < 1 for spot in others):
                return off
        return away

    @cached_property
    def angles(self) -> dict[str, TurnArrow]:
        """The dimensioned angles, each across the shorter of its legs, those of one vertex inside one another."""
        found, vertices = {}, list[str]()
        for letter, *corners in self.found.angles:
            vertex, start, end = (self.spots[name] for name in corners)
            legs = start - vertex, end - vertex
            share = NEAR if corners[0] in self.found.design.circles else SHARE
            radius = share * APART_BY ** vertices.count(corners[0]) * min(map(abs, legs))
            vertices.append(corners[0])
            found[letter] = TurnArrow(vertex, radius, cmath.phase(legs[0]), cmath.phase(legs[1] / legs[0]))
        return found

    def _said(self, letter: str) -> Phrase:
        return dimensioned(letter, self.found.design.sizes[letter], self.drafting)

    def _points(self) -> Iterator[Stroke]:
        found, hand = self.found, self.hand
        subject = Subject(found.name, SYMBOL, None)
        for name, value in found.places.items():
            spot = self.spots[name]
            hinged = name in found.figure.hinges | found.figure.fixed
            if name in found.figure.fixed:
                yield from fixed_hinge(spot, hand, HINGE * hand.symbol)
            circle = hinge(spot, hand)[0] if hinged else Circle(spot, DOT * hand.symbol, INK)
            yield point(subject, name, value, self.place, circle, "point" if value else "pole")

    def _chain(self, places: Sequence[complex], style: LineStyle) -> Polyline:
        return Polyline(tuple(map(self.place.on, places)), False, style)

    def _hatched(self, arc: list[complex]) -> Iterator[Stroke]:
        """Hatch an arc on its inner side."""
        spots = [self.place.on(spot) for spot in arc]
        middle = sum(spots) / len(spots)
        apart = abs(spots[1] - spots[0])
        if apart * len(spots) < APART * self.hand.symbol:  # there is no room for a stroke
            return
        step = max(round(APART * self.hand.symbol / apart), 1)
        for k in range(0, len(spots) - 1, step):
            along = spots[k + 1] - spots[k]
            inner = 1j * along if ((middle - spots[k]) * (1j * along).conjugate()).real > 0 else -1j * along
            way = (inner + along) / abs(inner + along)
            yield Line(spots[k], spots[k] + HATCH * self.hand.symbol * way, self.hand.drafted)

    def letters(self, labels: Labels) -> Iterator[Stroke]:
        """Letter the points, away from the middle of the figure."""
        middle = sum(self.spots.values()) / len(self.spots)
        for name, spot in self.spots.items():
            side = cmath.phase(spot - middle) if spot != middle else math.pi / 4
            yield labels.beside(spot, with_index(name), self.hand.letter, BESIDE, side)
        for line in (line for line in self.found.figure.lines if line[1] not in self.found.places):
            start, end = map(self.place.on, self.found.cut(*(self.found.design.places[name] for name in line)))
            text = self.drafting.word("centre far", letter=with_index(line[1]))
            yield labels.beside(end, text, self.hand.letter, BESIDE, cmath.phase(end - start))
        for letter, size in self.sizes.items():
            yield self._told(
                labels.along(
                    *size.lines[0], self._said(letter), size=self.hand.number, gap=BESIDE, prefer=cmath.phase(size.off)
                ),
                letter,
            )
        for letter, arc in self.angles.items():
            at, turn = arc.middle
            yield self._told(labels.beside(at, self._said(letter), self.hand.number, BESIDE, turn), letter)

    def _told(self, stroke: Stroke, letter: str) -> Stroke:
        return telling(self.found.name, stroke, self._said(letter))


def _angle(arc: TurnArrow, hand: Hand) -> Iterator[Stroke]:
    """Draw an angle with its arrows within or, where there is no room, outside."""
    head = HEAD[0] * hand.symbol / arc.radius
    if abs(arc.sweep) > ROOM * head:
        yield from arc.angle(hand)
        return
    tail = math.copysign(ROOM * head, arc.sweep)
    first, last = sorted((arc.start, arc.start + arc.sweep))
    yield Arc(arc.centre, arc.radius, first, last, hand.drafted)
    for start, sweep in ((arc.start - tail, tail), (arc.start + arc.sweep + tail, -tail)):
        yield from TurnArrow(arc.centre, arc.radius, start, sweep).draw(hand, hand.drafted)
