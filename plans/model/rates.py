"""The rates of a drive: its angular velocity and acceleration, steady or of each position (закон вращения)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from plans.model.mechanism import Drive
from plans.model.motion import Floats

ROUNDINGS = 16.0 * 2.0**-52  # of a place that is a distance of two points: nearer to a corner of a law it is there


class Rates(NamedTuple):
    """Angular velocity rad/s and acceleration rad/s2 of the drive: numbers, or rows (N,) over the positions."""

    omega: Floats | float
    epsilon: Floats | float

    @property
    def vary(self) -> bool:
        """Whether they are told of each position by itself."""
        return np.ndim(self.omega) > 0

    def part(self, chosen: slice | Sequence[int] | npt.NDArray[np.int_]) -> Rates:
        """Give those of some of the positions, in the order asked for."""
        return Rates(*(np.asarray(rate)[chosen] for rate in self)) if self.vary else self

    def against(self, axes: int) -> Rates:
        """Give them so that they multiply rows (N, ...) with so many further axes."""
        return Rates(*(np.reshape(rate, (-1, *[1] * axes)) for rate in self)) if self.vary else self

    def at(self, position: int) -> tuple[float, float]:
        """Give omega and epsilon in one position."""
        omega, epsilon = (np.ravel(rate)[position if self.vary else 0] for rate in self)
        return float(omega), float(epsilon)

    @property
    def times(self) -> Floats | float:
        """The time between two even positions about each, in that about the first: what a mean over time weighs by."""
        return np.ravel(self.omega)[0] / self.omega if self.vary else 1.0


# The rates at crank angles rad (N,), any number of turns on. They keep the sense of rotation of the drive.
Pace: TypeAlias = Callable[[Floats], Rates]


def rates_at(pace: Pace, phi: Floats) -> Rates:
    """Give the rates at crank angles rad (N,) as rows (N,)."""
    return Rates(*(np.broadcast_to(np.asarray(rate, dtype=np.float64), phi.shape) for rate in pace(phi)))


def steady(drive: Drive) -> Rates:
    """Give the rates of a drive that has those of its scene in every position."""
    return Rates(drive.omega, drive.epsilon)


def stroke_rates(drive: Drive, ways: Floats, speed: float, acceleration: float) -> tuple[Floats, Floats]:
    """Give speed m/s and acceleration m/s2 of a stroke at places m, (N,) each: those told, or those of the drive's law.

    The law has straight lines of v over s between its places, so that a = v dv/ds; from rest, and to it, one
    acceleration and v = sqrt(2 a s), for along a straight line it would take for ever. At a place itself the piece
    ahead of it counts, at the end the last.
    """
    if not drive.law:
        return np.full(ways.shape, speed), np.full(ways.shape, acceleration)
    places, speeds = np.array(drive.law).T
    fine = ROUNDINGS * np.abs(places).max()
    corner = places[np.abs(ways[..., None] - places).argmin(axis=-1)]
    ways = np.where(np.abs(ways - corner) <= fine, corner, ways)  # the root would make much of a rounding
    ahead = ways + np.sign(speeds.sum()) * fine
    part = np.clip(np.searchsorted(places, ahead) - 1, 0, len(places) - 2)
    low, high, length = speeds[part], speeds[part + 1], np.diff(places)[part]
    share = np.clip((ways - places[part]) / length, 0.0, 1.0)
    resting = low * high == 0.0
    even = np.sign(low + high) * np.sqrt(low**2 + (high**2 - low**2) * share)
    v = np.where(resting, even, np.interp(ways, places, speeds))
    return v, np.where(resting, (high**2 - low**2) / (2 * length), v * (high - low) / length)
