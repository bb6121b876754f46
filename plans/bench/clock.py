"""The clock: runs timed in turns, so that what disturbs the machine disturbs all of them alike (хронометраж)."""

from __future__ import annotations

import gc
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from time import perf_counter
from typing import Any

import numpy as np

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
