"""What a sheet of a cyclogram tells, read back: dimensions, letters of the charts, table, notes (проверка надписей)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import islice

from drawings.checks import reading
from drawings.checks.cyclogram.due_notes import DueNotes
from drawings.checks.documents_old import ruled, written_notes
from drawings.checks.documents_old.told_cell import Cell
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.precise import precise
from drawings.checks.wrong import Wrong, within
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Leaf, Text
from drawings.paper.walk import groups
from plans.checks.cyclogram_comparison import CyclogramComparison
from plans.model.cam import Cam
from plans.model.cyclogram import BEGIN, END, Cyclogram, Position
from plans.words.words import message

TABLE = "stations"  # the name of the table of positions
HEADS = ("φ by plan, °", "φ by analysis, °", "condition")
DIGITS = 7  # of the numbers of the notes
ANGLES, LENGTHS, TIMES = 5, 3, 3  # of the table: decimals of an angle, and of a length; digits of a condition


def table(leaf: Leaf, found: Cyclogram, drafting: Drafting) -> Iterator[Wrong]:
    """Read the table back, its lines and headings too: the positions of the analysis, every cell to its last digit."""
    due = dict(zip(names(found, drafting), (_due(one, found) for one in found.positions), strict=True))
    heads = [read(drafting.word(key)) for key in ("characteristic position", _gone(found), *HEADS)]
    for group in tables(leaf):
        yield from ruled.faults(group, TABLE, heads)
        for name, *cells in ([text.plain for text in row] for row in _lines(group)):
            own = due.pop(name, None)
            if own is None or len(cells) != len(own):
                yield within("row", TABLE, name=name)
                continue
            wrong = (text for text, cell in zip(cells, own, strict=True) if not cell.holds(text))
            yield from (message("wrong.row_cell", name=name, text=text) for text in wrong)
    if len(due) < len(found.positions) or leaf.metadata["of"] == 1:
        yield from (message("wrong.row_missing", name=name) for name in due)


def names(found: Cyclogram, drafting: Drafting) -> list[str]:
    """Give the first cells of the rows that there must be: the number of each position, and what it is."""
    return [f"{k}  {drafting.word(f'role {one.role}')}" for k, one in enumerate(found.positions)]


def tables(leaf: Leaf) -> Iterator[Group]:
    """Give the parts of the table of positions that a sheet bears."""
    return (one for one in groups(leaf.groups) if one.name.startswith(f"{TABLE}-"))


def _lines(group: Group) -> Iterator[Sequence[Text]]:
    """Give the rows of a part of the table under its headings."""
    return islice(sorted(reading.rows(group), key=lambda row: -row[0].at.imag), 1, None)


def _gone(found: Cyclogram) -> str:
    return "S, mm" if found.sliding else "ψ, °"


def _due(one: Position, found: Cyclogram) -> tuple[Cell, ...]:
    """Give what the cells of a position must say; where the tool stands nothing bounds how the turn is known."""
    gone = one.share * (1000 * found.stroke if found.sliding else math.degrees(found.stroke))
    turned = Cell(math.degrees(one.turned), ANGLES, turns=True)
    known = math.inf if one.role in (BEGIN, END) else one.condition
    return Cell(gone, LENGTHS), turned, turned, Cell(known, digits=TIMES)


def notes(leaf: Leaf, comparison: CyclogramComparison, cams: Sequence[Cam], drafting: Drafting) -> Iterator[Wrong]:
    """Read the notes back; of the construction is taken whether it has notched every position."""
    notched = all(one.notched for one in comparison.construction.positions)
    due = DueNotes(comparison.analysis, notched, cams, precise(drafting))
    return written_notes.faults(leaf, due.all(), (DIGITS,))
