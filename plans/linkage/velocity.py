"""The velocity plan: every end of a vector from the pole p is a point's velocity (план скоростей)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from plans.linkage.groups.kinds import KINDS
from plans.linkage.plan import Plan
from plans.linkage.primary import PRIMARIES
from plans.model.group import Group
from plans.model.rates import Rates, steady


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
