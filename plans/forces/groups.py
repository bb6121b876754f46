"""The forces of all groups, cut off in the reverse order of their attachment, then of the primary link (6.4.5)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from plans.forces.dyads import GROUP_FORCES
from plans.forces.force import ForcePlan
from plans.forces.primary import primary
from plans.linkage.plan import Plan
from plans.model.group import Group
from plans.model.kinetostatics import Loading
from plans.model.machine import Machine


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def forces(accelerations: Plan, groups: Sequence[Group], machine: Machine, loading: Loading) -> ForcePlan:
    """Draw the force plan over the acceleration plan, the group attached last first (section 6.4.5, M5.7)."""
    plan = ForcePlan(accelerations, machine, loading)
    for group in reversed(groups):
        cut = GROUP_FORCES[group.kind].cut(plan, group)
        plan.cuts.append(cut)
        for support in cut.supports:
            plan.hand_over(support)
    plan.cuts.append(primary(plan))
    return plan
