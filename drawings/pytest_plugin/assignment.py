"""The assignment: a scene that is set, and what its sheets ask for (задание)."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cache, cached_property, partial
from pathlib import Path
from typing import NamedTuple, TypeAlias, TypeVar

from drawings.grading.allowance import Allowance, Allowances, allowance
from drawings.grading.asked import Place, PlanAsked, VectorAsked, ends_of
from drawings.grading.class_list import grade_all, grade_own
from drawings.grading.drawn_plan import from_marks
from drawings.grading.graded import OURS, PASS, UNREAD, Graded, SheetTask, grade, sheet_task
from drawings.paper.limits import SheetRefused
from drawings.reading.measure import Measured, measure
from drawings.reading.sheet import see
from drawings.redrawn import Checked, Originals, check
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
        leaf = see(source).leaf
    except SheetRefused:  # of which the check tells
        return OnPaper(check(path, source, originals), (0.0, 0.0))
    return OnPaper(check(path, source, originals), (leaf.width, leaf.height))


def by_its_marks(source: bytes) -> Graded:
    """Read a sheet by its own marks alone, of whatever scene it is; nothing is judged."""
    try:
        measured = measure(source)
    except SheetRefused as refused:
        return Graded(UNREAD, reason=message("grade.refused", reason=refused.reason))
    found = (from_marks(plan, measured, None) for plan in _stated(measured))
    return Graded(PASS, drawn=tuple(plan for plan in found if plan is not None))


def _stated(measured: Measured) -> list[PlanAsked]:
    """Give the plans of a sheet with what its marks say that they are."""
    places: dict[Place, list[VectorAsked]] = {}
    for mark in measured.marks:
        start, end = ends_of(mark)
        places.setdefault((mark.plan, mark.position), []).append(VectorAsked(mark.name, start, end, mark.stated, None))
    units = {(mark.plan, mark.position): mark.unit for mark in measured.marks}
    return [PlanAsked(*place, "", units[place], tuple(vectors), {}) for place, vectors in places.items()]


FilePath: TypeAlias = str | os.PathLike[str]


def tolerated(tolerance: str) -> Allowance:
    """Read a tolerance."""
    if (found := allowance(tolerance)) is None:
        raise AcceptanceError(message("accept.tolerance", tolerance=tolerance))
    return found


class Assignment:
    """A scene that is set; its own sheets are drawn when the first one is held against them."""

    def __init__(self, originals: Originals) -> None:
        self.originals = originals
        self._sound = set[Allowance]()

    def __repr__(self) -> str:
        return self.originals.path.name

    @property
    def language(self) -> str:
        """The language in which is told what is wrong."""
        return self.originals.language

    @cached_property
    def task(self) -> SheetTask:
        """What the sheets ask for."""
        return sheet_task(self.originals)

    def graded(self, path: Path, by: Allowance) -> Graded:
        """Grade a sheet; one that cannot be read is rejected with the reason."""
        if not self.task.sheets:
            raise AcceptanceError(message("accept.ungraded", scene=self.originals.path.name))
        if by not in self._sound:
            if grade_own(self.originals, self.task, Allowances(by)).outcome != PASS:
                raise AcceptanceError(message("grade.self"))
            self._sound.add(by)
        return alone(path, partial(grade, task=self.task, by=Allowances(by)))

    def held(self, path: Path) -> OnPaper | Graded:
        """Hold a sheet against the one that the scene gives; one that cannot be read is rejected."""
        _ = self.originals.sheets  # laid out once for all that are handed in
        return alone(path, partial(held, path=path, originals=self.originals))


def assignment(scene: Assignment | FilePath) -> Assignment:
    """Set a scene of a file, once for all sheets that are held against it."""
    if isinstance(scene, Assignment):
        return scene
    path = Path(scene).absolute()
    return _assignment(path, path.stat().st_mtime_ns if path.exists() else 0)


@cache
def _assignment(scene: Path, changed: int) -> Assignment:
    return Assignment(Originals(scene))
