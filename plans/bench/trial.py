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
from plans.bench.error import Errors
from plans.bench.truth import NotInstalled

BUDGET = 1.0  # seconds of a row, after which it is repeated no more: the whole stays within a minute
DRAWN = 360  # positions: more cannot be told apart on any sheet, and no sheet shows them
ACCEPTED = 1e-4  # of the plan's largest: the fifth digit, the last that a sheet's table prints
NOT_INSTALLED = "not installed: python -m pip install '.[bench]'"
LEAST_ROUNDS = 2  # the fewest that show whether a time can be trusted


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
        return Times(tuple(own / theirs for own, theirs in zip(self.seconds, other.seconds, strict=False)))


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


@dataclass(frozen=True)
class Row:
    """A technique at a number of positions: its error and its time; a row without either says why in its note.

    `of` is the number of positions for which one run is. `often` is the error that 95 of 100 chance drawings keep
    under, where there is chance.
    """

    technique: str
    positions: int | None  # None: the same whatever the number of positions
    of: int = 0
    errors: Errors | None = None
    often: float | None = None
    times: Times | None = None
    note: str = ""

    @property
    def error(self) -> float | None:
        """The largest error, None where nothing was measured."""
        return self.errors.largest if self.errors else None

    @property
    def each(self) -> float | None:
        """The median time for one position, seconds."""
        return self.times.median / self.of if self.times and self.of else None


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
    told = Path("/proc/cpuinfo").read_text("utf-8", errors="replace") if Path("/proc/cpuinfo").is_file() else ""
    models = [line.partition(":")[2] for line in told.splitlines() if line.startswith("model name")]
    return " ".join(models[0].split()) if models else platform.processor() or platform.machine()


@dataclass(frozen=True)
class Bench:
    """All that a bench reports of a scene."""

    title: str
    machine: Computer
    rows: tuple[Row, ...]
    ratios: tuple[Ratio, ...]
    words: tuple[str, ...]  # definitions, acceptance, repetitions, what was left out
    accepted: float  # the largest error that is accepted
    gaps: bool = False  # whether some position could not be assembled


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
