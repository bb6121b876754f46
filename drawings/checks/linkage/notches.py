"""The self-check of the notches by which the shown position is constructed: centre, radius, place (засечки)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from drawings.checks.linkage.bars import holds
from drawings.checks.linkage.laid_plan import LaidPlan
from drawings.checks.linkage.pair_symbols import sizes
from drawings.checks.wrong import on
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Arc
from plans.model.dyad import Dyad
from plans.model.order import POSITIONS
from plans.words.words import Message

NOTCHES = "notches"  # the name of their group
KEPT = 9.0  # mm of a notch on either side of its meeting, where symbols are as large as on A1
SIDES = np.linspace(-1.0, 1.0, 9)  # of that, where it is looked for
SHARES = (0.0, 0.25, 0.5, 0.75, 1.0)  # of an arc: of one that a symbol cuts its middle is not its meeting


def faults(plan: LaidPlan) -> Iterator[Message]:
    """See that each group's point is notched by what turns about its hinges, and that no other arc stands there."""
    arcs = [one for one in plan.strokes(NOTCHES) if isinstance(one, Arc)]
    known = [one for one in _laid(plan) if not math.isnan(one[2].real)]
    for name, centre, spot in known:
        hidden = 2 * abs(spot - centre) <= plan.symbol  # the symbol at its meeting covers all of its circle
        if not hidden and not (
            any(notched(arc, centre, spot, plan) for arc in arcs) and _whole(arcs, centre, spot, plan)
        ):
            yield on("notch", POSITIONS.plan, name=name)
    if known and not all(any(about(arc, centre, spot, plan) for _, centre, spot in known) for arc in arcs):
        yield on("notch", POSITIONS.plan, name=NOTCHES)


def _whole(arcs: list[Arc], centre: complex, spot: complex, plan: LaidPlan) -> bool:
    """Tell whether arcs go on as far on either side of their meeting, but for what symbols hide of them."""
    own = [arc for arc in arcs if about(arc, centre, spot, plan)]
    size = min(sizes(plan), default=drafting_of(plan.laid.study.scene).hand.symbol)  # of small links they are smaller
    kept = KEPT * size - 2 * plan.near
    turn = min(kept / abs(spot - centre), math.pi)
    spots = centre + (spot - centre) * np.exp(1j * turn * SIDES)
    return all(any(holds(arc, complex(one), plan.near) for arc in own) for one in spots[plan.clear(spots)])


def _laid(plan: LaidPlan) -> Iterator[tuple[str, complex, complex]]:
    """Give each notch by its tip's letter, with its centre and its meeting on paper."""
    for start, name in _due(plan):
        centre, spot = (complex(plan.poses.point(one)[plan.position]) for one in (start, name))
        yield name, centre, spot


def _due(plan: LaidPlan) -> Iterator[tuple[str, str]]:
    """Give centre and tip of each notch: both arms of an RRR group, the rod of an RRP one."""
    for group in plan.laid.study.groups:
        if isinstance(group, Dyad) and isinstance(group.inner, str):
            outer = [one for one in group.outer if isinstance(one, str)]
            yield from ((start, group.inner) for start in outer)


def about(arc: Arc, centre: complex, spot: complex, plan: LaidPlan) -> bool:
    """Tell whether an arc has a centre and goes as far from it as a place."""
    return abs(arc.centre - centre) <= plan.near and abs(arc.radius - abs(spot - centre)) <= plan.near


def notched(arc: Arc, centre: complex, spot: complex, plan: LaidPlan) -> bool:
    """Tell whether an arc about a centre goes through its meeting, or up to the symbol that stands there."""
    if not about(arc, centre, spot, plan):
        return False
    return holds(arc, spot, plan.near) or min(abs(arc.at(share) - spot) for share in (0.0, 1.0)) <= plan.symbol
