"""The hub of a cam: what bore and keyway leave of it to its profile (ступица кулачка)."""

from __future__ import annotations

import cmath

import numpy as np

from plans.cam.course import FollowerCourse
from plans.cam.profile.profile import profile
from plans.model.cam_motion import CamFound, Contour

CLOSE = 1440  # turns of the profile that are looked at: a quarter of a degree from one to the next


def keyed(found: CamFound, at: Contour) -> complex:
    """Give the unit direction of the keyway's axis from O, the first of the contour's points being on the zero ray."""
    assert found.cam.hub is not None
    first = complex(found.made(at)[0])
    return first / abs(first) * cmath.exp(-1j * found.cam.sense * found.cam.hub.angle)


def rim(found: CamFound) -> Contour:
    """Give the contour at so many turns that the wall can be told, from 0 to a whole one."""
    turned = np.linspace(0.0, found.cam.turn, CLOSE + 1)
    return profile(FollowerCourse(found.cam), found.sizes, found.roller, turned).contour


def wall(found: CamFound) -> float:
    """Give the least that bore and keyway leave to the working profile, m; below 0 where they break through."""
    assert found.cam.hub is not None
    at, hub = rim(found), found.cam.hub
    spots = at.profile / keyed(found, at)  # the keyway's axis lies along x
    bore, half, end = hub.bore / 2, hub.width / 2, hub.bore / 2 + hub.depth
    along, across = spots.real - end, np.maximum(np.abs(spots.imag) - half, 0.0)
    key = np.where(across > 0, np.hypot(np.maximum(along, 0.0), across), along)
    beside = (spots.real > 0) & (half > 0)
    return float(np.where(beside, np.minimum(np.abs(spots) - bore, key), np.abs(spots) - bore).min())
