"""A cam's law by graphical integration timed and judged: its error against the number of strips (законы движения)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from plans.bench.clock import interleaved
from plans.bench.convergence import order
from plans.bench.error import Errors
from plans.bench.result import Row
from plans.cam.diagrams import MIDDLE, THREE, TRUE, LawDiagrams, law_diagrams
from plans.model.cam import Cam

COUNTS = (8, 16, 64, 256, 1024)  # of strips of a phase that moves the follower
WAYS = {MIDDLE: "laws: mid ordinates", THREE: "laws: three ordinates", TRUE: "laws: true mean ordinates"}
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


def diagrams_of(cam: Cam, count: int, means: str) -> LawDiagrams:
    """Draw the diagrams of a law with so many strips a phase."""
    return law_diagrams(replace(cam, divisions=count), means)


def judged(cam: Cam, count: int, means: str = MIDDLE) -> Judged:
    """Judge the diagrams of a law by the exact one."""
    found = diagrams_of(cam, count, means)
    return Judged(found.slope_departure.share, found.travel_departure.share)


def rows(cam: Cam, rounds: int, budget: float, counts: Sequence[int] = COUNTS) -> tuple[list[Row], list[str]]:
    """Time and judge the diagrams of a law at several numbers of strips; give the rows, and the orders in words."""
    ways = [(means, count) for means in WAYS for count in counts]
    found = [judged(cam, count, means) for means, count in ways]
    times = interleaved([_run(cam, count, means) for means, count in ways], rounds, budget)
    made = [
        Row(WAYS[means], count, count, one.errors, times=taken)
        for (means, count), one, taken in zip(ways, found, times, strict=True)
    ]
    orders = (_orders(WAYS[means], found[k * len(counts) :][: len(counts)], counts) for k, means in enumerate(WAYS))
    return made, [DEFINED, *(line for lines in orders for line in lines)]


def _run(cam: Cam, count: int, means: str) -> Callable[[], LawDiagrams]:
    return lambda: diagrams_of(cam, count, means)


def _orders(way: str, found: Sequence[Judged], counts: Sequence[int]) -> Iterator[str]:
    for name, errors in ((SLOPE, [one.slope for one in found]), (TRAVEL, [one.travel for one in found])):
        if min(errors) <= EXACT:
            yield f"  {way}, {name}: from {errors[0]:.1e} to no more than rounding"
        else:
            yield f"  {way}, {name}: order {order(errors, counts):.2f} from {counts[0]} to {counts[-1]} strips"
