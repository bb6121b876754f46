"""A machine's motion by both roads: reduction, works, loop, speeds; and the true error of the method (сравнение).

The chords of the construction are held against the same chords by the analysis's own ordinates, so that nothing but
rounding parts them; what the chords themselves leave out is told beside, against the exact turn, and is not judged.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

from geometry.strips import Departure, departure
from plans.analytic.dynamics.corners import with_flywheel_of_points, without_flywheel_of_points
from plans.analytic.dynamics.cycle import exact_cycle, sampled_cycle
from plans.analytic.dynamics.flywheel import Exact, exact, flywheel, flywheel_of_points
from plans.analytic.dynamics.link import reduced_link
from plans.analytic.dynamics.methods import methods
from plans.analytic.dynamics.reduction import Reduction as Reducing
from plans.analytic.dynamics.reduction import reduced
from plans.analytic.dynamics.speeds import Stall, Swing, with_flywheel, without_flywheel
from plans.checks.compare import MotionComparison
from plans.checks.comparison import Comparison, Finding
from plans.checks.dynamics_chords import Chords, Reductions
from plans.dynamics.study import DynamicsStudy
from plans.forces.loading import loading
from plans.forces.stroke import Stroke
from plans.model.account import Account
from plans.model.dynamics import Cycle, Speeds
from plans.model.flywheel_methods import Methods
from plans.model.kinetostatics import Loading
from plans.model.machine import Track
from plans.model.motion import Floats, Motion
from plans.model.run import Run

if TYPE_CHECKING:
    from plans.study import Study

ORDER = 2  # the reduction rests on velocities, its slope on accelerations: rounding is magnified once more for each


@dataclass(frozen=True)
class DynamicsComparison(Comparison):
    """A machine's motion by both roads, over its positions by both; `exact` is the turn without the chords' error."""

    construction: Account
    analysis: Account
    findings: tuple[Finding, ...]
    motion: MotionComparison
    exact: Account
    turn: Exact | None = None  # the exact turn at any angle; None where the crank cannot turn fully
    after: Swing | Stall | None = None  # the exact motion with the flywheel
    before: Swing | Stall | None = None  # and without one
    methods: Methods | None = None  # J0 by other methods, exact

    @property
    def agrees(self) -> bool:
        """Whether both roads find the same over the same motion."""
        return super().agrees and self.motion.agrees

    @property
    def error(self) -> Departure | None:
        """The true error of the chords in J0, as a share of it; None where no fluctuation is asked for."""
        drawn, true = self.construction.flywheel, self.exact.flywheel
        return None if drawn is None or true is None else departure([drawn.whole], [true.whole])


def comparison_of(study: Study) -> DynamicsComparison:
    """Compare a scene's machine (row of the table of techniques)."""
    return compare_dynamics(study["dynamics"], study.comparison("linkage"))


def compare_dynamics(study: DynamicsStudy, motion: MotionComparison) -> DynamicsComparison:
    """Compare the motion of a machine whose positions are compared."""
    road, strokes = _road(study, motion)
    theirs = Account("analysis", reduced(road, study.linkage.turn.phi))
    both = Reductions(study, motion, theirs)
    ours = study.account
    if ours.cycle is None:
        return DynamicsComparison(ours, theirs, tuple(both.findings()), motion, theirs)
    turn = exact(road, strokes)
    sampled = _sampled(study, theirs, turn, ours.cycle)
    true, after, before = _exact(study, theirs, turn, ours.cycle)
    chords = Chords(study, ours.cycle, sampled, turn)
    found = (*both.findings(), *chords.findings())
    return DynamicsComparison(ours, sampled, found, motion, true, turn, after, before, methods(turn, study.task))


def exact_turn(study: DynamicsStudy, motion: MotionComparison) -> Exact:
    """Find the turn of a machine without any error but rounding, by the road that its positions were compared by."""
    return exact(*_road(study, motion))


def _road(study: DynamicsStudy, motion: MotionComparison) -> tuple[Reducing, dict[Track, Stroke]]:
    strokes = study.statics.over(motion.road.extremes)
    loads, start = partial(_loads, study, strokes), float(study.linkage.turn.phi[0])
    return Reducing(motion.road, study.statics.machine, loads, start), strokes


def _loads(study: DynamicsStudy, strokes: Mapping[Track, Stroke], motion: Motion) -> Loading:
    return loading(study.statics.machine, motion, strokes)


def _sampled(study: DynamicsStudy, theirs: Account, turn: Exact, cycle: Cycle) -> Account:
    """Do what the construction does, with the ordinates of the analysis."""
    task, sampled = study.task, sampled_cycle(turn, cycle.turned)
    found, slope = flywheel_of_points(sampled, task) if task.delta else None, turn.slope(cycle.turned)
    speeds = with_flywheel_of_points(sampled, slope, task, found) if found else None
    before = without_flywheel_of_points(sampled, slope, task)
    return replace(theirs, cycle=sampled, flywheel=found, speeds=speeds, before=before)


def _exact(
    study: DynamicsStudy, theirs: Account, turn: Exact, cycle: Cycle
) -> tuple[Account, Swing | Stall | None, Swing | Stall]:
    """Account for the turn without any error but rounding."""
    task = study.task
    found = flywheel(turn, task) if task.delta else None
    before = without_flywheel(turn, task)
    after = with_flywheel(turn, task, found) if found else None
    speeds = [_told(one, cycle.turned) for one in (after, before)]
    true = replace(theirs, cycle=exact_cycle(turn, cycle.turned), flywheel=found, speeds=speeds[0], before=speeds[1])
    if study.motor is not None:
        true = replace(true, run=_run(study, turn))
    return true, after, before


def _run(study: DynamicsStudy, turn: Exact) -> Run:
    """Find the run of the machine with the flywheel that was constructed."""
    from plans.analytic.dynamics.run import run  # noqa: PLC0415  (only a scene with a motor pays for the solver)

    assert study.motor is not None  # asked before
    return run(reduced_link(turn, study.constant), study.motor, study.run_task)


def _told(found: Swing | Stall | None, turned: Floats) -> Speeds | None:
    return found.speeds(turned) if isinstance(found, Swing) else None
