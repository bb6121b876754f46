"""The least radius under the face of a rocker in closed form at each position (плоское коромысло)."""

from __future__ import annotations

import math

import numpy as np

from plans.analytic.cam.stretches import Stretch, golden, peak, stretches
from plans.model.cam import Cam
from plans.model.cam_faults import fast_face, no_distance, no_level, no_radius, no_region
from plans.model.cam_motion import Sizes, Travel
from plans.model.motion import Floats


def face_sizes(cam: Cam) -> Sizes:
    """Give R0 with L given: the least angle at the start at which no radius is less than it may be."""
    base, centre = cam.given.base, cam.given.centre
    if centre is None:
        raise no_distance(cam)
    if base is not None and abs(base - cam.follower.face) >= centre:
        raise no_level(cam, base, centre)
    initial = _initial(cam, centre) if base is None else math.asin((base - cam.follower.face) / centre)
    own = cam.follower.face + centre * math.sin(initial) if base is None else base
    if own <= 0:
        raise no_radius(cam)
    line = complex(math.cos(cam.lift / 2 + initial), -math.sin(cam.lift / 2 + initial))  # O1O where the rise is so
    mirrored = line if cam.rising > 0 else -line.conjugate()
    return Sizes(own, 0.0, centre, -centre * mirrored, initial)


def _initial(cam: Cam, centre: float) -> float:
    """Give the least angle of the line of centres with the arm at the start, rad.

    With A = (1 - 2m)/(1 - m)2, B = ψ''/(1 - m)3 each position asks for A sin ψ + B cos ψ >= q = (ρ_min - h)/L: for an
    angle from asin(q/R) - β on, up to π - asin(q/R) - β, where R = |A + iB| and β = arg(A + iB).
    """
    everywhere = stretches(cam, {one.kind for one in cam.phases})
    _slower(cam, everywhere)
    q = (cam.limits.curvature - cam.follower.face) / centre
    if golden(everywhere, lambda at: q - _wave(cam, at)[0]).value > 0:
        raise no_region(cam, cam.limits)
    least = golden(everywhere, lambda at: np.arcsin(np.maximum(q / _wave(cam, at)[0], -1.0)) - _wave(cam, at)[1]).value
    most = golden(everywhere, lambda at: np.arcsin(np.clip(q / _wave(cam, at)[0], -1.0, 1.0)) + _wave(cam, at)[1]).value
    if least > min(math.pi - most, math.pi / 2):
        raise no_region(cam, cam.limits)
    return least


def _wave(cam: Cam, at: Travel) -> tuple[Floats, Floats]:
    """Give R, and the S of the position with β: the angle of the line of centres at the start is what is sought."""
    m = cam.follower.sense * at.slope
    level, upright = (1 - 2 * m) / (1 - m) ** 2, at.bend / (1 - m) ** 3
    return np.hypot(level, upright), at.s + np.arctan2(upright, level)


def _slower(cam: Cam, everywhere: tuple[Stretch, ...]) -> None:
    """Refuse a rocker that turns as fast as the cam."""
    f = cam.follower.sense
    fastest = peak(everywhere, lambda at: f * at.slope, lambda at: f * at.bend)
    if fastest.value >= 1:
        raise fast_face(cam, fastest.stretch.turned(fastest.share))
