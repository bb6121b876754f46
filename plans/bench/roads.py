"""The roads to motion and forces: construction, its replay in 50 digits, analysis, three checks (пути).

A road to the forces holds its kinematics; a check stands alone, over the motion and the loads of its road.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import copy
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from geometry.errors import DraftError
from plans.analytic.closure import EPS
from plans.analytic.energy import energy_balance
from plans.analytic.kinematics import Analysis, solve
from plans.analytic.kinetostatics import kinetostatics
from plans.analytic.power import balancing_moment
from plans.bench.error import Errors, errors
from plans.bench.peers import peers
from plans.bench.trial import Road
from plans.bench.truth import BALANCING, MOMENT, Replay, Truth, of_forces, replay, sample, values
from plans.forces.loading import loading
from plans.forces.reading.form import FORCES, ForceForm
from plans.forces.statics import ForceDrafts, Statics
from plans.forces.stroke import Stroke, strokes
from plans.linkage.reading.form import LinkageForm
from plans.linkage.study import LinkageStudy
from plans.model.kinetostatics import Kinetostatics, Loading
from plans.model.machine import Track
from plans.model.motion import Floats, Motion
from plans.scene.scene import Scene

CONSTRUCTION = ("construction: positions", "construction: + velocities", "construction: all")
SET_UP, ONCE = "construction: set-up", "once a scene, not in the rows below"
REPLAY = "replay in 50 digits"
# Newton's law makes nine digits of three: a tolerance under 1e-8 already ends at rounding, the last row.
TOLERANCES = (1e-3, 1e-6)
ROUNDING = "Newton to rounding"
REPLAYED = 4  # positions of one timed replay: each takes as long as any other
IS_TRUTH = "the truth itself"
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


def statics_of(study: LinkageStudy) -> Statics | None:
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


class NothingToMeasure(DraftError):  # noqa: N818  (the message's own word)
    """A scene without a position that can be assembled, or whose drive has no turn."""

    exit_code = 4

    @classmethod
    def of(cls, scene: Scene) -> NothingToMeasure:
        """Say that no position can be assembled."""
        return cls(f"{scene.file}: no position can be assembled, so there is nothing to measure")


@dataclass(frozen=True)
class Ground:
    """What all techniques of one number of positions stand on: the prepared study, the truth, and what counts as 1."""

    study: LinkageStudy  # no plan of it is ever drawn: its copies draw
    truth: Truth
    replay: Replay
    largest: Mapping[str, float]
    statics: Statics | None = None  # of a scene that asks for forces

    def fresh(self) -> LinkageStudy:
        """Give the study with empty boards: what was prepared is shared, every plan is drawn anew."""
        return copy(self.study)

    def judge(self, motion: Motion) -> Errors:
        """Give the errors of a motion over all positions of the study."""
        return errors(values(motion, self.truth), self.truth, self.largest)


def newton(tolerance: float) -> str:
    """Name the analysis to a tolerance.

    >>> newton(1e-3)
    'Newton to 1e-03'
    """
    return f"Newton to {tolerance:.0e}"


def with_positions(scene: Scene, count: int) -> Scene:
    """Give a scene another number of positions, equal steps of a turn from its own first crank angle."""
    form, loaded = scene.of(LinkageForm), scene.of(ForceForm)
    drive, sheet = form.drive, form.sheet
    start = drive.positions[0] if isinstance(drive.positions, tuple) else drive.start
    plans, forces = (tuple(k for k in chosen if k < count) for chosen in (sheet.plans, loaded.sheet.forces))
    shown = sheet.position if sheet.position is not None and sheet.position < count else None
    return scene.changed(
        form.changed(
            drive=drive.changed(positions=count, start=start), sheet=sheet.changed(plans=plans, position=shown)
        ),
        loaded.changed(sheet=loaded.sheet.changed(forces=forces)),
    )


def prepared(scene: Scene, count: int) -> LinkageStudy:
    """Study a scene at a number of positions: structure, assembly, barriers and crank angles, but no plan yet."""
    study = LinkageStudy(with_positions(scene, count))
    for part in ("groups", "sweep", "barriers", "turn"):
        getattr(study, part)
    return study


def ground(scene: Scene, count: int, sampled: int, largest: Mapping[str, float]) -> Ground:
    """Prepare a scene at a number of positions, and find the truth at a sample of them."""
    study = prepared(scene, count)
    statics = statics_of(study)
    lost = copy(study).lost
    if statics is not None:
        lost = lost | np.isnan(over(study, statics).forces.balancing.moment)
    drawn = replay(study, sample(lost, sampled), statics)
    return Ground(study, drawn.truth(), replay(study, drawn.positions[:REPLAYED], statics), largest, statics)


def roads(found: Ground) -> list[Road]:
    """List the roads of plandraft itself."""
    study, count = found.study, len(found.study.turn)
    set_up = Road(lambda: statics_of(prepared(study.scene, count)), count, {SET_UP: _nothing}, ONCE, 0)
    drawn = [Road(_drawing(found, order), count, {name: found.judge}) for order, name in enumerate(CONSTRUCTION)]
    again = Road(found.replay.truth, count, {REPLAY: _nothing}, IS_TRUTH, len(found.replay.positions))
    tolerances = {newton(tolerance): tolerance for tolerance in TOLERANCES} | {ROUNDING: EPS}
    solved = [Road(_solving(study, limit), count, {name: found.judge}) for name, limit in tolerances.items()]
    stood = ForceGround(study, found.statics, found.truth, found.largest) if found.statics else None
    loaded = stood.roads() if stood else []
    # Their construction runs next to the motion that it is held against: after a long run the caches are cold.
    return [set_up, *drawn, *loaded[:1], again, *solved, *loaded[1:]]


def _nothing(_: Any) -> Errors:
    return Errors({})


def _drawing(found: Ground, order: int) -> Callable[[], Motion]:
    return lambda: found.fresh().motion(order)


def _solving(study: LinkageStudy, tolerance: float) -> Callable[[], Motion]:
    return lambda: solve(study.mechanism, study.turn.phi, tolerance=tolerance, first=study.first)


def compared(found: Ground) -> tuple[list[Road], dict[str, str]]:
    """List the peers' roads, and why others of them are left out."""
    ready, out = peers(found.fresh())
    count = len(found.study.turn)
    judges = {peer.name: (lambda result, read=peer.motion: found.judge(read(result))) for peer in ready}
    return [Road(peer.run, count, {peer.name: judges[peer.name]}, peer.versions) for peer in ready], out
