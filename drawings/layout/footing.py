"""The foot of a column of a sheet: the table, the notes and the title block, in the ways that they can stand."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from drawings.layout.table import RuledTable, Setting
from drawings.page.page import Field

PAD = 6.0  # mm between the frame, the table, the notes and the figures
NARROW = 70.0  # mm, the least width of a column of notes
BROKEN = 0.9  # share of a line that words fill on average when it is broken between them


class Notes(NamedTuple):
    """What the sheet says in words: the length of each paragraph in one line, the step of the lines, mm.

    They stand in no column of less than `least` mm.
    """

    lengths: tuple[float, ...]
    step: float
    least: float = NARROW

    def height(self, width: float) -> float:
        """Give the height, mm, of the notes broken at a width."""
        return sum(math.ceil(length / (BROKEN * width)) for length in self.lengths) * self.step


class Foot(NamedTuple):
    """A foot of a column: how high it is, and where table and notes stand."""

    top: float
    table: complex | None  # upper left corner
    notes: Field | None


def feet(
    column: Field, block: Field | None, table: RuledTable | None, setting: Setting | None, notes: Notes | None
) -> Iterator[Foot]:
    """List the ways to stand a table, notes and a title block at the foot of a column."""
    wide, high = table.size(setting) if table is not None and setting is not None else (0.0, 0.0)
    if wide > column.width:
        return
    ends = column.right if block is None else block.left - PAD
    floor = column.bottom if block is None else block.top + PAD
    beside, over = _one_row(column, ends, wide), _one_row(column, column.right, 0.0)
    if wide <= ends - column.left:
        corner = complex(column.left, column.bottom + high) if wide else None
        low = max(column.bottom + high, floor - PAD if block is not None else column.bottom)
        if notes is None:
            yield Foot(low, corner, None)
        elif beside.width >= notes.least:  # table, notes and block stand in one row
            tall = notes.height(beside.width)
            yield Foot(max(low, column.bottom + tall), corner, _upright(beside, column.bottom, tall))
        if notes is not None and block is not None and wide:  # the notes stand on the block, the table beside both
            stood = Field(block.left, floor, column.right, floor + notes.height(block.width))
            yield Foot(max(low, stood.top), corner, stood)
    if notes is None:
        yield Foot(floor + high, complex(column.left, floor + high), None)
    else:
        row = _one_row(column, ends, 0.0)
        if block is not None and row.width >= notes.least:  # notes and block in one row, the table on them
            tall = notes.height(row.width)
            top = max(floor - PAD, column.bottom + tall)
            yield _under_table(column, top, wide, high, _upright(row, column.bottom, tall))
        tall = notes.height(over.width)
        yield _under_table(column, floor + tall, wide, high, _upright(over, floor, tall))


def _one_row(column: Field, ends: float, wide: float) -> Field:
    """Give what a table leaves of a row for notes."""
    return Field(column.left + (wide + PAD if wide else 0.0), column.bottom, ends, column.top)


def _upright(row: Field, bottom: float, height: float) -> Field:
    return Field(row.left, bottom, row.right, bottom + height)


def _under_table(column: Field, top: float, wide: float, high: float, notes: Field) -> Foot:
    if not wide:
        return Foot(top, None, notes)
    return Foot(top + PAD + high, complex(column.left, top + PAD + high), notes)
