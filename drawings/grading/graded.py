"""A sheet graded: what its scene asks for, what was found on it, what is said of it, how it ends (оценённый лист)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from hashlib import sha256
from typing import Final, NamedTuple, TypeAlias

from drawings.grading import verdict
from drawings.grading.allowance import Allowances
from drawings.grading.asked import PlanAsked, plan_named, plans_asked
from drawings.grading.cells.asked_table import Drawn, TableAsked, alone, answered, tables_asked, tables_drawn
from drawings.grading.cells.cell_judge import BesideTables, table_verdicts
from drawings.grading.curves.drawn_figure import DrawnFigure
from drawings.grading.curves.figure_judge import allowed_of, figure_verdicts, figures_drawn
from drawings.grading.curves.figure_records import FigureAsked, figures_asked
from drawings.grading.curves.form_figure import every_axes, places_filled
from drawings.grading.drawing_faults import drawing_faults, written_scale
from drawings.grading.drawn_plan import DrawnPlan, drawn_places, from_marks, lacking_places, scales_beside
from drawings.grading.form_place import form_places
from drawings.grading.judgement import Judge
from drawings.grading.onlooker import Onlooker, legible, segments, spelled_labels
from drawings.grading.plans_on_form import plans_on_form, points_on_form, redrawn
from drawings.grading.scheme_arrows import COUPLE, arrow_verdicts, once
from drawings.grading.verdict import OTHERS, RIGHT, Marking, Verdict, keys_of
from drawings.paper.limits import SheetRefused
from drawings.paper.strokes import Text
from drawings.paper.walk import groups, texts
from drawings.reading.sheet import SeenSheet, see, ungiven
from drawings.reading.transform import STAY, Affine
from drawings.redrawn import Originals
from geometry.board import Mark
from plans.model.motion import POSITIONS, Complexes
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


# Right, with mistakes, not read, by an error of ours. What is not read somebody has to look at himself.
PASS, FAIL, UNREAD, OURS = "right", "mistakes", "unread", "error"


NOTES = "notes"  # the group of what a form gives
WORKING = re.compile(r"(?!μ|mu|[KК]_)[^\W\d][^\s=]{0,8}\s*=.*(?<![\w^])\d.*")


class Graded(NamedTuple):
    """How a sheet ends, and its verdicts; of one of which nothing is read the reason."""

    outcome: str
    verdicts: tuple[Verdict, ...] = ()
    reason: Message | None = None
    paper: tuple[float, float] = (0.0, 0.0)  # its width and height, mm
    digest: str = ""  # of the bytes: the same file from two students is told
    scene: str = ""  # the checksum of the scene that it says it is of
    drawn: tuple[DrawnPlan, ...] = ()  # the plans that were found, without their records

    @property
    def wrong(self) -> tuple[Verdict, ...]:
        """What loses something."""
        return tuple(said for said in self.verdicts if said.kind not in (*verdict.GOOD, *verdict.UNGRADED))

    @property
    def unseen(self) -> tuple[Verdict, ...]:
        """What is due and is not read: somebody has to look at it himself."""
        return tuple(said for said in self.verdicts if said.kind in verdict.UNSEEN)


class _FoundOnSheet(NamedTuple):
    plans: Sequence[DrawnPlan]
    figures: Mapping[str, Sequence[DrawnFigure]]
    tables: Drawn


def grade(source: bytes, task: SheetTask, by: Allowances) -> Graded:
    """Grade one sheet; one that cannot be read has the reason."""
    try:
        graded = _graded(source, task, by)
    except SheetRefused as refused:
        graded = Graded(UNREAD, reason=message("grade.refused", reason=refused.reason))
    return graded._replace(digest=sha256(source).hexdigest())


def _graded(source: bytes, task: SheetTask, by: Allowances) -> Graded:
    sheet, onlooker = _read(source)
    tables = tables_drawn(sheet, task.tables)
    found = _FoundOnSheet(plans_drawn(sheet, onlooker, task.plans), figures_drawn(sheet, task.curves), tables)
    if _is_bare(sheet, found, task):
        return Graded(UNREAD, reason=message("grade.bare"))
    said = tuple(_verdicts(sheet, found, task, by))
    if not all(math.isfinite(found.off or 0.0) for found in said):
        return Graded(UNREAD, reason=message("grade.unfinite"))
    said = tuple(_on_page(found, onlooker.moved) for found in said)
    scene = str(sheet.leaf.metadata.get("scene", ""))
    graded = Graded(PASS, said, paper=onlooker.page, scene=scene, drawn=tuple(plan.bare for plan in found.plans))
    return graded._replace(outcome=FAIL if graded.wrong else UNREAD if graded.unseen else PASS)


def _read(source: bytes) -> tuple[SeenSheet, Onlooker]:
    """See what can be read of a sheet, laid back by its corner marks if it was moved."""
    onlooker = Onlooker()
    sheet = see(source, onlooker)
    if sheet.measured.moved != STAY:
        onlooker = Onlooker(sheet.measured.moved)
        sheet = see(source, onlooker)
    return sheet._replace(leaf=legible(ungiven(sheet.leaf))), onlooker


def _on_page(said: Verdict, moved: Affine) -> Verdict:
    """Give a verdict with its places as they lie on the student's own page."""
    at = None if said.at is None else (moved(said.at[0]), moved(said.at[1]))
    return said._replace(at=at, frames=tuple(tuple(moved(spot) for spot in frame) for frame in said.frames))


def _is_bare(sheet: SeenSheet, found: _FoundOnSheet, task: SheetTask) -> bool:
    """Tell whether a sheet bears neither our marks nor a figure in a place of our form, nor tables to be graded."""
    if not (sheet.measured.marks or form_places(sheet.leaf) or every_axes(sheet)):
        lost = any(plan.sheet in alone(found.tables, sheet) for plan in task.plans)
        if lost or not sheet.measured.metadata:
            return True
    if form_places(sheet.leaf):
        return False  # a blank form lacks all
    others = {plan.sheet for plan in task.plans} | {curve.sheet for curve in task.curves}
    return not found.plans and not found.figures and not answered(found.tables, others)


def _verdicts(sheet: SeenSheet, found: _FoundOnSheet, task: SheetTask, by: Allowances) -> Iterator[Verdict]:
    """Judge all that is found on a sheet; what its sheet of the task asks for beside is missing."""
    yield from (said for plan in found.plans if (said := plan.unread) is not None)
    read = [plan for plan in found.plans if plan.unread is None]
    yield from once(tuple(_judged(sheet, read, by)))
    sheets = {plan.asked.sheet for plan in found.plans} | found.figures.keys() | alone(found.tables, sheet)
    there = {plan.asked.place for plan in found.plans}
    placed = {place.plan for place in form_places(sheet.leaf)}
    traced = any(not plan.asked.lettered for plan in found.plans) or bool(found.figures)  # what is found by marks alone
    for plan in task.plans:
        # On a form due is only what can surely be read there: arms, views and images of the lever can not.
        on_form = plan.place in placed and (plan.lettered or plan.plan == POSITIONS.plan)
        due = on_form if placed else plan.lettered or traced
        if plan.sheet in sheets and due and plan.place not in there:
            missing = Verdict(*plan.place, "", verdict.MISSING, unit=plan.unit)
            yield from (missing._replace(name=vector.name, letters=vector.letters) for vector in plan.vectors)
    marked = {plan.asked.sheet for plan in found.plans if not plan.lettered}
    allowed = partial(allowed_of, by=by, coarse=sheet.measured.quantum)
    filled = places_filled(sheet) if "form" in sheet.measured.metadata or every_axes(sheet) or placed else None
    figures = list[tuple[FigureAsked, Complexes]]()
    told = tuple(figure_verdicts(found.figures, task.curves, sheets, marked, allowed, filled, figures))
    yield from told
    shown = BesideTables(read, figures, sheets, {one.kind for one in told})
    yield from table_verdicts(found.tables, task.tables, shown, by, sheet)
    if (workings := tuple(_workings(sheet, found.tables))) and "form" in sheet.measured.metadata:
        what = ", ".join(text.plain for text in workings)
        yield Verdict("workings", None, "", verdict.WORKINGS, of=what, at=(workings[0].at, workings[0].at))


def _workings(sheet: SeenSheet, tables: Drawn) -> Iterator[Text]:
    """Give what a student has worked out beside tables and scales: a letter that is equal to a number."""
    notes = [text.at for group in groups(sheet.leaf.groups) if group.name == NOTES for text in texts((group,))]
    given = {*notes, *(text.at for table in tables for cell in table.cells.values() for text in cell.texts)}
    for text in texts(sheet.leaf.groups) if notes else ():  # of a form that is taken apart nothing tells what is given
        if text.at not in given and WORKING.fullmatch(text.plain):
            yield text


def plans_drawn(sheet: SeenSheet, onlooker: Onlooker, plans: Sequence[PlanAsked]) -> tuple[DrawnPlan, ...]:
    """Find the plans that are asked for on a sheet: by its marks, or by their places on our form."""
    found = (from_marks(plan, sheet.measured, written_scale(sheet, plan)) for plan in plans)
    marked = [plan for plan in found if plan is not None]
    if len(marked) == len(plans) and all(plan.whole for plan in marked):
        return tuple(marked)
    lines, places = segments(sheet.leaf, onlooker.heads), form_places(sheet.leaf)
    if places:  # a form gives the fixed points of the plan of positions with their data
        marked = [plan for plan in marked if not plan.asked.dotted]
    whole = tuple(redrawn(plan, lines) for plan in marked)
    arrows = (vector for plan in marked for vector in plan.asked.vectors if vector.letters in plan.arrows)
    given = any(vector.start or vector.letter for vector in arrows)  # data that are left in one plan are left in all
    if given or not places:
        return whole
    sheets, there = {plan.asked.sheet for plan in marked}, {plan.asked.place for plan in marked}
    left = [plan for plan in plans if plan.place not in there and (not sheets or plan.sheet in sheets)]
    labels, words = spelled_labels(sheet.leaf.groups), list(texts(sheet.leaf.groups))
    where = {place.plan: place for place in places}
    here = (plan for plan in left if plan.dotted and plan.place in where)
    dotted = (points_on_form(plan, where[plan.place], sheet.leaf, labels) for plan in here)
    points = [plan for plan in dotted if plan is not None]
    return (*whole, *plans_on_form(left, lines, words, labels, places), *points)


def _judged(sheet: SeenSheet, drawn: Sequence[DrawnPlan], by: Allowances) -> Iterator[Verdict]:
    labels = spelled_labels(sheet.leaf.groups)
    for plan in drawn:
        beside = [other for other in drawn if other.asked.position == plan.asked.position]
        may = by.of(plan.asked, scales_beside(plan, beside), sheet.measured.quantum)
        yield from Judge(plan, may, drawn_places(beside), lacking_places(beside)).verdicts()
        yield from arrow_verdicts(sheet, plan, by)
        yield from drawing_faults(sheet.leaf, labels, plan)


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
