"""The outline of a cam beside its pitch curve, at any turn: where it is, and how it runs (очертание кулачка)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from plans.cam.course import Course
from plans.cam.profile.curvature import curvature
from plans.cam.profile.tip import Tip
from plans.cam.profile.touch import Touch
from plans.model.cam import Cam
from plans.model.cam_motion import Points, Sizes
from plans.model.motion import Floats


class Spot(NamedTuple):
    """Points of an outline in the cam, (N,): m, the unit tangent there, how fast the outline runs along it, m/rad.

    The tangent is that of the pitch curve, or lies in the flat face: where the outline turns back on itself, on a loop,
    it runs against it.
    """

    at: Points
    tangent: Points
    speed: Floats


@dataclass(frozen=True)
class Outline:
    """The outline that lies `away` m from the pitch curve, outward: minus the roller's radius for the profile."""

    course: Course
    sizes: Sizes
    away: float = 0.0

    @property
    def cam(self) -> Cam:
        """The cam."""
        return self.course.cam

    def at(self, turned: Floats, before: bool = False) -> Spot:
        """Give points at turns of the cam, (N,) rad; at a joint after it, or before it."""
        tip = Tip(self.course, self.sizes, np.asarray(turned, dtype=float), before)
        if self.cam.flat:
            touch = Touch(tip)
            return self._spot(tip, touch.contact, touch.normal, touch.sweep)
        normal, speed = tip.lever / np.abs(tip.lever), np.abs(tip.lever)
        return self._spot(tip, tip.orders[0] + self.away * normal, normal, speed * (1 + self.away * curvature(tip)))

    def _spot(self, tip: Tip, place: Points, normal: Points, speed: Floats) -> Spot:
        tangent = -1j * self.cam.sense * normal * np.exp(-1j * tip.turns * tip.turned)
        return Spot(tip.on_cam(place), np.asarray(tangent), speed)

    def tip(self, turned: float) -> complex:
        """Give the place of the follower's tip in the cam at one turn, m."""
        tip = Tip(self.course, self.sizes, np.array([turned]))
        return complex(tip.on_cam(tip.orders[0])[0])
