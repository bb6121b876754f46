"""What the plans of a linkage drawn by hand may be out in, quantity by quantity (планы от руки)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from geometry.hand_error import Hand
from plans.checks.compare import MotionComparison
from plans.checks.hand.quantity import SLIP, Told, errors_by_hand
from plans.checks.parts import Span, spans
from plans.linkage.drafts import Drafts
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import FRAME
from plans.model.motion import Floats
from plans.model.order import ORDERS, POSITIONS


def motion_by_hand(
    study: LinkageStudy, comparison: MotionComparison, positions: Sequence[int], scales: Mapping[str, Floats]
) -> dict[str, Floats]:
    """Give within what 95 of 100 drawings are of each velocity, acceleration and rate, (positions,), in its unit.

    The names are those of the findings: "v_B", "ω_3", "a^n_BA"; of a vector it is the size. `scales` are those of the
    plans, true units a mm, one for each position. NaN: so near a dead centre that the slips of a hand tell nothing.
    """
    drafts = study.drafts(list(positions))
    return errors_by_hand(motion_read(study, comparison, drafts), Hand(SLIP, scales))


def plans_by_hand(
    study: LinkageStudy, comparison: MotionComparison, scales: Mapping[str, float], positions: Sequence[int]
) -> dict[tuple[str, int], float]:
    """Give what a hand may be out on the drawn plans, by name and position; one without its plans has nothing.

    `scales` are those of the figures, true units a mm, by their names: "positions", "velocities-3".
    """
    names = {
        k: {order.plan: order.plan if order is POSITIONS else f"{order.plan}-{k}" for order in ORDERS}
        for k in positions
    }
    whole = [k for k in positions if set(names[k].values()) <= set(scales) and not study.lost[k]]
    if not whole:
        return {}
    rows = {order.plan: np.array([scales[names[k][order.plan]] for k in whole]) for order in ORDERS}
    found = motion_by_hand(study, comparison, whole, rows)
    return {(name, k): float(error) for name, errors in found.items() for k, error in zip(whole, errors, strict=True)}


def motion_read(study: LinkageStudy, comparison: MotionComparison, drafts: Drafts) -> dict[str, Told]:
    """Give where the plans of some positions show what is read off them, by its letters."""
    found: dict[str, Told] = {}
    for order in ORDERS[1:]:
        plan = drafts.plan(order.number)
        moving = [name for name in comparison.construction.points if name not in study.mechanism.links[FRAME].points]
        found |= {f"{order.point.symbol}_{name}": Span(plan.pole, plan.point(name)) for name in moving}
        found |= {f"{order.link.symbol}_{link}": reading for link, reading in plan.readings.items()}
    return found | spans(study, drafts, comparison.analysis)
