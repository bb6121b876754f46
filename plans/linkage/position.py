"""The plan of positions: the crank circle divided, then group after group by notches (план положений)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from geometry.meet import Sizes
from plans.linkage.crank_positions import CrankPositions
from plans.linkage.groups.kinds import KINDS
from plans.linkage.plan import Image, Plan
from plans.model.mechanism import Mechanism
from plans.model.structure import Dyad
from plans.words.words import because


def crank(mechanism: Mechanism, turn: CrankPositions) -> Plan:
    """Start a plan of positions: the fixed hinge, the crank circle and the crank's end at every angle."""
    plan = Plan("positions", mechanism)
    drive, points = mechanism.drive, mechanism.links[mechanism.drive.link].points
    pivot = plan.point(drive.pivot)
    lead = points[drive.end] - points[drive.pivot]
    circle = plan.board.arc(f"{drive.pivot}{drive.end}", pivot, abs(lead), because("crank_circle"))
    angles = plan.board.given("φ", turn.directions, because("crank_directions"))
    end = plan.name(drive.end, plan.board.divide(drive.end, circle, angles, because("divided")))
    arm = plan.board.join(f"{drive.pivot}{drive.end}", pivot, end, because("link", link=drive.link))
    plan.images[drive.link] = Image(pivot, arm, points[drive.pivot], lead)
    return plan


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def positions(mechanism: Mechanism, groups: Sequence[Dyad], sides: Sequence[Sizes], turn: CrankPositions) -> Plan:
    """Draw the plan of positions; `sides` gives each group's side of its meeting, NaN where it must stay undrawn."""
    plan = crank(mechanism, turn)
    for group, side in zip(groups, sides, strict=True):
        KINDS[group.kind].positions(plan, group, side)
    return plan
