"""The tables of one sheet graded: found by their corners and rows, judged cell by cell (оценка таблиц)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence, Set
from typing import NamedTuple

from drawings.grading import verdict
from drawings.grading.allowance import Allowances
from drawings.grading.cells.asked_table import TableAsked
from drawings.grading.cells.cell_judge import BesideTables, CellJudge
from drawings.grading.cells.seen_table import Key, SeenCell, SeenTable, ruling, tables_seen
from drawings.grading.verdict import Verdict
from drawings.grading.written_number import number
from drawings.paper.walk import texts
from drawings.reading.alphabet import folded
from drawings.reading.sheet import SeenSheet


class TableDrawn(NamedTuple):
    """A table that is found on a sheet: its cells, in so many parts, and which of them differ in two."""

    asked: TableAsked
    cells: Mapping[Key, SeenCell]
    parts: int = 1
    doubled: Set[Key] = frozenset()


Drawn = Sequence[TableDrawn]


def tables_drawn(sheet: SeenSheet, asked: Sequence[TableAsked]) -> Drawn:
    """Find the tables that are asked for on a sheet; all parts of one are put together."""
    corners = {table.corner for table in asked}
    found: dict[int, list[SeenTable]] = {}
    for table in tables_seen(ruling(sheet.leaf), corners) if asked else ():
        fits = max(range(len(asked)), key=lambda k: _fit(table, asked[k], sheet))
        if _fit(table, asked[fits], sheet)[0] > 0:
            found.setdefault(fits, []).append(table)
    return [_whole(asked[k], parts) for k, parts in sorted(found.items())]


def _whole(asked: TableAsked, parts: Sequence[SeenTable]) -> TableDrawn:
    cells, doubled = dict[Key, SeenCell](), set[Key]()
    for key, cell in (pair for part in parts for pair in part.cells.items()):
        first = cells.get(key, cell)
        doubled |= {key} if key in asked.cells and len({first.plain, cell.plain, ""}) > 2 else set()
        cells[key] = first if first.texts else cell
    return TableDrawn(asked, cells, len(parts), doubled)


def answered(found: Drawn, others: Collection[str]) -> bool:
    """Tell whether the tables of a sheet can be graded: written in, or such that nothing else stands on their sheets.

    `others` are the sheets that more is asked for on: where all of it is lost it is not marked down.
    """
    return any(_filled(asked, cells) or not set(asked.sheets) & set(others) for asked, cells, *_ in found)


def alone(found: Drawn, sheet: SeenSheet) -> set[str]:
    """Give the sheets of tables that are written in on the only sheet of its kind, of which all is due then."""
    written = (asked for asked, cells, *_ in found if _filled(asked, cells) and sheet.measured.metadata.get("of") == 1)
    return {name for asked in written for name in asked.sheets}


def _filled(asked: TableAsked, cells: Mapping[Key, SeenCell]) -> bool:
    return any(cells[key].texts for key in asked.cells if key in cells)


def _fit(table: SeenTable, asked: TableAsked, sheet: SeenSheet) -> tuple[int, bool, int]:
    """Give how many cells of a table are asked for, whether its sheet is titled so, how many cells are as they must."""
    keys = [key for key in table.cells if key in asked.cells]
    written = ((number(table.cells[key].texts, asked.cells[key].unit), asked.cells[key]) for key in keys)
    said = sum(one is not None and abs(one.value - cell.true) <= cell.printed for one, cell in written)
    return len(keys), sheet.leaf.title in asked.titles, said


def table_verdicts(
    found: Drawn, asked: Sequence[TableAsked], shown: BesideTables, by: Allowances, sheet: SeenSheet
) -> Iterator[Verdict]:
    """Judge the tables of a sheet; what is due of them and not there is missing, or told where that is not sure."""
    for table, cells, _, doubled in found:
        yield from CellJudge(table, cells, by, sheet.measured.quantum, shown, doubled).verdicts()
        yield from _missing(table, cells, shown.sheets, sheet)
    there = {found_.asked.sought for found_ in found}
    for table in asked:
        if table.sought not in there and set(table.sheets) & shown.sheets:
            stands, data = _stands(table, found, sheet), sheet.measured.metadata
            lost = [] if stands else list(_missing(table, {}, shown.sheets, sheet))
            if lost or stands or "form" not in data or data.get("of") == 1:  # else it is on another page of the form
                yield from lost or [Verdict(table.name, None, "", verdict.UNTABLED)]


def _missing(asked: TableAsked, cells: Mapping[Key, SeenCell], sheets: Set[str], sheet: SeenSheet) -> Iterator[Verdict]:
    """Name the cells that must stand on a sheet of ours, and do not."""
    expected = {asked.cells[key].sheet for key in cells if key in asked.cells} | sheets if _is_whole(sheet) else set()
    for key, cell in asked.cells.items():
        if key not in cells and cell.told and cell.sheet in expected:
            yield Verdict(asked.name, cell.position, cell.name, verdict.MISSING, unit=cell.unit)


def _stands(asked: TableAsked, found: Drawn, sheet: SeenSheet) -> bool:
    """Tell whether the word in the corner of a table is still there: its lines are not read, and it is not missing."""
    words = sum(folded(text.plain) == asked.corner for text in texts(sheet.leaf.groups))
    return words > sum(table.parts for table in found if table.asked.corner == asked.corner)


def _is_whole(sheet: SeenSheet) -> bool:
    """Tell whether all that its sheets of the task have stands on a sheet: it is ours, or the only one of a form."""
    data = sheet.measured.metadata
    return data.get("of") == 1 if "form" in data else bool(data or sheet.measured.marks)
