"""The figure of a polygon of static moments or of their moments: vectors end to end, and what closes them."""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from drawings.figures.rotor.letters import FEW, MOST, letter, size
from drawings.layout.labels import Labels
from drawings.layout.parallel_offsets import APART, Box, Segment, lanes, moved
from drawings.layout.picture import Margins, Picture, Spot, picture
from drawings.layout.place import Place
from drawings.lettering.lettering import text_width
from drawings.lettering.rotor_letters import lowered
from drawings.page.drafting import Drafting
from drawings.page.page import Field
from drawings.paper.hand import Hand
from drawings.paper.limits import SEEN
from drawings.paper.strokes import LEAN, Group, Line, LineStyle, Stroke, Text
from drawings.symbols.figure import Subject, heading, point
from drawings.symbols.symbols import arrowhead, pole
from plans.rotor.balancing import COUPLES
from plans.rotor.polygon import Polygon as Construction

SYMBOLS = {COUPLES: ("{mDh}", "kg*m2")}  # letter and unit of the scale
SYMBOL = ("{mD}", "kg*m")
MARGINS = Margins(4.0, 2.4, 2.4)  # paper around a polygon for its letters, in their sizes
FLAT = 0.1  # of its length: a polygon that is narrower is drawn in lanes
LETTERS, EACH = 14.0, 1.8  # a polygon is drawn at least so many letters large, and so many for each of its vectors
BESIDE = 0.9  # mm from a vector to its letter
ROOM = 4.7 + 1.9j  # width + 1j * height of a letter between two lanes, in its sizes, with what it keeps clear of them
PAST = 1.0  # mm that the thin lines to a lane run past it
SUM = "Σ"  # before the letters of all vectors together, that stand for more than can be told apart


class Vector(NamedTuple):
    """A vector of the polygon: its name, the true place of its start, its true value, and whether it is a result."""

    name: str
    start: complex
    value: complex
    found: bool = False

    @property
    def end(self) -> complex:
        """The true place of its end."""
        return self.start + self.value


class Polygon(NamedTuple):
    """What a polygon shows: the vectors in the order of laying, the closing one last if there is one."""

    plan: str  # the board: "couples" or "unbalances"
    vectors: tuple[Vector, ...]
    closed: bool  # by itself, so that no vector closes it

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [0j, *(end for one in self.vectors for end in (one.start, one.end))]

    @property
    def subject(self) -> Subject:
        """What its marks belong to."""
        return Subject(self.plan, self.symbol[0].strip("{}"), None)

    @property
    def symbol(self) -> tuple[str, str]:
        """The letter of its scale, and its unit."""
        return SYMBOLS.get(self.plan, SYMBOL)

    def faint(self, mu: float) -> tuple[str, ...]:
        """Name the vectors that are not to be seen at a scale: a sheet lists them beside."""
        return tuple(one.name for one in self.vectors if abs(one.value) < SEEN * mu)


def polygon(drawn: Construction, names: frozenset[str] = frozenset()) -> Polygon:
    """Read a polygon from its record; `names` are vectors in it that are results themselves."""
    vectors = [
        Vector(side.vector.name, complex(side.start.point), complex(side.vector.point), side.vector.name in names)
        for side in drawn.sides
    ]
    if len(vectors) > MOST:
        vectors = _together(vectors, drawn.board.subject)
    if not drawn.closed:
        start = vectors[-1].end if vectors else 0j
        vectors.append(Vector(drawn.closing.name, start, complex(drawn.closing.point), True))
    return Polygon(drawn.board.subject, tuple(vectors), drawn.closed)


def _together(vectors: Sequence[Vector], plan: str) -> list[Vector]:
    """Draw one vector for all that are no results."""
    found = [one for one in vectors if one.found]
    end = found[0].start if found else vectors[-1].end
    return [Vector(sum_letters(plan), 0j, end), *found]


def sum_letters(plan: str) -> str:
    """Letter all vectors of a polygon together."""
    return SUM + SYMBOLS.get(plan, SYMBOL)[0].strip("{}")


class LaidVector(NamedTuple):
    """A vector on paper: its ends, mm, and how far it was shifted from its own place."""

    vector: Vector
    ends: Segment
    shift: complex


@dataclass(frozen=True)
class PolygonFigure:
    """A polygon placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    shown: Polygon
    place: Place
    lines: tuple[Stroke, ...]
    arrows: tuple[LaidVector, ...]  # those that are lettered
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure with the letter of each vector beside it, the shortest served first."""
        spots = [end for arrow in self.arrows for end in arrow.ends]
        middle = sum(spots, 0j) / max(len(spots), 1)
        letters = [labels.beside(self.place.on(0j), "0", self.drafting.hand.letter, 1.6, -cmath.pi / 4)]
        for one, (start, end), shift in sorted(self.arrows, key=lambda arrow: abs(arrow.vector.value)):
            outward = shift or (start + end) / 2 - middle or 1j
            text = letter(one.name, len(self.shown.vectors), self.drafting)
            letters.append(labels.along(start, end, text, size(text, self.drafting), BESIDE, cmath.phase(outward)))
        return (Group((*self.lines, Group(tuple(letters))), self.shown.plan),)


def measure(shown: Polygon, drafting: Drafting) -> Picture:
    """Measure the room that a polygon needs: its points, letters around them, lanes beside a flat one, its heading."""
    hand, points = drafting.hand, np.array(shown.points)
    title = text_width(Text(0j, _title(shown, drafting), hand.title)) + 2 * LEAN * hand.title
    wide, high = float(np.ptp(points.real)), float(np.ptp(points.imag))
    beside = 2 * APART * hand.symbol if min(wide, high) < FLAT * max(wide, high) else 0.0
    side, below, above = (share * hand.letter + beside for share in MARGINS)
    margins = Margins(side, below, above + 2 * hand.title + hand.text)
    least = hand.letter * max(LETTERS, EACH * min(len(shown.vectors), FEW))
    return picture(shown.plan, shown.points, shown.symbol, margins, title, least)


def draw(shown: Polygon, room: Picture, spot: Spot, drafting: Drafting) -> PolygonFigure:
    """Draw the polygon in its spot: results in main lines, the others thinner, title and scale above."""
    place, hand = room.placed(*spot), drafting.hand
    title = heading(spot.box, _title(shown, drafting), _under(shown, spot, drafting), hand)
    zero = point(shown.subject, "0", 0j, place, pole(place.on(0j)), "pole")
    order = sorted(shown.vectors, key=lambda one: (not one.found, -abs(one.value)))
    seen = [one for one in order if place.length(abs(one.value)) >= SEEN]
    segments = [(place.on(one.start), place.on(one.end)) for one in seen]
    shifts = lanes(segments, APART * hand.symbol, ROOM * hand.letter, _inside(spot.box, hand))
    arrows = tuple(
        LaidVector(one, moved(ends, shift), shift) for one, ends, shift in zip(seen, segments, shifts, strict=True)
    )
    short = [LaidVector(one, (place.on(one.start), place.on(one.end)), 0j) for one in order if one not in seen]
    thin = _carried(segments, shifts, hand)
    sides = (_side(shown, one, place, drafting) for one in (*reversed(arrows), *short))
    return PolygonFigure(shown, place, (title, *thin, *sides, zero), arrows, drafting)


def _inside(box: Field, hand: Hand) -> Box:
    """Give the part of a figure's box that a lane may run in: its letter has room beside it, the heading above."""
    wide, high = ROOM.real * hand.letter, ROOM.imag * hand.letter
    return box.left + wide, box.bottom + high, box.right - wide, box.top - 2 * hand.title - hand.text - high


def _side(shown: Polygon, one: LaidVector, place: Place, drafting: Drafting) -> Group:
    hand, vector = drafting.hand, one.vector
    style = hand.result if vector.found else hand.relative
    head = arrowhead(*one.ends, hand.symbol)
    strokes = (Line(*one.ends, style),) if head is None else (Line(*one.ends, style), head)
    data = shown.subject.data("vector", vector.name, vector.value, place.scale)
    return Group(strokes, "", data, letter(vector.name, len(shown.vectors), drafting))


def _carried(segments: list[Segment], shifts: list[complex], hand: Hand) -> list[Stroke]:
    """Draw the thin lines that carry the ends of a vector over to its lane."""
    style = LineStyle(hand.construction)
    return [
        Line(end, end + shift + shift / abs(shift) * PAST * hand.symbol, style)
        for ends, shift in zip(segments, shifts, strict=True) if shift for end in ends
    ]  # fmt: skip


def _title(shown: Polygon, drafting: Drafting) -> str:
    return drafting.word("polygon of moments" if shown.plan == COUPLES else "polygon of static moments")


def _under(shown: Polygon, spot: Spot, drafting: Drafting) -> str:
    """Write the scale; of a polygon that closes by itself that it does, and what is too short to bear a letter."""
    if not shown.vectors:
        return drafting.word("no vectors")
    parts = [drafting.scale(spot.scale)]
    parts += [drafting.word("closes by itself")] if shown.closed else []
    faint = ", ".join(lowered(name, drafting.language) for name in shown.faint(spot.scale.mu))
    parts += [drafting.word("unlettered", names=faint)] if faint else []
    return ";  ".join(parts)
