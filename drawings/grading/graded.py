"""A sheet graded: what was found on it, what is said of it, and how it ends (оценённый лист)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial
from hashlib import sha256
from typing import NamedTuple

from drawings.checks.labelled import labels_of
from drawings.eye.sheet import SeenSheet, see
from drawings.grading import verdict
from drawings.grading.allowance import Allowances
from drawings.grading.asked import PlanAsked
from drawings.grading.cells.asked_table import TableAsked
from drawings.grading.cells.graded_tables import alone, answered, table_verdicts, tables_drawn
from drawings.grading.curves.asked_figure import FigureAsked
from drawings.grading.curves.graded_figures import allowed_of, figure_verdicts, figures_drawn
from drawings.grading.drawing_faults import drawing_faults, written_scale
from drawings.grading.drawn_plan import DrawnPlan, from_marks
from drawings.grading.judgement import Judge
from drawings.grading.legible import legible
from drawings.grading.lettered_plan import figure_of, lettered_plans, redrawn
from drawings.grading.onlooker import Onlooker
from drawings.grading.own_places import left_out, own_places, scales_of
from drawings.grading.polygons.free_plan import free_plans
from drawings.grading.polygons.scheme_arrows import arrow_verdicts, once
from drawings.grading.segments import figures, segments
from drawings.grading.verdict import Verdict
from drawings.paper.limits import SheetRefused
from drawings.paper.walk import texts
from plans.words.words import Message, message

PASS, FAIL, REJECTED, OURS = "right", "mistakes", "rejected", "error"


class Graded(NamedTuple):
    """How a sheet ends: right, with mistakes, rejected or by an error of ours; the verdicts, or the reason."""

    outcome: str
    verdicts: tuple[Verdict, ...] = ()
    reason: Message | None = None
    paper: tuple[float, float] = (0.0, 0.0)  # its width and height, mm
    digest: str = ""  # of the bytes: the same file from two students is told
    drawn: tuple[DrawnPlan, ...] = ()  # the plans that were found, without their records

    @property
    def wrong(self) -> tuple[Verdict, ...]:
        """What loses something."""
        return tuple(one for one in self.verdicts if one.kind not in (*verdict.GOOD, *verdict.UNGRADED))


def grade(
    source: bytes,
    plans: Sequence[PlanAsked],
    by: Allowances,
    curves: Sequence[FigureAsked] = (),
    tables: Sequence[TableAsked] = (),
) -> Graded:
    """Grade one sheet; what cannot be read is rejected with the reason."""
    return _graded(source, plans, by, curves, tables)._replace(digest=sha256(source).hexdigest())


def _graded(
    source: bytes,
    plans: Sequence[PlanAsked],
    by: Allowances,
    curves: Sequence[FigureAsked],
    tables: Sequence[TableAsked],
) -> Graded:
    onlooker = Onlooker()
    try:
        seen = see(source, onlooker)
        seen = seen._replace(leaf=legible(seen.leaf))
    except SheetRefused as refused:
        return Graded(REJECTED, reason=message("grade.refused", reason=refused.reason))
    drawn = plans_drawn(seen, onlooker, plans)
    figures = figures_drawn(seen, curves)
    cells = tables_drawn(seen, tables)
    others = {plan.sheet for plan in plans} | {curve.sheet for curve in curves}
    if not drawn and not figures and not answered(cells, others):
        return Graded(REJECTED, reason=message("grade.nothing" if plans else "grade.formless"))
    if unread := [one.name for plan in drawn if plan.lettered for one in plan.lacking if not plan.is_small(one)]:
        return Graded(REJECTED, reason=message("grade.unread", names=", ".join(dict.fromkeys(unread))))
    sheets = {plan.asked.sheet for plan in drawn} | figures.keys() | alone(cells, seen)
    there = {plan.asked.place for plan in drawn}
    told = any(not plan.asked.lettered for plan in drawn) or bool(figures)  # what is found by marks alone
    due = [plan for plan in plans if plan.sheet in sheets and (told or plan.lettered)]
    lost = (plan for plan in due if plan.place not in there)
    marked = {plan.asked.sheet for plan in drawn if not plan.lettered}
    told_of = figure_verdicts(figures, curves, sheets, marked, partial(allowed_of, by=by, coarse=seen.measured.quantum))
    of_cells = table_verdicts(cells, tables, sheets | {*figures}, drawn, by, seen)
    judged = once(tuple(_judged(seen, drawn, by)))
    said = (*judged, *(one for plan in lost for one in _missing(plan)), *told_of, *of_cells)
    if not all(math.isfinite(one.off or 0.0) for one in said):
        return Graded(REJECTED, reason=message("grade.unfinite"))
    paper = seen.leaf.width, seen.leaf.height
    graded = Graded(PASS, tuple(said), paper=paper, drawn=tuple(plan.bare for plan in drawn))
    return graded._replace(outcome=FAIL) if graded.wrong else graded


def _missing(plan: PlanAsked) -> Iterator[Verdict]:
    """Name the vectors of a plan that is not drawn at all."""
    for one in plan.vectors:
        yield Verdict(plan.plan, plan.position, one.name, verdict.MISSING, unit=plan.unit, letters=one.letters)


def plans_drawn(seen: SeenSheet, onlooker: Onlooker, plans: Sequence[PlanAsked]) -> tuple[DrawnPlan, ...]:
    """Find the plans that are asked for on a sheet: by its marks, and those without any by their letters."""
    found = (from_marks(one, seen.measured, written_scale(seen, one)) for one in plans)
    marked = [one for one in found if one is not None]
    if len(marked) == len(plans) and all(plan.whole for plan in marked):
        return tuple(marked)
    lines = segments(seen.leaf, onlooker.heads)
    whole = tuple(redrawn(plan, lines) for plan in marked)
    if any(plan.arrowed for plan in marked):  # data that are left in one plan are left in all
        return whole
    here = {plan.asked.sheet for plan in marked}
    own = [figure_of(one) for one in figures(lines)]
    there = {plan.asked.place for plan in marked}
    left = [one for one in plans if one.place not in there and (not here or one.sheet in here)]
    words, labels = list(texts(seen.leaf.groups)), [one for own in labels_of(seen.leaf.groups).values() for one in own]
    polygons = tuple(free_plans(left, lines, words, labels))
    here |= {plan.asked.sheet for plan in polygons}  # a lever looks as the plan of another sheet does
    others = [one for one in left if not here or one.sheet in here]
    return (*whole, *polygons, *lettered_plans(others, own, words))


def _judged(seen: SeenSheet, drawn: Sequence[DrawnPlan], by: Allowances) -> Iterator[Verdict]:
    labels = labels_of(seen.leaf.groups)
    for plan in drawn:
        beside = [one for one in drawn if one.asked.position == plan.asked.position]
        may = by.of(plan.asked, scales_of(plan, beside), seen.measured.quantum)
        yield from Judge(plan, may, own_places(beside), left_out(beside)).verdicts()
        yield from arrow_verdicts(seen, plan, by)
        yield from drawing_faults(seen.leaf, labels, plan)
