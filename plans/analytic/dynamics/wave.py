"""A quantity that repeats every turn as a sum of harmonics, by even ordinates over the turn (ряд Фурье).

The mean of even ordinates is the trapezoid rule, which of a smooth periodic quantity is exact but for the harmonics
that the ordinates are too few to show.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plans.analytic.closure import EPS
from plans.model.dynamics import TURN
from plans.model.motion import Complexes, Floats

ROUNDINGS = 4.0  # of the largest ordinate: what summing harmonics leaves
LOOKS = 4  # places to a harmonic, among which no zero of the sum lies hidden


@dataclass(frozen=True)
class Wave:
    """Mean and harmonics (m,) of a quantity; `error` is the share of the largest that the highest of them still has."""

    mean: float
    harmonics: Complexes
    error: float

    @property
    def looks(self) -> Floats:
        """Angles rad among which every change of sign shows."""
        return np.linspace(0.0, TURN, max(LOOKS * len(self.harmonics), 16) + 1)

    def at(self, turned: Floats, _side: int = 1) -> Floats:
        """Give the quantity at angles turned rad, (N,); both sides are alike."""
        return self.mean + _sum(self.harmonics, turned)

    @property
    def slope(self) -> Wave:
        """Its derivative by the angle turned."""
        return Wave(0.0, 1j * np.arange(1, len(self.harmonics) + 1) * self.harmonics, self.error)

    @cached_property
    def one(self) -> Callable[[float], float]:
        """The quantity at one angle turned rad: for a solver that asks for one at a time (Horner's rule in e^(i q))."""
        mean, harmonics = self.mean, self.harmonics[::-1].tolist()

        def value(turned: float) -> float:
            step, total = complex(math.cos(turned), math.sin(turned)), 0j
            for harmonic in harmonics:
                total = (total + harmonic) * step
            return mean + 2.0 * total.real

        return value

    def since(self, turned: Floats) -> Floats:
        """Give its integral from 0."""
        orders = np.arange(1, len(self.harmonics) + 1)
        waves = self.harmonics / (1j * orders)
        return self.mean * turned + _sum(waves, turned) - 2.0 * float(waves.real.sum())


def wave(ordinates: Floats, size: float) -> Wave:
    """Find the harmonics of even ordinates over a turn, (N,), the first at 0; `size`: largest of what they sum up."""
    count = len(ordinates)
    if not np.isfinite(ordinates).all():
        return Wave(np.nan, np.zeros(0, complex), np.inf)
    found = np.fft.rfft(ordinates) / count
    inner = found[1 : (count + 1) // 2]
    error = float(np.abs(inner[-(count // 6) :]).max()) / size if size else 0.0
    heard = np.flatnonzero(np.abs(inner) > EPS * size / ROUNDINGS)
    return Wave(float(found[0].real), inner[: heard[-1] + 1 if heard.size else 0], error)


def _sum(harmonics: Complexes, turned: Floats) -> Floats:
    """Add harmonics 1, 2, ... at angles turned (Horner's rule in e^(i q))."""
    step, total = np.exp(1j * np.asarray(turned)), np.zeros(np.shape(turned), complex)
    for harmonic in harmonics[::-1]:
        total += harmonic
        total *= step
    return np.asarray(2.0 * total.real)
