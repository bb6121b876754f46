"""The flywheel of a scene's machine timed and judged: chords over strips, and the exact turn over ordinates (маховик).

The truth is the exact turn's flywheel: spectral between jumps, its extremes by roots. The analysis from so many even
ordinates alone shows what a smooth load allows.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from plans.analytic.dynamics.cycle import sampled_cycle
from plans.analytic.dynamics.exact import Exact
from plans.analytic.dynamics.flywheel import flywheel, flywheel_of_points
from plans.bench import convergence
from plans.bench.clock import Times, interleaved
from plans.bench.error import Errors
from plans.bench.result import Row
from plans.dynamics.cycle import Turn
from plans.dynamics.loop import loop
from plans.dynamics.study import DynamicsStudy
from plans.model.dynamics import Task

COUNTS = (12, 24, 96, 384, 1024, 4096)  # of strips
CHORDS, SAMPLED, EXACT = "construction: chords, loop", "analysis: the same strips", "analysis: exact turn"
WHOLE = "J_0"
DEFINED = (
    "error of the flywheel: the difference of J_0 from that of the exact turn, in shares of it; positions are the "
    "strips of a turn, beside which an edge stands on every jump"
)


class Judged(NamedTuple):
    """The flywheel of some strips: their number, and how far J_0 is off, in shares of it."""

    strips: int
    error: float


def chords(study: DynamicsStudy, count: int) -> float:
    """Draw works and loop over so many strips; give J_0, kg*m2."""
    return loop(Turn(study.reduction, count).works.cycle, study.task).flywheel.whole


def judged(study: DynamicsStudy, exact: Exact, counts: Sequence[int] = COUNTS) -> list[Judged]:
    """Judge the flywheel by chords against the exact turn's."""
    true = flywheel(exact, study.task).whole
    return [Judged(count, abs(chords(study, count) / true - 1)) for count in counts]


def order(found: Sequence[Judged]) -> float:
    """Give the order of the method: by which power of the strips the error falls from the first to the last.

    >>> order([Judged(12, 0.04), Judged(24, 0.01)])
    2.0
    """
    first, last = found[0], found[-1]
    return convergence.order([first.error, last.error], [first.strips, last.strips])


def rows(
    study: DynamicsStudy, exact: Callable[[], Exact], rounds: int, budget: float, counts: Sequence[int] = COUNTS
) -> tuple[list[Row], list[str]]:
    """Time and judge the flywheel by both roads; give the rows, and the order in words."""
    turn, task = exact(), study.task
    found = judged(study, turn, counts)
    runs = [*(_drawn(study, count) for count in counts), *(_sampled(study, turn, task, count) for count in counts)]
    times = interleaved([*runs, lambda: flywheel(exact(), task)], rounds, budget)
    pairs = zip([*found, *found], times, strict=False)
    made = [_row(CHORDS if k < len(counts) else SAMPLED, one, taken) for k, (one, taken) in enumerate(pairs)]
    made.append(Row(EXACT, None, 0, Errors({WHOLE: turn.error}, WHOLE), times=times[-1]))
    return made, [DEFINED, f"  {CHORDS}: order {order(found):.2f} from {counts[0]} to {counts[-1]} strips"]


def _row(name: str, one: Judged, taken: Times) -> Row:
    return Row(name, one.strips, one.strips, Errors({WHOLE: one.error}, WHOLE), times=taken)


def _drawn(study: DynamicsStudy, count: int) -> Callable[[], float]:
    return lambda: chords(study, count)


def _sampled(study: DynamicsStudy, turn: Exact, task: Task, count: int) -> Callable[[], float]:
    edges = Turn(study.reduction, count).edges
    return lambda: flywheel_of_points(sampled_cycle(turn, edges), task).whole
