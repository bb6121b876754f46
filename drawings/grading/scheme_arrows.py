"""Arrows and arcs that are not to scale, on loading schemes and the lever: each has its way (стрелки на схемах)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from drawings.grading import verdict
from drawings.grading.asked import DEVIATIONS, Allowances, PlanAsked
from drawings.grading.curves.drawn_figure import chains
from drawings.grading.curves.figure_records import Values
from drawings.grading.drawing_faults import TIP
from drawings.grading.drawn_plan import Arrow, DrawnPlan
from drawings.grading.verdict import Verdict
from drawings.paper.strokes import Arc, Fill, Group, Leaf, Line
from drawings.paper.walk import groups
from drawings.reading.sheet import SeenSheet
from geometry.hand_error import EDGE

FIGURE = "scheme-"  # how the name of the figure of a loading scheme begins
# What is said of a force that shows the other way, by how its letters begin.
TURNED = {"Φ": verdict.INERTIA, "G": verdict.UPWARD, "R": verdict.REACTION, "P": verdict.REACTION}
REVERSED = (verdict.INERTIA, verdict.UPWARD, verdict.REACTION, verdict.REVERSED)


def arrows_on(leaf: Leaf, plan: str, position: int | None) -> dict[str, Arrow]:
    """Give the arrows of forces on the figure of a scheme or a lever by their names; of two of one name none."""
    found: dict[str, list[Arrow]] = {}
    for one in groups(figures_of(leaf, plan, position)):
        shaft = one.strokes[0] if one.strokes else None
        if one.data.get("kind") == "force" and isinstance(shaft, Line):
            found.setdefault(one.data.get("name", ""), []).append(_arrows_headed(shaft, one))
    return {name: own[0] for name, own in found.items() if len(own) == 1}


def figures_of(leaf: Leaf, plan: str, position: int | None) -> tuple[Group, ...]:
    """Give the figures on a sheet that are of a scheme, or of a lever, in a position."""
    figure = f"{plan.replace('scheme ', FIGURE)}-{position}"
    return tuple(group for group in groups(leaf.groups) if group.name == figure)


def taken_apart(leaf: Leaf, asked: PlanAsked) -> bool:
    """Tell whether an editor has taken a figure apart: nothing tells then which of the arrows of a name are of it."""
    return bool(asked.senses or asked.turns) and not figures_of(leaf, asked.plan, asked.position)


def _arrows_headed(shaft: Line, group: Group) -> Arrow:
    """Give an arrow from its start to its head, whichever way its line was drawn."""
    tips = [spot for head in group.strokes if isinstance(head, Fill) for spot in head.points]
    ends = [any(abs(end - spot) <= TIP for spot in tips) for end in (shaft.start, shaft.end)]
    return Arrow(shaft.end, shaft.start) if ends == [True, False] else Arrow(shaft.start, shaft.end)


def arrow_verdicts(seen: SeenSheet, plan: DrawnPlan, by: Allowances) -> Iterator[Verdict]:
    """Judge the arrows of a figure: each has the direction of its force."""
    asked = plan.asked
    if taken_apart(seen.leaf, asked):
        yield Verdict(asked.plan, asked.position, "", verdict.UNGROUPED)
        return
    drawn = arrows_on(seen.leaf, asked.plan, asked.position) if asked.senses else {}
    for name, true in asked.senses.items():
        arrow = drawn.get(name)
        kind = verdict.MISSING if arrow is None else _kind(name, arrow, true / plan.turn, by, seen.measured.quantum)
        at = None if arrow is None else (arrow.start, arrow.end)
        yield Verdict(asked.plan, asked.position, name, kind, at=at, letters=("", name))


def _kind(name: str, arrow: Arrow, true: complex, by: Allowances, coarse: float) -> str:
    # No arrow that is not to scale is the largest of a plan: where a share is allowed, the slip of a fair hand is.
    length, slip = abs(arrow.vector), max(by.to(name).slip, coarse)
    allowed = DEVIATIONS * slip * (2 / length + 1 / EDGE) if length else 0.0
    off = abs(math.remainder(_phase(arrow.vector) - _phase(true), math.tau))
    if off <= allowed:
        return verdict.RIGHT
    back = TURNED.get(name.partition("_")[0], verdict.REVERSED)
    return back if math.pi - off <= allowed else verdict.TURNED


def _phase(vector: complex) -> float:
    return math.atan2(vector.imag, vector.real)


def once(verdicts: Sequence[Verdict]) -> Iterator[Verdict]:
    """Give verdicts where a force or a moment shown the wrong way on its scheme loses nothing more in a polygon."""
    wrong = (*REVERSED, verdict.COUPLE)
    shown = {(one.position, one.name) for one in verdicts if one.plan.startswith("scheme ") and one.kind in wrong}
    for one in verdicts:
        again = one.kind in REVERSED and (one.position, one.name) in shown
        again |= one.kind == verdict.COUPLE and (one.position, one.of) in shown
        yield one._replace(kind=verdict.FOLLOWS) if again and not one.plan.startswith("scheme ") else one


COUPLE = "M^Φ"  # how the letters of a moment of inertia forces begin
SHARES = np.linspace(0.0, 1.0, 9)  # of an arc


def arcs_on(leaf: Leaf, plan: str, position: int | None) -> dict[str, Values]:
    """Give the arcs of couples on the figure of a scheme by their names, each from its start to its head, mm."""
    found: dict[str, Values] = {}
    for one in groups(figures_of(leaf, plan, position)):
        points = _headed(one) if one.data.get("kind") == "couple" else None
        if points is not None:
            found[one.data.get("name", "")] = points
    return found


def _headed(group: Group) -> Values | None:
    """Give places along the arc of a couple up to its head, whichever way it was drawn; None where it has no head."""
    arcs = [np.array([one.at(share) for share in SHARES.tolist()]) for one in group.strokes if isinstance(one, Arc)]
    points = next(iter([*arcs, *chains(group.strokes)]), None)
    tips = [spot for head in group.strokes if isinstance(head, Fill) for spot in head.points]
    if points is None or not tips:
        return None
    ends = [any(abs(end - spot) <= TIP for spot in tips) for end in (points[0], points[-1])]
    return points[::-1] if ends == [True, False] else points if ends == [False, True] else None


def sense_of(points: Values) -> int:
    """Tell in which sense a line turns that is followed to its head: +1 counter-clockwise.

    >>> sense_of(np.array([1 + 0j, 1j, -1 + 0j])), sense_of(np.array([1 + 0j, -1j, -1 + 0j]))
    (1, -1)
    """
    run = np.diff(points)
    return int(math.copysign(1.0, float((run[:-1].conj() * run[1:]).imag.sum())))


def arc_verdicts(seen: SeenSheet, plan: DrawnPlan) -> Iterator[Verdict]:
    """Judge the arcs of a figure: each turns as its moment does."""
    asked = plan.asked
    if taken_apart(seen.leaf, asked):
        return
    drawn = arcs_on(seen.leaf, asked.plan, asked.position) if asked.turns else {}
    for name, sense in asked.turns.items():
        arc, wrong = drawn.get(name), verdict.COUPLE if name.startswith(COUPLE) else verdict.REVERSED
        kind = verdict.MISSING if arc is None else verdict.RIGHT if sense_of(arc) == sense else wrong
        at = None if arc is None else (complex(arc[0]), complex(arc[-1]))
        yield Verdict(asked.plan, asked.position, name, kind, at=at, letters=("", name))
