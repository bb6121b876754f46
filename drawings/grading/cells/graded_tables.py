"""The tables of one sheet graded: found by their corners and rows, judged cell by cell (оценка таблиц)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence, Set
from typing import NamedTuple

from drawings.eye.alike import folded
from drawings.eye.sheet import SeenSheet
from drawings.grading import verdict
from drawings.grading.allowance import Allowances
from drawings.grading.cells.asked_table import CellAsked, Key, SeenCell, SeenTable, TableAsked, tables_seen
from drawings.grading.cells.cell_judge import CellJudge, Readings
from drawings.grading.cells.ruling import ruling
from drawings.grading.cells.written_number import number
from drawings.grading.curves.drawn_figure import DrawnFigure
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.verdict import Verdict
from drawings.paper.walk import texts


class TableDrawn(NamedTuple):
    """A table that is found on a sheet: its cells, in so many parts, and the names of cells that differ in two."""

    asked: TableAsked
    cells: Mapping[Key, SeenCell]
    parts: int = 1
    doubled: tuple[str, ...] = ()


Drawn = Sequence[TableDrawn]


class Shown(NamedTuple):
    """What else is on the sheet, and which sheets of the task that is."""

    plans: Sequence[DrawnPlan]
    figures: Sequence[DrawnFigure]
    sheets: Set[str]


def tables_drawn(seen: SeenSheet, asked: Sequence[TableAsked]) -> Drawn:
    """Find the tables that are asked for on a sheet; all parts of one are put together."""
    corners = {one.corner for one in asked}
    found: dict[int, dict[Key, SeenCell]] = {}
    doubled: dict[int, list[str]] = {}
    parts = Counter[int]()
    for table in tables_seen(ruling(seen.leaf, seen.measured.moved), corners) if asked else ():
        fits = max(range(len(asked)), key=lambda k: _fit(table, asked[k], seen))
        if _fit(table, asked[fits], seen)[0] > 0:
            own = found.setdefault(fits, {})
            parts[fits] += 1
            doubled.setdefault(fits, []).extend(_doubled(asked[fits], own, table.cells))
            own |= {key: cell for key, cell in table.cells.items() if key not in own or not own[key].texts}
    return [TableDrawn(asked[k], cells, parts[k], tuple(doubled[k])) for k, cells in sorted(found.items())]


def _doubled(asked: TableAsked, own: Mapping[Key, SeenCell], other: Mapping[Key, SeenCell]) -> Iterator[str]:
    """Name the cells in which two copies of a table have numbers that differ."""
    for key in (key for key in asked.cells if key in own and key in other):
        ours, theirs = (" ".join(text.plain for text in cells[key].texts) for cells in (own, other))
        if ours and theirs and ours != theirs:
            yield asked.cells[key].name


def answered(found: Drawn, others: Collection[str]) -> bool:
    """Tell whether the tables of a sheet can be graded: written in, or such that nothing else stands on their sheets.

    `others` are the sheets that more is asked for on: where all of it is lost it is not marked down.
    """
    return any(_filled(one, cells) or not set(one.sheets) & set(others) for one, cells, *_ in found)


def alone(found: Drawn, seen: SeenSheet) -> set[str]:
    """Give the sheets of tables that are written in on the only sheet of its kind, of which all is due then."""
    own = (one for one, cells, *_ in found if _filled(one, cells) and seen.measured.metadata.get("of") == 1)
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
    """Judge the tables of a sheet; what is due of them and not there is missing, or told where that is not sure."""
    for one, cells, *_ in found:
        readings = Readings(shown.plans, shown.figures, one.language)
        yield from CellJudge(one, cells, seen.measured.moved, by, seen.measured.quantum, readings).verdicts()
        yield from _missing(one, cells, shown.sheets, seen)
    there = {one.asked.sought for one in found}
    for one in asked:
        if one.sought not in there and set(one.sheets) & shown.sheets:
            lost = [] if _stands(one, found, seen) else list(_missing(one, {}, shown.sheets, seen))
            yield from lost or [Verdict(one.name, None, "", verdict.UNTABLED)]


def _missing(asked: TableAsked, cells: Mapping[Key, SeenCell], sheets: Set[str], seen: SeenSheet) -> Iterator[Verdict]:
    """Name the cells that must stand on a sheet of ours, and do not."""
    due = {asked.cells[key].sheet for key in cells if key in asked.cells} | sheets if _is_whole(seen) else set()
    for key, cell in asked.cells.items():
        if key not in cells and cell.told and cell.sheet in due:
            yield Verdict(asked.name, cell.position, cell.name, verdict.MISSING, unit=cell.unit)


def _stands(asked: TableAsked, found: Drawn, seen: SeenSheet) -> bool:
    """Tell whether the word in the corner of a table is still there: its lines are not read, and it is not missing."""
    words = sum(folded(text.plain) == asked.corner for text in texts(seen.leaf.groups))
    return words > sum(one.parts for one in found if one.asked.corner == asked.corner)


def _is_whole(seen: SeenSheet) -> bool:
    """Tell whether all that its sheets of the task have stands on a sheet: it is ours, or the only one of a form."""
    data = seen.measured.metadata
    return data.get("of") == 1 if "form" in data else bool(data or seen.measured.marks)
