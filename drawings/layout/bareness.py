"""How bare a sheet will be: the largest empty rectangle between boxes, on a coarse grid (пустое место)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import TypeAlias

import numpy as np

from drawings.page.page import Field

CELLS = 72  # across the longer side of a sheet

Cells: TypeAlias = tuple[int, int]  # the first, and the first that is beyond


def bareness(boxes: Iterable[Field], field: Field) -> float:
    """Give the largest rectangle of a field that no box covers, as a share of the field.

    >>> round(bareness([Field(0.0, 0.0, 50.0, 100.0)], Field(0.0, 0.0, 100.0, 100.0)), 2)
    0.5
    """
    cell = max(field.width, field.height) / CELLS
    high, wide = (max(round(side / cell), 1) for side in (field.height, field.width))
    rows, columns = [(0, high)], [(0, wide)]
    for box in boxes:
        rows.append(_cells(box.bottom - field.bottom, box.top - field.bottom, cell, high))
        columns.append(_cells(box.left - field.left, box.right - field.left, cell, wide))
    return _largest(rows, columns) / (high * wide)


def _cells(low: float, high: float, cell: float, most: int) -> Cells:
    """Give the cells between two places, mm."""
    start, end = (min(max(round(side / cell), 0), most) for side in (low, high))
    return start, end


def _largest(rows: Sequence[Cells], columns: Sequence[Cells]) -> int:
    """Count the cells of the largest bare rectangle of a grid, of which boxes behind the first, the field, are taken.

    Heights of bare columns grow from one edge of a box to the next: between them one row is as the other.
    """
    ys, xs = (sorted({edge for cells in own for edge in cells}) for own in (rows, columns))
    places = [({edge: k for k, edge in enumerate(own)}) for own in (ys, xs)]
    heights, best = [0] * (len(xs) - 1), 0
    taken = np.zeros((len(ys) - 1, len(xs) - 1), dtype=bool)
    for (low, high), (left, right) in zip(rows[1:], columns[1:], strict=True):
        taken[places[0][low] : places[0][high], places[1][left] : places[1][right]] = True
    closing = np.append((taken[1:] > taken[:-1]).any(-1), True)  # what is bare below another bare row goes on in it
    for row, closes, (below, above) in zip(taken.tolist(), closing.tolist(), pairwise(ys), strict=True):
        heights = [0 if full else high + above - below for full, high in zip(row, heights, strict=True)]
        if closes:
            best = max(best, _under(heights, xs))
    return best


def _under(heights: Sequence[int], edges: Sequence[int]) -> int:
    """Give the largest rectangle under heights between edges; each is closed where its column ends."""
    best, starts = 0, list[tuple[int, int]]()  # left side and height of those that are still open
    for x, high in zip(edges, [*heights, 0], strict=True):
        left = x
        while starts and starts[-1][1] >= high:
            left, tall = starts.pop()
            best = max(best, tall * (x - left))
        if high:
            starts.append((left, high))
    return best
