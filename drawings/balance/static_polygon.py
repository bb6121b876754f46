"""The polygon of static moments m_i·r_Si laid end to end from the datum, and their sum m·r_S (8.6) (рис. 8.5)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.lettering.vector_letters import RESULT, lowered
from drawings.page.scale import Drafting
from drawings.paper.limits import SEEN
from drawings.paper.strokes import LEAN, Group, Stroke, Text
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.polygon import LaidVector, ShownVector, carriers, ends, lay, letters, margins
from drawings.symbols.symbols import pole

NAME, SYMBOL, UNIT, SCALE = "static-moments", "mr", "kg*m", "{mr}"
MARGINS = Margins(4.2, 2.4, 2.4)  # paper around the polygon for its letters, in their sizes
LETTERS = 16.0  # it is drawn at least so many of its letters large
ROOM = 5.0 + 1.9j  # width + 1j * height of a letter between two lanes, in its sizes
SIDE, SUM = "side", "sum"  # what a vector is


class StaticPolygon(NamedTuple):
    """The static moments of a position, kg*m, in the order of laying; their sum comes last, if it is not zero."""

    position: int
    vectors: tuple[ShownVector, ...]

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [0j, *(end for one in self.vectors for end in (one.at, one.end))]

    @property
    def subject(self) -> Subject:
        """What its marks belong to."""
        return Subject(NAME, SYMBOL, self.position)


def polygon(position: int, moments: Mapping[str, complex], least: float) -> StaticPolygon:
    """Lay static moments kg*m end to end by their letters; what is no more than `least` has no direction."""
    vectors, end = list[ShownVector](), 0j
    for name, value in moments.items():
        if abs(value) > least:
            vectors.append(ShownVector(name, SIDE, end, value))
            end += value
    if abs(end) > least:
        vectors.append(ShownVector(RESULT, SUM, 0j, end))
    return StaticPolygon(position, tuple(vectors))


@dataclass(frozen=True)
class StaticPolygonFigure:
    """The polygon placed on paper: its lines, and the letters still to be placed among those of all figures."""

    shown: StaticPolygon
    place: Place
    lines: tuple[Stroke, ...]
    arrows: tuple[LaidVector, ...]
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure with the letter of each vector beside it."""
        zero = labels.beside(self.place.on(0j), "0", self.drafting.hand.letter, 1.6, -math.pi / 4)
        beside = letters(self.arrows, self._mark, labels)
        return (Group((*self.lines, Group((zero, *beside))), NAME),)

    def _mark(self, name: str) -> tuple[str, float]:
        return lowered(name), self.drafting.hand.letter


def measure(shown: StaticPolygon, drafting: Drafting) -> Picture:
    """Measure the room that a polygon needs: its points, letters around them, lanes beside a flat one, its heading."""
    hand = drafting.hand
    title = text_width(Text(0j, _title(shown, drafting), hand.title)) + 2 * LEAN * hand.title
    return picture(
        NAME, shown.points, (SCALE, UNIT), margins(shown.points, MARGINS, hand), title, LETTERS * hand.letter
    )


def draw(shown: StaticPolygon, room: Picture, spot: Spot, drafting: Drafting) -> StaticPolygonFigure:
    """Draw the polygon in its spot: the sum in a main line, the others thinner, title and scale above."""
    place, hand = room.place(*spot), drafting.hand
    order = sorted(shown.vectors, key=lambda one: (one.kind != SUM, -abs(one.value)))
    seen = [one for one in order if place.length(abs(one.value)) >= SEEN]
    arrows = lay(seen, place, spot.box, ROOM, hand)
    short = (LaidVector(one, ends(one, place)) for one in order if one not in seen)
    lines = (
        heading(spot.box, _title(shown, drafting), _under(shown, spot, drafting), hand),
        *carriers(arrows, place, hand),
        *(_side(shown, one, place, drafting) for one in (*reversed(arrows), *short)),
        point(shown.subject, "0", 0j, place, pole(place.on(0j)), "pole"),
    )
    return StaticPolygonFigure(shown, place, lines, arrows, drafting)


def _side(shown: StaticPolygon, one: LaidVector, place: Place, drafting: Drafting) -> Group:
    hand = drafting.hand
    style = hand.result if one.vector.kind == SUM else hand.relative
    return one.draw(shown.subject, lowered(one.vector.name), place, style, hand.symbol)


def _title(shown: StaticPolygon, drafting: Drafting) -> str:
    return f"{drafting.word('polygon of static moments')}, {drafting.word('position', position=shown.position)}"


def _under(shown: StaticPolygon, spot: Spot, drafting: Drafting) -> str:
    """Write the scale; of a polygon that closes by itself that it does."""
    if not shown.vectors:
        return drafting.word("no vectors")
    closed = shown.vectors[-1].kind != SUM
    return ";  ".join([drafting.scale(spot.scale), *([drafting.word("closes by itself")] if closed else [])])
