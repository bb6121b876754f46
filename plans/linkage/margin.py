"""Margins of groups: how far each is from its dead centre, and where it has no place (запас до мёртвого положения).

A group's margin is the squared sine of its crossing angle: it falls to zero where the group comes to a dead centre, and
beyond it there is no meeting.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from geometry.board import Arc, Line, Mark, between
from geometry.meet import UNBORNE, cross
from plans.linkage.groups.kinds import KINDS
from plans.linkage.plan import Plan
from plans.model.dyad import Group
from plans.model.motion import Floats

# Two points so much nearer to each other than their figure is large give a direction without a true digit.
NOWHERE = 8.0 * UNBORNE


def margins(plan: Plan, groups: Sequence[Group], sides: Sequence[float]) -> tuple[Floats, list[Mark]]:
    """Give every group's margin over the positions, (groups, positions): above 0 assembled, 0 dead, below 0 missing.

    A miss counts as -1: only its sign is meant. Two guides cross with the sine of their angle, signed as the group's
    side: it changes sign where they are parallel and their pin runs to infinity. NaN: a group before fails.
    """
    marks = [meeting(plan, group) for group in groups]
    count = max(np.size(mark.point) for mark in plan.letters.values())
    rows = []
    for mark, side in zip(marks, sides, strict=True):
        miss = np.broadcast_to(np.asarray(mark.miss, dtype=float), count)
        sharpness = np.broadcast_to(np.asarray(mark.sharpness, dtype=float), count)
        turned = crossing(mark)
        if turned is None:
            rows.append(np.where(miss > 0, -1.0, sharpness**2))
        else:
            rows.append(np.broadcast_to(side * turned, count))
    return np.array(rows).reshape(len(marks), count), marks


def crossing(mark: Mark) -> Floats | None:
    """Give the sine of the angle from the first of two lines to the second where they meet; None for other meetings."""
    first, second = (locus.value for locus in mark.step.inputs[:2])
    if not (mark.step.op == "meet" and isinstance(first, Line) and isinstance(second, Line)):
        return None
    turned = cross(first.direction, second.direction)
    return np.asarray(turned / (np.abs(first.direction) * np.abs(second.direction)))


def undefined(plan: Plan, groups: Sequence[Group]) -> npt.NDArray[np.bool_]:
    """Tell at which positions each group has no one place, (groups, positions): its loci miss, fall into one, ..."""
    count = max(np.size(mark.point) for mark in plan.letters.values())
    return np.array([np.broadcast_to(_nowhere(meeting(plan, group)), count) for group in groups])


def _nowhere(mark: Mark) -> npt.NDArray[np.bool_]:
    """Tell where a meeting has no place, or any: its two centres, or a pin and its slot's pivot, are one point."""
    none = np.asarray(np.isnan(np.asarray(mark.point)))
    arcs = all(isinstance(locus.value, Arc) for locus in mark.step.inputs[:2])
    if mark.step.op != "tangent" and not arcs:
        return none
    ends = mark.step.inputs if not arcs else tuple(locus.step.inputs[0] for locus in mark.step.inputs)
    away = np.maximum(*(np.abs(np.asarray(end.point)) for end in ends))
    return np.asarray(none | (np.abs(between(*ends)) <= NOWHERE * away))


def meeting(plan: Plan, group: Group) -> Mark:
    """Give the mark of a group's own meeting on the plan of positions."""
    return KINDS[group.kind].meeting(plan, group)


def of_arcs(mark: Mark) -> bool:
    """Tell whether a meeting is of an arc, which may be out of reach; two lines are not."""
    return crossing(mark) is None
