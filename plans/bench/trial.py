"""A trial: runs timed in turns, what is ordered, the roads, and what is found and said of them (испытание)."""

from __future__ import annotations

import gc
import math
import os
import platform
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from time import perf_counter
from typing import Any, NamedTuple

import numpy as np

from geometry.errors import DraftError
from geometry.meet import EPS

BUDGET = 1.0  # seconds of a row, after which it is repeated no more: the whole stays within a minute
DRAWN = 360  # positions: more cannot be told apart on any sheet, and no sheet shows them
ACCEPTED = 1e-4  # of the plan's largest: the fifth digit, the last that a sheet's table prints
NOT_INSTALLED = "not installed: python -m pip install '.[bench]'"
LEAST_ROUNDS = 2  # the fewest that show whether a time can be trusted
LONG = 5.0  # seconds of a first run, after which there is no other


@dataclass(frozen=True)
class Times:
    """Wall times of the repetitions of one run, seconds, in the order of the rounds.

    >>> times = Times((4.0, 1.0, 2.0, 3.0, 5.0))
    >>> times.median, times.quartiles, times.least
    (3.0, (2.0, 4.0), 1.0)
    """

    seconds: tuple[float, ...]

    @cached_property
    def median(self) -> float:
        """The median."""
        return float(np.median(self.seconds))

    @cached_property
    def quartiles(self) -> tuple[float, float]:
        """The quartiles: half of the repetitions lie between them."""
        low, high = np.quantile(self.seconds, (0.25, 0.75))
        return float(low), float(high)

    @property
    def least(self) -> float:
        """The shortest: the least disturbed."""
        return min(self.seconds)

    def over(self, other: Times) -> Times:
        """Give the ratios of this run's times to another's, round by round: both of a round met the same machine.

        >>> Times((4.0, 6.0, 9.0)).over(Times((2.0, 2.0))).seconds
        (2.0, 3.0)
        """
        return Times(tuple(ours / theirs for ours, theirs in zip(self.seconds, other.seconds, strict=False)))


def interleaved(runs: Sequence[Callable[[], Any]], rounds: int, budget: float) -> list[Times]:
    """Time runs in turns, A B C A B C, each at most `rounds` times.

    A run that has taken `budget` seconds leaves after LEAST_ROUNDS, or after all the rounds if they are fewer.
    """
    seconds: list[list[float]] = [[] for _ in runs]
    for number in range(rounds):
        for run, taken in zip(runs, seconds, strict=True):
            if len(taken) == number and (number < LEAST_ROUNDS or sum(taken) < budget):
                taken.append(_timed(run))
    return [Times(tuple(taken)) for taken in seconds]


def _timed(run: Callable[[], Any]) -> float:
    """Time a run, and keep the collector of garbage away that would otherwise strike at random."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        start = perf_counter()
        run()
        return perf_counter() - start
    finally:
        if enabled:
            gc.enable()


class Errors(NamedTuple):
    """The errors of a technique over its quantities, each in shares of the largest of its plan."""

    worst: float
    typical: float  # the median of the quantities' own largest
    name: str = ""  # the quantity that is worst

    @classmethod
    def alone(cls, share: float) -> Errors:
        """Judge what has one error alone."""
        return cls(share, share)

    @property
    def roundings(self) -> float:
        """The worst in roundings of float64."""
        return self.worst / EPS

    @classmethod
    def of(cls, shares: Mapping[str, float]) -> Errors | None:
        """Judge quantities by their largest errors; none where there are none.

        >>> Errors.of({"v_A": 1e-3, "v_B": 4e-3, "v_C": 2e-3})
        Errors(worst=0.004, typical=0.002, name='v_B')
        """
        if not shares:
            return None
        return cls(max(shares.values()), float(np.median([*shares.values()])), max(shares, key=shares.__getitem__))


@dataclass(frozen=True)
class Timed:
    """A technique at a number of positions: its errors and its time; a row without either says why in its note."""

    technique: str
    positions: int | None  # None: the same whatever the number of positions
    errors: Errors | None = None
    times: Times | None = None
    note: str = ""
    of: int | None = None  # positions for which one run is, where they are others

    @property
    def each(self) -> float | None:
        """The median time for one position, seconds; of what has no positions that of the run."""
        return self.times.median / (self.of or self.positions or 1) if self.times else None


@dataclass(frozen=True)
class Goal:
    """A ratio that should be reached: at least or at most its bound."""

    bound: float
    least: bool = True

    def reached(self, ratio: float) -> bool:
        """Tell whether a ratio reaches the goal.

        >>> Goal(8).reached(7.9), Goal(0.5, least=False).reached(0.4)
        (False, True)
        """
        return ratio >= self.bound if self.least else ratio <= self.bound


@dataclass(frozen=True)
class Ratio:
    """How many times as long one thing takes as another, measured side by side; without times, why not."""

    name: str
    positions: int | None
    first: Times | None = None
    second: Times | None = None
    goal: Goal | None = None
    note: str = ""

    @property
    def times(self) -> Times | None:
        """The ratios round by round."""
        return self.first.over(self.second) if self.first and self.second else None

    @property
    def reached(self) -> bool | None:
        """Whether the median ratio reaches the goal; None where there is none, or nothing was measured."""
        ratios = self.times
        return self.goal.reached(ratios.median) if self.goal and ratios else None


@dataclass(frozen=True)
class Computer:
    """The machine: processor, cores that this process may use, load of the last minute, versions."""

    processor: str
    cores: int
    load: float | None  # mean number of busy processes; None where the system does not tell
    system: str
    python: str
    numpy: str

    def written(self) -> str:
        """Write the machine in one line."""
        busy = "" if self.load is None else f", load {self.load:.1f} at the start"
        cores = f"{self.cores} core{'' if self.cores == 1 else 's'}"
        return f"{self.processor}, {cores}{busy}; {self.system}; Python {self.python}, numpy {self.numpy}"


def machine() -> Computer:
    """Describe this machine."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else None
    system = f"{platform.system()} {platform.machine()}"
    return Computer(_processor(), cores, load, system, platform.python_version(), np.__version__)


def _processor() -> str:
    """Name the processor as Linux tells it; elsewhere the platform's own name must do."""
    text = Path("/proc/cpuinfo").read_text("utf-8", errors="replace") if Path("/proc/cpuinfo").is_file() else ""
    models = [line.partition(":")[2] for line in text.splitlines() if line.startswith("model name")]
    return " ".join(models[0].split()) if models else platform.processor() or platform.machine()


@dataclass(frozen=True)
class Bench:
    """All that a bench reports of a scene."""

    title: str
    machine: Computer
    rows: tuple[Timed, ...]
    ratios: tuple[Ratio, ...]
    words: tuple[str, ...]  # definitions, acceptance, repetitions, what was left out
    accepted: float  # the largest error that is accepted
    gaps: bool = False  # whether some position could not be assembled


@dataclass(frozen=True)
class Demand:
    """What is asked of a session."""

    positions: tuple[int, ...]
    rounds: int
    startup: bool = True
    drawn: int = DRAWN  # of more positions no sheet is drawn
    accepted: float = ACCEPTED


@dataclass(frozen=True)
class Timing:
    """A way to some numbers: what is run, for how many positions, and how its result is judged, by what names.

    One run may be judged in several ways: a drawn sheet by its ink and by its numbers.
    """

    run: Callable[[], Any]
    positions: int | None
    judged: Mapping[str, Callable[[Any], Errors | None]]  # by the name of the technique
    note: str = ""
    of: int | None = None


def timed(roads: Sequence[Timing], rounds: int, budget: float = BUDGET) -> list[Timed]:
    """Run every road once to judge what it gives, then time them in turns; a road that refuses says why.

    One whose first run takes longer than LONG is run no more: that is its time.
    """
    firsts = [_judged(road) for road in roads]
    again = [road.run for road, (found, took) in zip(roads, firsts, strict=True) if took <= LONG]
    times = iter(interleaved(again, rounds, budget))
    rows: list[Timed] = []
    for road, (found, took) in zip(roads, firsts, strict=True):
        if isinstance(found, str):
            rows += [Timed(name, road.positions, note=found) for name in road.judged]
        else:
            taken = next(times) if took <= LONG else Times((took,))
            rows += [Timed(name, road.positions, errors, taken, road.note, road.of) for name, errors in found.items()]
    return rows


def _judged(road: Timing) -> tuple[dict[str, Errors | None] | str, float]:
    """Judge a first run, which also fills caches and compiles; give the time it took, for ever where it refused."""
    start = perf_counter()
    try:
        result = road.run()
        took = perf_counter() - start
        return {name: judge(result) for name, judge in road.judged.items()}, took
    except DraftError as error:
        return f"left out: {error}", math.inf


def order(errors: Sequence[float], counts: Sequence[float]) -> float:
    """Give the order of a method: by which power of the count its error falls from the first to the last.

    >>> order([0.25, 0.0625], [2, 4])
    2.0
    """
    return math.log(errors[0] / errors[-1]) / math.log(counts[-1] / counts[0])


def orders(rows: Sequence[Timed], least: float = 1e-12) -> Iterator[str]:
    """Say by which power of the number of positions the error of each technique falls, where it does.

    What is `least` or under is rounding, and has no order.
    """
    for name in dict.fromkeys(row.technique for row in rows):
        measured = [(row.positions, row.errors.worst) for row in rows if row.technique == name and row.errors]
        there = [(count, error) for count, error in measured if count and error > least]
        counts, errors = [count for count, _ in there], [error for _, error in there]
        if len(set(counts)) > 1:
            yield f"  {name}: order {order(errors, counts):.2f} from {counts[0]} to {counts[-1]}"
