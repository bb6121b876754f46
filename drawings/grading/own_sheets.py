"""A scene's own sheets, graded before any student's: they are right if anything is (свои листы)."""

from __future__ import annotations

from collections.abc import Sequence

from drawings.grading.allowance import Allowances
from drawings.grading.asked import PlanAsked
from drawings.grading.cells.asked_table import TableAsked
from drawings.grading.curves.asked_figure import FigureAsked
from drawings.grading.graded import PASS, REJECTED, Graded, grade
from drawings.original.originals import Originals


def grade_own(
    originals: Originals,
    plans: Sequence[PlanAsked],
    by: Allowances,
    curves: Sequence[FigureAsked] = (),
    tables: Sequence[TableAsked] = (),
) -> Graded:
    """Grade the scene's own sheets; the first that is not right is told."""
    sheets = {plan.sheet for plan in plans} | {curve.sheet for curve in curves}
    sheets |= {name for table in tables for name in table.sheets}
    every = [grade(originals.drawn(one), plans, by, curves, tables) for one in originals.sheets if one.name in sheets]
    return next((one for one in every if one.outcome != PASS), Graded(PASS if every else REJECTED))
