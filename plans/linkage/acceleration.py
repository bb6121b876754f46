"""The acceleration plan: every end of a vector from the pole π is a point's acceleration (план ускорений)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from plans.linkage.groups.kinds import KINDS
from plans.linkage.plan import Plan
from plans.linkage.primary import PRIMARIES
from plans.model.group import Group
from plans.model.rates import Rates, steady


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
