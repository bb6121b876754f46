"""Harmonic analysis of a vector over a turn of the crank: by the fast transform of its samples (гармонический анализ).

F(phi) = sum of c_n e^(i n phi): the vectors c_n turn with the crank, the c_-n against it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np

from plans.model.balance.bank import EPS, ROUNDING, Harmonic
from plans.model.motion import Complexes, Floats

FEWEST, MOST = 256, 2**16  # samples of a turn: what orders up to 6 need at the least, and where doubling ends


def even(count: int) -> Floats:
    """Give crank angles rad that divide a turn evenly, from 0 on, the end left out."""
    return 2 * np.pi * np.arange(count) / count


def harmonics(vector: Callable[[Floats], Complexes], orders: Iterable[int], scale: float = 0.0) -> dict[int, Harmonic]:
    """Give harmonics of a vector of crank angles rad (N,): samples are doubled until the transform settles.

    `scale` is the size of what the vector is the sum of: where all but nothing is left of it, rounding counts by that.
    """
    told = sorted(set(orders))
    samples = vector(even(FEWEST))
    before, now = np.fft.fft(samples) / FEWEST, _finer(vector, samples)
    while not _settled(before, now, told, scale) and len(now[0]) < MOST:
        before, now = np.fft.fft(now[0]) / len(now[0]), _finer(vector, now[0])
    samples = now[0]
    row = np.fft.fft(samples) / len(samples)
    slack = ROUNDING * EPS * max(float(np.abs(samples).max()), scale)
    return {n: _harmonic(n, row, before, slack) for n in told}


def _finer(vector: Callable[[Floats], Complexes], samples: Complexes) -> tuple[Complexes, Complexes]:
    """Double the samples of a turn by those half way between them; give them, and their transform."""
    count = 2 * len(samples)
    finer = np.empty(count, dtype=np.complex128)
    finer[::2], finer[1::2] = samples, vector(even(count)[1::2])
    return finer, np.fft.fft(finer) / count


def _settled(before: Complexes, now: tuple[Complexes, Complexes], orders: Iterable[int], scale: float) -> bool:
    """Tell whether doubling moves the harmonics by rounding alone."""
    samples, row = now
    rounding = ROUNDING * EPS * max(float(np.abs(samples).max()), scale)
    return all(abs(row[n] - before[n]) <= rounding for order in orders for n in (order, -order))


def _harmonic(order: int, row: Complexes, before: Complexes, slack: float) -> Harmonic:
    moved = max(abs(row[n] - before[n]) for n in (order, -order))
    return Harmonic(order, complex(row[order]), complex(row[-order]), max(slack, float(moved)))
