"""The crank's motion with the flywheel that was found (закон движения главного вала, M4.8, M4.12, figure 6.7)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from geometry.board import Board
from geometry.calculus import Derivative, derivative_by_tangents
from plans.model.dynamics import CONSTRUCTION, Cycle, Speeds, settled
from plans.model.motion import Floats
from plans.words.calculus import REASONS

SPEEDS = "speeds"
ROUNDS = 60  # of halving an interval: more than a double has digits


@dataclass(frozen=True)
class SpeedCurve:
    """Angular velocity over the turn, and its derivative by tangents with the pole distance."""

    speeds: Speeds
    derivative: Derivative

    @property
    def board(self) -> Board:
        """The board that it is drawn on."""
        return self.derivative.board


def speed_curve(cycle: Cycle, slope: Floats, inertia: float, energy: float) -> SpeedCurve:
    """Read the speed off the energy-mass diagram, whose rays have the slope omega2/2, and its slope by tangents.

    A tangent at either side of each edge has the slope epsilon/omega, with J epsilon = M - omega2 J'/2: `slope`
    (n + 1,) is J', kg*m2. `inertia` kg*m2 and `energy` J are those of the whole machine at position 0.
    """
    omega = omegas(cycle, inertia, energy)
    both = np.stack([omega[:-1], omega[1:]], axis=1)
    inertias, slopes = (np.stack([row[:-1], row[1:]], axis=1) for row in (inertia + cycle.varying, slope))
    tangents = (cycle.driving + cycle.moments - both**2 * slopes / 2) / (inertias * both)
    places = np.stack([cycle.turned[:-1], cycle.turned[1:]], axis=1)
    x, y, steep = (row.ravel() for row in (places, both, tangents))
    derivative = derivative_by_tangents(Board(SPEEDS), "ω", x, y, steep, why=REASONS)
    extremes = float(omega.min()), float(omega.max())
    growth = settled(both * derivative.values.reshape(-1, 2), extremes[1] ** 2)
    speeds = Speeds(CONSTRUCTION, cycle.turned, omega, growth, extremes, inertia, energy)
    return SpeedCurve(speeds, derivative)


def omegas(cycle: Cycle, inertia: float, energy: float) -> Floats:
    """Give the angular velocity at the edges of the strips, rad/s (6.12); NaN where the machine has no energy left."""
    ratio = 2 * (energy + cycle.surplus) / (inertia + cycle.varying)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(np.sqrt(ratio))


def natural(cycle: Cycle, inertia: float, speed: float) -> float | None:
    """Give the energy J at position 0 with which the machine keeps its mean speed; None where it would stop.

    The mean of the least and the greatest speed grows with that energy.
    """
    least = float(np.max(-cycle.surplus))
    high = least + float(np.ptp(cycle.surplus)) + speed**2 * (inertia + float(np.max(cycle.varying)))
    if _mean(cycle, inertia, least) > speed:
        return None
    low = least
    for _ in range(ROUNDS):
        middle = (low + high) / 2
        low, high = (middle, high) if _mean(cycle, inertia, middle) < speed else (low, middle)
    return (low + high) / 2


def _mean(cycle: Cycle, inertia: float, energy: float) -> float:
    omega = omegas(cycle, inertia, energy)
    return float(np.nanmin(omega) + np.nanmax(omega)) / 2
