"""Reading what is handed in: always in a process of its own, with limits of memory and time (чтение листа)."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple, TypeVar

from drawings.eye.sheet import see
from drawings.grading.asked import Asked, Place, PlanAsked, ends_of
from drawings.grading.drawn_plan import from_marks
from drawings.grading.graded import OURS, PASS, REJECTED, Graded
from drawings.grading.roll import grade_all
from drawings.measure.measure import Measured, measure
from drawings.original.originals import Originals
from drawings.original.sheet_check import Checked, check
from drawings.paper.limits import SheetRefused
from geometry.errors import DraftError
from plans.words.words import message

Answer = TypeVar("Answer")


class AcceptanceError(DraftError, RuntimeError):
    """What is asked of a sheet cannot be answered, and not by the fault of who drew it."""


class OnPaper(NamedTuple):
    """A sheet that was held against the one that the scene gives, and its own width and height, mm."""

    checked: Checked
    paper: tuple[float, float]


def alone(path: Path, reading: Callable[[bytes], Answer]) -> Answer | Graded:
    """Read one sheet in a process of its own, or give why it is rejected; an error of ours is raised as one."""
    ((_, answer),) = grade_all([path], reading)
    if isinstance(answer, Graded) and answer.outcome == OURS:
        raise AcceptanceError(message("accept.ours", sheet=str(path), reason=answer.reason))
    return answer


def held(source: bytes, path: Path, originals: Originals) -> OnPaper:
    """Hold a sheet against the one that the scene gives."""
    try:
        seen = see(source).leaf
    except SheetRefused:  # of which the check tells
        return OnPaper(check(path, source, originals), (0.0, 0.0))
    return OnPaper(check(path, source, originals), (seen.width, seen.height))


def by_its_marks(source: bytes) -> Graded:
    """Read a sheet by its own marks alone, of whatever scene it is; nothing is judged."""
    try:
        measured = measure(source)
    except SheetRefused as refused:
        return Graded(REJECTED, reason=message("grade.refused", reason=refused.reason))
    found = (from_marks(plan, measured, None) for plan in _stated(measured))
    return Graded(PASS, drawn=tuple(plan for plan in found if plan is not None))


def _stated(measured: Measured) -> list[PlanAsked]:
    """Give the plans of a sheet with what its marks say that they are."""
    places: dict[Place, list[Asked]] = {}
    for mark in measured.marks:
        start, end = ends_of(mark)
        places.setdefault((mark.plan, mark.position), []).append(Asked(mark.name, start, end, mark.stated, None))
    units = {(mark.plan, mark.position): mark.unit for mark in measured.marks}
    return [PlanAsked(*place, "", units[place], tuple(own), {}) for place, own in places.items()]
