"""The plans of positions, velocities and accelerations, each drawn group after group (планы механизма)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from geometry.meet import Sizes
from plans.linkage.crank_positions import CrankPositions
from plans.linkage.groups.kinds import KINDS
from plans.linkage.plan import Plan
from plans.linkage.primary import PRIMARIES
from plans.model.dyad import Group
from plans.model.mechanism import Mechanism
from plans.model.motion import Rates, steady


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def positions(mechanism: Mechanism, groups: Sequence[Group], sides: Sequence[Sizes], turn: CrankPositions) -> Plan:
    """Draw the plan of positions; `sides` gives each group's side of its meeting, NaN where it must stay undrawn."""
    plan = PRIMARIES[mechanism.drive.kind].positions(mechanism, turn)
    for group, side in zip(groups, sides, strict=True):
        KINDS[group.kind].positions(plan, group, side)
    return plan


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def velocities(positions: Plan, groups: Sequence[Group], rates: Rates | None = None) -> Plan:
    """Draw the velocity plan over a plan of positions, group after group (section 6.4.2, M3.1).

    `rates` are the drive's in each of the positions; None: those that its scene gives.
    """
    plan = Plan("velocities", positions.mechanism, (positions,))
    drive = plan.mechanism.drive
    PRIMARIES[drive.kind].velocities(plan, rates or steady(drive))
    for group in groups:
        KINDS[group.kind].velocities(plan, group)
    return plan


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def accelerations(velocities: Plan, groups: Sequence[Group], rates: Rates | None = None) -> Plan:
    """Draw the acceleration plan over the velocity plan, group after group (section 6.4.2, M3.1).

    `rates` are those by which the velocity plan was drawn.
    """
    positions = velocities.positions
    plan = Plan("accelerations", positions.mechanism, (positions, velocities))
    drive = plan.mechanism.drive
    PRIMARIES[drive.kind].accelerations(plan, rates or steady(drive))
    for group in groups:
        KINDS[group.kind].accelerations(plan, group)
    return plan
