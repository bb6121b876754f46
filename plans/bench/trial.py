"""A trial: what is ordered, the roads that are timed in turns, and what is found and said of them (испытание)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from geometry.errors import DraftError
from plans.bench.clock import interleaved
from plans.bench.error import Errors
from plans.bench.result import Ratio, Row
from plans.bench.truth import NotInstalled

BUDGET = 1.0  # seconds of a row, after which it is repeated no more: the whole stays within a minute
DRAWN = 360  # positions: more cannot be told apart on any sheet, and no sheet shows them
ACCEPTED = 1e-4  # of the plan's largest: the fifth digit, the last that a sheet's table prints
NOT_INSTALLED = "not installed: python -m pip install '.[bench]'"


@dataclass(frozen=True)
class Order:
    """What is asked of a session."""

    positions: tuple[int, ...]
    rounds: int
    startup: bool = True
    drawn: int = DRAWN  # of more positions no sheet is drawn
    accepted: float = ACCEPTED


class Found(NamedTuple):
    """What the trials of a technique have found, and the words that make it mean something."""

    rows: Sequence[Row]
    words: Sequence[str]
    ratios: Sequence[Ratio] = ()
    gaps: bool = False  # whether some position could not be assembled


@dataclass(frozen=True)
class Road:
    """A way to some numbers: what is run, for which number of positions, and how its result is judged.

    One run may be judged in several ways: a drawn sheet by its vectors and by its table.
    """

    run: Callable[[], Any]
    positions: int | None
    judged: Mapping[str, Callable[[Any], Errors | None]]  # by the name of the technique
    note: str = ""
    of: int | None = None  # positions of one run, where they are others


def timed(roads: Sequence[Road], rounds: int, budget: float = BUDGET) -> list[Row]:
    """Run every road once to judge what it gives, then time them in turns; a road that refuses says why."""
    judged = [_judged(road) for road in roads]
    runs = [road.run for road, found in zip(roads, judged, strict=True) if isinstance(found, dict)]
    times = iter(interleaved(runs, rounds, budget))
    rows: list[Row] = []
    for road, found in zip(roads, judged, strict=True):
        if isinstance(found, str):
            rows += [Row(name, road.positions, note=found) for name in road.judged]
        else:
            taken, of = next(times), (road.positions or 0) if road.of is None else road.of
            rows += [Row(name, road.positions, of, e, times=taken, note=road.note) for name, e in found.items()]
    return rows


def _judged(road: Road) -> dict[str, Errors | None] | str:
    try:
        result = road.run()  # the first run also fills caches and compiles: it is not timed
    except NotInstalled:
        raise
    except DraftError as error:
        return f"left out: {error}"
    return {name: judge(result) for name, judge in road.judged.items()}


def order(errors: Sequence[float], counts: Sequence[float]) -> float:
    """Give the order of a method: by which power of the count its error falls from the first to the last.

    >>> order([0.25, 0.0625], [2, 4])
    2.0
    """
    return math.log(errors[0] / errors[-1]) / math.log(counts[-1] / counts[0])


def orders(rows: Sequence[Row], name: str, unit: str, rounding: float = 0.0) -> Iterator[str]:
    """Say by which power of the number of positions each kind of error of a technique falls, where it does."""
    own = [(row.positions, row.errors.kinds) for row in rows if row.technique == name and row.positions and row.errors]
    counts = [count for count, _ in own]
    for kind in own[0][1]:
        errors = [kinds[kind] for _, kinds in own]
        which = f"  {name}, {kind}" if len(own[0][1]) > 1 else f"  {name}"
        if min(errors) > rounding:
            yield f"{which}: order {order(errors, counts):.2f} from {counts[0]} to {counts[-1]} {unit}"
        elif rounding:
            yield f"{which}: from {errors[0]:.1e} to no more than rounding"


def terms(wanted: Order, share: str = "of the largest of its kind") -> tuple[str, str]:
    """Say what is accepted and how it is timed."""
    return (
        f"accepted: an error of at most {wanted.accepted:.0e} {share}",
        f"time: wall time of one run, techniques in turns, {wanted.rounds} times each; a first run is not timed",
    )
