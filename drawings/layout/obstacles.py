"""Clearance: how many of the lines already drawn a new line, or a number, would cross (свободное место)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from drawings.lettering.extent import bounds as box_of
from drawings.paper.strokes import TURN, Arc, Circle, Fill, Group, Line, Polyline, Stroke, Text
from plans.model.motion import Complexes, Floats

SAG = 0.2  # mm that a straight piece may be off the arc that it stands for
PIECES = 48  # straight pieces that stand for a smooth path, at least
RUNGS = 5  # lines across a text's box that feel what it would cover


class Obstacles:
    """The lines already drawn, as straight pieces, each with its weight."""

    def __init__(self) -> None:
        self._starts, self._ends = np.zeros(0, complex), np.zeros(0, complex)
        self._weights = np.zeros(0)

    def draw(self, strokes: Iterable[Stroke], weight: float = 1.0) -> None:
        """Add strokes; crossing each of their lines costs a weight."""
        pieces = [piece for stroke in strokes for chain in chains(stroke) for piece in pairwise(chain)]
        self._starts = np.append(self._starts, [start for start, _ in pieces])
        self._ends = np.append(self._ends, [end for _, end in pieces])
        self._weights = np.append(self._weights, np.full(len(pieces), weight))

    def crossed_by(self, strokes: Iterable[Stroke]) -> float:
        """Give the weight of the lines that some strokes cross or touch; a text crosses what lies in its box."""
        pieces = [piece for stroke in strokes for chain in chains(stroke) for piece in pairwise(chain)]
        starts, ends = np.array([piece[0] for piece in pieces]), np.array([piece[1] for piece in pieces])
        near = self._near(np.concatenate([starts, ends]))
        own_starts, own_ends = self._starts[near, None], self._ends[near, None]
        sides = _cross(ends - starts, own_starts - starts) * _cross(ends - starts, own_ends - starts)
        others = _cross(own_ends - own_starts, starts - own_starts) * _cross(own_ends - own_starts, ends - own_starts)
        return float(((sides <= 0) & (others <= 0)).sum(axis=1) @ self._weights[near])

    def _near(self, spots: Complexes) -> npt.NDArray[np.intp]:
        """Give the pieces whose boxes meet the box of some spots."""
        over = [
            (np.minimum(first, last) <= own.max()) & (np.maximum(first, last) >= own.min())
            for first, last, own in (
                (self._starts.real, self._ends.real, spots.real),
                (self._starts.imag, self._ends.imag, spots.imag),
            )
        ]
        return np.flatnonzero(over[0] & over[1])


def _cross(first: Complexes, second: Complexes) -> Floats:
    return np.asarray(first.real * second.imag - first.imag * second.real)


def chains(stroke: Stroke) -> Iterator[Sequence[complex]]:
    """Give a stroke as chains of straight pieces."""
    match stroke:
        case Group(strokes):
            for inner in strokes:
                yield from chains(inner)
        case Line(start, end):
            yield start, end
        case Polyline(points, closed):
            step = max(len(points) // PIECES, 1)  # a smooth path is felt as well by fewer pieces
            yield (*points[::step], points[0] if closed else points[-1])
        case Fill(points):
            yield *points, points[0]
        case Circle(centre, radius):
            yield from chains(Arc(centre, radius, 0.0, TURN))
        case Arc(radius=radius):
            facet = 2 * math.acos(max(1 - SAG / radius, 0.0)) if radius > 0 else TURN
            count = max(math.ceil(stroke.sweep / facet), 1)
            yield [stroke.at(k / count) for k in range(count + 1)]
        case Text():
            yield from _rungs(stroke)


def _rungs(text: Text) -> Iterator[Sequence[complex]]:
    """Lay lines across a text's box, turned as the text is."""
    left, bottom, right, top = box_of(Text(0j, text.content, text.size, text.anchor, text.slanted))
    turn = cmath.rect(1.0, math.radians(text.rotation))
    for k in range(RUNGS):
        level = bottom + (top - bottom) * k / (RUNGS - 1)
        yield text.at + complex(left, level) * turn, text.at + complex(right, level) * turn
    for side in (left, right):
        yield text.at + complex(side, bottom) * turn, text.at + complex(side, top) * turn
