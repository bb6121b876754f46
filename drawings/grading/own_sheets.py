"""A scene's own sheets, graded before any student's: they are right if anything is (свои листы)."""

from __future__ import annotations

from drawings.grading.allowance import Allowances
from drawings.grading.graded import PASS, REJECTED, Graded, grade
from drawings.grading.sheet_task import SheetTask
from drawings.original.originals import Originals


def grade_own(originals: Originals, task: SheetTask, by: Allowances) -> Graded:
    """Grade the scene's own sheets; the first that is not right is told."""
    every = [grade(originals.drawn(one), task, by) for one in originals.sheets if one.name in task.sheets]
    return next((one for one in every if one.outcome != PASS), Graded(PASS if every else REJECTED))
