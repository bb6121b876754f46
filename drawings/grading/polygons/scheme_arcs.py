"""Arcs of couples on loading schemes: the sense in which each known moment turns (пары сил на схемах)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from drawings.eye.sheet import SeenSheet
from drawings.grading import verdict
from drawings.grading.curves.asked_figure import Values
from drawings.grading.curves.drawn_curve import chains
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.polygons.scheme_arrows import figures_of, taken_apart
from drawings.grading.segments import TIP
from drawings.grading.verdict import Verdict
from drawings.paper.strokes import Arc, Fill, Group, Leaf
from drawings.paper.walk import groups

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


def turns_of(leaf: Leaf, plan: str, position: int | None, known: Mapping[str, float]) -> dict[str, int]:
    """Give the senses of the known moments that a scheme shows by arcs, by their names."""
    return {name: int(math.copysign(1, known[name])) for name in arcs_on(leaf, plan, position) if name in known}


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
