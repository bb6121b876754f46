"""Students: a scene's own sheet with a mistake in it, and what rests on that drawn from there as they would."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np

from drawings.grading.asked import PlanAsked, plans_asked
from drawings.grading.cells.asked_table import TableAsked, tables_asked
from drawings.grading.curves.figure_records import FigureAsked, figures_asked
from drawings.lettering.words import with_index
from drawings.paper.strokes import Circle, Fill, Group, Line, Stroke, Text
from drawings.pens.svg import svg
from drawings.redrawn import Original, Originals
from geometry.board import Mark
from geometry.replay import redraw
from tests.gallery import GALLERY

ASIDE = ("values", "output", "notes", "title-block", "equations")  # what is not graded takes long to read
TABLED = ("notes", "title-block", "equations")  # of a sheet that is handed in with its tables
Places = Mapping[str, complex]


@dataclass(frozen=True, eq=False)
class Task:
    """A scene that is set: its sheets, and what they ask for."""

    originals: Originals

    @cached_property
    def plans(self) -> tuple[PlanAsked, ...]:
        return plans_asked(self.originals)

    @cached_property
    def figures(self) -> tuple[FigureAsked, ...]:
        return figures_asked(self.originals)

    @cached_property
    def tables(self) -> tuple[TableAsked, ...]:
        return tables_asked(self.originals)

    def plan(self, plan: str, position: int | None) -> PlanAsked:
        return next(one for one in self.plans if one.place == (plan, position))

    def figure(self, key: str) -> FigureAsked:
        return next(one for one in self.figures if one.key == key)

    def table(self, name: str) -> TableAsked:
        return next(one for one in self.tables if one.sought[1] == name)

    def sheet(self, name: str) -> Original:
        return next(one for one in self.originals.sheets if one.name == name)


@cache
def task(scene: str) -> Task:
    """Set a scene of the gallery."""
    return Task(Originals(GALLERY / f"{scene}.toml"))


def marks_of(plan: PlanAsked) -> dict[str, Mark]:
    """Give the marks of the record by their letters."""
    return {
        letter: mark
        for one in plan.vectors
        if one.found
        for letter, mark in zip(one.letters, one.found.span, strict=True)
    }


def true_places(plan: PlanAsked) -> dict[str, complex]:
    """Give where each letter of a plan lies from its pole, true units."""
    return {letter: complex(np.ravel(mark.point)[0]) for letter, mark in marks_of(plan).items()}


def gone_on(plan: PlanAsked, moved: Places) -> dict[str, complex]:
    """Give where all letters lie if some were drawn elsewhere and the rest was drawn on from there."""
    marks = marks_of(plan)
    again = redraw(list(marks.values()), {marks[letter]: place for letter, place in moved.items()})
    return {letter: complex(np.ravel(again[mark].point)[0]) for letter, mark in marks.items()}


def drawn(
    sheet: Original,
    plan: PlanAsked,
    places: Places,
    keep: Callable[[Stroke], Stroke | None] = lambda one: one,
    aside: tuple[str, ...] = ASIDE,
) -> bytes:
    """Draw a sheet with the letters of one plan elsewhere; `keep` gives each stroke as it is drawn, or none."""
    was = true_places(plan)
    shifts = {letter: (place - was[letter]) / plan.scales[plan.plan] for letter, place in places.items()}
    own = (group for group in sheet.leaf.groups if not group.name.startswith(aside))
    groups = tuple(_group(group, plan, shifts, keep) for group in own)
    return svg(sheet.leaf._replace(groups=groups))


def _group(group: Group, plan: PlanAsked, shifts: Places, keep: Callable[[Stroke], Stroke | None]) -> Group:
    """Move the arrows of a plan with their ends, and the letters of its own figure with what they name."""
    if group.name.startswith((f"{plan.plan}-{plan.position}", "positions")) or group.data.get("plan"):
        own: Iterator[Stroke] = (_moved(one, plan, shifts) for one in group.strokes)
        if _is_of(group, plan) and group.data["kind"] == "vector":
            own = iter(_arrow(group, shifts))
        kept = (keep(one) for one in own)
        return group._replace(strokes=tuple(one for one in kept if one is not None))
    return group


def _is_of(group: Group, plan: PlanAsked) -> bool:
    return (group.data.get("plan"), group.data.get("position")) == (plan.plan, str(plan.position))


def _moved(one: Stroke, plan: PlanAsked, shifts: Places) -> Stroke:
    if isinstance(one, Group):
        if _is_of(one, plan) and one.data["kind"] == "vector":
            return one._replace(strokes=_arrow(one, shifts))
        by = shifts.get(one.data["name"], 0j) if _is_of(one, plan) and one.data["kind"] == "point" else 0j
        led = sum((_shift(part, shifts) for part in one.strokes if isinstance(part, Text)), 0j)
        parts = (_led(part, led) if isinstance(part, Line) else _moved(part, plan, shifts) for part in one.strokes)
        return one._replace(strokes=tuple(_aside(part, by) for part in parts))
    return one._replace(at=one.at + _shift(one, shifts)) if isinstance(one, Text) else one


def _shift(letter: Text, shifts: Places) -> complex:
    return next((by for name, by in shifts.items() if lettered(name) == letter.plain), 0j)


def _led(leader: Line, by: complex) -> Line:
    """Move the leader of a letter with it."""
    return leader._replace(start=leader.start + by, end=leader.end + by)


def _aside(one: Stroke, by: complex) -> Stroke:
    return one._replace(centre=one.centre + by) if isinstance(one, Circle) and by else one


def lettered(letter: str) -> str:
    """Give a letter as it is read."""
    return Text(0j, letter if "{" in letter else with_index(letter)).plain


def _arrow(group: Group, shifts: Places) -> tuple[Stroke, ...]:
    start, end = group.data["name"].split(" ")
    line, *head = group.strokes
    assert isinstance(line, Line)
    again = line._replace(start=line.start + shifts.get(start, 0j), end=line.end + shifts.get(end, 0j))
    old, new = line.end - line.start, again.end - again.start
    turn = cmath.rect(1, cmath.phase(new) - cmath.phase(old)) if old and new else 1
    heads = (
        one._replace(points=tuple(again.end + (spot - line.end) * turn for spot in one.points))
        for one in head
        if isinstance(one, Fill)
    )
    return again, *heads
