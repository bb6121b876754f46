"""The self-check of the arrows about the crank's pivot: which way it turns, how that changes (направление вращения)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from drawings.checks.graphs.figure_strokes import FigureStrokes, Turning
from drawings.checks.letters import NEAREST, distance, labels_of
from drawings.checks.linkage.laid_plan import LaidPlan
from drawings.checks.linkage.pair_symbols import sizes
from drawings.checks.linkage.position_marks import named
from drawings.checks.wrong import on
from drawings.paper.strokes import Text
from plans.model.order import POSITIONS
from plans.words.words import Message

ARROWS = "rotation"  # the name of their group
SWEEP = math.radians(65)  # from the beginning of an arrow to its tip
WITHIN = (10.0, 14.0)  # mm on A1: radii within the crank's circle
RIM, OUTSIDE = 4.0, 9.0  # mm: from such an arrow to the circle, from the circle to one outside


def faults(plan: LaidPlan) -> Iterator[Message]:
    """See that the crank's rates have their arrows, each in its sense with its letter, and no other has."""
    turnings = [one for group in named(plan.leaf, ARROWS) for one in FigureStrokes(group).turnings]
    due = dict(due_of(plan))
    labels = labels_of(plan.leaf.groups)
    for letter, sense in due.items():
        plain = Text(0j, letter).plain
        own = (one for one in turnings if distance(labels.get(plain, ()), (one.middle,)) <= NEAREST)
        if not any(_turns(one, sense, plan) for one in own):
            yield on("sense", POSITIONS.plan, name=plain)
    if len(turnings) > len(due):
        yield on("sense", POSITIONS.plan, name=str(len(turnings)))


def due_of(plan: LaidPlan) -> Iterator[tuple[str, int]]:
    """Give the letters of the crank's rates in the shown position with their signs."""
    link = plan.laid.mechanism.drive.link
    rates = zip("ωε", plan.road.rates(plan.laid.motion.phi), strict=True)
    for symbol, rate in rates:
        value = float(np.broadcast_to(rate, plan.laid.motion.phi.shape)[plan.position])
        if value:
            yield f"{symbol}_{link}", 1 if value > 0 else -1


def _turns(one: Turning, sense: int, plan: LaidPlan) -> bool:
    """Tell whether an arrow turns about the pivot in a sense, as far round and as near to it as it must."""
    pivot = complex(plan.poses.point(plan.laid.mechanism.drive.pivot)[plan.position])
    if one.sense != sense or abs(one.centre - pivot) > plan.near:
        return False
    long = abs(one.swept - SWEEP) * one.radius <= plan.near
    return long and any(abs(one.radius - radius) <= plan.near for radius in _radii(plan, pivot))


def _radii(plan: LaidPlan, pivot: complex) -> list[float]:
    """Give the radii that an arrow may have: within the crank's circle where there is room, or outside its numbers."""
    circle, size = abs(complex(plan.crank_ends[plan.position]) - pivot), min(sizes(plan), default=1.0)
    room = circle - RIM + plan.near
    return [size * one for one in WITHIN if size * one <= room] or [circle + OUTSIDE]
