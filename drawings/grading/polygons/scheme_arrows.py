"""Arrows that are not to scale, on loading schemes and on the lever: the way that each force shows (направления)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from drawings.eye.sheet import SeenSheet
from drawings.grading import verdict
from drawings.grading.allowance import DEVIATIONS, Allowances
from drawings.grading.asked import PlanAsked
from drawings.grading.drawn_plan import Arrow, DrawnPlan
from drawings.grading.segments import TIP
from drawings.grading.verdict import Verdict
from drawings.paper.strokes import Fill, Group, Leaf, Line
from drawings.paper.walk import groups
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
            found.setdefault(one.data.get("name", ""), []).append(_headed(shaft, one))
    return {name: own[0] for name, own in found.items() if len(own) == 1}


def figures_of(leaf: Leaf, plan: str, position: int | None) -> tuple[Group, ...]:
    """Give the figures on a sheet that are of a scheme, or of a lever, in a position."""
    figure = f"{plan.replace('scheme ', FIGURE)}-{position}"
    return tuple(group for group in groups(leaf.groups) if group.name == figure)


def taken_apart(leaf: Leaf, asked: PlanAsked) -> bool:
    """Tell whether an editor has taken a figure apart: nothing tells then which of the arrows of a name are of it."""
    return bool(asked.senses or asked.turns) and not figures_of(leaf, asked.plan, asked.position)


def _headed(shaft: Line, group: Group) -> Arrow:
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


def senses_of(leaf: Leaf, plan: str, position: int | None, known: Mapping[str, complex]) -> dict[str, complex]:
    """Give the directions of the known forces that a figure shows by arrows, by their names."""
    return {name: known[name] for name in arrows_on(leaf, plan, position) if name in known}
