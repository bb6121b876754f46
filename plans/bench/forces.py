"""The roads to the forces: their construction, their analysis, and the balancing moment by three checks (пути к силам).

A road holds its kinematics; a check stands alone, over the motion and the loads of the road it belongs to.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import copy
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from geometry.errors import DraftError
from plans.analytic.energy import energy_balance
from plans.analytic.kinematics import Analysis
from plans.analytic.kinetostatics import kinetostatics
from plans.analytic.power import balancing_moment
from plans.bench.error import Errors, errors
from plans.bench.trial import Road
from plans.bench.truth import BALANCING, MOMENT, Truth, of_forces
from plans.forces.loading import loading
from plans.forces.reading.form import FORCES
from plans.forces.statics import ForceDrafts, Statics
from plans.forces.stroke import Stroke, strokes
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import Kinetostatics, Loading
from plans.model.machine import Track
from plans.model.motion import Floats, Motion

FORCES_CONSTRUCTED, FORCES_ANALYSED = "construction: forces", "analysis: forces"
LEVER, POWER, ENERGY = CHECKS = ("check: lever", "check: power", "check: energy")
TECHNIQUES = (FORCES_CONSTRUCTED, FORCES_ANALYSED, *CHECKS)
ENERGY_MOST = 1000  # positions: each takes eight others solved around it
TOO_LONG = f"the energy balance of more than {ENERGY_MOST} positions, each a millisecond, tells no more"
WITH_MOTION, LOADED = "with its kinematics", "reactions and M_bal at once, with its kinematics"
OVER_PLANS, OVER_MOTION = "M_bal alone, over the force plan", "M_bal alone, over the analysis's motion and loads"


def asked(study: LinkageStudy) -> bool:
    """Tell whether a scene asks for forces."""
    return FORCES in study.scene.sheets


def prepared(study: LinkageStudy) -> Statics | None:
    """Prepare the statics of a study: machine, strokes and the pattern of the force plan; None: no forces are asked."""
    if not asked(study):
        return None
    statics = Statics(copy(study))
    for part in ("machine", "strokes", "pattern", "pairs"):
        getattr(statics, part)
    return statics


def over(study: LinkageStudy, statics: Statics) -> Statics:
    """Give prepared statics over the empty boards of a study."""
    other = copy(statics)
    other.study = copy(study)
    return other


@dataclass(frozen=True)
class ForceGround:
    """What the roads to the forces of one number of positions stand on."""

    study: LinkageStudy
    statics: Statics  # no force plan of it is ever drawn: its copies draw
    truth: Truth
    largest: Mapping[str, float]

    def fresh(self) -> Statics:
        """Give the statics over empty boards."""
        return over(self.study, self.statics)

    def constructed(self) -> Kinetostatics:
        """Construct all forces, with the plans that they rest on."""
        return self.fresh().forces

    def analysed(self) -> Kinetostatics:
        """Solve the equations of all links at once."""
        road, motion, loads = self._loaded()
        return kinetostatics(road, self.statics.machine, motion, loads, self.statics.pairs)

    def lever(self) -> Floats:
        """Hang the loads on the lever over force plans that are there."""
        moments = [moment for part in self._parts if (moment := part.hung()) is not None]
        if len(moments) < len(self._parts):
            raise DraftError("nothing moves, so the lever has no velocity plan")
        return np.concatenate(moments)

    def power(self) -> Floats:
        """Reduce all forces to the crank by their power."""
        road, motion, loads = self._solved
        return balancing_moment(road, self.statics.machine, motion, loads)

    def energy(self) -> Floats:
        """Balance the energy; NaN where that is not judged."""
        if len(self.study.turn) > ENERGY_MOST:
            raise DraftError(TOO_LONG)
        road, motion, loads = self._solved
        return energy_balance(road, self.statics.machine, motion, loads).moment

    def judge(self, forces: Kinetostatics) -> Errors:
        """Give the errors of reactions and moments."""
        return errors(of_forces(forces, self.truth), self.truth, self.largest)

    def judge_moment(self, moment: Floats) -> Errors:
        """Give the error of a balancing moment where it has one."""
        judged = [k for k in self.truth.positions if np.isfinite(moment[k])]
        if not judged:
            return Errors({})
        return errors({(MOMENT, BALANCING): moment[judged]}, self.truth.at(judged), self.largest)

    def _marched(self) -> tuple[Analysis, Motion]:
        road = Analysis(self.study.mechanism, first=self.study.first)
        return road, road.motion(self.study.turn.phi)

    def _loaded(self) -> tuple[Analysis, Motion, Loading]:
        road, motion = self._marched()
        return road, motion, loading(self.statics.machine, motion, self._strokes)

    @cached_property
    def _solved(self) -> tuple[Analysis, Motion, Loading]:
        """What the checks stand on."""
        return self._loaded()

    @cached_property
    def _strokes(self) -> dict[Track, Stroke]:
        """The strokes by analysis: once a scene, as those of the construction."""
        return strokes(self.statics.machine, self.study.mechanism, self.study.output, self._marched()[0].extremes)

    @cached_property
    def _parts(self) -> list[ForceDrafts]:
        parts = list(self.fresh().parts())
        for part in parts:
            part.read()
        return parts

    def roads(self) -> list[Road]:
        """List the ways to the forces."""
        ways: dict[str, tuple[Callable[[], Any], Callable[[Any], Errors], str]] = {
            FORCES_CONSTRUCTED: (self.constructed, self.judge, WITH_MOTION),
            FORCES_ANALYSED: (self.analysed, self.judge, LOADED),
            LEVER: (self.lever, self.judge_moment, OVER_PLANS),
            POWER: (self.power, self.judge_moment, OVER_MOTION),
            ENERGY: (self.energy, self.judge_moment, OVER_MOTION),
        }
        count = len(self.study.turn)
        return [Road(run, count, {name: judge}, note) for name, (run, judge, note) in ways.items()]
