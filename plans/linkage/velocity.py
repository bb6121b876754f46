"""The velocity plan: every end of a vector from the pole p is a point's velocity (план скоростей)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from plans.linkage.groups.kinds import KINDS
from plans.linkage.plan import Image, Plan, Reading
from plans.model.structure import Dyad
from plans.words.words import because


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def velocities(positions: Plan, groups: Sequence[Dyad]) -> Plan:
    """Draw the velocity plan over a plan of positions, group after group (section 6.4.2, M3.1)."""
    plan = Plan("velocities", positions.mechanism, (positions,))
    drive = plan.mechanism.drive
    base = positions.images[drive.link]
    assert base.arm is not None  # the crank has an arm on the plan of positions
    arm = plan.carry(base.arm)
    omega = 1j * drive.omega
    part = plan.board.turn(f"v_{drive.end}", arm, omega, because("crank_velocity"))
    tip = plan.board.lay_off(plan.letter(drive.end), plan.pole, part, because("crank_end_velocity"))
    end = plan.name(drive.end, tip)
    relative = plan.board.join(f"{plan.pole.name}{end.name}", plan.pole, end)
    plan.images[drive.link] = Image(plan.pole, relative, base.at, base.span)
    plan.readings[drive.link] = Reading(arm, relative)
    for group in groups:
        KINDS[group.kind].velocities(plan, group)
    return plan
