"""Parting: which runs of units make the sheets of a set, as few as can be and filled evenly (разбивка на листы)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TypeAlias

from drawings.paper.ties import tied

SheetRun: TypeAlias = tuple[int, int]  # the first and the last unit of a sheet
Fits: TypeAlias = Callable[[int, int], bool]

MOST = 400  # ways to part a set that are compared at most


def fewest(count: int, fits: Fits) -> int:
    """Give the least number of sheets for some units, 0 if one of them fits none.

    >>> fewest(5, lambda i, j: j - i < 2)
    3
    """
    least = [0]
    for j in range(count):
        ways = [least[i] for i in _starts(j, fits) if least[i] or i == 0]
        least.append(min(ways) + 1 if ways else 0)
    return least[count]


def _starts(j: int, fits: Fits) -> Iterator[int]:
    """Give the first units of the sheets that may end with a unit: a longer run fits no better."""
    for i in range(j, -1, -1):
        if not fits(i, j):
            return
        yield i


def partings(count: int, sheets: int, fits: Fits, areas: Sequence[float]) -> list[tuple[SheetRun, ...]]:
    """List the ways to part units into sheets, those first whose sheets are filled most evenly.

    >>> partings(3, 2, lambda i, j: True, [1.0, 1.0, 2.0])
    [((0, 1), (2, 2)), ((0, 0), (1, 2))]
    """
    ways: list[tuple[SheetRun, ...]] = []
    for way in _ways(0, count, sheets, fits):
        ways.append(way)
        if len(ways) == MOST:
            break
    return sorted(ways, key=lambda way: tied(max(sum(areas[i : j + 1]) for i, j in way)))


def _ways(start: int, count: int, sheets: int, fits: Fits) -> Iterator[tuple[SheetRun, ...]]:
    if sheets == 1:
        if start < count and fits(start, count - 1):
            yield ((start, count - 1),)
        return
    for end in range(start, count - sheets + 1):
        if not fits(start, end):
            return
        for rest in _ways(end + 1, count, sheets - 1, fits):
            yield (start, end), *rest
