"""A table on a form (таблица для заполнения): its heads and the names of its rows, its cells empty and marked."""

from __future__ import annotations

from collections.abc import Iterable

from drawings.form.laid import LaidTable
from drawings.layout.table import RuledTable, TableRow, table
from drawings.page.drafting import Drafting

BESIDE = (
    "by hand",
    "true error",
)  # columns of a sheet that tell how far a value may be out: a form asks for no such thing


def blank(bands: Iterable[LaidTable], drafting: Drafting) -> tuple[RuledTable, ...]:
    """Give the tables of a set of sheets, each whole: the bands and parts in which it was set put together."""
    own: dict[str, list[LaidTable]] = {}
    for band in bands:
        own.setdefault(band.name, []).append(band)
    return tuple(_whole(name, parts, drafting) for name, parts in own.items())


def _whole(name: str, parts: list[LaidTable], drafting: Drafting) -> RuledTable:
    positions = tuple(dict.fromkeys(position for part in parts for position in part.positions))
    rows = dict.fromkeys(row for part in parts for row in part.rows if row)
    first, told = parts[0], [drafting.word(key) for key in BESIDE]
    heads = tuple(head for head in first.heads if head not in told)
    cells = ("",) * (len(heads) * max(len(positions), 1))
    lines = [TableRow(row, cells) for row in rows]
    return table(lines, first.first, heads, first.text, positions)._replace(name=name)
