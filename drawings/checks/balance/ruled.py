"""A ruled table of no position read back as a grid: its lines, each text in a cell of its own (линованная таблица)."""

from __future__ import annotations

from bisect import bisect
from collections import Counter
from collections.abc import Iterator
from itertools import pairwise

from drawings.checks.wrong import Wrong, within
from drawings.lettering.extent import bounds
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Group, Leaf, Line, Text
from drawings.paper.walk import flat, groups


def faults(leaf: Leaf, table: str) -> Iterator[Wrong]:
    """Hold each part of a table of a sheet: each line goes through, each cell has one text, none stands beside."""
    for group in groups(leaf.groups):
        if group.name.removeprefix(f"{table}-").isdigit():
            yield from _part(group, table)


def _part(group: Group, table: str) -> Iterator[Wrong]:
    lines = [one for one in flat((group,)) if isinstance(one, Line)]
    texts = [one for one in flat((group,)) if isinstance(one, Text)]
    upright = sorted(one.start.real for one in lines if _along(one, 1j))
    level = sorted(one.start.imag for one in lines if _along(one, 1 + 0j))
    if not _is_grid(lines, upright, level):
        yield within("ruled", table)
        return
    cells = Counter[tuple[int, int]]()
    for one in texts:
        place = _cell(one, upright, level)
        cells[place] += 1
        if not (0 <= place[0] < len(upright) - 1 and 0 <= place[1] < len(level) - 1) or cells[place] > 1:
            yield within("out_of_cell", table, text=one.plain)
    if len(cells) != (len(upright) - 1) * (len(level) - 1):
        yield within("ruled", table)


def _along(line: Line, way: complex) -> bool:
    return abs(((line.end - line.start) * way.conjugate()).imag) <= QUANTUM < abs(line.end - line.start)


def _is_grid(lines: list[Line], upright: list[float], level: list[float]) -> bool:
    """Tell whether lines are a grid: each from side to side, rows alike, columns alike but the first one, of names."""
    if len(upright) + len(level) != len(lines) or min(len(upright), len(level)) < 2:
        return False
    apart = [after - one for row in (upright, level) for one, after in pairwise(row)]
    whole = abs(complex(upright[-1] - upright[0], 0)), abs(level[-1] - level[0])
    sizes = (abs(one.end - one.start) - whole[0 if _along(one, 1 + 0j) else 1] for one in lines)
    columns, rows = apart[1 : len(upright) - 1] or [0.0], apart[len(upright) - 1 :]
    even = all(max(row) - min(row) <= 4 * QUANTUM for row in (columns, rows))
    return even and min(apart) > QUANTUM and all(abs(size) <= 2 * QUANTUM for size in sizes)


def _cell(text: Text, upright: list[float], level: list[float]) -> tuple[int, int]:
    """Give the column and the row, from below, that the middle of a text is in."""
    left, bottom, right, top = bounds(text)
    return bisect(upright, (left + right) / 2) - 1, bisect(level, (bottom + top) / 2) - 1
