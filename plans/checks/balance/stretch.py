"""The positions over which both roads of a balance are compared: the scene's, and those of a whole turn (участки)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from geometry.board import Mark
from geometry.precision import errors
from plans.balance.states import positions_around
from plans.checks.compare import MotionComparison, cap, with_analysis
from plans.checks.comparison import Finding
from plans.linkage.drafts import Drafts
from plans.linkage.study import LinkageStudy
from plans.model.motion import Floats


class Stretch(NamedTuple):
    """Some positions of a linkage: the plans there, and the motion by both roads, which is judged elsewhere."""

    study: LinkageStudy
    drafts: Drafts
    motion: MotionComparison

    @property
    def rate(self) -> float:
        """The largest acceleration of a point of a link 1 m from one that rests, 1/s2; NaN where there is none."""
        rows = [np.abs(1j * link.epsilon - link.omega**2) for link in self.motion.analysis.links.values()]
        return float(np.fmax.reduce(rows, axis=None))

    @property
    def size(self) -> float:
        """How far the mechanism reaches from the datum, m."""
        rows = [np.abs(point.r) for point in self.motion.analysis.points.values()]
        return float(np.fmax.reduce(rows, axis=None))

    def allowed(self, own: Floats, order: int, largest: float) -> Floats:
        """Add what the analysis needs to what the construction does."""
        return with_analysis(own, order, self.motion.kappa, largest)

    def bounds(self, *marks: Mark) -> list[Floats]:
        """Give how far rounding can have moved marks, over the positions."""
        bounds, count = errors(*marks), len(self.motion.kappa)
        return [np.asarray(np.broadcast_to(bounds[mark].place, count)) for mark in marks]

    def capped(self, findings: Iterable[Finding]) -> tuple[Finding, ...]:
        """Allow no more than a share of the largest where the construction is sharp."""
        return cap(self.study, list(findings), self.drafts)


def scene_stretch(study: LinkageStudy, motion: MotionComparison) -> Stretch:
    """Give the positions of the scene, over which the motion is compared."""
    return Stretch(study, study.drafts(), motion)


def turn_stretch(study: LinkageStudy, motion: MotionComparison) -> Stretch:
    """Give even positions of a turn; of a crank that cannot turn fully they are the scene's."""
    around = positions_around(study)
    if around is study.turn:
        return scene_stretch(study, motion)
    drafts = Drafts(study, around)
    solved = motion.road.around(drafts.turn.phi)
    kappa = motion.road.conditions(solved)
    return Stretch(
        study, drafts, replace(motion, construction=drafts.motion(2), analysis=solved, findings=(), kappa=kappa)
    )
