"""The flywheel of a steady turn by extremes of energy, by other classical methods; its rim (маховик)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from math import pi, sqrt

import numpy as np

from plans.analytic.closure import EPS
from plans.analytic.dynamics.breaks import LEAST, Sided, StrokeRun, TurnQuantity, breaks, broken, looks, roots, smooth
from plans.analytic.dynamics.reduction import ExactReduction
from plans.analytic.extremes import EQUAL
from plans.model.dynamics import ANALYSIS, CHOSEN, TURN, Cycle, Flywheel, Methods, Rim, Task, Touch, Wheel, settled
from plans.model.machine import Track
from plans.model.motion import Floats, Motion
from plans.model.run import OfTurn, ReducedLink


def wheel(inertia: float, rim: Rim) -> Wheel | None:
    """Size a flywheel of an inertia kg*m2 at the crank's shaft on its own; None of none.

    On a shaft that turns U times faster J/U^2 stores as much energy; all the mass m = 4 J / D^2 is at the diameter D,
    and its volume is pi D times the section, whose breadth is so many times its thickness.
    """
    if inertia <= 0.0:
        return None
    on_shaft = inertia / rim.ratio**2
    thick = sqrt(4.0 * on_shaft / (rim.density * pi) / rim.breadth)  # at a diameter of 1 m; t/D falls as D^(-5/2)
    diameter = rim.sized((thick / CHOSEN) ** 0.4)
    mass = 4.0 * on_shaft / diameter**2
    section = mass / (rim.density * pi * diameter)
    thickness = sqrt(section / rim.breadth)
    return Wheel(on_shaft, diameter, mass, thickness, rim.breadth * thickness, rim.ratio)


ROUNDINGS = 8.0  # a linear solution at rest leaves a few roundings of the largest term in each of its rows
MOST = 1e-6  # share: more than this is allowed no number that the two roads are compared by


@dataclass(frozen=True)
class Exact:
    """The loads, reduced to the crank, and the inertia over a turn; angles `turned` rad (N,) in the sense of rotation.

    `noise` is the share of the largest to which positions and rates are known.
    """

    breaks: Floats
    load: TurnQuantity  # of loads and weights
    weight: TurnQuantity  # of the weights alone
    mass: TurnQuantity
    growth: TurnQuantity
    noise: float
    size: float = 0.0  # N*m: the largest sum of the moments of loads and weights, each taken positive

    @property
    def error(self) -> float:
        """The share of the largest by which moment or inertia may be off; infinite where they are not known."""
        return max(curve.error for curve in (self.load, self.mass, self.growth))

    @property
    def settled(self) -> bool:
        """Whether that is rounding."""
        return self.error <= self.noise

    def moment(self, turned: Floats, side: int = 1) -> Floats:
        """Give the moment of loads and weights, N*m; at a jump as it is beyond, or before it if side < 0."""
        return settled(self.load.at(turned, side), self.size)

    def work(self, turned: Floats) -> Floats:
        """Give their work since position 0, J."""
        return settled(self.load.since(turned), self.size * TURN)

    @cached_property
    def driving(self) -> float:
        """The constant moment N*m of the drive that keeps the motion steady."""
        return -float(self.work(np.array([TURN]))[0]) / TURN

    def surplus(self, turned: Floats) -> Floats:
        """Give the change of the kinetic energy since position 0, J."""
        return self.driving * np.asarray(turned) + self.work(turned)

    def inertia(self, turned: Floats) -> Floats:
        """Give the reduced inertia of the linkage, kg*m2."""
        return self.mass.at(turned)

    @cached_property
    def own(self) -> float:
        """The reduced inertia of the linkage at position 0, kg*m2."""
        return float(self.inertia(np.zeros(1))[0])

    def varying(self, turned: Floats) -> Floats:
        """Give the part of it that changes: that above its value at position 0."""
        return self.inertia(turned) - self.own

    def slope(self, turned: Floats) -> Floats:
        """Give its derivative by the angle, kg*m2."""
        return self.growth.at(turned)

    def turns(self, slope: Sided) -> Floats:
        """Give where a quantity with this slope may be least or greatest: at rests of it, at breaks, at the ends."""
        places = looks([self.load, self.mass], *self.breaks)
        return np.unique(np.concatenate(([0.0], self.breaks, roots(slope, places))))


def exact(reduction: ExactReduction, strokes: Mapping[Track, StrokeRun]) -> Exact:
    """Find moments and inertia over a turn of a machine whose loads change over `strokes`."""
    kappa = reduction.road.conditions(reduction.even(LEAST))
    largest = float(np.max(kappa, where=np.isfinite(kappa), initial=1.0))
    # Rates are known to this share: their condition magnifies a rounding once for every order.
    # At a change point it is of no account, for the linkage is carried through.
    noise, sizes = min(ROUNDINGS * EPS * largest**2, MOST), list[float]()

    def masses(motion: Motion) -> tuple[Floats, Floats]:
        found = reduction.ordinates(motion)
        return np.array((found.inertia, found.slope)), np.full(2, np.abs(found.inertia).max())

    def loads(motion: Motion) -> tuple[Floats, Floats]:
        found = reduction.ordinates(motion)
        sizes.append(float(found.gross.max()))
        return np.array((found.moment, found.weight)), np.full(2, found.gross.max())

    at = breaks(reduction, strokes, noise)
    mass, growth = smooth(reduction, masses, noise)
    load, weight = broken(reduction, loads, at, noise) if at.size else smooth(reduction, loads, noise)
    return Exact(at, load, weight, mass, growth, noise, max(sizes))


# Extremes that differ by less than this share of the loop's height are one and the same: the first of them counts.
SAME = 1e-12

Support = Callable[[float, int], Touch]  # slope of a tangent, and +1 where it touches from above, to where it touches


def speed_slopes(task: Task) -> tuple[float, float]:
    """Give omega2/2 of the least and the greatest speed, J per kg*m2: the mean speed times 1 -+ delta/2 (6.13)."""
    delta = task.delta or 0.0
    low, high = (task.speed * (1.0 + sign * delta / 2.0) for sign in (-1, 1))
    return low**2 / 2.0, high**2 / 2.0


def book_slopes(task: Task) -> tuple[float, float]:
    """Give them as the book does, without the square of delta: 1 -+ delta in place of (1 -+ delta/2)^2 (6.14)."""
    delta = task.delta or 0.0
    return task.speed**2 / 2.0 * (1.0 - delta), task.speed**2 / 2.0 * (1.0 + delta)


def flywheel(found: Exact, task: Task, slopes: tuple[float, float] | None = None) -> Flywheel:
    """Find the flywheel of a task: exact tangents to the loop, or such of other slopes."""
    return _flywheel(lambda slope, sign: _touch(found, slope, sign), found.own, task, slopes)


def flywheel_of_points(cycle: Cycle, task: Task, slopes: tuple[float, float] | None = None) -> Flywheel:
    """Find it from a drawn loop alone: its corners, and the cubics that join them."""
    return _flywheel(lambda slope, sign: _touch_drawn(cycle, slope, sign), cycle.own, task, slopes)


def _flywheel(support: Support, linkage: float, task: Task, slopes: tuple[float, float] | None) -> Flywheel:
    low, high = slopes or speed_slopes(task)
    below, above = support(low, -1), support(high, 1)
    cuts = below.surplus - low * below.varying, above.surplus - high * above.varying
    return Flywheel(ANALYSIS, (low, high), (below, above), cuts, linkage, task.present)


def _touch(found: Exact, slope: float, sign: int) -> Touch:
    """Find where energy less slope times inertia is greatest, or least: where it rests, or at a break."""
    driving = found.driving
    at = found.turns(lambda turned, side: driving + found.moment(turned, side) - slope * found.slope(turned))
    return _farthest(at, found.varying(at), found.surplus(at), slope, sign)


def _touch_drawn(cycle: Cycle, slope: float, sign: int) -> Touch:
    """Find where the drawn energy less slope times the drawn inertia is greatest, or least: at a corner or a rest."""
    wide = np.diff(cycle.turned)
    leaning = np.column_stack((cycle.leaning[:-1], cycle.leaning[1:]))
    energy = _powers(cycle.surplus, (cycle.driving + cycle.moments) * wide[:, None])
    inertia = _powers(cycle.varying, leaning * wide[:, None])
    _, linear, square, cube = energy - slope * inertia
    with np.errstate(divide="ignore", invalid="ignore"):  # a strip without a rest has no number
        stem = -(square + np.copysign(np.sqrt(square**2 - 3.0 * linear * cube), square))
        shares = np.stack((stem / (3.0 * cube), linear / stem))
    _, k = inside = np.nonzero((shares > 0.0) & (shares < 1.0))
    s = shares[inside]
    varying, surplus = (sum(row[k] * s**power for power, row in enumerate(rows)) for rows in (inertia, energy))
    turned = np.append(cycle.turned, cycle.turned[k] + s * wide[k])
    return _farthest(turned, np.append(cycle.varying, varying), np.append(cycle.surplus, surplus), slope, sign)


def _powers(edges: Floats, slopes: Floats) -> Floats:
    """Give the powers of the share of a strip that make up the cubic with its ends and slopes, (4, n)."""
    first, rise, (start, end) = edges[:-1], np.diff(edges), slopes.T
    return np.stack((first, start, 3.0 * rise - 2.0 * start - end, start + end - 2.0 * rise))


def _farthest(turned: Floats, varying: Floats, surplus: Floats, slope: float, sign: int) -> Touch:
    """Give the first of the points that lie farthest above a line of this slope, or below it."""
    height = sign * (surplus - slope * varying)
    first = int(np.argmax(height >= height.max() - SAME * np.ptp(height)))
    return Touch(float(turned[first]), float(varying[first]), float(surplus[first]))


def reduced_link(found: Exact, constant: float) -> ReducedLink:
    """Give the reduced link of a machine; `constant`: inertia kg*m2 of shafts and flywheel."""
    breaks = sorted({float(place) % TURN for place in found.breaks})
    both, weight = found.load.value, found.weight.value
    inertia, loads = _raised(found.mass.value, lambda _: constant), _raised(both, lambda turned: -weight(turned))
    return ReducedLink(inertia, found.growth.value, loads, weight, tuple(breaks))


def _raised(curve: OfTurn, by: OfTurn) -> OfTurn:
    return lambda turned: curve(turned) + by(turned)


def methods(found: Exact, task: Task) -> Methods | None:
    """Find J0 by each method; None where no fluctuation is asked for.

    Mertsalov takes the energy of the varying inertia at the mean speed throughout; Gutyar at the greatest where he
    seeks the greatest energy of the rest, at the least where he seeks the least. Both divide by omega_m^2 delta.
    """
    if not task.delta:
        return None
    even = task.speed**2 * task.delta
    mean = task.speed**2 / 2.0
    level = flywheel(found, task, (mean, mean))
    exact = flywheel(found, task)
    return Methods(
        book=flywheel(found, task, book_slopes(task)).whole,
        mertsalov=(level.cuts[1] - level.cuts[0]) / even,
        gutyar=(exact.cuts[1] - exact.cuts[0]) / even,
        height=level.cuts[1] - level.cuts[0],
        touches=level.touches,
    )


def exact_cycle(found: Exact, turned: Floats) -> Cycle:
    """Account for a turn on strips with edges `turned`, (n + 1,) rad, without any error but rounding."""
    return _cycle(found, turned, found.work(turned))


def sampled_cycle(found: Exact, turned: Floats) -> Cycle:
    """Account for it as the construction must: the work of a strip is its width by the ordinate at its middle."""
    strips = np.diff(turned) * found.moment(_middles(turned))
    return _cycle(found, turned, np.concatenate(([0.0], np.cumsum(strips))))


def _cycle(found: Exact, turned: Floats, work: Floats) -> Cycle:
    sides = np.array(turned)  # where an edge is meant for a break it is the very break: each side is that of its strip
    for at in found.breaks:
        sides[np.abs(turned - at) <= EQUAL] = at
    moments = np.stack((found.moment(sides[:-1], 1), found.moment(sides[1:], -1)), axis=1)
    means = found.moment(_middles(turned))
    return Cycle(ANALYSIS, turned, found.breaks, moments, means, work, found.inertia(turned))


def _middles(turned: Floats) -> Floats:
    return np.asarray((turned[:-1] + turned[1:]) / 2.0)
