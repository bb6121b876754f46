"""Keys of a table of marks that change nothing: no quantity of the task is called so (лишние обозначения)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.grading.asked import PlanAsked
from drawings.grading.cells.asked_table import TableAsked
from drawings.grading.curves.asked_figure import FigureAsked
from drawings.grading.marking import OTHERS, Marking, keys_of
from drawings.grading.sheet_task import SheetTask
from drawings.grading.verdict import RIGHT, Verdict


def idle_keys(marking: Marking, task: SheetTask) -> tuple[str, ...]:
    """Give the keys of points and of tolerances that are of no quantity of a task, as their tables have them."""
    drawn, cells = list(_drawn(task.plans, task.curves)), list(_cells(task.tables))
    points = {key for one in (*drawn, *cells) for key in keys_of(one)} | {OTHERS}
    read = {key for table in task.tables for cell in table.cells.values() for key in _names(cell.quantity)}
    slips = {key for one in drawn for key in _names(one.name)} | read
    idle = [f"points.{key}" for key in marking.points if key not in points]
    return (*idle, *(f"tolerance.{key}" for key in marking.tolerance if key not in slips))


def _names(name: str) -> tuple[str, str]:
    return name, name.partition("_")[0]


def _drawn(plans: Sequence[PlanAsked], curves: Sequence[FigureAsked]) -> Iterator[Verdict]:
    """Give a verdict on each quantity that is drawn."""
    for plan in plans:
        names = (*(one.name for one in plan.vectors), *plan.senses, *plan.turns)
        yield from (Verdict(plan.plan, plan.position, name, RIGHT) for name in names)
    for curve in curves:
        yield from (Verdict(curve.plan, None, one.called, RIGHT) for one in curve.items)


def _cells(tables: Sequence[TableAsked]) -> Iterator[Verdict]:
    for table in tables:
        yield from (Verdict(table.name, cell.position, cell.name, RIGHT) for cell in table.cells.values())
