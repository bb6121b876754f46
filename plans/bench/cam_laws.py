"""A cam's law by graphical integration timed and judged: its error against the number of strips (законы движения)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from plans.bench.clock import interleaved
from plans.bench.error import Errors
from plans.bench.result import Row
from plans.cam.diagrams import LawDiagrams, law_diagrams
from plans.model.cam import Cam

COUNTS = (8, 16, 64, 256, 1024)  # of strips of a phase that moves the follower
MIDDLE, TRUE = "laws: mid ordinates", "laws: true mean ordinates"
SLOPE, TRAVEL = "S'", "S"
EXACT = 1e-12  # shares: what is less is the rounding of the steps, and has no order
DEFINED = (
    "graphical laws: the largest differences of S' and S from the exact ones at the strips' edges, in shares of the "
    "largest of each; positions are the strips of one phase; a dwell is one strip, an edge stands on a corner of S''"
)


class Judged(NamedTuple):
    """The diagrams of some strips: how far S' and S are off, in shares."""

    slope: float
    travel: float

    @property
    def errors(self) -> Errors:
        """The errors, the worse one named."""
        return Errors({SLOPE: self.slope, TRAVEL: self.travel}, SLOPE if self.slope >= self.travel else TRAVEL)


def diagrams_of(cam: Cam, count: int, true_means: bool) -> LawDiagrams:
    """Draw the diagrams of a law with so many strips a phase."""
    return law_diagrams(replace(cam, divisions=count), true_means)


def judged(cam: Cam, count: int, true_means: bool = False) -> Judged:
    """Judge the diagrams of a law by the exact one."""
    found = diagrams_of(cam, count, true_means)
    return Judged(found.slope_departure.share, found.travel_departure.share)


def order(errors: Sequence[float], counts: Sequence[int]) -> float:
    """Give the order of a method: by which power of the strips its error falls from the first to the last.

    >>> order([0.25, 0.0625], [2, 4])
    2.0
    """
    return math.log(errors[0] / errors[-1]) / math.log(counts[-1] / counts[0])


def rows(cam: Cam, rounds: int, budget: float, counts: Sequence[int] = COUNTS) -> tuple[list[Row], list[str]]:
    """Time and judge the diagrams of a law at several numbers of strips; give the rows, and the orders in words."""
    ways = [(name, true, count) for name, true in ((MIDDLE, False), (TRUE, True)) for count in counts]
    found = [judged(cam, count, true) for _, true, count in ways]
    times = interleaved([_run(cam, count, true) for _, true, count in ways], rounds, budget)
    made = [
        Row(name, count, count, one.errors, times=taken)
        for (name, _, count), one, taken in zip(ways, found, times, strict=True)
    ]
    return made, [DEFINED, *_orders(found[: len(counts)], counts)]


def _run(cam: Cam, count: int, true: bool) -> Callable[[], LawDiagrams]:
    return lambda: diagrams_of(cam, count, true)


def _orders(found: Sequence[Judged], counts: Sequence[int]) -> Iterator[str]:
    for name, errors in ((SLOPE, [one.slope for one in found]), (TRAVEL, [one.travel for one in found])):
        if min(errors) <= EXACT:
            yield f"  {MIDDLE}, {name}: exact, at most {max(errors):.1e} from rounding"
        else:
            yield f"  {MIDDLE}, {name}: order {order(errors, counts):.2f} from {counts[0]} to {counts[-1]} strips"
