"""Angles read off a plan: directions of links, angular velocities and accelerations."""

from __future__ import annotations

import numpy as np

from geometry.meet import Vectors
from plans.linkage.plan import Plan
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes, Floats

RUN = 40  # positions whose angles are measured from the middle one, where they are close to it
CLOSE = 1 / 64  # tangent of an angle whose series may leave out t9/9: less than a rounding


def heading(vector: Vectors, span: complex = 1 + 0j) -> Floats:
    """Give the direction of a link's own +x axis, rad in (-pi, pi], from one of its vectors that is `span` there."""
    own = np.asarray(vector if span.imag == 0 < span.real else vector / span)
    # The first run tells most often enough that the others are not close either.
    close = own.size >= RUN and own.size % RUN == 0 and abs(own[RUN // 2] - own[0]) <= CLOSE * abs(own[0])
    found = _close(own.reshape(-1, RUN)) if close else None
    return _turned(own) if found is None else found


def _turned(own: Complexes) -> Floats:
    turned = np.arctan2(own.imag, own.real)
    return (
        turned
        if np.minimum.reduce(turned, None, initial=np.inf) > -np.pi
        else np.where(turned <= -np.pi, np.pi, turned)
    )


def _close(runs: Complexes) -> Floats | None:
    """Measure runs of vectors close to each other, each from the middle of its run; None where one is not close.

    An arctangent costs as much as a meeting; of a small tangent t it is t - t3/3 + t5/5 - t7/7 to the last digit.
    """
    middle = runs[:, RUN // 2, None]
    from_middle = np.conjugate(middle) * runs
    tangent = from_middle.imag / from_middle.real
    if not (np.abs(tangent).max() <= CLOSE and from_middle.real.min() > 0):
        return None
    square = tangent * tangent
    angle = square * (-1 / 7)
    for share in (1 / 5, -1 / 3):
        angle += share
        angle *= square
    angle *= tangent
    angle += tangent
    angles = _turned(middle)
    angle += angles
    if np.abs(angles).max() > np.pi - CLOSE:
        angle -= np.where(angle > np.pi, 2 * np.pi, 0.0)
        angle += np.where(angle <= -np.pi, 2 * np.pi, 0.0)
    return angle.ravel()


def angle(plan: Plan, link: int) -> Floats:
    """Read off the plan of positions the direction of a link's own +x axis, rad in (-pi, pi]."""
    if link == FRAME:
        return np.zeros(1)
    return heading(plan.arm(link).point, plan.images[link].span)


def rate(plan: Plan, link: int) -> Floats:
    """Read off a velocity or acceleration plan a link's omega rad/s or epsilon rad/s2: Im(t/AB) (0.1).

    t is the part of the plan's relative vector that is square to the link; a link that does not turn has none.
    """
    if link not in plan.readings:
        return np.zeros(1)
    reading = plan.readings[link]
    return np.imag(reading.turning.point / reading.arm.point)
