"""The main sizes by closed formulas and roots (основные размеры, аналитически)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from plans.analytic.cam.rocker_sizes import rocker_sizes
from plans.analytic.cam.stretches import eased, golden, peak, stretches
from plans.model.cam import FORCE, LEAST_BASE, RETURN, RISE, Cam, limits_of
from plans.model.cam_motion import (
    CamSizes,
    FollowerTravel,
    fast_face,
    hard_face,
    no_distance,
    no_level,
    no_radius,
    no_region,
    still,
    too_far,
    vanishing,
)
from plans.model.motion import Floats


def face_sizes(cam: Cam) -> CamSizes:
    """Give R0 with L given: the least angle at the start at which no radius is less than it may be."""
    base, centre = cam.given.base, cam.given.centre
    if centre is None:
        raise no_distance(cam)
    if base is not None and abs(base - cam.follower.face) >= centre:
        raise no_level(cam, base, centre)
    initial = _initial(cam, centre) if base is None else math.asin((base - cam.follower.face) / centre)
    height = cam.follower.face + centre * math.sin(initial) if base is None else base
    if height <= 0:
        raise no_radius(cam)
    line = complex(math.cos(cam.lift / 2 + initial), -math.sin(cam.lift / 2 + initial))  # O1O where the rise is so
    mirrored = line if cam.rising > 0 else -line.conjugate()
    return CamSizes(height, 0.0, centre, -centre * mirrored, initial)


def _initial(cam: Cam, centre: float) -> float:
    """Give the least angle of the line of centres with the arm at the start, rad.

    With A = (1 - 2m)/(1 - m)2, B = ψ''/(1 - m)3 each position asks for A sin ψ + B cos ψ >= q = (ρ_min - h)/L: for an
    angle from asin(q/R) - β on, up to π - asin(q/R) - β, where R = |A + iB| and β = arg(A + iB).
    """
    everywhere = stretches(cam, {phase.kind for phase in cam.phases})
    f = cam.follower.sense
    fastest = peak(everywhere, lambda at: f * at.slope, lambda at: f * at.bend)
    if fastest.value >= 1:
        raise fast_face(cam, fastest.stretch.turned(fastest.share))
    q = (cam.limits.curvature - cam.follower.face) / centre
    if golden(everywhere, lambda at: q - _wave(cam, at)[0]).value > 0:
        raise no_region(cam, cam.limits)
    least = golden(everywhere, lambda at: np.arcsin(np.maximum(q / _wave(cam, at)[0], -1.0)) - _wave(cam, at)[1]).value
    most = golden(everywhere, lambda at: np.arcsin(np.clip(q / _wave(cam, at)[0], -1.0, 1.0)) + _wave(cam, at)[1]).value
    if least > min(math.pi - most, math.pi / 2):
        raise no_region(cam, cam.limits)
    return least


def _wave(cam: Cam, at: FollowerTravel) -> tuple[Floats, Floats]:
    """Give R, and the S of the position with β: the angle of the line of centres at the start is what is sought."""
    m = cam.follower.sense * at.slope
    level, upright = (1 - 2 * m) / (1 - m) ** 2, at.bend / (1 - m) ** 3
    return np.hypot(level, upright), at.s + np.arctan2(upright, level)


def sizes(cam: Cam) -> CamSizes:
    """Give the main sizes, those that are given as they are. Raises CamError where there are none."""
    if cam.translates:
        return CamSizes(0.0)
    if cam.given.base is None and not any(cam.moving()):
        raise still(cam)
    if cam.flat:
        refuse_falls(cam)
        return face_sizes(cam) if cam.rocks else _flat(cam)
    return rocker_sizes(cam) if cam.rocks else _guided(cam)


class LimitLine(NamedTuple):
    """A limiting line of O = (-e, -S0): sign*e + S0 tan a >= Q."""

    sign: int
    tangent: float
    most: float  # Q, m

    def held(self, offset: float, level: float) -> float:
        """Give by how much it is held, m; below 0 it is broken."""
        return self.sign * offset + level * self.tangent - self.most


def _guided(cam: Cam) -> CamSizes:
    """Give R0 and e: S0 = (Q1 + Q2)/(tan a1 + tan a2), e = (Q1 tan a2 - Q2 tan a1)/(tan a1 + tan a2)."""
    given = cam.given
    if given.base is not None and given.offset is not None:
        if abs(given.offset) >= given.base:
            raise too_far(cam, given.offset, given.base)
        return CamSizes(given.base, given.offset)
    if given.base is not None and cam.unlimited:
        return CamSizes(given.base, 0.0)
    if given.base is not None:
        return CamSizes(given.base, eased(cam, lambda one: complex(*least(tuple(sides_of(one))))).real)
    sides = tuple(sides_of(cam))
    if given.offset is not None:
        level = max((side.most - side.sign * given.offset) / side.tangent for side in sides)
        return CamSizes(math.hypot(level, given.offset), given.offset)
    offset, level = least(sides)
    base = math.hypot(offset, level)
    if base < LEAST_BASE * cam.way:
        raise vanishing(cam, limits_of(cam))
    return CamSizes(base, offset)


def sides_of(cam: Cam) -> Iterator[LimitLine]:
    """Give the limiting lines of a follower that translates."""
    limits = limits_of(cam)
    assert limits.rise is not None  # the book's at least
    yield _side(cam, RISE, limits.rise, 1)
    if limits.back is not None:
        yield _side(cam, RETURN, limits.back, -1)
    if cam.closure == FORCE:
        yield _side(cam, RISE, limits.rise, -1)


def _side(cam: Cam, kind: str, angle: float, sign: int) -> LimitLine:
    """Give the line of a limit: Q is the greatest of sign*S' - S tan a, at S'' = sign*S' tan a or at a corner."""
    t = math.tan(angle)
    along = stretches(cam, (kind,))
    found = peak(along, lambda at: sign * at.slope - t * at.s, lambda at: sign * at.bend - t * at.slope)
    return LimitLine(sign, t, found.value)


def least(sides: tuple[LimitLine, ...]) -> tuple[float, float]:
    """Give e and S0 of the least R0: where two lines meet, or square to one of them."""
    rise, *others = sides
    corners = [_meeting(rise, other) for other in others]
    corners += [_meeting(first, other) for first, other in pairwise(others)]
    places = [_foot(side) for side in sides] + [corner for corner in corners if corner is not None]
    slack = 1e-14 * max(abs(side.most) for side in sides)  # a few roundings of Q
    inside = [spot for spot in places if all(side.held(*spot) >= -slack for side in sides)]
    return min(inside, key=lambda spot: math.hypot(*spot))


def _meeting(side: LimitLine, other: LimitLine) -> tuple[float, float] | None:
    if side.sign == other.sign:
        turn = side.tangent - other.tangent
        level = (side.most - other.most) / turn if turn else math.inf
        return (side.sign * (side.most - level * side.tangent), level) if turn else None
    level = (side.most + other.most) / (side.tangent + other.tangent)
    return side.sign * (side.most * other.tangent - other.most * side.tangent) / (side.tangent + other.tangent), level


def _foot(side: LimitLine) -> tuple[float, float]:
    size = side.most / (1 + side.tangent**2)
    return side.sign * size, side.tangent * size


def _flat(cam: Cam) -> CamSizes:
    """Give R0 = ρ_min - min(S + S'')."""
    offset = cam.given.offset or 0.0
    if cam.given.base is not None:
        return CamSizes(cam.given.base, offset)
    everywhere = stretches(cam, {phase.kind for phase in cam.phases})
    base = cam.limits.curvature + golden(everywhere, lambda at: -(at.s + at.bend)).value
    if base <= 0:
        raise no_radius(cam)
    return CamSizes(base, offset)


def refuse_falls(cam: Cam) -> None:
    """Refuse a fall of S' at once under a face that is to be sized, between two stretches or where a turn closes."""
    if cam.given.base is not None:
        return
    along = stretches(cam, {phase.kind for phase in cam.phases})
    steepest = max(abs(phase.change) / phase.angle for phase in cam.moving())
    for earlier, other in pairwise((along[-1], *along)):
        before = float(earlier.at(np.array([earlier.end])).slope[0])
        after = float(other.at(np.array([other.start])).slope[0])
        if after - before < -1e-12 * steepest:  # more than the rounding of a law's coefficients
            raise hard_face(cam, other.turned(other.start))
