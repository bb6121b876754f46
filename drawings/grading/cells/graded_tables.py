"""The tables of one sheet graded: found by their corners and rows, judged cell by cell (оценка таблиц)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence, Set
from typing import NamedTuple

from drawings.eye.sheet import SeenSheet
from drawings.grading import verdict
from drawings.grading.allowance import Allowances
from drawings.grading.cells.asked_table import CellAsked, TableAsked
from drawings.grading.cells.cell_judge import CellJudge
from drawings.grading.cells.own_reading import Readings
from drawings.grading.cells.ruling import ruling
from drawings.grading.cells.seen_table import Key, SeenCell, SeenTable, tables_seen
from drawings.grading.cells.written_number import number
from drawings.grading.curves.drawn_figure import DrawnFigure
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.verdict import Verdict

Drawn = Sequence[tuple[TableAsked, Mapping[Key, SeenCell]]]


class Shown(NamedTuple):
    """What else is on the sheet, and which sheets of the task that is."""

    plans: Sequence[DrawnPlan]
    figures: Sequence[DrawnFigure]
    sheets: Set[str]


def tables_drawn(seen: SeenSheet, asked: Sequence[TableAsked]) -> Drawn:
    """Find the tables that are asked for on a sheet; all parts of one are put together."""
    corners = {one.corner for one in asked}
    found: dict[int, dict[Key, SeenCell]] = {}
    for table in tables_seen(ruling(seen.leaf, seen.measured.moved), corners) if asked else ():
        fits = max(range(len(asked)), key=lambda k: _fit(table, asked[k], seen))
        if _fit(table, asked[fits], seen)[0] > 0:
            found.setdefault(fits, {}).update(table.cells)
    return [(asked[k], cells) for k, cells in sorted(found.items())]


def answered(found: Drawn, others: Collection[str]) -> bool:
    """Tell whether the tables of a sheet can be graded: written in, or such that nothing else stands on their sheets.

    `others` are the sheets that more is asked for on: where all of it is lost it is not marked down.
    """
    return any(_filled(one, cells) or not set(one.sheets) & set(others) for one, cells in found)


def alone(found: Drawn, seen: SeenSheet) -> set[str]:
    """Give the sheets of tables that are written in on the only sheet of its kind, of which all is due then."""
    own = (one for one, cells in found if _filled(one, cells) and seen.measured.metadata.get("of") == 1)
    return {name for one in own for name in one.sheets}


def _filled(asked: TableAsked, cells: Mapping[Key, SeenCell]) -> bool:
    return any(cells[key].texts for key in asked.cells if key in cells)


def _fit(table: SeenTable, asked: TableAsked, seen: SeenSheet) -> tuple[int, bool, int]:
    """Give how many cells of a table are asked for, whether its sheet is titled so, how many cells are as they must."""
    own = [key for key in table.cells if key in asked.cells]
    said = sum(_says(table.cells[key], asked.cells[key]) for key in own)
    return len(own), seen.leaf.title in asked.titles, said


def _says(seen: SeenCell, asked: CellAsked) -> bool:
    written = number(seen.texts, asked.unit)
    return written is not None and abs(written.value - asked.true[0]) <= asked.printed


def table_verdicts(
    found: Drawn, asked: Sequence[TableAsked], shown: Shown, by: Allowances, seen: SeenSheet
) -> Iterator[Verdict]:
    """Judge the tables of a sheet; one of a sheet of the task that is not on it is told and not graded."""
    for one, cells in found:
        readings = Readings(shown.plans, shown.figures, one.language)
        yield from CellJudge(one, cells, seen.measured.moved, by, seen.measured.quantum, readings).verdicts()
        for cell in (cell for key, cell in one.cells.items() if key not in cells and _is_whole(one, seen)):
            yield Verdict(one.name, cell.position, cell.name, verdict.MISSING, unit=cell.unit)
    there = {one.sought for one, _ in found}
    for one in asked:
        if one.sought not in there and set(one.sheets) & shown.sheets:
            yield Verdict(one.name, None, "", verdict.UNTABLED)


def _is_whole(asked: TableAsked, seen: SeenSheet) -> bool:
    """Tell whether all of a table stands on a sheet that is ours: a form has the rows that tell nothing."""
    data = seen.measured.metadata
    return len(asked.sheets) == 1 and data.get("of") == 1 and "form" not in data
