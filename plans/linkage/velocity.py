"""The velocity plan: every end of a vector from the pole p is a point's velocity (план скоростей)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from plans.linkage.groups.kinds import KINDS
from plans.linkage.plan import Plan
from plans.linkage.primary import PRIMARIES
from plans.model.group import Group


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def velocities(positions: Plan, groups: Sequence[Group]) -> Plan:
    """Draw the velocity plan over a plan of positions, group after group (section 6.4.2, M3.1)."""
    plan = Plan("velocities", positions.mechanism, (positions,))
    PRIMARIES[plan.mechanism.drive.kind].velocities(plan)
    for group in groups:
        KINDS[group.kind].velocities(plan, group)
    return plan
