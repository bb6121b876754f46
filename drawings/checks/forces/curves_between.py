"""The curves of a force sheet between their positions, by the analysis of other angles (кривые между ними)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plans.analytic.kinetostatics import kinetostatics
from plans.checks.force_comparison import ForceComparison
from plans.forces.statics import Statics
from plans.model.kinetostatics import Kinetostatics
from plans.model.motion import Floats, Motion

BETWEEN = 12  # angles over a turn, beside those of the positions
# Of a step: no division of a turn into whole numbers of positions falls on these angles; the others are taken where a
# load jumps beside one of the first, so that the drawn curve has its jump up to half a degree off.
APART, BESIDE = 0.37, 0.61


@dataclass(frozen=True)
class ForcesBetween:
    """The forces by analysis at angles between the positions of a turn."""

    statics: Statics
    comparison: ForceComparison
    apart: float = APART

    @cached_property
    def turned(self) -> Floats:
        """How far the crank has turned from position 0, degrees in the sense of rotation."""
        return 360.0 * (np.arange(BETWEEN) + self.apart) / BETWEEN

    @cached_property
    def motion(self) -> Motion:
        """The motion at these angles."""
        study = self.statics.study
        return self.comparison.motion.road.motion(study.turn.phi[0] + study.sense * np.radians(self.turned), 2)

    @cached_property
    def found(self) -> Kinetostatics:
        """The forces at these angles."""
        statics, road = self.statics, self.comparison.motion.road
        with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN
            loads = statics.loading_over(self.motion, statics.over(road.extremes))
            return kinetostatics(road, statics.machine, self.motion, loads, statics.pairs)

    @cached_property
    def balancing(self) -> Floats:
        """What is told of the drive at these angles."""
        strokes = self.statics.over(self.comparison.motion.road.extremes)
        return self.statics.given(self.found, self.motion, strokes)
