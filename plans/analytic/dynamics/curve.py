"""A quantity over the turn, to rounding: by harmonics where it is smooth, else on pieces (кривая по углу поворота)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from plans.analytic.closure import EPS
from plans.analytic.dynamics.pieces import pieces
from plans.analytic.dynamics.reduction import Reduction
from plans.model.dynamics import TURN
from plans.model.motion import Complexes, Floats, Motion

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


# A motion of N positions to several quantities there, (k, N), and to the largest of what each of them sums up, (k,).
Sample = Callable[[Motion], tuple[Floats, Floats]]

LEAST, MOST = 36, 1152  # ordinates of a turn


class Curve(Protocol):
    """A quantity that can be asked for at any angle turned, and for its integral from 0."""

    @property
    def looks(self) -> Floats:
        """Angles rad among which every change of sign shows."""

    @property
    def error(self) -> float:
        """Share of the largest by which it may be off."""

    @property
    def one(self) -> Callable[[float], float]:
        """The quantity at one angle turned rad, of any turn: for a solver that asks for one at a time."""

    def at(self, turned: Floats, side: int = 1, /) -> Floats:
        """Give it at angles turned rad, (N,): at a jump as it is beyond, or before it if side < 0."""

    @property
    def slope(self) -> Curve:
        """Its derivative by the angle turned."""

    def since(self, turned: Floats) -> Floats:
        """Give its integral from 0."""


def smooth(reduction: Reduction, sample: Sample, noise: float) -> list[Curve]:
    """Fit smooth quantities by harmonics, twice as many ordinates as long as the last of these are heard.

    Where they do not die away, because the quantities change too fast somewhere, they are fitted on pieces.
    """
    count = LEAST
    while count <= MOST:
        rows, sizes = sample(reduction.even(count))
        found = [wave(row, float(size)) for row, size in zip(rows, sizes, strict=True)]
        worst = max((one.error for one in found), default=0.0)
        if worst <= ROUNDINGS * EPS or (count == MOST and worst <= noise):
            return list(found)
        if not np.isfinite(worst):
            break
        count *= 2
    return broken(reduction, sample, np.zeros(0), noise)


def broken(reduction: Reduction, sample: Sample, breaks: Floats, noise: float) -> list[Curve]:
    """Fit quantities that jump or bend at `breaks`, rad."""
    knots = np.unique(np.concatenate(([0.0], breaks, [TURN])))
    return list(pieces(lambda turned: sample(reduction.motion(turned)), knots, noise))


def looks(curves: Sequence[Curve], *more: float) -> Floats:
    """Give the angles among which every change of sign of a combination of curves shows."""
    return np.unique(np.concatenate([np.array((0.0, *more, TURN)), *(one.looks for one in curves)]))
