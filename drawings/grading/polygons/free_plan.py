"""Polygons on a form: the arrows in a place, each told by the letter beside it (многоугольники на бланке)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from drawings.checks.letters import Label, along, off
from drawings.grading.asked import Asked, PlanAsked
from drawings.grading.drawn_plan import Arrow, DrawnPlan
from drawings.grading.form_places import FormPlace, nearest
from drawings.grading.lettered_plan import FAR, LEAST, scale_at, turn_of
from drawings.grading.seeing.spelling import spelled
from drawings.grading.segments import Segment
from drawings.lettering.extent import bounds
from drawings.paper.strokes import Box, Text


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
