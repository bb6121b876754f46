"""Polygons on a form: the arrows in a place, each told by the letter beside it (многоугольники на бланке)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from drawings.checks.letters import Label, along, off
from drawings.eye.sheet import SeenSheet
from drawings.grading import verdict
from drawings.grading.asked import DEVIATIONS, Allowances, Asked, PlanAsked
from drawings.grading.curves.drawn_figure import chains
from drawings.grading.curves.figure_records import Values
from drawings.grading.drawing_faults import TIP, Segment
from drawings.grading.drawn_plan import Arrow, DrawnPlan
from drawings.grading.form_places import FormPlace, nearest
from drawings.grading.lettered_plan import FAR, LEAST, scale_at, turn_of
from drawings.grading.seeing.onlooker import spelled
from drawings.grading.verdict import Verdict
from drawings.lettering.extent import bounds
from drawings.paper.strokes import Arc, Box, Fill, Group, Leaf, Line, Text
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


def paired(costs: Sequence[Sequence[float]]) -> list[int]:
    """Give each row the column of its own that makes the sum of costs least; there are no fewer columns than rows.

    Rows are added one by one, each by the shortest path of exchanges with those before it (the Hungarian method).

    >>> paired([[1.0, 2.0, 9.0], [1.0, 5.0, 9.0]])
    [1, 0]
    """
    count = len(costs[0]) if costs else 0
    rows, columns = [0.0] * (len(costs) + 1), [0.0] * (count + 1)
    owner = [0] * (count + 1)  # by columns, from 1 on: the row that has it
    for row in range(1, len(costs) + 1):
        _exchange(costs, row, (rows, columns), owner)
    found = [0] * len(costs)
    for column, row in enumerate(owner[1:]):
        if row:
            found[row - 1] = column
    return found


def _exchange(
    costs: Sequence[Sequence[float]], row: int, prices: tuple[list[float], list[float]], owner: list[int]
) -> None:
    """Give a row its column, and those whose columns it takes others."""
    rows, columns = prices
    least, before = [math.inf] * len(columns), [0] * len(columns)
    used, here = set[int](), 0
    owner[0] = row
    while owner[here]:
        used.add(here)
        one = owner[here]
        free = [k for k in range(1, len(columns)) if k not in used]
        for k in free:
            cost = costs[one - 1][k - 1] - rows[one] - columns[k]
            if cost < least[k]:
                least[k], before[k] = cost, here
        there = min(free, key=lambda k: least[k])
        step = least[there]
        for k in used:
            rows[owner[k]] += step
            columns[k] -= step
        for k in free:
            least[k] -= step
        here = there
    while here:
        owner[here] = owner[before[here]]
        here = before[here]


UNSURE, SHARE = 8.0, 0.2  # mm within which a letter is as near to another arrow; how far out one is drawn otherwise
BESIDE = 25.0  # mm: an arrow that lies farther from a place is not of it


def free_plans(
    asked: Sequence[PlanAsked],
    figures: Sequence[Sequence[Segment]],
    texts: Sequence[Text],
    labels: Sequence[Label],
    places: Sequence[FormPlace],
) -> Iterator[DrawnPlan]:
    """Find polygons: all arrows that are drawn in the place of one on the form, or beside it, are of it."""
    due = {plan.place: plan for plan in asked if plan.lettered and all(one.letter for one in plan.vectors)}
    own: dict[FormPlace, list[Segment]] = {}
    for joined in figures:
        middle = sum(one.start + one.end for one in joined) / (2 * len(joined))
        here = nearest(middle, places)
        if here is not None and here.plan in due and here.off(middle) <= BESIDE:
            own.setdefault(here, []).extend(joined)
    for here, arrows in own.items():
        drawn = _drawn(due[here.plan], arrows, texts, labels, here)
        if len(drawn.arrows) >= max(LEAST, len(drawn.asked.vectors) / 2):
            yield drawn


def _drawn(
    plan: PlanAsked, drawn: Sequence[Segment], texts: Sequence[Text], labels: Sequence[Label], place: FormPlace
) -> DrawnPlan:
    names = {spelled(one.letter): one for one in plan.vectors if one.corners}
    scale = scale_at(place, texts, plan)
    own = [text for text in texts if spelled(text.plain) in names]
    turn = turn_of(own, lambda text: min(_distance(bounds(text), one) for one in drawn))
    arrows = _named(names, drawn, labels, (scale or 0.0) * turn)
    bare = DrawnPlan(plan, arrows, 1.0, {}, False)
    return DrawnPlan(plan, arrows, scale or bare.fitted, {}, scale is not None, turn, lettered=True)


def _named(
    names: Mapping[str, Asked], arrows: Sequence[Segment], labels: Sequence[Label], scale: complex
) -> dict[tuple[str, str], Arrow]:
    """Give the arrows by the letters beside them: all letters together as close to their arrows as they can be.

    Where letters are as near to one arrow as to another, the one that is drawn rightly has it: nobody is marked down
    for a letter that can be read in two ways.
    """
    own = {name: [label.place for label in labels if spelled(label.text.plain) == name] for name in names}
    read = [name for name, boxes in own.items() if boxes]
    rows = [[_cost(names[name], own[name], one, scale) for one in arrows] + [FAR + UNSURE] * len(read) for name in read]
    found = {}
    for name, row, k in zip(read, rows, paired(rows), strict=True):
        if k < len(arrows) and row[k] < FAR + UNSURE:
            found[names[name].letters] = Arrow(arrows[k].start, arrows[k].end)
    return found


def _cost(asked: Asked, boxes: Sequence[Box], arrow: Segment, scale: complex) -> float:
    """Give how far the letter of a vector is from an arrow, mm, and more where the arrow is drawn otherwise."""
    away = min(_distance(box, arrow) for box in boxes)
    off = abs((arrow.end - arrow.start) * scale - asked.true)
    return away + (UNSURE if scale and off > SHARE * abs(asked.true) else 0.0) if away <= FAR else FAR + UNSURE


def _distance(box: Box, arrow: Segment) -> float:
    """Give how far a box is from an arrow, mm."""
    left, low, right, high = box
    corners = (complex(x, y) for x in (left, right) for y in (low, high))
    ends = min(off(spot, box) for spot in along(arrow.start, arrow.end))
    return min(ends, *(_from(corner, arrow) for corner in corners), _from(complex(left + right, low + high) / 2, arrow))


def _from(spot: complex, arrow: Segment) -> float:
    """Give how far a place is from an arrow, mm."""
    vector = arrow.end - arrow.start
    share = ((spot - arrow.start) * vector.conjugate()).real / abs(vector) ** 2 if vector else 0.0
    return abs(spot - arrow.start - vector * min(max(share, 0.0), 1.0)) if math.isfinite(share) else math.inf
