"""How much of a sheet is left bare: the largest empty rectangle on a grid of ink, and where it lies."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from drawings.lettering.lettering import bounds
from drawings.page.page import Field, Page
from drawings.paper.strokes import TURN, Arc, Box, Circle, Curve, Fill, Group, Leaf, Line, Polyline, Stroke, Text
from drawings.paper.walk import flat
from geometry.curve import sampled

CELL = 4.0  # mm
SAG = 0.5  # mm that a chord may be off its curve
STILL = ("frame", "corners")  # groups that stand on every sheet around its field

Grid = npt.NDArray[np.bool_]


def emptiness(leaf: Leaf, page: Page) -> float:
    """Give the largest empty rectangle of a sheet as a share of the field inside its frame."""
    return largest(inked(leaf, page))[0]


def bare(leaf: Leaf, page: Page) -> Field:
    """Give the largest empty rectangle itself, mm."""
    _, (low, high, left, right) = largest(inked(leaf, page))
    at = page.field
    return Field(at.left + left * CELL, at.bottom + low * CELL, at.left + right * CELL, at.bottom + high * CELL)


def inked(leaf: Leaf, page: Page) -> Grid:
    """Give the cells of the field inside the frame, by rows from the bottom: which have ink."""
    field = page.field
    grid = np.zeros((int(field.height // CELL), int(field.width // CELL)), dtype=bool)
    for place in page.taken:
        _fill(grid, field, (place.left, place.bottom, place.right, place.top))
    shown = [one for one in leaf.groups if not (isinstance(one, Group) and one.name in STILL)]
    for stroke in flat(shown):
        if isinstance(stroke, Text):
            _fill(grid, field, bounds(stroke))
        else:
            for chain in _chains(stroke):
                _draw(grid, field, chain)
    return grid


def largest(grid: Grid) -> tuple[float, tuple[int, int, int, int]]:
    """Give the share of the largest rectangle of bare cells, and its sides: bottom, top, left, right.

    >>> largest(np.array([[False, False, True], [False, False, False]]))
    (0.6666666666666666, (0, 2, 0, 2))
    """
    heights, best, where = [0] * grid.shape[1], 0, (0, 0, 0, 0)
    for k, row in enumerate(grid.tolist()):
        heights = [0 if ink else high + 1 for ink, high in zip(row, heights, strict=True)]
        starts: list[tuple[int, int]] = []  # of rectangles still open: left side, height
        for x, high in enumerate([*heights, 0]):
            left = x
            while starts and starts[-1][1] >= high:
                left, tall = starts.pop()
                if tall * (x - left) > best:
                    best, where = tall * (x - left), (k + 1 - tall, k + 1, left, x)
            starts.append((left, high))
    return best / grid.size, where


def _fill(grid: Grid, field: Field, box: Box) -> None:
    left, bottom, right, top = box
    rows = slice(max(int((bottom - field.bottom) // CELL), 0), max(int((top - field.bottom) // CELL) + 1, 0))
    columns = slice(max(int((left - field.left) // CELL), 0), max(int((right - field.left) // CELL) + 1, 0))
    grid[rows, columns] = True


def _draw(grid: Grid, field: Field, chain: Iterable[complex]) -> None:
    for start, end in pairwise(chain):
        count = int(abs(end - start) / (CELL / 4)) + 2
        points = np.linspace(start, end, count)
        rows, columns = (points.imag - field.bottom) // CELL, (points.real - field.left) // CELL
        there = (rows >= 0) & (columns >= 0) & (rows < grid.shape[0]) & (columns < grid.shape[1])
        grid[rows[there].astype(int), columns[there].astype(int)] = True


def _chains(stroke: Stroke) -> Iterator[list[complex]]:
    match stroke:
        case Line(start, end):
            yield [start, end]
        case Polyline(points, closed):
            yield [*points, *points[: int(closed)]]
        case Fill(points):
            yield [*points, points[0]]
        case Circle(centre, radius):
            yield _round(centre, radius, 0.0, TURN)
        case Arc(centre, radius, angle, sweep):
            yield _round(centre, radius, angle, sweep)
        case Curve(pieces):
            yield list(sampled(pieces, SAG))


def _round(centre: complex, radius: float, start: float, sweep: float) -> list[complex]:
    count = max(math.ceil(abs(sweep) * radius / CELL), 8)
    return [centre + cmath.rect(radius, start + sweep * k / count) for k in range(count + 1)]
