"""Students at curves: a scene's own sheet with one figure drawn otherwise, and those that follow drawn on."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from drawings.grading.curves.figure_records import ORDINATES, FigureAsked
from drawings.paper.strokes import Circle, Group, Line, Polyline, Stroke, Text
from drawings.pens.svg import svg
from drawings.redrawn import Original
from plans.model.motion import Complexes
from tests.drawings.students import Task

Keep = Callable[[Stroke], Stroke | None]


def gone_on(task: Task, key: str, values: Complexes) -> dict[str, Complexes]:
    """Give all figures of a sheet where one is drawn otherwise and those that rest on it go on from there."""
    sheet = task.figure(key).sheet
    own = [one for one in task.figures if one.sheet == sheet]
    found = {one.key: one.true for one in own}
    found[key] = values
    changed = {key}
    for one in own:
        if one.course is not None and changed & set(one.behind) and one.key != key:
            found[one.key] = one.course(found)
            changed.add(one.key)
    return {name: found[name] for name in changed}


def drawn(
    task: Task, sheet: Original, values: Mapping[str, Complexes], keep: Keep = lambda one: one, along: float = 0.0
) -> bytes:
    """Draw a sheet with the values of some figures otherwise; `along` moves their ordinates along the axis, mm."""
    leaf = sheet.leaf
    for key, own in values.items():
        asked = task.figure(key)
        moves = np.asarray(np.nan_to_num(own - asked.true) / asked.scale)
        groups = tuple(_group(one, asked, moves, along) for one in leaf.groups)
        leaf = leaf._replace(groups=groups)
    kept = (_kept(one, keep) for one in leaf.groups)
    return svg(leaf._replace(groups=tuple(one for one in kept if isinstance(one, Group))))


def _kept(one: Stroke, keep: Keep) -> Stroke | None:
    if isinstance(one, Group):
        parts = (_kept(part, keep) for part in one.strokes)
        one = one._replace(strokes=tuple(part for part in parts if part is not None))
    return keep(one)


def _group(group: Group, asked: FigureAsked, moves: Complexes, along: float, within: bool = False) -> Group:
    """Draw a group of the figure otherwise: its marks, its curve, which may stand in a group of what it states."""
    places = {(one.name, "" if one.position is None else str(one.position)): one.place for one in asked.items}
    own = group.data.get("name", ""), group.data.get("position", "")
    if group.data.get("plan") == asked.plan and own in places:
        by = complex(moves[places[own]])
        return group._replace(strokes=tuple(_marked(one, asked, by, along) for one in group.strokes))
    within = within or group.name == asked.plan
    parts = (_group(one, asked, moves, along, within) if isinstance(one, Group) else one for one in group.strokes)
    curved = within and asked.paper is not None
    return group._replace(strokes=tuple(_curve(one, asked, moves, along) if curved else one for one in parts))


def _marked(one: Stroke, asked: FigureAsked, by: complex, along: float) -> Stroke:
    aside = along * _along(asked)
    if isinstance(one, Line):
        return one._replace(start=one.start + aside, end=one.end + by + aside)
    return one._replace(centre=one.centre + by) if isinstance(one, Circle) else one


def _along(asked: FigureAsked) -> complex:
    if asked.paper is None:
        return 0j
    start, end = asked.paper.axis
    return (end - start) / abs(end - start)


def _curve(one: Stroke, asked: FigureAsked, moves: Complexes, along: float) -> Stroke:
    """Move the corners of a curve with its ordinates; lines that are straight over the turn stay."""
    if not isinstance(one, Polyline) or len(one.points) < 3:
        return one
    assert asked.paper is not None  # asked before
    way, start = _along(asked), asked.paper.axis[0]
    feet = ((asked.paper.feet - start) / way).real
    at = ((np.array(one.points) - start) / way).real
    order = np.argsort(feet, kind="stable")
    by = np.interp(at, feet[order], moves.real[order]) + 1j * np.interp(at, feet[order], moves.imag[order])
    return one._replace(points=tuple((np.array(one.points) + by + along * way).tolist()))


def made(task: Task, row: Mapping[str, Any]) -> bytes:
    """Draw a sheet with a mistake of the table."""
    asked = task.figure(row["figure"])
    places = {one.name if one.position is None else one.called: one.place for one in asked.items}
    places |= {one.name: one.place for one in asked.items}
    by = row.get("by", 0)
    at = [places[name] for name in row.get("at", ())]
    if row["how"] in ("missing", "unscaled"):
        return drawn(task, task.sheet(asked.sheet), {}, lambda one: _lost(one, asked, row))
    if row["how"] == "shifted":
        return drawn(task, task.sheet(asked.sheet), {asked.key: asked.true}, along=by)
    values = _mistaken(asked, row, at, by)
    later = gone_on(task, asked.key, values) if row.get("on", True) else {asked.key: values}
    return drawn(task, task.sheet(asked.sheet), later)


def _mistaken(asked: FigureAsked, row: Mapping[str, Any], at: list[int], by: float) -> Complexes:
    """Give a figure as a mistake has it."""
    values, way = asked.true.copy(), asked.way if asked.kind == ORDINATES else 1 + 0j
    every: dict[str, Callable[[], Complexes]] = {
        "back": lambda: -values,
        "times": lambda: np.asarray(by * values),
        "level": lambda: np.asarray(values + way * by * asked.scale),
        "mistake": lambda: _named(asked, row["kind"], by),
    }
    some: dict[str, Callable[[Complexes], Complexes]] = {
        "moved": lambda own: np.asarray(own + way * by * asked.scale),
        "turned": lambda own: np.asarray(own * cmath.rect(1, math.radians(by))),
        "one back": lambda own: -own,
    }
    if row["how"] in every:
        return every[row["how"]]()
    values[at] = some[row["how"]](values[at])
    return values


def _named(asked: FigureAsked, kind: str, by: float) -> Complexes:
    """Give a figure with the mistake of a name; of several that by which it is out most."""
    found = [one for one in asked.mistakes if one.kind == kind]
    one = max(found, key=lambda one: float(np.abs(one.values - asked.true).max()))
    return np.asarray(one.values + (0 if one.along is None else by * asked.scale * one.along))


def _lost(one: Stroke, asked: FigureAsked, row: Mapping[str, Any]) -> Stroke | None:
    """Give a stroke unless it is left out: an ordinate of some names, or the line of the scales."""
    if isinstance(one, Group) and row["how"] == "missing":
        lost = one.data.get("plan") == asked.plan and one.data.get("name") in row["at"]
        return None if lost else one
    if isinstance(one, Group) and one.name == asked.plan and row["how"] == "unscaled":
        return _kept_texts(one)
    return one


def _kept_texts(group: Group) -> Group:
    parts = (_kept_texts(one) if isinstance(one, Group) else one for one in group.strokes)
    return group._replace(strokes=tuple(one for one in parts if not (isinstance(one, Text) and "μ" in one.plain)))
