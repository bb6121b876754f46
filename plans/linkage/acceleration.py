"""The acceleration plan: every end of a vector from the pole π is a point's acceleration (план ускорений)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from plans.linkage.groups import lead
from plans.linkage.groups.kinds import KINDS
from plans.linkage.plan import Image, Plan, Reading
from plans.model.structure import Dyad
from plans.words.words import because


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def accelerations(velocities: Plan, groups: Sequence[Dyad]) -> Plan:
    """Draw the acceleration plan over the velocity plan, group after group (section 6.4.2, M3.1)."""
    positions = velocities.positions
    plan = Plan("accelerations", positions.mechanism, (positions, velocities))
    drive = plan.mechanism.drive
    base = positions.images[drive.link]
    normal = lead.normal(plan, drive.link, plan.pole, (drive.pivot, drive.end))
    arm = lead.arm(plan, drive.link)
    why = because("crank_tangential") if drive.epsilon else because("even")
    part = plan.board.turn(f"a^t_{drive.end}", arm, 1j * drive.epsilon, why)
    tip = plan.board.lay_off(plan.letter(drive.end), normal, part, because("crank_end_acceleration"))
    end = plan.name(drive.end, tip)
    whole = plan.board.join(f"{plan.pole.name}{end.name}", plan.pole, end)
    plan.images[drive.link] = Image(plan.pole, whole, base.at, base.span)
    plan.readings[drive.link] = Reading(arm, part)
    for group in groups:
        KINDS[group.kind].accelerations(plan, group)
    return plan
