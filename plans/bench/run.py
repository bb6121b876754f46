"""The run of a machine by the book's table and by the solver, measured: error against step, and cost (разбег)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from plans.analytic.dynamics import run as solver
from plans.analytic.dynamics.equation import AT_REST, COMMON, Ends, Equation, Leg, Solver
from plans.bench.error import Errors
from plans.bench.result import Row
from plans.dynamics import run as table
from plans.model.dynamics import TURN
from plans.model.motor import Motor
from plans.model.run import RUN_UP, ReducedLink, Run, RunTask

SOLVED, TABLED = "analysis: solver of the run", "construction: table of the run"
HALVES = 5  # steps, each half of the one before
DEFINED = "error of a run: the time of its run-up, in shares of it; the truth is the solver's, to its tolerance"


@dataclass(frozen=True)
class StepError:
    """The error of a table with a step s, in shares of the time of the run-up."""

    step: float
    error: float


def ways(link: ReducedLink, motor: Motor, task: RunTask) -> list[tuple[str, Callable[[], Run]]]:
    """List the roads; each begins anew with every run."""
    return [(TABLED, lambda: table.run(link, motor, task)), (SOLVED, lambda: solver.run(link, motor, task))]


def step_errors(link: ReducedLink, motor: Motor, task: RunTask, halves: int = HALVES) -> tuple[StepError, ...]:
    """Measure the table of a run-up with the step that it takes by itself, half of it, a quarter, ..."""
    asked = task._replace(turns=0, brake=None)
    true = _time(solver.run(link, motor, asked))
    first = table.step_of(link, motor, task)
    steps = [first / 2**k for k in range(halves)]
    found = (_time(table.run(link, motor, asked._replace(step=step))) for step in steps)
    return tuple(StepError(step, abs(time / true - 1)) for step, time in zip(steps, found, strict=True))


def order(errors: Sequence[StepError]) -> float:
    """Give the order in which the error falls with the step, from the last two.

    >>> order([StepError(0.1, 0.02), StepError(0.05, 0.01)])
    1.0
    """
    before, last = errors[-2:]
    return math.log(before.error / last.error) / math.log(before.step / last.step)


def rows(errors: Sequence[StepError]) -> list[Row]:
    """Make a row of each step, the last one with the order."""
    notes = ["" for _ in errors[:-1]] + [f"order {order(errors):.2f}"]
    return [
        Row(f"{TABLED}, step {one.step:.3g} s", None, errors=Errors({"t": one.error}), note=note)
        for one, note in zip(errors, notes, strict=True)
    ]


def costs(link: ReducedLink, motor: Motor, speed: float, turns: int) -> tuple[Leg, Leg]:
    """Follow a run-up to a speed and some loaded turns by the solver that is chosen, and by the common one."""
    chosen = solver.chosen(link, motor, speed)
    first, second = (_followed(one, link, motor, speed, turns) for one in (chosen, _common(chosen)))
    return first, second


def _common(chosen: Solver) -> Solver:
    return Solver(COMMON, chosen.sizes, chosen.longest)


def _followed(way: Solver, link: ReducedLink, motor: Motor, speed: float, turns: int) -> Leg:
    equation = Equation(link, motor, base=motor.speed(0.0) or 0.0)
    up = way.leg(equation, AT_REST, Ends(math.inf, speed))
    loaded = Equation(link, motor, loaded=True, base=equation.base)
    on = way.leg(loaded, up.end, Ends(up.end.turned + turns * TURN))
    return on._replace(evaluations=up.evaluations + on.evaluations, jacobians=up.jacobians + on.jacobians)


def _time(run: Run) -> float:
    ends = run.ends(RUN_UP)
    assert ends is not None  # a machine that does not start is not measured
    return ends[1]
