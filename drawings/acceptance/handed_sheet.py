"""A sheet that is handed in, as a test asks for it: `sheet.plan("velocity", position=3).vector("b")` (сданный лист)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from drawings.acceptance.assignment import FAIR_HAND, Assignment, FilePath, assignment
from drawings.acceptance.read_plan import NotDrawnError, ReadPlan, chosen, named
from drawings.acceptance.reading import alone, by_its_marks
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.graded import Graded
from plans.words.words import ENGLISH, message


@dataclass(frozen=True)
class HandedSheet:
    """A sheet in a file; the scene that it is of, if it is known; where pictures of what is wrong go, under what name.

    `silent`: what is wrong is told without values, as it is to a student.
    """

    path: Path
    scene: Assignment | None = None
    report: Path | None = None
    name: str = ""
    silent: bool = False

    @property
    def language(self) -> str:
        """The language in which is told what is wrong."""
        return self.scene.language if self.scene else ENGLISH

    def of(self, scene: Assignment | FilePath | None) -> HandedSheet:
        """Give the sheet as one of a scene; of none, as it is."""
        return self if scene is None else replace(self, scene=assignment(scene))

    def plan(self, name: str, position: int | None = None) -> ReadPlan:
        """Give a plan by its name and its position, which need not be said where there is but one."""
        __tracebackhide__ = True
        found = self._read(self.scene)
        if self.scene is not None and not named(found, name, position):
            found = (*found, *self._read(None))  # what is measured and not graded
        return chosen(found, name, position, self.language)

    def _read(self, scene: Assignment | None) -> tuple[DrawnPlan, ...]:
        """Give the plans that are found on the sheet."""
        __tracebackhide__ = True
        changed = self.path.stat().st_mtime_ns if self.path.exists() else 0
        read = _read(self.path, changed, scene)
        if read.reason is not None:
            told = message("accept.rejected", sheet=self.path.name, reason=read.reason)
            raise NotDrawnError(told.worded(self.language))
        return read.drawn


def handed(sheet: HandedSheet | FilePath) -> HandedSheet:
    """Give a sheet of a file."""
    return sheet if isinstance(sheet, HandedSheet) else HandedSheet(Path(sheet))


@cache
def _read(path: Path, changed: int, scene: Assignment | None) -> Graded:
    """Read a sheet, once as long as it is not changed: of a known scene by its letters too, else by its marks alone."""
    return alone(path, by_its_marks) if scene is None else scene.graded(path, FAIR_HAND)
