"""Pictures before and on paper: what a figure shows in true units, its place, its letters (место фигуры)."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import groupby, islice, pairwise
from typing import NamedTuple, Protocol

import numpy as np

from drawings.layout.labels import Labels
from drawings.page.page import Field, Scale, fitting
from drawings.paper.strokes import NO_DATA, Box, Group, Stroke
from drawings.paper.walk import PLACES, tied


class Place(NamedTuple):
    """Where a plan's true values lie on paper: `zero` in true units lies at `origin`, mm."""

    origin: complex
    zero: complex
    scale: Scale

    def on(self, value: complex) -> complex:
        """Give the place on paper of a true value."""
        return self.origin + (value - self.zero) / self.scale.mu

    def length(self, size: float) -> float:
        """Give a true length in mm."""
        return size / self.scale.mu


class Figure(Protocol):
    """A figure in its spot on paper. Its file has the same few functions as every other figure's:

    `measure` gives the room that it needs, `draw` draws its lines in a spot, and the figure letters itself.
    """

    @property
    def lines(self) -> tuple[Stroke, ...]:
        """All that is drawn before any letter is placed."""
        ...

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure, its letters placed among the lines of all figures."""
        ...


class LetteredFigure(NamedTuple):
    """A figure by its name and its lines, and by what places its letters."""

    name: str
    lines: tuple[Stroke, ...]
    letters: Callable[[Labels], Iterable[Stroke]]
    grouped: bool = True  # whether its letters are a group within it
    data: Mapping[str, str] = NO_DATA  # of its group

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure, its letters over its lines."""
        placed = tuple(self.letters(labels))
        return (Group((*self.lines, *((Group(placed),) if self.grouped else placed)), self.name, self.data),)


class StillFigure(NamedTuple):
    """A figure that has no letters to be placed."""

    lines: tuple[Group, ...]

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure."""
        return self.lines


NARROW = 20.0  # sizes of its letters, the least width of a column of notes
BROKEN = 0.9  # share of a line that words fill on average when it is broken between them
WIDTHS = 8  # in which notes are tried, from their least to the width of the sheet


class TextBlock(NamedTuple):
    """Lettering kept together: its sizes mm, the narrowest first, and of a table into how many pieces each tears it."""

    name: str
    sizes: tuple[tuple[float, float], ...]
    pieces: tuple[int, ...] = ()


class Notes(NamedTuple):
    """What the sheet says in words: length of each paragraph in one line, step of lines, least column, mm."""

    lengths: tuple[float, ...]
    step: float
    least: float = NARROW * 3.5

    def height(self, width: float) -> float:
        """Give the height, mm, of the notes broken at a width."""
        return sum(high for _, high in self.lines(width))

    def lines(self, width: float) -> Iterator[tuple[float, float]]:
        """Give width and height, mm, of each paragraph written in a width: short lines leave paper beside them."""
        for length in self.lengths:
            yield min(width, length), math.ceil(length / (BROKEN * width)) * self.step

    def sizes(self, widest: float) -> tuple[tuple[float, float], ...]:
        """Give widths and heights, mm, that they may have up to a width, the narrowest first, each lower than the last.

        >>> Notes((100.0,), 5.0, 60.0).sizes(120.0)
        ((60.0, 10.0), (120.0, 5.0))
        """
        widths = [self.least * max(widest / self.least, 1.0) ** (k / (WIDTHS - 1)) for k in range(WIDTHS)]
        found: list[tuple[float, float]] = []
        for width in widths:
            if (height := self.height(width)) < (found[-1][1] if found else math.inf):
                found.append((width, height))
        return tuple(found)


BANDS = 8  # of equal height, from below


class Band(NamedTuple):
    """What may be inked between two heights of the box of a figure: shares of the box, from its left and from below."""

    low: float
    high: float
    left: float
    right: float


WHOLE = (Band(0.0, 1.0, 0.0, 1.0),)


def outline(values: Sequence[complex]) -> tuple[Band, ...]:
    """Give what the convex hull of points takes of their box; alike bands are one.

    >>> outline([0j, 8 + 0j, 8 + 8j])[0], outline([0j, 1 + 0j, 1 + 1j, 1j])
    (Band(low=0.0, high=0.125, left=0.0, right=1.0), (Band(low=0.0, high=1.0, left=0.0, right=1.0),))
    """
    shares = _shares([values], values)
    if not shares:
        return WHOLE
    hull = _hull(set(shares[0]))
    return tuple(_joined(_band(hull, k / BANDS, (k + 1) / BANDS) for k in range(BANDS)))


def traced(lines: Sequence[Sequence[complex]], values: Sequence[complex]) -> tuple[Band, ...]:
    """Give what lines, each from point to point, take of the box of some points: no more than they cross of a band.

    >>> traced([[0j, 8j], [8j, 8 + 8j]], [0j, 8 + 8j])[0]
    Band(low=0.0, high=0.875, left=0.0, right=0.0)
    """
    shares = _shares(lines, values)
    bands = (_crossed(shares, k / BANDS, (k + 1) / BANDS) for k in range(BANDS))
    return tuple(_joined(band for band in bands if band is not None)) if shares else WHOLE


def _shares(lines: Sequence[Sequence[complex]], values: Sequence[complex]) -> list[list[complex]]:
    """Give where lines lie in the box of some points, in shares of it; nothing where the box is flat."""
    left, low, right, top = _box(values)
    wide, high = right - left, top - low
    if not wide or not high or not lines:
        return []
    points = np.concatenate(lines)
    across, up = (points.real - left) / wide, (points.imag - low) / high
    shares = map(complex, (across.round(PLACES) + 0.0).tolist(), (up.round(PLACES) + 0.0).tolist())
    return [[*islice(shares, len(line))] for line in lines]


def _box(values: Sequence[complex]) -> Box:
    """Give the box of some points."""
    across, up = [v.real for v in values], [v.imag for v in values]
    return min(across), min(up), max(across), max(up)


def _crossed(lines: Sequence[Sequence[complex]], low: float, high: float) -> Band | None:
    """Give between what sides lines are between two heights, if any is."""
    sides = [side for line in lines for side in _sides(line, low, high)]
    return Band(low, high, tied(min(sides)), tied(max(sides))) if sides else None


def _joined(bands: Iterator[Band]) -> Iterator[Band]:
    for (left, right), alike in groupby(bands, key=lambda band: (band.left, band.right)):
        stack = list(alike)
        yield Band(stack[0].low, stack[-1].high, left, right)


def _band(hull: Sequence[complex], low: float, high: float) -> Band:
    """Give between what sides a hull lies between two heights."""
    sides = list(_sides([*hull, hull[0]], low, high))
    return Band(low, high, tied(min(sides)), tied(max(sides)))


def _sides(line: Sequence[complex], low: float, high: float) -> Iterator[float]:
    """Give the abscissas of the points of a line between two heights, and of where it crosses these."""
    yield from (point.real for point in line if low <= point.imag <= high)
    for corner, other in pairwise(line):
        for y in (low, high):
            if (corner.imag - y) * (other.imag - y) < 0:
                yield (corner + (other - corner) * (y - corner.imag) / (other.imag - corner.imag)).real


def _hull(points: set[complex]) -> list[complex]:
    """Give the corners of the convex hull, counterclockwise."""
    ordered = sorted(points, key=lambda point: (point.real, point.imag))
    return [*_chain(ordered)[:-1], *_chain(ordered[::-1])[:-1]]


def _chain(ordered: Sequence[complex]) -> list[complex]:
    chain: list[complex] = []
    for point in ordered:
        while len(chain) > 1 and ((chain[-1] - chain[-2]).conjugate() * (point - chain[-1])).imag <= 0:  # no turn left
            chain.pop()
        chain.append(point)
    return chain


RUNGS = 12  # scales tried for a picture: the last is a hundredth of the first, too small for any sheet
SMALLER = 1 - 1e-9  # of a drawn size: too small for its own scale, and no other scale lies so near


class Margins(NamedTuple):
    """Paper around a picture, mm: for letters and symbols, and above it for its heading."""

    side: float
    below: float
    above: float


class Picture(NamedTuple):
    """A figure's extent in true units about its middle, the letter and unit of its scale, and its margins."""

    name: str  # no two pictures of a set of sheets share it
    wide: float
    high: float
    middle: complex
    letter: str
    unit: str
    margins: Margins
    heading: float  # mm, width of the heading
    least: float  # mm: lines drawn smaller are hidden by their letters
    most: float = math.inf  # mm: lines drawn larger would be out of proportion
    open: bool = True  # above it stands nothing but its heading in the middle
    exact: float = 0.0  # mu: it is drawn at this scale and no other, if there is one
    bands: tuple[Band, ...] = WHOLE  # what of the box of its lines may be inked
    taller: float = 1.0  # times its height that its lines may be drawn, where there is room: a graph's own scale grows

    def size(self, scale: Scale) -> tuple[float, float]:
        """Give width and height on paper, mm, margins and heading included."""
        wide, high = self.wide / scale.mu, self.high / scale.mu
        around = self.margins
        return max(wide + 2 * around.side, self.heading), high + around.below + around.above

    def extent(self, scale: Scale) -> float:
        """Give the larger side of the drawn lines, mm."""
        return max(self.wide, self.high) / scale.mu

    def rungs(self, width: float, height: float, standard: str = "GOST") -> "tuple[Rung, ...]":
        """List the standard scales at which the picture and its margins fit a room, the largest picture first."""
        across, up = width - 2 * self.margins.side, height - self.margins.below - self.margins.above
        if across <= 0 or up <= 0 or self.heading > width:
            return ()
        if self.exact:
            return tuple(self._only(width, height))
        extent, room = (self.wide, across) if self.wide * up >= self.high * across else (self.high, up)
        room = min(room, self.most)
        rungs: list[Rung] = []
        while len(rungs) < RUNGS and room > 0:
            scale = fitting(extent, room, self.letter, self.unit, standard)
            rungs.append(Rung(scale, *self.size(scale), self.extent(scale)))
            room = extent / scale.mu * SMALLER
        return tuple(rungs)

    def at(self, mu: float) -> "Picture":
        """Give the picture to be drawn at a scale that is asked for, however small its lines are."""
        return self._replace(exact=mu, least=0.0, most=math.inf)

    def _only(self, width: float, height: float) -> "Iterator[Rung]":
        """Give the scale that is asked for, if the picture fits a room so."""
        scale = Scale(self.exact, self.letter, self.unit)
        wide, high = self.size(scale)
        if wide * SMALLER <= width and high * SMALLER <= height:
            yield Rung(scale, wide, high, self.extent(scale))

    def filling(self, spot: "Spot") -> "Picture":
        """Give a picture that may be taller as high as its box: its bottom stays."""
        if self.taller == 1.0:
            return self
        high = (spot.box.height - self.margins.below - self.margins.above) * spot.scale.mu
        return self._replace(high=high, middle=self.middle + 1j * (high - self.high) / 2)

    def place(self, box: Field, scale: Scale) -> Place:
        """Place the picture in a box of its size: its middle in the middle of what the margins leave."""
        inner = Field(box.left, box.bottom + self.margins.below, box.right, box.top - self.margins.above)
        return Place(inner.centre, self.middle, scale)


class Rung(NamedTuple):
    """A standard scale of a picture, its width and height with margins, and the larger side of its lines, mm."""

    scale: Scale
    wide: float
    high: float
    extent: float


class Spot(NamedTuple):
    """Where a picture stands, and its scale."""

    box: Field
    scale: Scale


def picture(
    name: str, values: Sequence[complex], subject: tuple[str, str], margins: Margins, heading: float, least: float = 0.0
) -> Picture:
    """Measure what a figure of true values needs; `subject` is the letter and the unit of its scale."""
    left, bottom, right, top = _box(values)
    middle = complex(left + right, bottom + top) / 2
    drawn = Picture(name, right - left, top - bottom, middle, *subject, margins, heading, least)
    return drawn._replace(bands=outline(values))
