"""The plan of positions: the crank circle divided, then group after group by notches (план положений)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from geometry.meet import Sizes
from plans.linkage.crank_positions import CrankPositions
from plans.linkage.groups.kinds import KINDS
from plans.linkage.plan import Plan
from plans.linkage.primary import PRIMARIES
from plans.model.group import Group
from plans.model.mechanism import Mechanism


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def positions(mechanism: Mechanism, groups: Sequence[Group], sides: Sequence[Sizes], turn: CrankPositions) -> Plan:
    """Draw the plan of positions; `sides` gives each group's side of its meeting, NaN where it must stay undrawn."""
    plan = PRIMARIES[mechanism.drive.kind].positions(mechanism, turn)
    for group, side in zip(groups, sides, strict=True):
        KINDS[group.kind].positions(plan, group, side)
    return plan
