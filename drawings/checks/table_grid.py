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
