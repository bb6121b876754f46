"""The flywheel by chords against the exact one: error over the number of strips, and what it costs (испытание).

The truth is the analysis's exact turn: moments and inertia to rounding, extremes by roots.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from plans.analytic.dynamics.cycle import exact_cycle
from plans.analytic.dynamics.exact import Exact
from plans.analytic.dynamics.flywheel import flywheel, flywheel_of_points
from plans.bench.calculus import COUNTS, order
from plans.bench.clock import interleaved
from plans.bench.error import Errors
from plans.bench.result import Row
from plans.dynamics.cycle import Turn
from plans.dynamics.loop import loop
from plans.dynamics.reduction import Reduction
from plans.model.dynamics import TURN, Cycle, Flywheel, Task

CHORDS, POINTS, MEAN = "construction: chords", "analysis: extremes at edges", "analysis: mean of positions"
EXACT = "analysis: exact turn"
FEW = (12, 24, 36)  # positions whose mean gives the driving moment: of a smooth load to rounding
DRIVING, WHOLE = "M_dr", "J_0"
DEFINED = (
    "error of a turn: the driving moment in shares of the largest moment, and J_0, where a fluctuation is asked for, "
    "in shares of itself; the largest of both"
)
KNOWN = 1e-12  # a smaller error is rounding, and has no order
ROUGH = "jumps keep it from falling fast"


class Truth(NamedTuple):
    """The exact turn, and what is asked of it."""

    task: Task
    found: Exact

    @property
    def wheel(self) -> Flywheel | None:
        """The exact flywheel."""
        return flywheel(self.found, self.task) if self.task.delta else None

    def errors(self, cycle: Cycle, wheel: Flywheel | None) -> Errors:
        """Judge a turn and the flywheel that came of it."""
        kinds = {DRIVING: abs(cycle.driving - self.found.driving) / self.most}
        true = self.wheel
        if wheel is not None and true is not None and true.whole:
            kinds[WHOLE] = abs(wheel.whole / true.whole - 1)
        return Errors(kinds, max(kinds, key=lambda kind: kinds[kind]))

    @property
    def most(self) -> float:
        """The largest moment of the loads, N*m; 1 where there are none."""
        return float(np.abs(self.found.moment(self.found.load.looks)).max(initial=0.0)) or 1.0

    def mean(self, count: int) -> Errors:
        """Judge the driving moment as the mean of so many ordinates."""
        turned = np.asarray(np.arange(count) * (TURN / count), dtype=np.float64)
        found = -float(np.mean(self.found.moment(turned) + self.found.moment(turned, -1))) / 2
        return Errors({DRIVING: abs(found - self.found.driving) / self.most}, DRIVING)


def by_chords(reduction: Reduction, task: Task, count: int) -> tuple[Cycle, Flywheel | None]:
    """Draw the works in so many strips, and the loop from them."""
    cycle = Turn(reduction, count).works.cycle
    return cycle, loop(cycle, task).flywheel if task.delta else None


def by_points(truth: Truth, count: int) -> tuple[Cycle, Flywheel | None]:
    """Look for the extremes at the edges of even strips alone, at true energies."""
    cycle = exact_cycle(truth.found, np.linspace(0.0, TURN, count + 1))
    return cycle, flywheel_of_points(cycle, truth.task) if truth.task.delta else None


def rows(
    reduction: Reduction,
    truth: Truth,
    exact: Callable[[], Exact],
    rounds: int,
    budget: float,
    counts: Sequence[int] = COUNTS,
) -> tuple[list[Row], list[str]]:
    """Time and judge both at several numbers of strips, and time the exact turn; give the rows, and what is said."""
    task = truth.task
    ways: Mapping[str, Callable[[int], tuple[Cycle, Flywheel | None]]] = {
        CHORDS: lambda count: by_chords(reduction, task, count),
        POINTS: lambda count: by_points(truth, count),
    }
    pairs = [(name, count) for name in ways for count in counts if not (name == POINTS and truth.wheel is None)]
    judged = [truth.errors(*ways[name](count)) for name, count in pairs]
    timed = [*(_run(ways[name], count) for name, count in pairs), exact]
    *times, whole = interleaved(timed, rounds, budget)
    made = [
        Row(name, count, count, errors, times=taken)
        for (name, count), errors, taken in zip(pairs, judged, times, strict=True)
    ]
    made.append(Row(EXACT, None, 0, Errors({DRIVING: truth.found.error}, DRIVING), times=whole))
    made += [Row(MEAN, count, count, truth.mean(count), note=_rough(truth)) for count in FEW]
    return made, [DEFINED, *_words(pairs, judged, truth)]


def _run(way: Callable[[int], object], count: int) -> Callable[[], object]:
    return lambda: way(count)


def _rough(truth: Truth) -> str:
    return ROUGH if truth.found.breaks.size else ""


def _words(pairs: Sequence[tuple[str, int]], judged: Sequence[Errors], truth: Truth) -> Iterator[str]:
    """Say the orders of the error, and how far the truth is known."""
    yield f"truth of a turn: moments and inertia to {max(truth.found.error, truth.found.noise):.1e} of their largest"
    for name in dict.fromkeys(name for name, _ in pairs):
        own = [(n, e.largest or 0.0) for (one, n), e in zip(pairs, judged, strict=True) if one == name]
        seen = [(n, error) for n, error in own if error > KNOWN]
        if len(seen) > 1:
            told = order([error for _, error in seen], [n for n, _ in seen])
            yield f"  {name}: order {told:.2f} from {seen[0][0]} to {seen[-1][0]} strips"
        else:
            yield f"  {name}: exact, at most {max(error for _, error in own):.1e} from rounding"
