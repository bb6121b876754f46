"""The force plan drawn anew at all positions, where no pattern of it can be followed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from geometry.board import Mark
from geometry.meet import UNBORNE
from plans.forces.cut import Support
from plans.forces.force import ForcePlan
from plans.forces.force_template import ForcePlans, forces, reaction_of, row
from plans.forces.lever import lever
from plans.linkage.groups import guide
from plans.linkage.plan import Plan
from plans.model.group import Group
from plans.model.kinetostatics import Balancing, Kinetostatics, Loading, Reaction
from plans.model.machine import Machine
from plans.model.motion import Floats


class ForceDrawing:
    """What a pattern of forces does, by drawing: the plans below take the place of its numbers."""

    def __init__(self, groups: Sequence[Group], machine: Machine) -> None:
        self.groups, self.machine = groups, machine

    def follow(self, plans: Sequence[Plan], loading: Loading) -> ForcePlan:
        """Draw the force plan over the plans of the motion."""
        return forces(plans[2], self.groups, self.machine, loading)

    @np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
    def plans_of(self, plan: ForcePlan) -> ForcePlans:
        """Give the force plan itself, and the lever."""
        return ForcePlans(plan, lever(plan))

    def hung(self, plan: ForcePlan, count: int) -> Floats | None:
        """Read the balancing moment off the lever."""
        hung = self.plans_of(plan).lever
        return None if hung is None else np.asarray(row(hung.moment.point, count).real)

    def singular(self, plan: ForcePlan, count: int) -> Any:
        """Tell at which positions a polygon or an equation of moments has no answer with a true digit."""
        found = np.zeros(count, dtype=bool)
        for mark in plan.board:
            if mark.meeting is not None:
                found |= ~(np.broadcast_to(mark.meeting.sharpness, count) > UNBORNE)
        return found

    def read(self, plan: ForcePlan, phi: Floats) -> Kinetostatics:
        """Read all reactions and the balancing moment off the force plan."""
        supports = (support for cut in plan.cuts for support in cut.reactions)
        found = [_reaction(plan, support, len(phi)) for support in supports]
        reactions = {f"{one.giver}-{one.taker}": one for one in found}
        return Kinetostatics("construction", phi, reactions, _balancing(plan, len(phi)), ())


def _reaction(plan: ForcePlan, support: Support, count: int) -> Reaction:
    def value(mark: Mark | None) -> Any:
        return None if mark is None else mark.point

    along = None if support.slide is None else guide.direction(plan.positions, support.slide, support.slide.owner)
    return reaction_of(support, *map(value, (support.at, support.force, support.moment, along)), count=count)


def _balancing(plan: ForcePlan, count: int) -> Balancing:
    moment = row(plan.balancing.point, count).real.copy()
    if plan.drive is None or plan.driven is None:
        return Balancing(moment)
    return Balancing(moment, row(plan.drive.point, count), row(plan.driven.point, count))
