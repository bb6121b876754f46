"""What balancing costs, by both roads over a turn: shaking force, reactions, balancing moment, before and after."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

import numpy as np

from plans.analytic.balance.counterweights import uncertain
from plans.analytic.balance.states import Course
from plans.balance.study import COSTS, BalanceStudy
from plans.checks.balance.centre import Centre
from plans.checks.balance.stretch import Stretch
from plans.checks.balance.weights import Weights
from plans.checks.comparison import Finding
from plans.checks.force_comparison import ForceFindings
from plans.forces.statics import ForceDrafts, Statics
from plans.model.balance.linkage import Balance, State
from plans.model.motion import Floats


class Costs:
    """The machine before and after by both roads, over a turn."""

    def __init__(
        self, study: BalanceStudy, course: Course, stretch: Stretch, roads: tuple[Balance, Balance], weights: Weights
    ) -> None:
        self.study, self.course, self.stretch, self.weights = study, course, stretch, weights
        self.ours, self.theirs = roads

    def findings(self) -> Iterator[Finding]:
        """Compare all of it."""
        for after in (False, True):
            one, other = self._states(after)
            if one is not None and other is not None:
                found = *self.centre(after).findings(COSTS, one.around, other.around), *self._forces(after)
                yield from self.stretch.capped(found)

    def _states(self, after: bool) -> tuple[State | None, State | None]:
        return (self.ours.after, self.theirs.after) if after else (self.ours.before, self.theirs.before)

    def centre(self, after: bool) -> Centre:
        """Give the mass centre over the turn."""
        return self._centres[after]

    @cached_property
    def _centres(self) -> dict[bool, Centre]:
        told = (False, True) if self.ours.after is not None else (False,)
        return {after: Centre(self.study, self.stretch, after, self.weights) for after in told}

    def forces(self, after: bool) -> ForceFindings:
        """Give the forces over the turn by both roads, with what rounding allows the construction."""
        one, other = self._states(after)
        assert one is not None and other is not None  # asked before
        statics: Statics = self.study.loaded_statics if after else self.study.statics
        plans = ForceDrafts(statics, self.stretch.drafts).plans
        _, force, moment = self.centre(after).sizes  # a counterweight far out has a large moment of inertia forces
        borne = max(force, moment / self.stretch.size)
        return ForceFindings(statics, self.stretch.motion, one.forces, other.forces, plans, borne)

    def _forces(self, after: bool) -> Iterator[Finding]:
        """Compare reactions and what the drive gives; what the counterweights are off, the reactions magnify."""
        both, mark = self.forces(after), "'" if after else ""
        off = self.given * self.stretch.motion.kappa if after else np.zeros(1)
        for one in (*both.reactions(), *both.balancing(self.course.loading)):
            arm = both.size if one.unit == "N*m" else 1.0
            letters, space, way = one.name.partition(" ")
            name = f"{letters}{mark}{space}{way}"
            yield one._replace(plan=COSTS, name=name, allowed=np.asarray(one.allowed + off * arm))

    @property
    def given(self) -> float:
        """How far the inertia and weight of the counterweights may be off, N."""
        off = [uncertain(one, self.weights.slack(one.link)) for one in self.ours.counterweights]
        return self.weights.whole * self.stretch.rate + abs(self.course.machine.gravity) * sum(off)

    def allowed(self, after: bool, index: str) -> tuple[Floats, Floats]:
        """Give how far main vector and the reaction of a pair, by its index, may be off over the turn, N."""
        both = self.forces(after)
        found = {one.name: one.allowed for one in both.reactions()}
        off = self.given * self.stretch.motion.kappa if after else np.zeros(1)
        return self.centre(after).shaken, np.asarray(found[f"R_{index}"] + off)
