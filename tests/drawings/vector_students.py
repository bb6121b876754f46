"""Students at polygons: a sheet of free vectors with a mistake in it, and all that rests on it drawn from there."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from drawings.grading.asked import PlanAsked, VectorAsked
from drawings.paper.strokes import Fill, Group, Line, Stroke, Text
from drawings.pens.svg import svg
from geometry.board import Mark
from geometry.replay import redraw
from tests.drawings.students import ASIDE, Task, lettered

Key = tuple[str, str]  # a plan and a vector of it
SLIGHT = 1.0  # mm: the letter of an arrow that moves further stands at its middle


class Laid(NamedTuple):
    """A vector as a student has it: its value, and where it begins in its polygon, true units."""

    value: complex
    start: complex


def beside(own: Task, place: tuple[str, int | None]) -> tuple[PlanAsked, ...]:
    """Give the plans of one sheet and position."""
    one = next(plan for plan in own.plans if plan.place == place)
    return tuple(plan for plan in own.plans if (plan.sheet, plan.position) == (one.sheet, one.position))


def free(plans: tuple[PlanAsked, ...]) -> dict[Key, VectorAsked]:
    """Give the free vectors of plans that a record is known of."""
    return {(plan.plan, one.name): one for plan in plans for one in plan.vectors if one.letter and one.found}


def mark_of(plans: tuple[PlanAsked, ...], name: str) -> Mark:
    """Give the mark of a vector by its name, wherever it is first drawn."""
    return next(one.found.span.end for (_, called), one in free(plans).items() if called == name and one.found)


def laid(plans: tuple[PlanAsked, ...], moved: Mapping[Mark, complex]) -> dict[Key, Laid]:
    """Give all free vectors if some were drawn otherwise and the rest was drawn on from there."""
    own = free(plans)
    spans = {key: (*one.found.span, *(one.found.side or ())) for key, one in own.items() if one.found}
    again = redraw([mark for span in spans.values() for mark in span], moved)
    points = {key: [complex(np.ravel(again[mark].point)[0]) for mark in span] for key, span in spans.items()}
    return {key: Laid(spot[1] - spot[0], spot[2] if len(spot) > 2 else 0j) for key, spot in points.items()}


def sheet_of(
    own: Task, plans: tuple[PlanAsked, ...], now: Mapping[Key, Laid], keep: Callable[[Stroke], Stroke | None]
) -> bytes:
    """Draw the sheet of some plans with its free vectors as a student has them; `keep` may change or leave out."""
    was, leaf = laid(plans, {}), own.sheet(plans[0].sheet).leaf
    scales = {plan.plan: plan.scales[plan.plan] for plan in plans}
    moves = {key: ((now[key].start - was[key].start) / scales[key[0]], now[key].value / scales[key[0]]) for key in now}
    position = None if plans[0].position is None else str(plans[0].position)
    groups = (
        _group(group, moves, position, keep) for group in leaf.groups if not group.name.startswith(ASIDE)
    )  # fmt: skip
    return svg(leaf._replace(groups=tuple(groups)))


def _group(
    top: Group, moves: Mapping[Key, tuple[complex, complex]], position: str | None, keep: Callable[[Stroke], Any]
) -> Group:
    shifts = dict(_shifts(top, moves, position))
    return top._replace(strokes=tuple(_strokes(top.strokes, moves, shifts, position, keep)))


def _shifts(
    top: Group, moves: Mapping[Key, tuple[complex, complex]], position: str | None
) -> Iterator[tuple[str, tuple[complex, complex]]]:
    """Give by how much the middles of arrows move, by what is written beside them."""
    for key, line, title in _vectors(top, position):
        if key in moves and isinstance(line, Line):
            start, vector = moves[key]
            old = (line.start + line.end) / 2
            yield lettered(title), (old, line.start + start + vector / 2 - old)


def _vectors(top: Group, position: str | None) -> Iterator[tuple[Key, Stroke, str]]:
    for one in top.strokes:
        if isinstance(one, Group):
            if one.data.get("kind") == "vector" and one.data.get("position") == position:
                yield (one.data["plan"], one.data["name"]), one.strokes[0], one.title
            yield from _vectors(one, position)


def _strokes(
    own: tuple[Stroke, ...],
    moves: Mapping[Key, tuple[complex, complex]],
    shifts: Mapping[str, tuple[complex, complex]],
    position: str | None,
    keep: Callable[[Stroke], Stroke | None],
) -> Iterator[Stroke]:
    for one in own:
        drawn: Stroke | None = one
        if isinstance(one, Group):
            key = one.data.get("plan", ""), one.data.get("name", "")
            match one.strokes:
                case (Line() as leader, Text() as text) if text.plain in shifts:
                    by = shifts[text.plain][1]
                    led = leader._replace(start=leader.start + by, end=leader.end + by)
                    one = one._replace(strokes=(led, text._replace(at=text.at + by)))  # noqa: PLW2901
                    shifts = {letter: shift for letter, shift in shifts.items() if letter != text.plain}
            if one.data.get("kind") == "vector" and one.data.get("position") == position and key in moves:
                drawn = one._replace(strokes=_arrow(one, *moves[key]))
            else:
                drawn = one._replace(strokes=tuple(_strokes(one.strokes, moves, shifts, position, keep)))
        elif isinstance(one, Text) and one.plain in shifts:
            middle, by = shifts[one.plain]
            drawn = one._replace(at=middle + by) if abs(by) > SLIGHT else one._replace(at=one.at + by)
        kept = keep(drawn)
        if kept is not None:
            yield kept


def _arrow(group: Group, by: complex, vector: complex) -> tuple[Stroke, ...]:
    line, *heads = group.strokes
    assert isinstance(line, Line)
    old = line.end - line.start
    again = line._replace(start=line.start + by, end=line.start + by + vector)
    turn = cmath.rect(1, cmath.phase(vector) - cmath.phase(old)) if vector else 1
    if abs(vector - old) < 1e-9:
        return (line._replace(start=line.start + by, end=line.end + by), *(_along(one, by) for one in heads))
    return again, *(
        one._replace(points=tuple(again.end + (spot - line.end) * turn for spot in one.points))
        for one in heads[:1]
        if isinstance(one, Fill)
    )


def _along(head: Stroke, by: complex) -> Stroke:
    return head._replace(points=tuple(spot + by for spot in head.points)) if isinstance(head, Fill) else head


def turned(vector: complex, degrees: float) -> complex:
    """Turn a vector counter-clockwise."""
    return vector * cmath.rect(1, math.radians(degrees))
