"""What a bench has found: rows of error and time, and ratios of times with the goals set for them (итоги)."""

from __future__ import annotations

import os
import platform
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from plans.bench.clock import Times
from plans.bench.error import Errors


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
