"""What a force plan drawn by hand may be out in, force by force (силовой расчёт от руки)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from geometry.board import Mark
from geometry.hand_error import SlippingHand, slopes
from plans.checks.hand.quantity import SLIP, Slipping, errors_by_hand
from plans.forces.cut import indices
from plans.forces.force_template import ForcePlans
from plans.forces.primary import BALANCING, DRIVING, balancing_quantity
from plans.forces.statics import Statics

# The figures of a force sheet on which each board of the record is drawn.
FIGURES = {"positions": "scheme-", "forces": "forces-", "lever": "lever"}


def forces_by_hand(
    statics: Statics, position: int, scales: Mapping[str, float], by: Slipping = slopes
) -> dict[tuple[str, int], float]:
    """Give what a hand may be out on the force sheet of one position, by the names of the findings.

    Arms are measured on the schemes of the groups, and all polygons drawn, each as the coarsest of them: `scales` are
    those of the figures, true units a mm: "scheme-4-5", "forces-4-5", "lever". Inertia forces and the lever's images
    are known from the kinematics.
    """
    drawn = statics.drafts([position]).plans
    coarsest = {
        plan: [mu for name, mu in scales.items() if name.startswith(figure)] for plan, figure in FIGURES.items()
    }
    rows = {plan: np.array([max(found)]) for plan, found in coarsest.items() if found}
    found = errors_by_hand(dict(_forces_read(drawn)), SlippingHand(SLIP, rows), by)
    if drawn.lever is not None:
        name, _, share = balancing_quantity(statics.study.mechanism.drive)
        hung = errors_by_hand({name: drawn.lever.moment}, SlippingHand(SLIP, rows), by)
        found[f"{name} lever"] = share * hung[name]
    return {(name, position): float(error[0]) for name, error in found.items()}


def _forces_read(drawn: ForcePlans) -> Iterator[tuple[str, Mark]]:
    """Give where a force plan and its lever show what is read off them, by the names of the findings."""
    plan = drawn.plan
    for support in (one for cut in plan.cuts for one in cut.reactions):
        index = indices(*sorted((support.giver, support.taker)))
        yield f"R_{index}", support.force
        if support.moment is not None:
            yield f"M_{index}", support.moment
    yield BALANCING, plan.balancing
    if plan.drive is not None:
        yield DRIVING, plan.drive
