"""A ruled table of one block read back: its lines, its headings, each text in its own cell (линовка таблицы)."""

from __future__ import annotations

from bisect import bisect
from collections.abc import Collection, Iterator, Sequence
from operator import attrgetter

from drawings.checks import reading
from drawings.checks.wrong import Wrong, within
from drawings.lettering.extent import bounds
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Group, Line, Text
from drawings.paper.walk import flat


def faults(group: Group, table: str, heads: Sequence[str], blank: Collection[tuple[str, int]] = ()) -> Iterator[Wrong]:
    """See that a table has all its lines, and that its headings and the texts of its rows stand in their cells.

    `blank` are the cells that are empty, each by the name of its row and the number of its column.
    """
    lines = [one for one in flat((group,)) if isinstance(one, Line)]
    upright = [one for one in lines if abs((one.end - one.start).real) <= QUANTUM]
    level = [one for one in lines if abs((one.end - one.start).imag) <= QUANTUM]
    rows = sorted(reading.rows(group), key=lambda row: -row[0].at.imag)
    columns, floors = (_places(own, axis) for own, axis in ((upright, "real"), (level, "imag")))
    whole = len(columns) == len(heads) + 1 and len(floors) == len(rows) + 1 and len(upright) + len(level) == len(lines)
    if not (whole and _spanning(upright, floors, "imag") and _spanning(level, columns, "real")):
        yield within("ruled", table)
        return
    for k, row in enumerate(rows):
        if k == 0 and [text.plain for text in row] != [*heads]:
            yield within("in", table, text="; ".join(text.plain for text in row))
            continue
        due = [(j, len(rows) - 1 - k) for j in range(len(heads)) if (row[0].plain, j) not in blank]
        if k and [_cell(text, columns, floors) for text in row if text.plain] != due:
            yield within("row", table, name=row[0].plain)


def _places(lines: Sequence[Line], axis: str) -> list[float]:
    """Give the places of parallel lines, each once."""
    every = sorted(attrgetter(axis)(one.start) for one in lines)
    return [x for k, x in enumerate(every) if not k or x - every[k - 1] > QUANTUM]


def _spanning(lines: Sequence[Line], across: Sequence[float], axis: str) -> bool:
    """Tell whether lines go from the first to the last of those across them."""
    ends = [sorted((attrgetter(axis)(one.start), attrgetter(axis)(one.end))) for one in lines]
    return all(abs(low - across[0]) <= QUANTUM and abs(high - across[-1]) <= QUANTUM for low, high in ends)


def _cell(text: Text, columns: Sequence[float], floors: Sequence[float]) -> tuple[int, int]:
    left, bottom, right, top = bounds(text)
    return bisect(columns, (left + right) / 2) - 1, bisect(floors, (bottom + top) / 2) - 1
