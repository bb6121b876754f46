"""The plan of positions on a form: its points, where strokes end and letters stand (план положений на бланке)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from drawings.checks.hold import Label, distance
from drawings.grading.asked import PlanAsked
from drawings.grading.curves.drawn_figure import foot
from drawings.grading.drawn_plan import Arrow, DrawnPlan, places_of
from drawings.grading.form_place import KIND, FormPlace
from drawings.grading.onlooker import JOINED, spelled
from drawings.paper.strokes import Circle, Group, Leaf, Line, Polyline, Stroke
from plans.model.motion import POSITIONS

LETTERED = 25.0  # mm: a letter that is farther from a point does not name it
BESIDE = 8.0  # mm: nor one that is farther from a place on a line where nothing marks it


def points_on_form(
    plan: PlanAsked, place: FormPlace, leaf: Leaf, labels: Mapping[str, Sequence[Label]]
) -> DrawnPlan | None:
    """Give the points that are drawn in a place, where strokes end or go by; None of none, or of a few of a view."""
    strokes = [stroke for stroke in _drawn(leaf.groups) if any(place.off(spot) == 0 for spot in _ends(stroke))]
    spots = [spot for stroke in strokes for spot in _ends(stroke)]
    datum, found = (place.pole or 0j) - place.value / place.scale, dict[str, complex]()
    for vector in plan.vectors:
        letter = spelled(vector.title or vector.end)  # alone, or with the number of the position
        named = [label for name in (letter, f"{letter}{plan.position}") for label in labels.get(name, ())]
        at = _at(datum + vector.true / place.scale, spots, strokes, named)
        found |= {} if at is None else {vector.end: at}
    arrows = {("", name): Arrow(datum, spot) for name, spot in found.items()}
    some = len(arrows) >= (1 if plan.plan == POSITIONS.plan else len(plan.vectors) / 2)
    return DrawnPlan(plan, arrows, place.scale, places_of(arrows), lettered=True) if some else None


def _drawn(strokes: Sequence[Stroke]) -> Iterator[Stroke]:
    """Give the strokes that are no part of the form's own places and axes."""
    for stroke in strokes:
        if not isinstance(stroke, Group):
            yield stroke
        elif stroke.data.get("kind") not in (KIND, "axes"):
            yield from _drawn(stroke.strokes)


def _ends(stroke: Stroke) -> Sequence[complex]:
    match stroke:
        case Line():
            return stroke.start, stroke.end
        case Polyline():
            return stroke.points
        case Circle():
            return (stroke.centre,)
    return ()


def _at(due: complex, spots: Sequence[complex], strokes: Sequence[Stroke], labels: Sequence[Label]) -> complex | None:
    """Give where a point is: at what is marked where it is due, by its letter on a line, else nearest to its letter."""
    nearest = min(spots, key=lambda spot: abs(spot - due), default=due + 2 * JOINED)
    if abs(nearest - due) <= JOINED:
        return nearest
    feet = (foot((np.array([line.start, line.end]),), due) for line in strokes if isinstance(line, Line))
    near = min(feet, key=lambda at: abs(at - due), default=nearest)
    if abs(near - due) <= JOINED and distance(labels, [due]) <= BESIDE:
        return near
    lettered = min(spots, key=lambda spot: distance(labels, [spot]), default=None)
    return lettered if lettered is not None and distance(labels, [lettered]) <= LETTERED else None
