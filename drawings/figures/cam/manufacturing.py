"""What the drawing of a cam to be made shows: the working profile alone, by radii at even turns (чертёж кулачка)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.figures.cam.profile_view import ProfileView, profile_view
from plans.cam.course import Course
from plans.cam.profile import profile
from plans.model.cam import GROOVE, Cam
from plans.model.cam_motion import CamFound, Contour, Points
from plans.model.motion import Floats

PLAN, QUANTITY = "manufacturing", "l"
STEP = 5  # degrees from one tabled turn to the next; of a cam that translates parts of its travel
PARTS = 60  # of the travel of a cam that translates
RAY = 30  # degrees from one drawn radius to the next
TRAVELS = 10  # parts from one drawn ordinate to the next


def tabled(cam: Cam) -> Floats:
    """Give the turns of the cam that a sheet tells radii at, rad: every 5 degrees, or a sixtieth of its travel."""
    count = PARTS if cam.translates else 360 // STEP
    return np.linspace(0.0, cam.turn, count + 1)[: count + cam.translates]


class Manufacture(NamedTuple):
    """A cam to be made: its view, and the profile at the tabled turns."""

    view: ProfileView
    at: Contour

    @property
    def cam(self) -> Cam:
        """The cam that was asked for."""
        return self.view.cam

    @property
    def grooved(self) -> bool:
        """Whether a mill as broad as the groove makes it, so that the path of its centre is told."""
        return self.cam.closure == GROOVE and self.view.apart

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
        every = TRAVELS if self.cam.translates else RAY // STEP
        yield from ((k, self.names[k]) for k in range(every, len(self.names), every))

    @property
    def corners(self) -> list[complex]:
        """The corners of what is drawn to scale, m."""
        if self.cam.translates:
            left, right = self.view.body
            return [left, complex(right.real, float(self.view.curve.pitch.imag.max()))]
        return [complex(spot) for one in (*self.view.outlines, self.view.curve.pitch) for spot in one]


def manufacture(found: CamFound) -> Manufacture:
    """Give what the drawing of a cam to be made shows of one that the construction found."""
    at = profile(Course(found.cam), found.sizes, found.roller, tabled(found.cam)).contour
    return Manufacture(profile_view(found), at)
