"""A quantity over the turn, to rounding: by harmonics where it is smooth, else on pieces (кривая по углу поворота)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

import numpy as np

from plans.analytic.closure import EPS
from plans.analytic.dynamics.pieces import pieces
from plans.analytic.dynamics.reduction import Reduction
from plans.analytic.dynamics.wave import ROUNDINGS, wave
from plans.model.dynamics import TURN
from plans.model.motion import Floats, Motion

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
