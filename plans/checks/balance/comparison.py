"""A mechanism balanced by both roads: mass centre, counterweights, what they cost, the share (сравнение)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from plans.analytic.balance.balance import balance
from plans.analytic.balance.states import Course
from plans.analytic.kinematics import Analysis
from plans.balance.study import BalanceStudy
from plans.checks.balance.centre import Centres
from plans.checks.balance.costs import Costs
from plans.checks.balance.shares import share_findings
from plans.checks.balance.stretch import scene_stretch, turn_stretch
from plans.checks.balance.weights import Weights
from plans.checks.compare import MotionComparison, compare
from plans.checks.comparison import Comparison, Finding
from plans.forces.loading import loading
from plans.model.balance.linkage import Balance
from plans.model.motion import Motion
from plans.model.order import ACCELERATIONS

if TYPE_CHECKING:
    from plans.study import Study


@dataclass(frozen=True)
class BalanceComparison(Comparison):
    """A balance by both roads, over the motion by both."""

    construction: Balance
    analysis: Balance
    findings: tuple[Finding, ...]
    motion: MotionComparison

    @property
    def agrees(self) -> bool:
        """Whether both roads find the same over the same motion."""
        return super().agrees and self.motion.agrees


def comparison_of(study: Study) -> BalanceComparison:
    """Compare both roads of a scene's balance (row of the table of techniques)."""
    motion = study.comparison("linkage")
    if motion.analysis.order < ACCELERATIONS.number:  # a bank asks for the balance and shows none of its motion
        motion = compare(study["linkage"], ACCELERATIONS.number)
    return compare_balance(study["balance"], motion)


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN on both roads
def compare_balance(study: BalanceStudy, motion: MotionComparison) -> BalanceComparison:
    """Balance a mechanism by analysis too, and put every quantity beside that of the construction.

    Of a share that is sought both roads tell their own, and go on with that of the construction.
    """
    ours, scene, turn = study.balance, scene_stretch(study.linkage, motion), turn_stretch(study.linkage, motion)
    course = course_of(study, motion.road, motion.analysis, turn.motion.analysis)
    theirs = balance(course, study.task, study.linkage.groups, study.share)
    weights = Weights(study, course)
    found = [*Centres(study, scene, ours, theirs, weights).findings()]
    found += weights.findings(ours, theirs)
    costs = Costs(study, course, turn, (ours, theirs), weights)
    found += [*costs.findings(), *share_findings(costs)]
    return BalanceComparison(ours, theirs, tuple(found), motion)


def course_of(study: BalanceStudy, road: Analysis, motion: Motion, turn: Motion) -> Course:
    """Give the course by analysis of a mechanism: its loads over the turn, with the strokes that the analysis finds."""
    statics = study.statics
    loads = loading(statics.machine, turn, statics.over(road.extremes))
    return Course(road, study.machine, statics.pairs, motion, turn, loads)
