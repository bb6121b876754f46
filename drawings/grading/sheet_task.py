"""What the sheets of a scene ask for, to be graded: plans, curves, tables, by what each is found (задание листов)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Final, NamedTuple, TypeAlias

from drawings.grading.asked import PlanAsked, plan_named, plans_asked
from drawings.grading.cells.asked_table import TableAsked, tables_asked
from drawings.grading.curves.figure_records import FigureAsked, figures_asked
from drawings.grading.scheme_arrows import COUPLE
from drawings.grading.verdict import OTHERS, RIGHT, Marking, Verdict, keys_of
from drawings.redrawn import Originals
from geometry.board import Mark
from plans.words.words import Message, because, message

Hints: TypeAlias = Mapping[str, tuple[Message, ...]]  # the steps to look at again, by the names of quantities
# How the record names lines that no letter names, and the keys of their words.
LINES: Final = {"guide of": "guide", "slot of": "slot", "stone": "stone", "line of action": "action"}


class SheetTask(NamedTuple):
    """The plans, curves and tables that are asked for."""

    plans: Sequence[PlanAsked] = ()
    curves: Sequence[FigureAsked] = ()
    tables: Sequence[TableAsked] = ()

    @property
    def sheets(self) -> frozenset[str]:
        """The sheets that ask for something, by name."""
        drawn = (*(plan.sheet for plan in self.plans), *(curve.sheet for curve in self.curves))
        return frozenset((*drawn, *(name for table in self.tables for name in table.sheets)))

    @property
    def hints(self) -> Hints:
        """By what each quantity is found, by their names."""
        return dict(_of_curves(self.curves)) | {name: steps for plan in self.plans for name, steps in _of_plan(plan)}


def sheet_task(originals: Originals) -> SheetTask:
    """Gather what a scene's own sheets ask for."""
    return SheetTask(plans_asked(originals), figures_asked(originals), tables_asked(originals))


def _of_plan(plan: PlanAsked) -> Iterator[tuple[str, tuple[Message, ...]]]:
    for vector in plan.vectors:
        if vector.found is not None:
            yield vector.name, tuple(_steps(max(vector.found.span, key=lambda mark: mark.number)))
    couple = _hint(plan_named(plan.plan), because("inertia_moment"))
    yield from ((name, (couple,)) for name in plan.ways if name.startswith(COUPLE))


def _of_curves(figures: Sequence[FigureAsked]) -> Iterator[tuple[str, tuple[Message, ...]]]:
    for figure in figures:
        if figure.why is not None:
            hint = _hint(plan_named(figure.plan), figure.why)
            yield from ((item.called, (hint,)) for item in figure.items)


def _hint(name: str | Message, why: Message) -> Message:
    return message("grade.hint", name=name, why=why)


def _steps(end: Mark) -> Iterator[Message]:
    """Give what a place is found by: the lines that meet there, or the vector that is laid off."""
    sources = end.step.inputs if end.step.op == "meet" else end.step.inputs[1:]
    yield from (_hint(_named(mark), mark.step.why) for mark in (*sources, end) if isinstance(mark.step.why, Message))


def _named(mark: Mark) -> str | Message:
    """Name what is drawn in a step: by its letters, or a line by what it is of.

    The record names its lines in one language.
    """
    for begin, key in LINES.items():
        if mark.name.startswith(begin):
            return message(f"grade.line.{key}", of=mark.name.removeprefix(begin).strip())
    return mark.name


def idle_keys(marking: Marking, task: SheetTask) -> tuple[str, ...]:
    """Give the keys of points and of tolerances that are of no quantity of a task, as their tables have them."""
    drawn, cells = list(_drawn(task)), [cell for table in task.tables for cell in table.cells.values()]
    verdicts = [Verdict(table.name, None, cell.name, RIGHT) for table in task.tables for cell in table.cells.values()]
    points = {key for quantity in (*drawn, *verdicts) for key in keys_of(quantity)} | {OTHERS}
    names = (*(quantity.name for quantity in drawn), *(cell.quantity for cell in cells))
    slips = {key for name in names for key in (name, name.partition("_")[0])}
    idle = [f"points.{key}" for key in marking.points if key not in points]
    plans = {quantity.plan for quantity in (*drawn, *verdicts)}
    figures = {*plans, *(re.split("[- ]", plan)[0] for plan in plans), OTHERS}
    idle += [f"caps.{key}" for key in marking.caps if key not in figures]
    return (*idle, *(f"tolerance.{key}" for key in marking.tolerance if key not in slips))


def _drawn(task: SheetTask) -> Iterator[Verdict]:
    for plan in task.plans:
        names = (*(vector.name for vector in plan.vectors), *plan.ways)
        yield from (Verdict(plan.plan, plan.position, name, RIGHT) for name in names)
    for curve in task.curves:
        yield from (Verdict(curve.plan, None, item.called, RIGHT) for item in curve.items)
