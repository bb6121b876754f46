"""The crank's motion over a steady turn, from its energy alone (закон движения главного вала; M4.8, M4.12)."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from plans.analytic.closure import EPS
from plans.analytic.dynamics.flywheel import Exact
from plans.model.dynamics import ANALYSIS, Cycle, Flywheel, Speeds, Task, settled
from plans.model.motion import Floats

ROUNDS = 64  # halvings alone make all digits of an energy
ROUNDINGS = 8.0  # of an energy: a step of so much is none


class Stall(NamedTuple):
    """No energy at position 0 keeps the crank turning at the mean speed asked for (останов).

    At `turned` rad the loads have used up the most of it. Even where they leave none there, the mean speed is `mean`
    rad/s: only a machine that runs faster than this on the average gets past. NaN: there is no inertia at all.
    """

    turned: float
    mean: float


class Swing(NamedTuple):
    """The motion of a machine with inertia kg*m2 and energy J at position 0."""

    found: Exact
    inertia: float
    energy: float

    def omega(self, turned: Floats) -> Floats:
        """Give the angular velocity of the crank, rad/s, at angles turned (N,): T = J omega^2 / 2."""
        kinetic = self.energy + self.found.surplus(turned)
        with np.errstate(divide="ignore", invalid="ignore"):  # where the links have no inertia, no speed is too high
            square = 2.0 * kinetic / (self.inertia + self.found.varying(turned))
        return np.asarray(np.sqrt(np.maximum(square, 0.0)))

    def epsilon(self, turned: Floats, side: int = 1) -> Floats:
        """Give its angular acceleration, rad/s2: M = J epsilon + J' omega^2 / 2; at a jump as it is on that side."""
        inertia = self.inertia + self.found.varying(turned)
        moment = self.found.driving + self.found.moment(turned, side)
        return np.asarray((moment - self.omega(turned) ** 2 * self.found.slope(turned) / 2.0) / inertia)

    def extremes(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Give where the crank is slowest and fastest, rad, and the speeds there, rad/s."""
        at = self.found.turns(self.epsilon)
        speeds = self.omega(at)
        low, high = int(np.argmin(speeds)), int(np.argmax(speeds))
        return (float(at[low]), float(at[high])), (float(speeds[low]), float(speeds[high]))

    def speeds(self, turned: Floats) -> Speeds:
        """Tell it on strips with edges `turned`, (n + 1,) rad."""
        sides = self.epsilon(turned[:-1], 1), self.epsilon(turned[1:], -1)
        omega, extremes = self.omega(turned), self.extremes()[1]
        epsilon = settled(np.stack(sides, axis=1), extremes[1] ** 2)
        return Speeds(ANALYSIS, turned, omega, epsilon, extremes, self.inertia, self.energy)


def with_flywheel(found: Exact, task: Task, wheel: Flywheel) -> Swing | Stall:
    """Give the motion with a flywheel; one that is not needed is not there."""
    return Swing(found, wheel.whole, wheel.energy) if wheel.needed > 0.0 else without_flywheel(found, task)


def without_flywheel(found: Exact, task: Task) -> Swing | Stall:
    """Give the motion of the machine as it is."""
    return steady(found, found.own + task.present, task.speed)


def steady(found: Exact, inertia: float, speed: float) -> Swing | Stall:
    """Give the motion with an inertia kg*m2 at position 0 at which the mean of least and greatest speed is `speed`."""
    emptiest = found.turns(lambda turned, side: found.driving + found.moment(turned, side))
    left = found.surplus(emptiest)
    stopped = Swing(found, inertia, -float(left.min()))
    places = np.append(emptiest, found.load.looks)
    if not (inertia + found.varying(places)).min() > 0.0:
        return Stall(float(emptiest[np.argmin(left)]), np.nan)
    mean = sum(stopped.extremes()[1]) / 2.0
    if mean >= speed:
        return Stall(float(emptiest[np.argmin(left)]), mean)
    return _balanced(stopped, speed, float(np.ptp(left)))


def _balanced(stopped: Swing, speed: float, height: float) -> Swing:
    """Find the energy at which the mean speed is the one asked for, by Newton's method between bounds that close in."""
    found, inertia, least = stopped.found, stopped.inertia, stopped.energy
    heaviest = inertia + float(found.varying(found.mass.looks).max())
    low, high = least, least + height + 2.0 * heaviest * speed**2  # all inertias would turn twice too fast
    energy = least + heaviest * speed**2 / 2.0
    for _ in range(ROUNDS):
        swing = Swing(found, inertia, energy)
        at, speeds = swing.extremes()
        miss = sum(speeds) / 2.0 - speed
        low, high = (low, energy) if miss > 0.0 else (energy, high)
        inertias = inertia + found.varying(np.array(at))
        growth = float((1.0 / (inertias * np.maximum(speeds, EPS * speed))).sum()) / 2.0
        step = -miss / growth
        if abs(step) <= ROUNDINGS * EPS * (energy - least + height):
            break
        energy = energy + step if low < energy + step < high else (low + high) / 2.0
    return swing


def with_flywheel_of_points(cycle: Cycle, slope: Floats, task: Task, wheel: Flywheel) -> Speeds | None:
    """Give the motion with a flywheel; one that is not needed is not there.

    `slope` (n + 1,) kg*m2 is the derivative of the reduced inertia at the edges.
    """
    if wheel.needed > 0.0:
        found = _speeds(cycle, slope, wheel.whole, wheel.energy)
        speeds = *found.extremes, *(touch.omega(wheel.whole, wheel.energy) for touch in wheel.touches)
        return replace(found, extremes=(min(speeds), max(speeds)))
    return without_flywheel_of_points(cycle, slope, task)


def without_flywheel_of_points(cycle: Cycle, slope: Floats, task: Task) -> Speeds | None:
    """Give the motion of the machine as it is; None where it would stop."""
    inertia = cycle.own + task.present
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
