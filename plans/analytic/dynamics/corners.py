"""The crank's motion by the corners of a drawn loop alone, as the construction must find it (движение по петле)."""

from __future__ import annotations

import numpy as np

from plans.analytic.closure import EPS
from plans.analytic.dynamics.speeds import ROUNDINGS, ROUNDS
from plans.model.dynamics import ANALYSIS, Cycle, Flywheel, Speeds, Task, settled
from plans.model.motion import Floats


def with_flywheel_of_points(cycle: Cycle, slope: Floats, task: Task, wheel: Flywheel) -> Speeds | None:
    """Give the motion with a flywheel; one that is not needed is not there.

    `slope` (n + 1,) kg*m2 is the derivative of the reduced inertia at the edges.
    """
    if wheel.needed > 0.0:
        return _speeds(cycle, slope, wheel.whole, wheel.energy)
    return without_flywheel_of_points(cycle, slope, task)


def without_flywheel_of_points(cycle: Cycle, slope: Floats, task: Task) -> Speeds | None:
    """Give the motion of the machine as it is; None where it would stop."""
    inertia = float(cycle.inertia[0]) + task.present
    energy = energy_at(task.speed, cycle.surplus, inertia + cycle.varying)
    return None if energy is None else _speeds(cycle, slope, inertia, energy)


def energy_at(speed: float, surplus: Floats, masses: Floats) -> float | None:
    """Find the energy J at which the mean of the least and greatest speed is the one asked, by Newton's method.

    `surplus` J and `masses` kg*m2 are the surplus energy and the whole inertia at the edges; None where it would stop.
    """
    least, lightest = -float(surplus.min()), float(masses.min())
    if not lightest > 0.0 or _mean(surplus, masses, least)[0] > speed:
        return None
    energy = least + float(masses.max()) * speed**2 / 2.0 + float(np.ptp(surplus))
    for _ in range(ROUNDS):
        mean, growth = _mean(surplus, masses, energy)
        step = (speed - mean) / growth
        # The mean speed bends down over the energy: a step from below never leads beyond, one from above may be cut.
        energy = max(energy + step, (energy + least) / 2.0)
        if abs(step) <= ROUNDINGS * EPS * abs(energy):
            break
    return energy


def _mean(surplus: Floats, masses: Floats, energy: float) -> tuple[float, float]:
    """Give the mean of the least and the greatest speed, rad/s, and how it grows with the energy."""
    omega = np.sqrt(np.maximum(2.0 * (energy + surplus), 0.0) / masses)
    low, high = int(np.argmin(omega)), int(np.argmax(omega))
    speeds, ends = omega[[low, high]], masses[[low, high]]
    with np.errstate(divide="ignore"):
        return float(speeds.sum()) / 2.0, float((1.0 / (ends * speeds)).sum()) / 2.0


def _speeds(cycle: Cycle, slope: Floats, inertia: float, energy: float) -> Speeds:
    """Give speeds at the edges, and accelerations on either side of them: M = J epsilon + J' omega^2 / 2."""
    masses = inertia + cycle.varying
    omega = np.sqrt(2.0 * (energy + cycle.surplus) / masses)
    turning = omega**2 * slope / 2.0
    sides = [
        (cycle.driving + cycle.moments[:, k] - turning[side]) / masses[side]
        for k, side in enumerate((slice(None, -1), slice(1, None)))
    ]
    extremes = float(omega.min()), float(omega.max())
    growth = settled(np.stack(sides, axis=1), extremes[1] ** 2)
    return Speeds(ANALYSIS, cycle.turned, omega, growth, extremes, inertia, energy)
