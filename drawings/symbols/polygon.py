"""Vectors laid end to end: side by side where they run along one another, lettered beside them (многоугольник)."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from drawings.layout.labels import Labels
from drawings.layout.parallel_offsets import APART, Box, Segment, offset, parallel_offsets
from drawings.layout.picture import Margins, Place
from drawings.page.page import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, LineStyle, Stroke
from drawings.paper.walk import tied
from drawings.symbols.figure import Subject
from drawings.symbols.symbols import arrowhead

FLAT = 0.1  # of its length: a polygon that is narrower is drawn in lanes
BESIDE = 0.9  # mm from a vector to its letter
PAST = 1.0  # mm that the thin lines to a lane run past it


class ShownVector(NamedTuple):
    """A vector as a figure shows it, before it is put on paper: where it begins or acts, and its value.

    The place is in the figure's own true units: N of a polygon of forces, m of a scheme, m/s of a lever.
    """

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

    def draw(self, subject: Subject, letter: str, place: Place, style: LineStyle, symbol: float) -> Group:
        """Draw it, measurable, with its arrowhead."""
        head = arrowhead(*self.ends, symbol)
        strokes = (Line(*self.ends, style),) if head is None else (Line(*self.ends, style), head)
        data = subject.data("vector", self.vector.name, self.vector.value, place.scale)
        return Group(strokes, "", data, letter)


def margins(points: Sequence[complex], sizes: Margins, hand: Hand) -> Margins:
    """Give the paper around a polygon, mm: its letters, given in their sizes, lanes beside a flat one, its heading."""
    spots = np.array(points)
    wide, high = float(np.ptp(spots.real)), float(np.ptp(spots.imag))
    beside = 2 * APART * hand.symbol if min(wide, high) < FLAT * max(wide, high) else 0.0
    side, below, above = (size * hand.letter + beside for size in sizes)
    return Margins(side, below, above + 2 * hand.title + hand.text)


def ends(one: ShownVector, place: Place) -> Segment:
    """Give the ends of a vector at its own place on paper."""
    return place.on(one.at), place.on(one.end)


def lay(order: Sequence[ShownVector], place: Place, box: Field, room: complex, hand: Hand) -> tuple[LaidVector, ...]:
    """Lay vectors in their lanes; of several that run along one another the first keeps its place.

    A letter between two lanes has a room of width + 1j * height, in its sizes.
    """
    segments = [ends(one, place) for one in order]
    wide, high = room.real * hand.letter, room.imag * hand.letter  # of a letter beside the outermost lane
    top = box.top - 2 * hand.title - hand.text - high
    inside: Box = (box.left + wide, box.bottom + high, box.right - wide, top)
    shifts = parallel_offsets(segments, APART * hand.symbol, room * hand.letter, inside)
    placed = zip(order, segments, shifts, strict=True)
    return tuple(LaidVector(one, offset(line, shift), shift) for one, line, shift in placed)


def carriers(arrows: Sequence[LaidVector], place: Place, hand: Hand) -> list[Stroke]:
    """Draw the thin lines that carry the ends of vectors over to their lanes."""
    style = LineStyle(hand.construction)
    return [
        Line(end, end + arrow.shift + arrow.shift / abs(arrow.shift) * PAST * hand.symbol, style)
        for arrow in arrows
        if arrow.shift
        for end in ends(arrow.vector, place)
    ]


def letters(arrows: Sequence[LaidVector], mark: Callable[[str], tuple[str, float]], labels: Labels) -> list[Stroke]:
    """Letter each vector on its outer side, the shortest served first; `mark` gives a name's letter and its size."""
    spots = [end for arrow in arrows for end in arrow.ends]
    middle = sum(spots, 0j) / max(len(spots), 1)
    strokes = []
    for one, (start, end), shift in sorted(arrows, key=lambda arrow: tied(abs(arrow.ends[1] - arrow.ends[0]))):
        outward = shift or (start + end) / 2 - middle or 1j
        strokes.append(labels.along(start, end, *mark(one.name), BESIDE, cmath.phase(outward)))
    return strokes
