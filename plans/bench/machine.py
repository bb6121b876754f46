"""A machine's motion timed and judged: flywheel, a turn known at some positions, run by a table (динамика машины).

The truth is the exact turn: moments and inertia to rounding, extremes by roots; of a run, the solver's.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from plans.analytic.dynamics import run as solver
from plans.analytic.dynamics.flywheel import Exact, exact_cycle, flywheel, flywheel_of_points, sampled_cycle
from plans.bench.error import Errors
from plans.bench.trial import Found, Road, Row, order, orders, timed
from plans.dynamics import run as table
from plans.dynamics.cycle import Turn
from plans.dynamics.loop import loop
from plans.dynamics.study import DynamicsStudy
from plans.model.dynamics import TURN, Task
from plans.model.motion import Floats
from plans.model.motor import Motor
from plans.model.run import RUN_UP, ReducedLink, Run, RunTask

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
