"""Angles read off a plan: directions of links, angular velocities and accelerations."""

from __future__ import annotations

import numpy as np

from geometry.meet import cross
from plans.mechanism import FRAME
from plans.motion import Floats
from plans.plan import Plan


def angle(plan: Plan, link: int) -> Floats:
    """Read off the plan of positions the direction of a link's own +x axis, rad in (-pi, pi]."""
    if link == FRAME:
        return np.zeros(1)
    image = plan.images[link]
    assert image.arm is not None  # every link has an arm on the plan of positions
    turned = np.angle(np.asarray(image.arm.point) / image.span)
    return np.where(turned <= -np.pi, np.pi, turned)


def rate(plan: Plan, link: int) -> Floats:
    """Read off a velocity or acceleration plan a link's omega rad/s or epsilon rad/s2: cross(AB, t)/|AB|2 (0.1).

    t is the part of the plan's relative vector that is square to the link; a link that does not turn has none.
    """
    if link not in plan.readings:
        return np.zeros(1)
    reading = plan.readings[link]
    arm = np.asarray(reading.arm.point)
    return np.asarray(cross(arm, reading.turning.point) / (arm.real * arm.real + arm.imag * arm.imag))
