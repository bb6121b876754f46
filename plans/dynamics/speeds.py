"""The crank's motion with the flywheel that was found (закон движения главного вала, M4.8, M4.12, figure 6.7)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from geometry.board import Board
from geometry.calculus import Derivative, derivative_by_chords
from plans.model.dynamics import CONSTRUCTION, Cycle, Speeds
from plans.model.motion import Floats

SPEEDS = "speeds"
ROUNDS = 60  # of halving an interval: more than a double has digits


@dataclass(frozen=True)
class SpeedCurve:
    """Angular velocity over the turn, and its derivative by chords with the pole distance."""

    speeds: Speeds
    derivative: Derivative

    @property
    def board(self) -> Board:
        """The board that it is drawn on."""
        return self.derivative.board


def speed_curve(cycle: Cycle, inertia: float, energy: float) -> SpeedCurve:
    """Read the speed off the energy-mass diagram, whose rays have the slope omega2/2, and its slope by chords.

    `inertia` kg*m2 and `energy` J are those of the whole machine at position 0.
    """
    omega = omegas(cycle, inertia, energy)
    board = Board(SPEEDS)
    derivative = derivative_by_chords(board, "ω", cycle.turned, omega, breaks=_corners(cycle))
    middle = (omega[:-1] + omega[1:]) / 2
    extremes = float(omega.min()), float(omega.max())
    speeds = Speeds(CONSTRUCTION, cycle.turned, omega, middle * derivative.values, extremes, inertia, energy)
    return SpeedCurve(speeds, derivative)


def omegas(cycle: Cycle, inertia: float, energy: float) -> Floats:
    """Give the angular velocity at the edges of the strips, rad/s (6.12); NaN where the machine has no energy left."""
    ratio = 2 * (energy + cycle.surplus) / (inertia + cycle.varying)
    with np.errstate(invalid="ignore"):
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


def _corners(cycle: Cycle) -> Floats:
    """Give the breaks that are edges inside the turn."""
    inside = cycle.breaks[(cycle.breaks > cycle.turned[0]) & (cycle.breaks < cycle.turned[-1])]
    return np.asarray(inside[np.isin(inside, cycle.turned)])
