"""The assignment: a scene that is set, and what its sheets ask for (задание)."""

from __future__ import annotations

import os
from functools import cache, cached_property, partial
from pathlib import Path
from typing import TypeAlias

from drawings.acceptance.reading import AcceptanceError, OnPaper, alone, held
from drawings.grading.allowance import Allowance, Allowances
from drawings.grading.graded import PASS, Graded, grade
from drawings.grading.hints import hints
from drawings.grading.own_sheets import grade_own
from drawings.grading.sheet_task import SheetTask, sheet_task
from drawings.grading.told import Hints
from drawings.grading.tolerance_text import allowance
from drawings.original.originals import Originals
from plans.words.words import message

FAIR_HAND = "0.2 mm"  # what a fair hand slips by, which is allowed where nothing else is said
FilePath: TypeAlias = str | os.PathLike[str]


class Assignment:
    """A scene that is set; its own sheets are drawn when the first one is held against them."""

    def __init__(self, originals: Originals) -> None:
        self.originals = originals
        self._sound = set[Allowance]()

    @property
    def language(self) -> str:
        """The language in which is told what is wrong."""
        return self.originals.language

    @cached_property
    def task(self) -> SheetTask:
        """What the sheets ask for."""
        return sheet_task(self.originals)

    @cached_property
    def hints(self) -> Hints:
        """The steps by which each quantity is found, by its name."""
        return {name: own for plan in self.task.plans for name, own in hints(plan)}

    def graded(self, path: Path, tolerance: str) -> Graded:
        """Grade a sheet; one that cannot be read is rejected with the reason."""
        by = allowance(tolerance)
        if by is None:
            raise AcceptanceError(message("accept.tolerance", tolerance=tolerance))
        self._try_own(by)
        return alone(path, partial(grade, task=self.task, by=Allowances(by)))

    def held(self, path: Path) -> OnPaper | Graded:
        """Hold a sheet against the one that the scene gives; one that cannot be read is rejected."""
        _ = self.originals.sheets  # laid out once for all that are handed in
        return alone(path, partial(held, path=path, originals=self.originals))

    def _try_own(self, by: Allowance) -> None:
        """Grade the scene's own sheets first: nobody is answered by what they do not pass."""
        if not self.task.sheets:
            raise AcceptanceError(message("accept.ungraded", scene=self.originals.path.name))
        if by not in self._sound:
            if grade_own(self.originals, self.task, Allowances(by)).outcome != PASS:
                raise AcceptanceError(message("grade.self"))
            self._sound.add(by)


def assignment(scene: Assignment | FilePath) -> Assignment:
    """Set a scene of a file, once for all sheets that are held against it."""
    if isinstance(scene, Assignment):
        return scene
    path = Path(scene).absolute()
    return _assignment(path, path.stat().st_mtime_ns if path.exists() else 0)


@cache
def _assignment(scene: Path, changed: int) -> Assignment:
    return Assignment(Originals(scene))
