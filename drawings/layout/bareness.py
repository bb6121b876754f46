"""How bare a sheet will be: the largest empty rectangle between boxes, on a coarse grid (пустое место)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from drawings.page.page import Field
from drawings.paper.ties import PLACES, tied
from plans.model.motion import Floats

CELLS = 72  # across the longer side of a sheet

Edges: TypeAlias = Sequence[int]
Inked: TypeAlias = npt.NDArray[np.bool_]


class Area(NamedTuple):
    """Cells of a grid: the first, and the first that is beyond, of its columns and of its rows from below."""

    left: int
    bottom: int
    right: int
    top: int

    def meets(self, other: Area) -> bool:
        """Tell whether a cell is in both."""
        across = self.left < other.right and other.left < self.right
        return across and self.bottom < other.top and other.bottom < self.top

    @property
    def size(self) -> int:
        """How many cells it has."""
        return (self.right - self.left) * (self.top - self.bottom)


class Grid:
    """The cells of a field."""

    def __init__(self, field: Field) -> None:
        self.field = field

    @cached_property
    def cell(self) -> float:
        """The side of a cell, mm."""
        return max(self.field.width, self.field.height) / CELLS

    @cached_property
    def whole(self) -> Area:
        """All its cells."""
        high, wide = (max(round(side / self.cell), 1) for side in (self.field.height, self.field.width))
        return Area(0, 0, wide, high)

    def cells(self, boxes: Floats) -> npt.NDArray[np.intp]:
        """Give the cells that boxes (..., 4) mm cover."""
        low = np.array([self.field.left, self.field.bottom] * 2)
        ends = ((boxes - low) / self.cell).round(PLACES).round().astype(int)
        return np.asarray(np.clip(ends, 0, np.array(self.whole[2:] * 2)))

    def area(self, box: Field) -> Area:
        """Give the cells that a box covers."""
        (left, low, *_), cell, (_, _, wide, high) = self.field, self.cell, self.whole
        first, beyond = (min(max(round(tied((side - left) / cell)), 0), wide) for side in (box.left, box.right))
        lowest, above = (min(max(round(tied((side - low) / cell)), 0), high) for side in (box.bottom, box.top))
        return Area(first, lowest, beyond, above)

    def barest(self, areas: Sequence[Area]) -> Area:
        """Give the largest rectangle that none of some areas covers."""
        return _largest((self.whole, *areas))

    def share(self, area: Area) -> float:
        """Give what share of all cells an area takes."""
        return area.size / self.whole.size


def bareness(boxes: Iterable[Field], field: Field) -> float:
    """Give the largest rectangle of a field that no box covers, as a share of the field.

    >>> round(bareness([Field(0.0, 0.0, 50.0, 100.0)], Field(0.0, 0.0, 100.0, 100.0)), 2)
    0.5
    """
    grid = Grid(field)
    return grid.share(grid.barest([grid.area(box) for box in boxes]))


def barest(inked: Inked) -> Area:
    """Find the largest bare rectangle of a grid, of which it is known, row by row from below, what cells are inked.

    >>> barest(np.array([[False, False, True], [False, False, False]]))
    Area(left=0, bottom=0, right=2, top=2)
    """
    high, wide = inked.shape
    return _rectangle(inked, range(wide + 1), range(high + 1))


def _largest(areas: Sequence[Area]) -> Area:
    """Find the largest bare rectangle of a grid, of which areas behind the first, the whole, are taken."""
    ys = sorted({edge for own in areas for edge in (own.bottom, own.top)})
    xs = sorted({edge for own in areas for edge in (own.left, own.right)})
    row, column = ({edge: k for k, edge in enumerate(own)} for own in (ys, xs))
    taken = np.zeros((len(ys) - 1, len(xs) - 1), dtype=bool)
    for left, bottom, right, top in areas[1:]:
        taken[row[bottom] : row[top], column[left] : column[right]] = True
    return _rectangle(taken, xs, ys)


def _rectangle(taken: Inked, xs: Edges, ys: Edges) -> Area:
    """Find the largest bare rectangle between edges; heights of bare columns grow from one edge to the next."""
    heights, best = [0] * (len(xs) - 1), Area(0, 0, 0, 0)
    closing = np.append((taken[1:] > taken[:-1]).any(-1), True)  # what is bare below another bare row goes on in it
    for full, closes, (below, above) in zip(taken.tolist(), closing.tolist(), pairwise(ys), strict=True):
        heights = [0 if one else high + above - below for one, high in zip(full, heights, strict=True)]
        if closes:
            best = max(best, _under(heights, xs, above), key=lambda one: one.size)
    return best


def _under(heights: Sequence[int], edges: Edges, top: int) -> Area:
    """Give the largest rectangle that hangs from a row under heights between edges; each ends where its column does."""
    best, count, starts = Area(0, top, 0, top), 0, list[tuple[int, int]]()  # left side and height of those still open
    for x, high in zip(edges, [*heights, 0], strict=True):
        left = x
        while starts and starts[-1][1] >= high:
            left, tall = starts.pop()
            if tall * (x - left) > count:
                best, count = Area(left, top - tall, x, top), tall * (x - left)
        if high:
            starts.append((left, high))
    return best
