"""Arms of masses as a student drew them: from its shaft to the black circle that bears a letter (плечи масс)."""

from __future__ import annotations

import numpy as np

from drawings.checks.letters import NEAREST, labels_of, off
from drawings.eye.sheet import SeenSheet
from drawings.grading.curves.asked_figure import BEARINGS, FigureAsked
from drawings.grading.curves.drawn_curve import PLACED
from drawings.grading.curves.drawn_figure import DrawnFigure, scales_on
from drawings.grading.drawn_plan import Arrow
from drawings.lettering.bank_letters import lowered
from drawings.paper.strokes import Circle, Leaf, Line, Text
from drawings.paper.walk import flat, group_named

HOLLOW = ("", "none", "#ffffff")  # what fills a circle that is no mass


def written(name: str) -> str:
    """Give the letter of a mass as it is read."""
    return Text(0j, lowered(name)).plain


def from_arms(asked: FigureAsked, seen: SeenSheet) -> DrawnFigure | None:
    """Give the arms of a figure by the letters of their masses; None where none is found."""
    found = {k: arm_at(seen.leaf, asked.plan, letter) for k, letter in enumerate(asked.arms)}
    arrows = {k: Arrow(*arm) for k, arm in found.items() if arm is not None}
    if not arrows:
        return None
    scale, is_written = scales_on(asked, seen)
    values, turn = np.full(len(asked.true), complex(np.nan, np.nan)), seen.measured.moved.p
    for k, arrow in arrows.items():
        own = arrow.vector / turn * (1.0 if asked.on_paper else scale["l"])
        values[k] = own * abs(asked.true[k]) / abs(own) if asked.kind == BEARINGS and own else own
    return DrawnFigure(asked, values, arrows, is_written, free=True)


def arm_at(leaf: Leaf, plan: str, letter: str) -> tuple[complex, complex] | None:
    """Give the ends of the arm of the mass that bears a letter, in its figure or where that is lost anywhere."""
    group = group_named(leaf.groups, plan)
    strokes = leaf.groups if group is None else (group,)
    masses = [one.centre for one in flat(strokes) if isinstance(one, Circle) and one.style.fill not in HOLLOW]
    places = [label.place for label in labels_of(strokes).get(letter, ())]
    near = [(off(spot, place), spot) for spot in masses for place in places]
    far, mass = min(near, key=lambda one: one[0], default=(NEAREST, 0j))
    if far >= NEAREST:
        return None
    lines = [one for one in flat(strokes) if isinstance(one, Line)]
    both = [ends for one in lines for ends in ((one.start, one.end), (one.end, one.start))]
    arms = [ends for ends in both if abs(ends[1] - mass) <= PLACED]
    return max(arms, key=lambda ends: abs(ends[1] - ends[0]), default=None)
