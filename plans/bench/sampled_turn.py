"""A turn known at some positions alone: extremes looked for at edges, moments as means of positions (выборка за цикл).

The truth is the exact turn: moments and inertia to rounding, extremes by roots.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from plans.analytic.dynamics.cycle import exact_cycle
from plans.analytic.dynamics.exact import Exact
from plans.analytic.dynamics.flywheel import flywheel, flywheel_of_points
from plans.bench.clock import interleaved
from plans.bench.error import Errors
from plans.bench.result import Row
from plans.model.dynamics import TURN, Task

POINTS, MEAN = "analysis: extremes at edges", "analysis: mean of positions"
FEW = (12, 24, 36)  # positions whose mean gives the driving moment: of a smooth load to rounding
DRIVING, WHOLE = "M_dr", "J_0"
ROUGH = "jumps keep it from falling fast"
DEFINED = (
    f"{POINTS}: J_0 from even strips with true energies, in shares of it; {MEAN}: the driving moment as their mean, in "
    "shares of the largest moment"
)


def by_points(found: Exact, task: Task, count: int) -> float:
    """Give J_0, kg*m2, with the extremes of the loop looked for at the edges of even strips alone."""
    return flywheel_of_points(exact_cycle(found, np.linspace(0.0, TURN, count + 1)), task).whole


def mean_error(found: Exact, count: int) -> float:
    """Give the error of the driving moment as the mean of so many positions, in shares of the largest moment."""
    turned = np.asarray(np.arange(count) * (TURN / count), dtype=np.float64)
    driving = -float(np.mean(found.moment(turned) + found.moment(turned, -1))) / 2
    most = float(np.abs(found.moment(found.load.looks)).max(initial=0.0)) or 1.0
    return abs(driving - found.driving) / most


def rows(found: Exact, task: Task, rounds: int, budget: float, counts: Sequence[int]) -> tuple[list[Row], list[str]]:
    """Time and judge both; without a fluctuation that is asked for the means alone."""
    note = ROUGH if found.breaks.size else ""
    made = [Row(MEAN, count, count, Errors({DRIVING: mean_error(found, count)}, DRIVING), note=note) for count in FEW]
    if task.delta:
        true, times = flywheel(found, task).whole, interleaved([_run(found, task, n) for n in counts], rounds, budget)
        off = (abs(by_points(found, task, count) / true - 1) if true else 0.0 for count in counts)
        judged = zip(counts, off, times, strict=True)
        made += [Row(POINTS, n, n, Errors({WHOLE: error}, WHOLE), times=taken) for n, error, taken in judged]
    return made, [DEFINED]


def _run(found: Exact, task: Task, count: int) -> Callable[[], float]:
    return lambda: by_points(found, task, count)
