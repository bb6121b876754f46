"""The bench of machines' motions and of cyclograms: error against run time (динамика, циклограммы)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from geometry.replay import DIGITS, exact
from plans.analytic.cyclogram import cyclogram
from plans.analytic.dynamics import run as solver
from plans.analytic.dynamics.flywheel import Exact, exact_cycle, flywheel, flywheel_of_points, sampled_cycle
from plans.analytic.kinematics import Analysis
from plans.bench.error import Errors
from plans.bench.trial import Found, Order, Road, Row, order, orders, terms, timed
from plans.bench.truth import digits
from plans.cyclogram.stations import Stations, crank
from plans.cyclogram.study import CYCLOGRAM, CyclogramStudy
from plans.dynamics import run as table
from plans.dynamics.cycle import Turn
from plans.dynamics.loop import loop
from plans.dynamics.study import DynamicsStudy
from plans.model.cyclogram import TURN as ROUND
from plans.model.cyclogram import Position, Stop
from plans.model.dynamics import TURN, Task
from plans.model.motion import Floats
from plans.model.motor import Motor
from plans.model.run import RUN_UP, ReducedLink, Run, RunTask
from plans.scene.scene import Scene
from plans.study import Study

ROUNDS = 5  # at most: a turn of thousands of strips takes the better part of a second
CHORDS, SAMPLED, EXACT = "construction: chords, loop", "analysis: the same strips", "analysis: exact turn"
POINTS, MEAN = "analysis: extremes at edges", "analysis: mean of positions"
TABLED = "construction: table of the run"
FEW = (12, 24, 36)  # positions whose mean gives the driving moment: of a smooth load to rounding
HALVES = 5  # steps, each half of the one before
DRIVING, WHOLE = "M_dr", "J_0"
ROUGH = "jumps keep it from falling fast"
NO_FLYWHEEL = "no fluctuation is asked for: no flywheel is judged"
DEFINED = (
    "error of the flywheel: the difference of J_0 from that of the exact turn, in shares of it; positions are the "
    "strips of a turn, beside which an edge stands on every jump"
)
SAMPLED_DEFINED = (
    f"{POINTS}: J_0 from even strips with true energies, in shares of it; {MEAN}: the driving moment as their mean, in "
    "shares of the largest moment"
)
RUN_DEFINED = "error of a run: the time of its run-up, in shares of it; the truth is the solver's, to its tolerance"


def by_strips(study: DynamicsStudy, exact: Callable[[], Exact], rounds: int, counts: Sequence[int]) -> Found:
    """Time and judge the flywheel by chords over strips, and by the exact turn over the same ordinates."""
    turn, task = exact(), study.task
    judge = partial(_off, flywheel(turn, task).whole)
    edges = {count: Turn(study.reduction, count).edges for count in counts}
    roads = [Road(partial(_chords, study, count), count, {CHORDS: judge}) for count in counts]
    roads += [Road(partial(_sampled, turn, task, edges[count]), count, {SAMPLED: judge}) for count in counts]
    roads.append(Road(lambda: flywheel(exact(), task), None, {EXACT: lambda _: Errors({WHOLE: turn.error}, WHOLE)}))
    rows = timed(roads, rounds)
    return Found(rows, [DEFINED, *orders(rows, CHORDS, "strips")])


def _chords(study: DynamicsStudy, count: int) -> float:
    """Draw works and loop over so many strips; give J_0, kg*m2."""
    return loop(Turn(study.reduction, count).works.cycle, study.task).flywheel.whole


def _sampled(turn: Exact, task: Task, edges: Floats) -> float:
    return flywheel_of_points(sampled_cycle(turn, edges), task).whole


def _off(true: float, whole: float) -> Errors:
    return Errors({WHOLE: abs(whole / true - 1) if true else 0.0}, WHOLE)


def by_points(found: Exact, task: Task, count: int) -> float:
    """Give J_0, kg*m2, with the extremes of the loop looked for at the edges of even strips alone."""
    return flywheel_of_points(exact_cycle(found, np.linspace(0.0, TURN, count + 1)), task).whole


def mean_error(found: Exact, count: int) -> float:
    """Give the error of the driving moment as the mean of so many positions, in shares of the largest moment."""
    turned = np.asarray(np.arange(count) * (TURN / count), dtype=np.float64)
    driving = -float(np.mean(found.moment(turned) + found.moment(turned, -1))) / 2
    most = float(np.abs(found.moment(found.load.looks)).max(initial=0.0)) or 1.0
    return abs(driving - found.driving) / most


def by_positions(found: Exact, task: Task, rounds: int, counts: Sequence[int]) -> Found:
    """Judge means of positions, and where a fluctuation is asked for time and judge extremes at edges."""
    note = ROUGH if found.breaks.size else ""
    rows = [Row(MEAN, count, count, Errors({DRIVING: mean_error(found, count)}, DRIVING), note=note) for count in FEW]
    if task.delta:
        judge = partial(_off, flywheel(found, task).whole)
        rows += timed([Road(partial(by_points, found, task, n), n, {POINTS: judge}) for n in counts], rounds)
    return Found(rows, [SAMPLED_DEFINED])


def step_errors(link: ReducedLink, motor: Motor, task: RunTask, halves: int = HALVES) -> dict[float, float]:
    """Give the error of the run-up's time, in shares of it, with the table's own step, half of it, a quarter, ..."""
    asked = task._replace(turns=0, brake=None)
    true = _time(solver.run(link, motor, asked))
    steps = [table.step_of(link, motor, task) / 2**k for k in range(halves)]
    return {step: abs(_time(table.run(link, motor, asked._replace(step=step))) / true - 1) for step in steps}


def by_steps(link: ReducedLink, motor: Motor, task: RunTask) -> Found:
    """Judge the table of a run by its step; the last row tells the order, from the last two."""
    found = step_errors(link, motor, task)
    steps, errors = list(found)[-2:], list(found.values())[-2:]
    notes = {steps[-1]: f"order {order(errors, [1 / step for step in steps]):.2f}"}
    rows = [
        Row(f"{TABLED}, step {step:.3g} s", None, errors=Errors({"t": error}), note=notes.get(step, ""))
        for step, error in found.items()
    ]
    return Found(rows, [RUN_DEFINED])


def _time(run: Run) -> float:
    ends = run.ends(RUN_UP)
    assert ends is not None  # a machine that does not start is not measured
    return ends[1]


NOTCHED, TRIED, ANALYSED = "construction: notches from the tool", "trial on the travel", "analysis: roots of the travel"
KIND = "φ"
DEFINED_TURNS = (
    "error: the largest difference from the truth of the turns of the main shaft at the tool's places, in turns"
)
TRUE = f"truth: the notches from the tool's places carried out in {DIGITS} digits"
NONE = "no notches lead back from this tool: there is no truth to judge by"


def session(scene: Scene, order: Order, tell: Callable[[str], None]) -> Found:
    """Time and judge the characteristic positions of a scene."""
    study: CyclogramStudy = Study(scene)[CYCLOGRAM]
    true, count = truth(study), len(study.stations.asked)
    tell("the characteristic positions")

    def judge(found: Sequence[float]) -> Errors | None:
        return errors(found, true) if true else None

    rows = timed([Road(run, count, {name: judge}) for name, run in ways(study)], order.rounds)
    return Found(rows, [DEFINED_TURNS, TRUE if true else NONE, *terms(order, "of a turn")])


def ways(study: CyclogramStudy) -> list[tuple[str, Callable[[], Sequence[float]]]]:
    """List the roads to the turns of the main shaft, rad, at the tool's places; each begins anew with every run."""

    def anew() -> Stations:
        """Begin the way from the tool back to the crank anew; the extremes are those of the linkage."""
        return Stations(study.linkage.sweep, study.output, study.reached, study.task)

    def analysed() -> list[float]:
        linkage = study.linkage
        road = Analysis(linkage.mechanism, first=linkage.first, looks=linkage.looks.phi)
        found = cyclogram(road, study.task, study.output, None)
        return [] if found is None else in_order(study, found.positions)

    return [
        (NOTCHED, lambda: in_order(study, anew().cyclogram.positions)),
        (TRIED, lambda: [float(angle) * study.cyclogram.sense for angle in anew().tried]),
        (ANALYSED, analysed),
    ]


def truth(study: CyclogramStudy) -> list[float]:
    """Find the turns in many digits, rounded once; nothing where no notches lead back."""
    plan, mp = study.stations.plan, digits()
    if plan is None:
        return []
    arm, count = crank(plan), len(study.stations.asked)
    return [float(mp.arg(exact([arm], k)[arm])) * study.cyclogram.sense for k in range(count)]


def errors(found: Sequence[float], true: Sequence[float]) -> Errors:
    """Judge what a road has found."""
    off = [abs(math.remainder(one - other, ROUND)) / ROUND for one, other in zip(found, true, strict=True)]
    return Errors({KIND: max(off)} if off else {}, f"{KIND}_{off.index(max(off))}" if off else "")


def in_order(study: CyclogramStudy, positions: Sequence[Position]) -> list[float]:
    """Give the turns at the tool's places in the order in which they are asked for; a share is known to a rounding."""
    return [_nearest(stop, positions).turned for stop in study.stations.asked]


def _nearest(stop: Stop, positions: Sequence[Position]) -> Position:
    alike = (one for one in positions if (one.role, one.back) == (stop.role, stop.back))
    return min(alike, key=lambda one: abs(one.share - stop.share))
