"""The flywheel by the extremes of energy that it must even out, exact and of a drawn loop (маховик; M4.9, check)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from plans.analytic.dynamics.exact import Exact
from plans.model.dynamics import ANALYSIS, Cycle, Flywheel, Task, Touch
from plans.model.motion import Floats

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
    """Find it from the corners of a drawn loop alone."""
    points = cycle.turned, cycle.varying, cycle.surplus
    return _flywheel(lambda slope, sign: _farthest(*points, slope, sign), float(cycle.inertia[0]), task, slopes)


def _flywheel(support: Support, own: float, task: Task, slopes: tuple[float, float] | None) -> Flywheel:
    low, high = slopes or speed_slopes(task)
    below, above = support(low, -1), support(high, 1)
    cuts = below.surplus - low * below.varying, above.surplus - high * above.varying
    return Flywheel(ANALYSIS, (low, high), (below, above), cuts, own, task.present)


def _touch(found: Exact, slope: float, sign: int) -> Touch:
    """Find where energy less slope times inertia is greatest, or least: where it rests, or at a break."""
    driving = found.driving
    at = found.turns(lambda turned, side: driving + found.moment(turned, side) - slope * found.slope(turned))
    return _farthest(at, found.varying(at), found.surplus(at), slope, sign)


def _farthest(turned: Floats, varying: Floats, surplus: Floats, slope: float, sign: int) -> Touch:
    """Give the first of the points that lie farthest above a line of this slope, or below it."""
    height = sign * (surplus - slope * varying)
    first = int(np.argmax(height >= height.max() - SAME * np.ptp(height)))
    return Touch(float(turned[first]), float(varying[first]), float(surplus[first]))
