"""A sheet that is handed in, as a test asks for it: `sheet.plan("velocity", position=3).vector("b")` (сданный лист)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import NamedTuple

from drawings.grading.allowance import Allowance
from drawings.grading.asked import plan_named, plan_told
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.graded import Graded
from drawings.grading.onlooker import spelled
from drawings.pytest_plugin.assignment import Assignment, FilePath, alone, assignment, by_its_marks
from geometry.errors import DraftError
from plans.words.words import ENGLISH, Message, languages, message, term

WHOLE = 360.0  # degrees


class NotDrawnError(DraftError, AssertionError):
    """A plan or a vector that is asked of a sheet and is not on it."""


class ReadAngle(float):
    """A direction, degrees from x, counter-clockwise, from 0 to 360; what it differs from another by is within a turn.

    >>> ReadAngle(359.5) - 1.0, 1.0 - ReadAngle(359.5), ReadAngle(0.0) == 360.0
    (-1.5, 1.5, True)
    """

    def __sub__(self, other: float) -> float:
        return math.remainder(float(self) - float(other), WHOLE)

    def __rsub__(self, other: float) -> float:
        return math.remainder(float(other) - float(self), WHOLE)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, int | float):  # what is about so large compares by itself
            return NotImplemented
        return math.remainder(float(self) - float(other), WHOLE) == 0.0

    def __hash__(self) -> int:
        return hash(float(self) % WHOLE)


class ReadVector(NamedTuple):
    """A vector of a sheet, or a point of its plan of positions: its value in true units."""

    name: str
    value: complex
    unit: str

    @property
    def size(self) -> float:
        """How long it is."""
        return abs(self.value)

    @property
    def angle(self) -> ReadAngle:
        """Its direction, degrees from x, counter-clockwise, from 0 to 360; compared within a turn."""
        return ReadAngle(math.degrees(cmath.phase(self.value)) % WHOLE)

    def __repr__(self) -> str:
        return f"{self.name} = {self.size:.4g} {self.unit} at {self.angle:.1f}°"

    @property
    def x(self) -> float:
        """Its share along x."""
        return self.value.real

    @property
    def y(self) -> float:
        """Its share along y, which goes up."""
        return self.value.imag


@dataclass(frozen=True)
class ReadPlan:
    """A plan of a sheet as it was read: found by its marks or by its letters, measured by the scale written on it."""

    drawn: DrawnPlan
    language: str

    def __repr__(self) -> str:
        return plan_told(self.name, self.position).worded(self.language)

    @property
    def name(self) -> str:
        """What plan it is."""
        return self.drawn.asked.plan

    @property
    def position(self) -> int | None:
        """Of what position it is."""
        return self.drawn.asked.position

    @property
    def scale(self) -> float:
        """True units a mm."""
        return self.drawn.scale

    def vector(self, name: str) -> ReadVector:
        """Give a vector by its name ("v_B"), by the letters of its ends ("a b"), or from the pole to a letter ("b")."""
        __tracebackhide__ = True
        start, end = self._letters(name)
        value = self.drawn.value((start, end))
        if value is None:
            value = self.drawn.between(start, end)
        if value is None:
            there = tuple(one.name for one in self.drawn.asked.vectors if one.letters in self.drawn.arrows)
            where = plan_told(self.name, self.position)
            raise NotDrawnError(message("accept.no_vector", plan=where, name=name, names=there).worded(self.language))
        return ReadVector(name, value, self.drawn.asked.unit)

    def _letters(self, name: str) -> tuple[str, str]:
        named = [vector.letters for vector in self.drawn.asked.vectors if vector.name == name]
        if named:
            return named[0]
        known = {spelled(letter): letter for letter in self.drawn.places}
        start, _, end = name.rpartition(" ")
        return known.get(spelled(start), start) if start else self._pole, known.get(spelled(end), end)

    @property
    def _pole(self) -> str:
        """The letter that arrows begin at, and none ends at."""
        begins, ends = ({letters[k] for letters in self.drawn.arrows} for k in (0, 1))
        return next(iter(sorted(begins - ends)), "")


def chosen(plans: Sequence[DrawnPlan], name: str, position: int | None, language: str) -> ReadPlan:
    """Give the plan of a name in anybody's words: "velocity", "velocities", "план скоростей"."""
    __tracebackhide__ = True
    found = named(plans, name, position)
    if len(found) == 1:
        return ReadPlan(found[0], language)
    there = tuple(_faults(found or plans)) or (message("accept.nothing"),)
    key = f"accept.{'no' if not found else 'several'}_plan{'' if position is None else '_at'}"
    raise NotDrawnError(message(key, name=name, names=there, position=position).worded(language))


def named(plans: Sequence[DrawnPlan], name: str, position: int | None) -> list[DrawnPlan]:
    """Give the plans that are called so, of that position if one is said."""
    return [plan for plan in plans if _called(plan.asked.plan, name) and position in (None, plan.asked.position)]


def _called(plan: str, name: str) -> bool:
    """Tell whether a plan is called so, in any language, one or many."""
    wanted = name.casefold().replace("_", " ")
    known = {plan, plan.removesuffix("s"), *(term(language, "plan", plan) for language in languages())}
    known |= {plan_named(plan).worded(language) for language in languages()}
    known |= {f"{word.removesuffix('ies')}y" for word in known if word.endswith("ies")}
    return wanted in {word.casefold().replace("_", " ") for word in known}


def _faults(plans: Iterable[DrawnPlan]) -> Iterator[Message]:
    positions: dict[str, list[str]] = {}
    for plan, position in (plan.asked.place for plan in plans):
        positions.setdefault(plan, []).extend([] if position is None else [str(position)])
    yield from (plan_told(plan, ", ".join(position) if position else None) for plan, position in positions.items())


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

    def __repr__(self) -> str:
        return self.path.name

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
        __tracebackhide__ = True
        changed = self.path.stat().st_mtime_ns if self.path.exists() else 0
        read = _read(self.path, changed, scene)
        if read.reason is not None:
            fault = message("accept.rejected", sheet=self.path.name, reason=read.reason)
            raise NotDrawnError(fault.worded(self.language))
        return read.drawn


def handed(sheet: HandedSheet | FilePath) -> HandedSheet:
    """Give a sheet of a file."""
    return sheet if isinstance(sheet, HandedSheet) else HandedSheet(Path(sheet))


@cache
def _read(path: Path, changed: int, scene: Assignment | None) -> Graded:
    return alone(path, by_its_marks) if scene is None else scene.graded(path, Allowance())
