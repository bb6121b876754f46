"""Clearance: how many of the lines already drawn a new line, or a number, would cross (свободное место)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

import numpy as np

from drawings.strokes import Arc, Circle, Fill, Group, Line, Polyline, Stroke, Text
from drawings.strokes import bounds as box_of

FACETS = 24  # straight pieces that stand for a whole circle
RUNGS = 5  # lines across a text's box that feel what it would cover


class Drawn:
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

    def crossed(self, start: complex, end: complex) -> float:
        """Give the weight of the lines that a straight line crosses or touches."""
        run, runs = end - start, self._ends - self._starts
        sides = [_cross(run, ends - start) for ends in (self._starts, self._ends)]
        others = [_cross(runs, point - self._starts) for point in (start, end)]
        return float(self._weights[(sides[0] * sides[1] <= 0) & (others[0] * others[1] <= 0)].sum())

    def crossed_by(self, strokes: Iterable[Stroke]) -> float:
        """Give the weight of the lines that some strokes cross; a text crosses what lies in its box."""
        pieces = (piece for stroke in strokes for chain in chains(stroke) for piece in pairwise(chain))
        return sum(self.crossed(*piece) for piece in pieces)


def _cross(first: object, second: object) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    return np.asarray((np.conj(np.asarray(first)) * np.asarray(second)).imag)


def chains(stroke: Stroke) -> Iterator[Sequence[complex]]:
    """Give a stroke as chains of straight pieces."""
    match stroke:
        case Group(strokes):
            for inner in strokes:
                yield from chains(inner)
        case Line(start, end):
            yield start, end
        case Polyline(points, closed):
            step = max(len(points) // (2 * FACETS), 1)  # a smooth path is felt as well by fewer pieces
            yield (*points[::step], points[0] if closed else points[-1])
        case Fill(points):
            yield *points, points[0]
        case Circle(centre, radius):
            yield [centre + cmath.rect(radius, 2 * math.pi * k / FACETS) for k in range(FACETS + 1)]
        case Arc():
            count = max(math.ceil(FACETS * stroke.sweep / (2 * math.pi)), 1)
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
