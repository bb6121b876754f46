"""Vectors end to end: side by side where they run along one another, lettered beside them (многоугольник)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Collection, Iterator, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from drawings.kinds import working
from drawings.kinds.working import Workings
from drawings.layout.labels import Labels, Lines
from drawings.layout.parallel_offsets import APART, Box, Segment, offset, parallel_offsets
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.page.page import Drafting, Field, Scale
from drawings.paper.hand import Hand
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Group, Line, LineStyle, Stroke
from drawings.paper.walk import tied, tied_spot
from drawings.symbols.figure import Subject, around, heading, heading_width, point
from drawings.symbols.symbols import arrowhead, pole

FLAT = 0.1  # of its length: a polygon that is narrower is drawn in lanes
BESIDE = 0.9  # mm from a vector to its letter
HIGH = 1.9  # sizes of a letter: the height of one between two lanes, with what it keeps clear of them
PAST = 1.0  # mm that the thin lines to a lane run past it


class ShownVector(NamedTuple):
    """A vector as a figure shows it in its own true units, N, m or m/s: where it begins or acts, and its value."""

    name: str
    kind: str  # what it is on its figure
    at: complex
    value: complex
    spot: str = ""  # the letter of the point there, if it is one

    @property
    def end(self) -> complex:
        """The true place of its end in a polygon."""
        return self.at + self.value

    @property
    def direction(self) -> complex:
        """Its unit direction; a vector that is zero has none."""
        return self.value / abs(self.value)

    @property
    def moment(self) -> float:
        """Its moment about the figure's zero: W of a force on a lever."""
        return (self.at.conjugate() * self.value).imag


class LaidVector(NamedTuple):
    """A vector of a polygon on paper: its ends, mm, and how far it was shifted from its own place."""

    vector: ShownVector
    ends: Segment
    shift: complex = 0j

    def draw(self, subject: Subject, letter: str, place: Place, style: LineStyle, hand: Hand) -> Group:
        """Draw it, measurable, with its arrowhead; one whose head is no wider than its line by a thinner pen."""
        head = arrowhead(*self.ends, hand.symbol)
        wide = abs(head.points[1] - head.points[2]) if head is not None else 0.0
        line = Line(*self.ends, next((pen for pen in (style, hand.relative) if 2 * pen.width <= wide), hand.other))
        strokes = (line,) if head is None else (line, head)
        data = subject.data("vector", self.vector.name, self.vector.value, place.scale)
        return Group(strokes, "", data, letter)


def margins(points: Sequence[complex], sizes: Margins, hand: Hand) -> Margins:
    """Give the paper around a polygon, mm: its letters, given in their sizes, lanes beside a flat one, its heading."""
    spots = np.array(points)
    wide, high = float(np.ptp(spots.real)), float(np.ptp(spots.imag))
    beside = 2 * APART * hand.symbol if min(wide, high) < FLAT * max(wide, high) else 0.0
    return around(sizes, hand, beside, beside, beside)


def ends(vector: ShownVector, place: Place) -> Segment:
    """Give the ends of a vector at its own place on paper."""
    return place.on(vector.at), place.on(vector.end)


class Chain(NamedTuple):
    """Vectors laid on paper: those that are seen, and those that are too short to bear a letter."""

    seen: tuple[LaidVector, ...]
    short: tuple[LaidVector, ...]

    def sides(self, subject: Subject, thin: str, letter: Callable[[str], str], place: Place, hand: Hand) -> list[Group]:
        """Draw them, measurable, those of the `thin` kind in thinner lines; what keeps its place lies on top."""
        found = []
        for side in (*reversed(self.seen), *self.short):
            style = hand.relative if side.vector.kind == thin else hand.result
            found.append(side.draw(subject, letter(side.vector.name), place, style, hand))
        return found


def lay(
    vectors: Sequence[ShownVector],
    thin: str,
    place: Place,
    box: Field,
    wide: float,
    hand: Hand,
    least: float = 0.0,
    enlarged: Collection[str] = (),
) -> Chain:
    """Lay vectors, in lanes where they run along one another: the longest keeps its place, before any `thin` one.

    A letter between two lanes is so many of its sizes `wide`. What is shorter than the `least`, mm, is a point.
    What is `enlarged` elsewhere keeps its place too, and has its letter there.
    """
    lengths = {vector: place.length(abs(vector.value)) for vector in vectors}
    order = sorted(lengths, key=lambda vector: (vector.kind == thin, -tied(lengths[vector])))
    long = [vector for vector in order if tied(lengths[vector]) >= SEEN and vector.name not in enlarged]
    short = (vector for vector in lengths if vector not in long and lengths[vector] >= least)
    return Chain(
        _lanes(long, place, box, complex(wide, HIGH), hand),
        tuple(LaidVector(side, ends(side, place)) for side in short),
    )


def _lanes(order: Sequence[ShownVector], place: Place, box: Field, room: complex, hand: Hand) -> tuple[LaidVector, ...]:
    """Lay vectors in their lanes; of several that run along one another the first keeps its place.

    A letter between two lanes has a room of width + 1j * height, in its sizes.
    """
    segments = [ends(vector, place) for vector in order]
    wide, high = room.real * hand.letter, room.imag * hand.letter  # of a letter beside the outermost lane
    top = box.top - 2 * hand.title - hand.text - high
    inside: Box = (box.left + wide, box.bottom + high, box.right - wide, top)
    shifts = parallel_offsets(segments, APART * hand.symbol, room * hand.letter, inside)
    placed = zip(order, segments, shifts, strict=True)
    return tuple(LaidVector(vector, offset(line, shift), shift) for vector, line, shift in placed)


def carriers(arrows: Sequence[LaidVector], place: Place, hand: Hand) -> list[Stroke]:
    """Draw the thin lines that carry the ends of vectors over to their lanes."""
    style = LineStyle(hand.construction)
    return [
        Line(end, end + arrow.shift + arrow.shift / abs(arrow.shift) * PAST * hand.symbol, style)
        for arrow in arrows
        if arrow.shift
        for end in ends(arrow.vector, place)
    ]


def letters(
    arrows: Sequence[LaidVector], mark: Callable[[str], tuple[str, float]], labels: Labels, more: Lines = ()
) -> list[Stroke]:
    """Letter each vector on its outer side, nearest to it, not to `more`, the shortest first; `mark` gives how."""
    spots = [end for arrow in arrows for end in arrow.ends]
    middle = sum(spots, 0j) / max(len(spots), 1)
    strokes = []
    for vector, (start, end), shift in sorted(arrows, key=lambda arrow: tied(abs(arrow.ends[1] - arrow.ends[0]))):
        outward = shift or tied_spot((start + end) / 2 - middle) or 1j
        others = [*(arrow.ends for arrow in arrows if arrow.vector is not vector), *more]
        strokes.append(labels.along(start, end, *mark(vector.name), BESIDE, cmath.phase(outward), others))
    return strokes


FEW = 9  # vectors: of more each is numbered alone
SIDE, RESULT = "side", "result"  # what a vector is: given, or found
LANE = 2.4  # sizes of a letter: paper over and under a polygon


class Letters(NamedTuple):
    """How vectors are lettered: with their indices lowered, or where they are many by their numbers alone."""

    lower: Callable[[str], str]
    number: Callable[[str], str]  # "" of one that has none

    def of(self, name: str, count: int, hand: Hand) -> tuple[str, float]:
        """Letter one of so many; give the size of its letter too, mm: numbers alone are smaller."""
        text = (self.number(name) if count > FEW else "") or self.lower(name)
        return text, hand.number if text.isdigit() else hand.letter


class Sizes(NamedTuple):
    """What a polygon wants for its letters, in their sizes."""

    least: float  # it is drawn at least so large
    each: float  # and so large for each of its vectors
    wide: float  # a letter between two lanes, with what it keeps clear of them
    side: float = 4.0  # paper beside it


class Polygon(NamedTuple):
    """A polygon as a sheet shows it: its vectors in the order of laying, their sum or what closes them last, if any."""

    name: str  # of the figure, and of the plan of its marks
    title: str
    scale: tuple[str, str]  # letter and unit
    vectors: tuple[ShownVector, ...]
    closed: bool  # by itself
    letters: Letters
    sizes: Sizes
    position: int | None = None

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [0j, *(end for vector in self.vectors for end in (vector.at, vector.end))]

    @property
    def subject(self) -> Subject:
        """What its marks belong to."""
        return Subject(self.name, self.scale[0].strip("{}"), self.position)

    def mark(self, name: str, hand: Hand) -> tuple[str, float]:
        """Give the letter of a vector, and its size, mm."""
        return self.letters.of(name, len(self.vectors), hand)

    def under(self, scale: Scale, drafting: Drafting) -> str:
        """Write the scale; of a polygon that closes by itself that it does, and what is too short to bear a letter."""
        if not self.vectors:
            return drafting.word("no vectors")
        parts = [drafting.scale(scale)]
        parts += [drafting.word("closes by itself")] if self.closed else []
        faint = ", ".join(self.letters.lower(side.name) for side in self.vectors if abs(side.value) < SEEN * scale.mu)
        parts += [drafting.word("unlettered", names=faint)] if faint else []
        return ";  ".join(parts)

    def working(self, drafting: Drafting) -> Workings:
        """Write beside it how long its vectors are drawn."""
        sizes = {self.letters.lower(vector.name): abs(vector.value) for vector in self.vectors}
        return working.segment_working(sizes, self.subject.quantity, self.name, drafting)


def measure(shown: Polygon, drafting: Drafting) -> Picture:
    """Measure the room that a polygon needs: its points, letters around them, lanes beside a flat one, its heading."""
    hand, sizes = drafting.hand, shown.sizes
    paper = margins(shown.points, Margins(sizes.side, LANE, LANE), hand)
    least = hand.letter * max(sizes.least, sizes.each * min(len(shown.vectors), FEW))
    return picture(shown.name, shown.points, shown.scale, paper, heading_width(shown.title, hand), least)


def draw(shown: Polygon, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the polygon in its spot: results in main lines, the others thinner, title and scale above."""
    place, hand = room.place(*spot), drafting.hand
    chain = lay(shown.vectors, SIDE, place, spot.box, shown.sizes.wide, hand)
    lines = (
        heading(spot.box, shown.title, shown.under(spot.scale, drafting), hand),
        *carriers(chain.seen, place, hand),
        *chain.sides(shown.subject, SIDE, lambda name: shown.mark(name, hand)[0], place, hand),
        point(shown.subject, "0", 0j, place, pole(place.on(0j)), "pole"),
    )
    return LetteredFigure(shown.name, lines, partial(_letter, shown, chain, place.on(0j), hand))


def _letter(shown: Polygon, chain: Chain, zero: complex, hand: Hand, labels: Labels) -> Iterator[Stroke]:
    """Letter the beginning, and each vector beside it."""
    yield labels.beside(zero, "0", hand.letter, 1.6, -math.pi / 4)
    yield from letters(chain.seen, lambda name: shown.mark(name, hand), labels)
