"""A pattern of forces: the force plan drawn at one position over the other plans, to be followed at any others."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from geometry.board import Mark, behind
from geometry.meet import UNBORNE
from geometry.tracing import Tracing, remade
from plans.forces.cut import ForcePlan, Support
from plans.forces.drive import primary, pushing
from plans.forces.dyads import GROUP_FORCES
from plans.forces.lever import Lever, lever
from plans.linkage import leads
from plans.linkage.motion_plans import PlanTemplate, resting
from plans.linkage.plan import Plan
from plans.model.dyad import Assur
from plans.model.kinetostatics import Effort, Kinetostatics, Loading, Reaction
from plans.model.machine import Machine
from plans.model.motion import Floats


class ForceDrawing:
    """What a pattern of forces does, by drawing: the plans below take the place of its numbers."""

    def __init__(self, groups: Sequence[Assur], machine: Machine) -> None:
        self.groups, self.machine = groups, machine

    def follow(self, plans: Sequence[Plan], loading: Loading) -> ForcePlan:
        """Draw the force plan over the plans of the motion."""
        return forces(plans[2], self.groups, self.machine, loading)

    @np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
    def plans_of(self, plan: ForcePlan) -> ForcePlans:
        """Give the force plan itself, and the lever."""
        return ForcePlans(plan, lever(plan))

    def singular(self, plan: ForcePlan, count: int) -> Any:
        """Tell at which positions a polygon or an equation of moments has no answer with a true digit."""
        found = np.zeros(count, dtype=bool)
        for mark in plan.board:
            if mark.meeting is not None:
                found |= ~(np.broadcast_to(mark.meeting.sharpness, count) > UNBORNE)
        return found

    def read(self, plan: ForcePlan, phi: Floats) -> Kinetostatics:
        """Read all reactions and the balancing moment off the force plan."""
        return read(plan, phi, lambda mark: mark.point)


def read(plan: ForcePlan, phi: Floats, value: Callable[[Mark], Any]) -> Kinetostatics:
    """Read all reactions and the balancing moment off a force plan, by the value of each mark over the positions."""

    def numbers(mark: Mark) -> Any:
        return row(value(mark), len(phi))

    reactions = {}
    for support in (support for cut in plan.cuts for support in cut.reactions):
        reaction = _reaction(plan, support, numbers)
        reactions[f"{reaction.giver}-{reaction.taker}"] = reaction
    moment = numbers(plan.balancing).real.copy()
    driving = () if plan.drive is None or plan.driven is None else (numbers(plan.drive), numbers(plan.driven))
    return Kinetostatics("construction", phi, reactions, Effort(moment, *driving), ())


def _reaction(plan: ForcePlan, support: Support, numbers: Callable[[Mark], Any]) -> Reaction:
    """Make a reaction of its numbers, told from the lower link on; it may have been found as the opposite one."""
    rising = support.giver < support.taker
    force, r = numbers(support.force), numbers(support.at)
    low, high = sorted((support.giver, support.taker))
    reaction = Reaction(low, high, support.point, r, force if rising else -force)
    if support.slide is None:
        return reaction
    moment = row(0.0, len(r)).real if support.moment is None else numbers(support.moment).real
    along = numbers(leads.direction(plan.positions, support.slide, support.slide.owner))
    return reaction._replace(moment=moment if rising else -moment, along=along)


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def forces(accelerations: Plan, groups: Sequence[Assur], machine: Machine, loading: Loading) -> ForcePlan:
    """Draw the force plan over the acceleration plan, the group attached last first (section 6.4.5, M5.7)."""
    plan = ForcePlan(accelerations, machine, loading)
    for group in reversed(groups):
        cut = GROUP_FORCES[group.kind].cut(plan, group)
        plan.cuts.append(cut)
        for support in cut.supports:
            plan.hand_over(support)
    plan.cuts.append(primary(plan))
    return plan


class ForcePlans(NamedTuple):
    """The force plan and the lever at the positions of some plans, their marks made."""

    plan: ForcePlan
    lever: Lever | None


class ForcePattern:
    """The force plan over a pattern of accelerations; the lever is hung when it is looked at."""

    def __init__(self, pattern: PlanTemplate, groups: Sequence[Assur], machine: Machine, loading: Loading) -> None:
        self.pattern = pattern
        self.plan = forces(pattern.plans[2], groups, machine, loading)
        self._below = [plan.board for plan in pattern.plans]
        free = [*self.plan.given, *([self.plan.push] if self.plan.push is not None else [])]
        self.tracing = pattern.tracing.over(behind(*chain(*self._below, self.plan.board)), free)

    @cached_property
    def lever(self) -> Lever | None:
        """Zhukovsky's lever at the pattern's one position."""
        return lever(self.plan)

    @cached_property
    def _hung(self) -> Tracing:
        """The acts of the lever over those of the force plan."""
        boards = [*self._below, self.plan.board, *([self.lever.board] if self.lever is not None else [])]
        return self.tracing.over(behind(*chain(*boards)), ())

    @np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
    def follow(self, numbers: list[Any], loading: Loading) -> list[Any]:
        """Work out all numbers of the force plan over those of the plans below."""
        values = (*(load.force for load in loading.forces), *(twist.moment for twist in loading.moments))
        given, plan = dict(zip(self.plan.given, values, strict=True)), self.plan
        if plan.push is None:
            return self.tracing.follow_on(numbers, given)
        # Either flank asks the same moment of the teeth, and that tells which of them bears.
        found = self.tracing.follow_on(numbers, given | {plan.push: plan.push.point})
        moment = found[self.tracing.place(plan.balancing)].real
        along = pushing(plan.machine.transmission, plan.mechanism.drive, moment)
        return self.tracing.follow_on(numbers, given | {plan.push: along})

    def singular(self, numbers: list[Any], count: int) -> Any:
        """Tell at which positions a polygon or an equation of moments has no answer that the condition bears."""
        found = np.zeros(count, dtype=bool)
        for met in self.tracing.meetings(numbers):
            found |= ~(met.sharpness > UNBORNE)
        return found

    def read(self, numbers: list[Any], phi: Floats) -> Kinetostatics:
        """Read all reactions and the balancing moment off the force plan."""
        return read(self.plan, phi, lambda mark: numbers[self.tracing.place(mark)])

    @np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
    def plans_of(self, numbers: list[Any]) -> ForcePlans:
        """Make the plans that have these numbers of the force plan, and the lever."""
        boards, made = self._hung.boards(self._hung.follow_on(numbers, {}))
        plans: list[Plan] = []
        for plan in self.pattern.plans:
            plans.append(plan.redraw(boards[plan.board.subject], made, tuple(plans)))
        found = self.plan.redraw(boards, made, plans)
        return ForcePlans(found, remade(self.lever, made, boards))


def row(value: Any, count: int) -> Any:
    """Give a number as a row: what is the same at all positions takes no room."""
    row = np.asarray(value)
    return row if row.shape == (count,) else resting(row, count)
