"""What the drawing of a cam to be made shows: the working profile alone, by radii at even turns (чертёж кулачка)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.figures.cam.profile_view import ProfileView, profile_view
from plans.cam.course import Course, settled
from plans.cam.profile.profile import profile
from plans.model.cam import DWELL, GROOVE, Cam, Phase
from plans.model.cam_motion import CamFound, Contour, Points
from plans.model.motion import Floats

PLAN, QUANTITY = "manufacturing", "l"
COUNT = 72  # tabled turns: every 5 degrees; of a cam that translates so many at most, and its end
RAY = 6  # tabled turns from one drawn radius to the next: 30 degrees
TRAVELS = 10  # from one drawn ordinate of a cam that translates to the next
MANTISSAS = (1.0, 2.0, 2.5, 5.0, 10.0)  # of the travel in mm from one to the next


def tabled(cam: Cam) -> Floats:
    """Give the turns of the cam that a sheet tells radii at, rad: every 5 degrees, or by a round length of travel."""
    if not cam.translates:
        return settled(np.linspace(0.0, cam.turn, COUNT + 1)[:-1], Course(cam))
    step = _step(cam.turn * 1000 / COUNT) / 1000
    return settled(np.append(np.arange(0.0, cam.turn - step / 2, step), cam.turn), Course(cam))


def _step(least: float) -> float:
    """Give the least round length that is not less than another, mm."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(one * power for one in MANTISSAS if one * power >= least * (1 - 1e-12))


class TabledProfile(NamedTuple):
    """The profile at the tabled turns, by either road: what is found of the cam, its contour there."""

    found: CamFound
    at: Contour

    @property
    def cam(self) -> Cam:
        """The cam that was asked for."""
        return self.found.cam

    @property
    def grooved(self) -> bool:
        """Whether a mill as broad as the groove makes it, so that the path of its centre is told."""
        return self.cam.closure == GROOVE and self.found.roller > 0

    @property
    def told(self) -> Points:
        """The tabled points, m, (N,): of the working profile, of a groove those of its middle."""
        return self.at.pitch if self.grooved else self.at.profile

    @property
    def zero(self) -> complex:
        """The unit direction of the zero ray: from O to the first tabled point."""
        first = complex(self.told[0])
        return first / abs(first)

    @property
    def radii(self) -> Floats:
        """Polar radii of the tabled points, m, (N,)."""
        return np.asarray(np.abs(self.told))

    @property
    def angles(self) -> Floats:
        """Polar angles of the tabled points from the zero ray, against the rotation, rad, (N,)."""
        return np.asarray(-self.cam.sense * np.unwrap(np.angle(self.told / self.zero)))

    @property
    def names(self) -> list[float]:
        """The tabled turns, degrees; of a cam that translates its travels, mm."""
        own = 1000 * self.at.turned if self.cam.translates else np.degrees(self.at.turned)
        return [float(one) for one in own.round(9)]

    def rays(self) -> Iterator[tuple[int, float]]:
        """Give the tabled turns whose radii are drawn, with their names."""
        every = TRAVELS if self.cam.translates else RAY
        yield from ((k, self.names[k]) for k in range(every, len(self.names), every))

    def dwells(self) -> Iterator[tuple[Phase, float]]:
        """Give the dwells with the radii of their arcs, m: of the profile, of a groove of its middle."""
        spots = self.found.contour.pitch if self.grooved else self.found.contour.profile
        for one in self.cam.phases:
            if one.kind == DWELL:
                yield one, float(abs(spots[int(np.argmin(abs(self.found.contour.turned - one.start)))]))


class Manufacture(NamedTuple):
    """A cam to be made: its view, and the profile at the tabled turns."""

    view: ProfileView
    table: TabledProfile

    @property
    def corners(self) -> list[complex]:
        """The corners of what is drawn to scale, m."""
        if self.view.cam.translates:
            left, right = self.view.body
            return [left, complex(right.real, float(self.view.curve.pitch.imag.max()))]
        return [complex(spot) for one in (*self.view.outlines, self.view.curve.pitch) for spot in one]


def manufacture(found: CamFound) -> Manufacture:
    """Give what the drawing of a cam to be made shows of one that the construction found."""
    at = profile(Course(found.cam), found.sizes, found.roller, tabled(found.cam)).contour
    return Manufacture(profile_view(found), TabledProfile(found, at))
