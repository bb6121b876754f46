"""A ruled table of positions read back as a grid: headings over their columns, each text in its own cell (сетка)."""

from __future__ import annotations

from bisect import bisect
from collections.abc import Iterator, Sequence
from itertools import pairwise

from drawings.checks import reading
from drawings.checks.wrong import Wrong, within
from drawings.lettering.extent import bounds
from drawings.lettering.words import word
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Group, Line, Text
from drawings.paper.walk import flat

HEADED = 2  # rows of headings: positions, and under each the names of its columns
Row = list[tuple[str, float]]  # texts and the middles of their lettering, mm, from left to right


def faults(group: Group, table: str, heads: Sequence[str], language: str) -> Iterator[Wrong]:
    """Hold the headings of a table of positions, and see that each row has one text in each of its cells.

    `heads` are the words of its columns: that of the names, then those that each position has.
    """
    edges = _edges(group)
    first, *own = (Text(0j, word(language, key)).plain for key in heads)
    positions = [Text(0j, word(language, "position", position=k)).plain for k in reading.positions_of(group)]
    found = [_row(row) for row in sorted(reading.rows(group), key=lambda row: -row[0].at.imag)]
    titles, corner, columns, lines = found[0] if found else [], found[1:2], found[2:3], found[3:]
    count = 1 + len(own) * len(positions)
    if len(edges) != count + 1:
        yield within("in", table, text="|" * len(edges))
        return
    if not _ruled(group, edges, len(lines) + HEADED, len(own)):
        yield within("ruled", table)
    yield from _named(titles, positions, _bands(edges, len(own)), table)
    yield from _named(corner[0] if corner else [], [first], [(edges[0], edges[1])], table)
    cells = list(pairwise(edges))
    yield from _named(columns[0] if columns else [], own * len(positions), cells[1:], table)
    for line in lines:
        if [bisect(edges, middle) - 1 for _, middle in line] != list(range(count)):
            yield within("row", table, name=line[0][0])


def _edges(group: Group) -> list[float]:
    """Give the places of the upright lines of a table."""
    lines = (one for one in flat((group,)) if isinstance(one, Line))
    upright = sorted(one.start.real for one in lines if abs((one.end - one.start).real) <= QUANTUM)
    return [x for k, x in enumerate(upright) if not k or x - upright[k - 1] > QUANTUM]


def _ruled(group: Group, edges: Sequence[float], rows: int, each: int) -> bool:
    """Tell whether a table has its lines: level ones over and under each row, upright ones from the last row up.

    Those between the `each` columns of one position end under its heading, which no line parts from its columns' names
    in the column of the names.
    """
    lines = [one for one in flat((group,)) if isinstance(one, Line)]
    level = [one for one in lines if abs((one.end - one.start).imag) <= QUANTUM]
    level.sort(key=lambda one: one.start.imag)
    floors = [one.start.imag for one in level]
    if len(level) != rows + 1 or len(lines) != len(level) + len(edges):
        return False
    lefts = [edges[k == rows - 1] for k in range(rows + 1)]
    wide = all(_ends(one.start.real, one.end.real, low, edges[-1]) for one, low in zip(level, lefts, strict=True))
    steps = [high - low for low, high in pairwise(floors)]
    tops = [floors[-1] if k < 2 or (k - 1) % each == 0 else floors[-2] for k in range(len(edges))]
    upright = sorted((one for one in lines if one not in level), key=lambda one: one.start.real)
    high = all(_ends(one.start.imag, one.end.imag, floors[0], top) for one, top in zip(upright, tops, strict=True))
    return wide and high and max(steps) - min(steps) <= 2 * QUANTUM


def _ends(one: float, other: float, low: float, high: float) -> bool:
    return abs(min(one, other) - low) <= QUANTUM and abs(max(one, other) - high) <= QUANTUM


def _bands(edges: Sequence[float], count: int) -> list[tuple[float, float]]:
    """Give the ends of the columns of each position together."""
    return [(edges[k], edges[k + count]) for k in range(1, len(edges) - 1, count)]


def _row(texts: Sequence[Text]) -> Row:
    return [(text.plain, (bounds(text)[0] + bounds(text)[2]) / 2) for text in texts]


def _named(seen: Row, due: Sequence[str], cells: Sequence[tuple[float, float]], table: str) -> Iterator[Wrong]:
    """See that headings stand over what they must."""
    if [text for text, _ in seen] != list(due):
        told = "; ".join(text for text, _ in seen) or "—"
        yield within("in", table, text=told)
        return
    for (text, middle), (left, right) in zip(seen, cells, strict=True):
        if not left < middle < right:
            yield within("in", table, text=text)
