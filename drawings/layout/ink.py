"""The map of what is inked on a sheet, felt in two ways: by cells, quick, and line by line, exact (свободное место)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from drawings.layout.parallel_offsets import nearest
from drawings.layout.standing import barest
from drawings.lettering.lettering import bounds
from drawings.page.page import Field
from drawings.paper.strokes import INK, TURN, Arc, Box, Circle, Curve, Fill, Line, Polyline, Stroke, Text
from drawings.paper.walk import MARGIN, flat
from geometry.curve import sampled
from plans.model.motion import Complexes, Floats

CELL = 0.5  # mm, the grain of the cells: finer than a thin line's least distance
COARSE = 8  # cells along the side of one by which bare paper is sought
BESIDE = 0.8  # mm: a line drawn so near along another is taken for it
LETTERED = 1000  # of a cell under letters; a line adds 1, and no cell is crossed by so many
CLEAR = 0.4  # mm kept free around a label
SAG = 0.2  # mm that a straight piece may be off the arc that it stands for
MARK = 2.5  # mm, radius of the largest circle that is the mark of a point: a hinge
PIECES = 48  # straight pieces that stand for a smooth path, at least
RUNGS = 5  # lines across a text's box that feel what it would cover

Chain: TypeAlias = Sequence[complex]


class Ink:
    """What is drawn on paper of some size, mm. Either way to feel it is made ready when it is first asked for."""

    def __init__(self, width: float = 0.0, height: float = 0.0) -> None:
        self._cells, self._uncelled = _Cells(width, height), list[Stroke]()
        self._pieces, self._unpieced = _Pieces(), list[tuple[Stroke, float]]()
        self._bare = dict[Field, Field]()  # what was found since the last stroke
        self._marks = list[Circle]()

    def bar(self, field: Box, taken: Iterable[Box] = ()) -> None:
        """Keep lettering inside a field and off what is taken of it: all else counts as lettered over."""
        self._cells.bar(field, taken)
        self._bare.clear()

    def draw(self, strokes: Iterable[Stroke], weight: float = 1.0) -> None:
        """Ink strokes in; each of their lines that another crosses costs it a weight."""
        inked = [*flat(strokes)]
        self._uncelled += inked
        self._unpieced += [(stroke, weight) for stroke in inked]
        self._marks += [stroke for stroke in inked if isinstance(stroke, Circle) and stroke.radius <= MARK]
        heads = (stroke.points for stroke in inked if isinstance(stroke, Fill) and len(stroke.points) == 3)
        self._marks += [Circle(sum(head) / 3, abs(head[1] - head[2]) / 2, INK) for head in heads]
        self._bare.clear()

    def bare(self, field: Field) -> Field:
        """Give the largest rectangle of a field in which nothing is drawn, to a few mm."""
        if field not in self._bare:
            self._bare[field] = self._celled().bare(field)
        return self._bare[field]

    def under(self, box: Box) -> int:
        """Count what a box would cover, by cells."""
        return self._celled().under(box)

    def along(self, start: complex, end: complex) -> tuple[int, float]:
        """Count what a straight line would cross, by cells; and give the longest way that ink is at or by it, mm."""
        return self._celled().along(start, end)

    def passed(self, start: complex, end: complex, own: float) -> int:
        """Count the marks of points and heads of arrows that a line passes, but those as near its start as its own."""
        others = (mark for mark in self._marks if abs(mark.centre - start) > own)
        return sum(abs(nearest(start, end, mark.centre) - mark.centre) < mark.radius for mark in others)

    def crossed_by(self, strokes: Iterable[Stroke]) -> float:
        """Give the weight of the lines that some strokes cross or touch; a text crosses what lies in its box."""
        self._pieces.add(self._unpieced)
        self._unpieced.clear()
        return self._pieces.crossed_by(strokes)

    def _celled(self) -> _Cells:
        if self._uncelled:
            self._cells.draw(self._uncelled)
            self._uncelled.clear()
        return self._cells


class _Cells:
    """Square cells of the paper: how many lines run through each, and where letters stand."""

    def __init__(self, width: float, height: float) -> None:
        self._map = np.zeros((int(height / CELL) + 2, int(width / CELL) + 2), dtype=np.int32)

    def bar(self, field: Box, taken: Iterable[Box]) -> None:
        for place in taken:
            self._map[self._covered(place)] += LETTERED
        rows, columns = self._covered(field)
        for outside in (np.s_[: rows.start], np.s_[rows.stop :]):
            self._map[outside] += LETTERED
        for outside in (np.s_[: columns.start], np.s_[columns.stop :]):
            self._map[:, outside] += LETTERED

    def draw(self, strokes: Iterable[Stroke]) -> None:
        chains = [chain for stroke in strokes for chain in self._chains(stroke)]
        if chains:
            np.add.at(self._map, self._sampled(chains), 1)

    def bare(self, field: Field) -> Field:
        rows, columns = self._covered(field)
        window = self._map[rows, columns]
        high, wide = (side // COARSE for side in window.shape)
        cells = window[: high * COARSE, : wide * COARSE].reshape(high, COARSE, wide, COARSE)
        coarse = np.any(np.any(cells > 0, axis=1), axis=2)
        left, low, right, top = barest(coarse)
        start, step = complex(columns.start, rows.start) * CELL, COARSE * CELL
        ends = start + step * complex(left, low), start + step * complex(right, top)
        return Field(ends[0].real, ends[0].imag, ends[1].real, ends[1].imag)

    def under(self, box: Box) -> int:
        return int(np.add.reduce(self._map[self._covered(box)], axis=None))

    def along(self, start: complex, end: complex) -> tuple[int, float]:
        side = 1j * BESIDE * (end - start) / (abs(end - start) or 1.0)
        lanes = self._map[self._sampled([[start + off, end + off] for off in (-side, 0j, side)])].reshape(3, -1)
        bare = np.flatnonzero(np.concatenate(([0], lanes.sum(axis=0), [0])) == 0)
        return int(lanes[1].sum()), float(np.diff(bare).max() - 1) * abs(end - start) / len(lanes[1])

    def _chains(self, stroke: Stroke) -> Iterator[Chain]:
        """Give the lines of a stroke as chains of points; letters are inked in as boxes on the way."""
        match stroke:
            case Text():
                self._map[self._lettered(stroke)] += LETTERED
            case Line():
                yield [stroke.start, stroke.end]
            case Polyline() | Fill():
                closed = isinstance(stroke, Fill) or stroke.closed
                yield [*stroke.points, *stroke.points[:1]] if closed else stroke.points
            case Circle():
                yield _round(stroke.centre, stroke.radius, 0.0, 2 * math.pi)
            case Arc():
                yield _round(stroke.centre, stroke.radius, stroke.start_angle, stroke.sweep)
            case Curve():
                yield sampled(stroke.pieces, SAG)

    def _lettered(self, text: Text) -> tuple[Any, Any]:
        """Give the cells of a text's box; of one that is turned aslant not those of the corners beside it."""
        if text.rotation % 90 == 0:
            return self._covered(padded(bounds(text), 0j))
        left, bottom, right, top = padded(bounds(text._replace(at=0j, rotation=0.0)), 0j)
        x, y = np.meshgrid(np.arange(left, right, CELL / 2), np.arange(bottom, top, CELL / 2))
        spots = text.at + (x + 1j * y).ravel() * cmath.rect(1.0, math.radians(text.rotation))
        return self._holding(spots)

    def _covered(self, box: Box) -> tuple[slice, slice]:
        left, bottom, right, top = [int(side / CELL + MARGIN) if side > 0.0 else 0 for side in box]
        return slice(bottom, top + 1), slice(left, right + 1)

    def _sampled(self, chains: list[Chain]) -> tuple[npt.NDArray[np.intp], npt.NDArray[np.intp]]:
        """Give the cells along chains of points, each segment sampled at the grain of the cells."""
        points = np.concatenate([np.asarray(chain) for chain in chains])
        steps = np.diff(points)
        breaks = np.cumsum([len(chain) for chain in chains])[:-1] - 1
        counts = (np.abs(steps) / CELL + MARGIN).astype(int) + 2  # both ends among them
        counts[breaks] = 0  # from the end of a chain to the next one's start nothing is drawn
        which = np.repeat(np.arange(len(steps)), counts)
        share = (np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)) / (counts[which] - 1)
        return self._holding(points[which] + steps[which] * share)

    def _holding(self, spots: Complexes) -> tuple[npt.NDArray[np.intp], npt.NDArray[np.intp]]:
        """Give the cells that hold some spots."""
        rows = np.clip((spots.imag / CELL + MARGIN).astype(int), 0, self._map.shape[0] - 1)
        columns = np.clip((spots.real / CELL + MARGIN).astype(int), 0, self._map.shape[1] - 1)
        return rows, columns


class _Pieces:
    """The lines as straight pieces, each with its weight."""

    def __init__(self) -> None:
        self._starts, self._ends = np.zeros(0, complex), np.zeros(0, complex)
        self._weights, self._boxes = np.zeros(0), np.zeros((4, 0))  # left, bottom, right, top

    def add(self, strokes: Iterable[tuple[Stroke, float]]) -> None:
        pieces = [(*piece, weight) for stroke, weight in strokes for piece in _pieces(stroke)]
        if pieces:
            starts, ends, weights = zip(*pieces, strict=True)
            self._starts, self._ends = np.append(self._starts, starts), np.append(self._ends, ends)
            self._weights = np.append(self._weights, weights)
            sides = np.array((self._starts.real, self._starts.imag)), np.array((self._ends.real, self._ends.imag))
            self._boxes = np.concatenate((np.minimum(*sides), np.maximum(*sides)))

    def crossed_by(self, strokes: Iterable[Stroke]) -> float:
        pieces = [piece for stroke in flat(strokes) for piece in _pieces(stroke)]
        starts, ends = np.array([piece[0] for piece in pieces]), np.array([piece[1] for piece in pieces])
        near = self._near(np.concatenate([starts, ends]))
        own_starts, own_ends = self._starts[near, None], self._ends[near, None]
        step, own_step, apart = ends - starts, own_ends - own_starts, starts - own_starts
        sides = _cross(step, -apart) * _cross(step, own_ends - starts)
        others = _cross(own_step, apart) * _cross(own_step, ends - own_starts)
        return float(((sides <= MARGIN) & (others <= MARGIN)).sum(axis=1) @ self._weights[near])

    def _near(self, spots: Complexes) -> npt.NDArray[np.intp]:
        """Give the pieces whose boxes meet the box of some spots."""
        left, bottom, right, top = self._boxes
        x, y = spots.real, spots.imag
        across = (left <= x.max() + MARGIN) & (right >= x.min() - MARGIN)
        up = (bottom <= y.max() + MARGIN) & (top >= y.min() - MARGIN)
        return np.flatnonzero(across & up)


def padded(box: Box, shift: complex, by: float = CLEAR) -> Box:
    """Shift a box and widen it to all sides, mm."""
    x, y = shift.real, shift.imag
    return box[0] + x - by, box[1] + y - by, box[2] + x + by, box[3] + y + by


def _round(centre: complex, radius: float, start: float, sweep: float) -> Chain:
    count = max(int(abs(sweep) * radius / CELL + MARGIN), 8)
    return [centre + cmath.rect(radius, start + sweep * k / count) for k in range(count + 1)]


def _cross(first: Complexes, second: Complexes) -> Floats:
    return np.asarray(first.real * second.imag - first.imag * second.real)


def _pieces(stroke: Stroke) -> Iterator[tuple[complex, complex]]:
    """Give a stroke as straight pieces."""
    return (piece for chain in _chains(stroke) for piece in pairwise(chain))


def _chains(stroke: Stroke) -> Iterator[Chain]:
    """Give a stroke as chains of straight pieces."""
    match stroke:
        case Line(start, end):
            yield start, end
        case Polyline(points, closed):
            step = max(len(points) // PIECES, 1)  # a smooth path is felt as well by fewer pieces
            yield (*points[::step], points[0] if closed else points[-1])
        case Fill(points):
            yield *points, points[0]
        case Circle(centre, radius):
            yield from _chains(Arc(centre, radius, 0.0, TURN))
        case Arc(radius=radius):
            facet = 2 * math.acos(max(1 - SAG / radius, 0.0)) if radius > 0 else TURN
            count = max(math.ceil(stroke.sweep / facet - MARGIN), 1)
            yield [stroke.at(k / count) for k in range(count + 1)]
        case Curve(pieces):
            yield sampled(pieces, SAG)
        case Text():
            yield from _rungs(stroke)


def _rungs(text: Text) -> Iterator[Chain]:
    """Lay lines across a text's box, turned as the text is, and as far beyond it as a line may be off its pieces."""
    left, bottom, right, top = padded(bounds(Text(0j, text.content, text.size, text.anchor, text.slanted)), 0j, SAG)
    turn = cmath.rect(1, math.radians(text.rotation))
    for k in range(RUNGS):
        level = bottom + (top - bottom) * k / (RUNGS - 1)
        yield text.at + complex(left, level) * turn, text.at + complex(right, level) * turn
    for side in (left, right):
        yield text.at + complex(side, bottom) * turn, text.at + complex(side, top) * turn
