"""The exact outline of a cam at any turn: a point, its normal out of the cam, and how fast it runs (очертание кулачка).

All follows from the motion of the follower's tip K in the frame, K' and K'' by the cam's turn; the frame is then turned
back by the turn itself. Roller and groove lie along the normal at a distance; a flat face envelopes its profile.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from plans.cam.course import Course
from plans.model.cam import Cam
from plans.model.cam_motion import Points, Sizes, Travel
from plans.model.motion import Floats


class Spot(NamedTuple):
    """Points of an outline in the cam, (N,): m, the unit normal out of the cam, m/rad along it, its turning.

    `speed` is signed, above 0 where the outline runs against the cam's turn as a convex one does; `turning` is how fast
    the normal turns, 1, counter-clockwise.
    """

    at: Points
    normal: Points
    speed: Floats
    turning: Floats


class _Tip(NamedTuple):
    """K with its derivatives by the cam's turn, (N,) m, m/rad, m/rad2."""

    at: Points
    rate: Points
    bend: Points


@dataclass(frozen=True)
class Outline:
    """The outline that lies `away` m from the pitch curve, outward: minus the roller's radius for the profile."""

    cam: Cam
    sizes: Sizes
    away: float = 0.0

    def at(self, turned: Floats, before: bool = False) -> Spot:
        """Give points at turns of the cam, (N,) rad; at a joint after it, or before it."""
        phi = np.asarray(turned, dtype=float)
        travel = Course(self.cam).at(phi, before)
        if self.cam.flat:
            return self._turned_back(self._faced(travel), phi)
        return self._turned_back(self._offset(_tip(self.cam, self.sizes, travel)), phi)

    def _offset(self, tip: _Tip) -> Spot:
        """Give the outline beside the pitch curve, in the frame."""
        sense = self.cam.sense
        lever, drift = 1j * sense * tip.rate, 1j * sense * tip.bend
        lever, drift = (lever + 1j, drift) if self.cam.translates else (lever + tip.at, drift + tip.rate)
        normal = lever / np.abs(lever)
        turning = (drift / lever).imag - (0 if self.cam.translates else sense)
        speed = np.abs(lever) - self.away * sense * turning
        return Spot(tip.at + self.away * normal, normal, speed, turning)

    def _faced(self, travel: Travel) -> Spot:
        """Give where a flat face touches, in the frame: where it does not move along its normal over the cam."""
        sense = self.cam.sense
        if not self.cam.rocks:
            at = sense * travel.slope + 1j * (self.sizes.base + travel.s)
            up = np.full_like(at, 1j)
            return Spot(at, up, self.sizes.base + travel.s + travel.bend, np.full_like(travel.s, -sense))
        rising, with_cam = self.cam.rising, self.cam.follower.sense
        along = rising * np.exp(1j * rising * (travel.s - self.cam.lift / 2))
        foot = (along.conjugate() * self.sizes.pivot).real
        across = rising * (along.conjugate() * self.sizes.pivot).imag
        slower = with_cam * travel.slope - 1
        reach = foot / slower
        drift = (across * travel.slope - reach * with_cam * travel.bend) / slower
        normal = 1j * rising * along
        at = self.sizes.pivot + self.cam.follower.face * normal + reach * along
        # Along the face the point runs with its reach and the face's own swing, and the cam below it with its turn.
        run = drift - travel.slope * self.cam.follower.face - (along.conjugate() * 1j * sense * at).real
        speed = run * with_cam
        return Spot(at, normal, speed, rising * travel.slope - sense)

    def _turned_back(self, spot: Spot, turned: Floats) -> Spot:
        if self.cam.translates:
            return spot._replace(at=spot.at + self.cam.sense * turned)
        back = np.exp(-1j * self.cam.sense * turned)
        return spot._replace(at=spot.at * back, normal=spot.normal * back)


def _tip(cam: Cam, sizes: Sizes, travel: Travel) -> _Tip:
    """Give the motion of the follower's point or its roller's centre in the frame."""
    if not cam.rocks:
        level = np.sqrt((sizes.base - sizes.offset) * (sizes.base + sizes.offset))
        axis = 0.0 if cam.translates else cam.sense * sizes.offset
        up = np.complex128(1j)
        return _Tip(axis + up * (level + travel.s), up * travel.slope, up * travel.bend)
    rising = cam.rising
    arm = rising * (cam.follower.length or 0.0) * np.exp(1j * rising * (travel.s - cam.lift / 2))
    bend = (1j * rising * travel.bend - travel.slope**2) * arm
    return _Tip(sizes.pivot + arm, 1j * rising * travel.slope * arm, bend)
