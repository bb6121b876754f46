"""How bare a sheet will be: the largest empty rectangle between boxes, on a coarse grid (пустое место)."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import numpy.typing as npt

from drawings.page.page import Field

CELLS = 72  # across the longer side of a sheet


def bareness(boxes: Iterable[Field], field: Field) -> float:
    """Give the largest rectangle of a field that no box covers, as a share of the field.

    >>> round(bareness([Field(0.0, 0.0, 50.0, 100.0)], Field(0.0, 0.0, 100.0, 100.0)), 2)
    0.5
    """
    return _largest(_covered(boxes, field))


def _covered(boxes: Iterable[Field], field: Field) -> npt.NDArray[np.bool_]:
    cell = max(field.width, field.height) / CELLS
    grid = np.zeros((max(round(field.height / cell), 1), max(round(field.width / cell), 1)), dtype=bool)
    for box in boxes:
        rows = [max(round((side - field.bottom) / cell), 0) for side in (box.bottom, box.top)]
        columns = [max(round((side - field.left) / cell), 0) for side in (box.left, box.right)]
        grid[slice(*rows), slice(*columns)] = True
    return grid


def _largest(grid: npt.NDArray[np.bool_]) -> float:
    """Grow the heights of bare columns row by row, and close each rectangle where its column ends."""
    heights, best = [0] * grid.shape[1], 0
    for row in grid.tolist():
        heights = [0 if taken else high + 1 for taken, high in zip(row, heights, strict=True)]
        best = max(best, _under(heights))
    return best / grid.size


def _under(heights: list[int]) -> int:
    """Give the largest rectangle under a row of heights."""
    best, starts = 0, list[tuple[int, int]]()  # left side and height of those that are still open
    for x, high in enumerate([*heights, 0]):
        left = x
        while starts and starts[-1][1] >= high:
            left, tall = starts.pop()
            best = max(best, tall * (x - left))
        if high:
            starts.append((left, high))
    return best
