"""The roads that are timed: the construction in three lengths, its replay in 50 digits, and the analysis (пути)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from copy import copy
from dataclasses import dataclass
from typing import Any

import numpy as np

from geometry.errors import DraftError
from plans.analytic.closure import EPS
from plans.analytic.kinematics import solve
from plans.bench import forces
from plans.bench.error import Errors, errors
from plans.bench.peers import peers
from plans.bench.trial import Road
from plans.bench.truth import Replay, Truth, replay, sample, values
from plans.forces.reading.form import ForceForm
from plans.forces.statics import Statics
from plans.linkage.reading.form import LinkageForm
from plans.linkage.study import LinkageStudy
from plans.model.motion import Motion
from plans.scene.scene import Scene

CONSTRUCTION = ("construction: positions", "construction: + velocities", "construction: all")
SET_UP, ONCE = "construction: set-up", "once a scene, not in the rows below"
REPLAY = "replay in 50 digits"
# Newton's law makes nine digits of three: a tolerance under 1e-8 already ends at rounding, the last row.
TOLERANCES = (1e-3, 1e-6)
ROUNDING = "Newton to rounding"
REPLAYED = 4  # positions of one timed replay: each takes as long as any other
IS_TRUTH = "the truth itself"


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
    statics = forces.prepared(study)
    lost = copy(study).lost
    if statics is not None:
        lost = lost | np.isnan(forces.over(study, statics).forces.balancing.moment)
    drawn = replay(study, sample(lost, sampled), statics)
    return Ground(study, drawn.truth(), replay(study, drawn.positions[:REPLAYED], statics), largest, statics)


def roads(found: Ground) -> list[Road]:
    """List the roads of plandraft itself."""
    study, count = found.study, len(found.study.turn)
    set_up = Road(lambda: forces.prepared(prepared(study.scene, count)), count, {SET_UP: _nothing}, ONCE, 0)
    drawn = [Road(_drawing(found, order), count, {name: found.judge}) for order, name in enumerate(CONSTRUCTION)]
    again = Road(found.replay.truth, count, {REPLAY: _nothing}, IS_TRUTH, len(found.replay.positions))
    tolerances = {newton(tolerance): tolerance for tolerance in TOLERANCES} | {ROUNDING: EPS}
    solved = [Road(_solving(study, limit), count, {name: found.judge}) for name, limit in tolerances.items()]
    stood = forces.ForceGround(study, found.statics, found.truth, found.largest) if found.statics else None
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
