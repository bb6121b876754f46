"""A grid of pictures: rows in a room, each picture at the largest standard scale, whitespace even (сетка фигур)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias, TypeVar

from drawings.layout.picture import Ladder, Rung, Spot
from drawings.page.page import Field

T = TypeVar("T")

GAP = 4.0  # mm at least between two pictures; their margins keep letters apart already

Rows: TypeAlias = Sequence[Sequence[Ladder]]


class Grid(NamedTuple):
    """Rows of pictures at their scales."""

    rows: Rows
    rungs: tuple[tuple[Rung, ...], ...]

    @property
    def size(self) -> tuple[float, float]:
        """Least width and height of the room, mm."""
        return _size(self.rungs)

    @property
    def extent(self) -> list[float]:
        """The larger side of the lines of every picture that is more than a point, mm."""
        return [rung.extent for row in self.rungs for rung in row if rung.extent > 0]

    @property
    def legible(self) -> bool:
        """Whether every picture is drawn large enough for its letters."""
        pairs = (
            pair for row, rungs in zip(self.rows, self.rungs, strict=True) for pair in zip(row, rungs, strict=True)
        )
        return all(rung.extent >= one.least for one, rung in pairs if rung.extent)

    def spots(self, room: Field) -> dict[str, Spot]:
        """Stand the pictures in a room: columns and rows share what is left over, headings of a row are level."""
        widths, heights = _widths(self.rungs), _heights(self.rungs)
        across = (room.width - sum(widths)) / (len(widths) + 1)
        up = (room.height - sum(heights)) / (len(heights) + 1)
        spots: dict[str, Spot] = {}
        top = room.top - up
        for row, rungs, height in zip(self.rows, self.rungs, heights, strict=True):
            left = room.left + across
            for one, rung, width in zip(row, rungs, widths, strict=False):
                middle = left + width / 2
                box = Field(middle - rung.wide / 2, top - rung.high, middle + rung.wide / 2, top)
                spots[one.name] = Spot(box, rung.scale)
                left += width + across
            top -= height + up
        return spots


def grid(rows: Rows, width: float, height: float) -> Grid | None:
    """Fit rows of pictures into a room: first in equal cells, then the smallest is enlarged while all still fit."""
    columns = max(len(row) for row in rows)
    wide, high = (width - GAP * (columns - 1)) / columns, (height - GAP * (len(rows) - 1)) / len(rows)
    steps = [[_first(one, wide, high) for one in row] for row in rows]
    if any(
        step == len(one.rungs)
        for row, taken in zip(rows, steps, strict=True)
        for one, step in zip(row, taken, strict=True)
    ):
        return None
    growing = [(i, j) for i, row in enumerate(rows) for j in range(len(row))]
    rungs = [[one.rungs[step] for one, step in zip(*row, strict=True)] for row in zip(rows, steps, strict=True)]
    while growing:
        i, j = min(growing, key=lambda place: rungs[place[0]][place[1]].extent)
        if steps[i][j] > 0:
            kept, rungs[i][j] = rungs[i][j], rows[i][j].rungs[steps[i][j] - 1]
            size = _size(rungs)
            if size[0] <= width and size[1] <= height:
                steps[i][j] -= 1
                continue
            rungs[i][j] = kept
        growing.remove((i, j))
    return Grid(rows, tuple(map(tuple, rungs)))


def _first(one: Ladder, wide: float, high: float) -> int:
    """Give the place of the largest scale that fits a cell."""
    return next((k for k, rung in enumerate(one.rungs) if rung.wide <= wide and rung.high <= high), len(one.rungs))


def _widths(rungs: Sequence[Sequence[Rung]]) -> list[float]:
    columns = max(len(row) for row in rungs)
    return [max(row[k].wide for row in rungs if k < len(row)) for k in range(columns)]


def _heights(rungs: Sequence[Sequence[Rung]]) -> list[float]:
    return [max(rung.high for rung in row) for row in rungs]


def _size(rungs: Sequence[Sequence[Rung]]) -> tuple[float, float]:
    widths, heights = _widths(rungs), _heights(rungs)
    return sum(widths) + GAP * (len(widths) - 1), sum(heights) + GAP * (len(heights) - 1)


def arrangements(*rows: Sequence[T]) -> list[list[Sequence[T]]]:
    """List the ways to set groups in rows, given member by member: a group's members stay beside or under each other.

    >>> [[len(row) for row in rows] for rows in arrangements("pq", "xy")]
    [[2, 2], [4], [1, 1, 1, 1], [2, 2]]
    """
    count = len(rows[0]) if rows else 0
    ways: list[list[Sequence[T]]] = []
    for columns in sorted({math.ceil(count / lines) for lines in range(1, count + 1)}, reverse=True):
        parts = [slice(k, k + columns) for k in range(0, count, columns)]
        ways.append([row[part] for part in parts for row in rows])
        ways.append(
            [[one for group in zip(*(row[part] for row in rows), strict=True) for one in group] for part in parts]
        )
    return ways
