"""What the figure of a profile shows: the cam as it stands at its start, the frame turned about it (профиль)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from drawings.paper.ties import tied
from plans.cam.course import Course
from plans.cam.path import ProfilePath, path
from plans.cam.profile.profile import profile
from plans.model.cam import GROOVE, Cam
from plans.model.cam_motion import CamFound, Contour, Points, Sizes
from plans.model.motion import Complexes, Floats

MANY = 1441  # turns at which the contour is known: every quarter of a degree
WORKING, PITCH, OUTER = "profile", "pitch", "outer"  # the curves by their names in the data
BODY = 0.8  # of the lift: how far below its lowest profile the body of a cam that translates goes
BEYOND = 0.12  # of the range of contact: how far a face is drawn past it
NAME, QUANTITY, SYMBOL, UNIT = "profile", "l", "l", "m"


class ShownCurve(NamedTuple):
    """A curve of the cam in pieces: how far from the pitch curve outward it lies, m, its name in the data."""

    name: str
    away: float
    path: ProfilePath


class ProfileView(NamedTuple):
    """A cam to be seen: what is found at its numbered positions, its contour at many turns, its curves in pieces."""

    found: CamFound
    curve: Contour
    curves: tuple[ShownCurve, ...]  # the working profile, then its pitch curve, then the other side of a groove

    @property
    def cam(self) -> Cam:
        """The cam that was asked for."""
        return self.found.cam

    @property
    def sizes(self) -> Sizes:
        """Its main sizes."""
        return self.found.sizes

    @property
    def contour(self) -> Contour:
        """The profile at the numbered positions."""
        return self.found.contour

    @property
    def positions(self) -> list[tuple[int, float]]:
        """The numbered positions with the turns of the cam, rad."""
        return list(enumerate(self.contour.turned.tolist()))

    @property
    def apart(self) -> bool:
        """Whether pitch curve and working profile are two."""
        return self.found.roller > 0

    def back(self, place: complex, turned: float) -> complex:
        """Carry a place of the frame back with the frame, against the motion of the cam."""
        return complex(self.backs(np.array([place]), np.array([turned]))[0])

    def backs(self, places: Points, turned: Floats) -> Complexes:
        """Carry places of the frame back, each by its own turn, (N,)."""
        sense = self.cam.sense
        moved = places + sense * turned if self.cam.translates else places * np.exp(-1j * sense * turned)
        return np.asarray(moved)

    def way(self, direction: complex, turned: float) -> complex:
        """Turn a direction of the frame back with the frame."""
        return direction if self.cam.translates else self.back(direction, turned)

    @property
    def outlines(self) -> tuple[Complexes, ...]:
        """The working profile by points, m; of a groove its other side too."""
        own = self.curve
        return (own.profile,) if own.outer is None or not self.apart else (own.profile, own.outer)

    @property
    def axis(self) -> float:
        """Where the axis of a follower that translates stands, x in m."""
        return self.cam.sense * self.sizes.offset

    @property
    def reach(self) -> float:
        """How far from O the cam and its rollers reach, m."""
        own = self.curve
        if self.cam.flat and not self.cam.rocks:
            return float(abs(own.tip.imag + 1j * max(map(abs, self.face))).max())
        far = [abs(own.pitch).max() + self.found.roller, *(abs(one).max() for one in self.outlines)]
        if self.cam.follower.reach is not None:  # the end of a rocker's face
            end = self.sizes.pivot - 1j * own.lever * max(self.face, key=abs) + self.cam.follower.face * own.lever
            far.append(abs(end).max())
        return float(max(far))

    @property
    def face(self) -> tuple[float, float]:
        """How far a face is drawn from its follower's axis or pivot to either side, m.

        As far as it reaches, of a rocker from its pivot on; where that is not said a little past all contact.
        """
        foot = self.sizes.pivot if self.cam.rocks else complex(self.axis)
        off = ((self.curve.tip - foot) * (-1j * self.curve.lever).conj()).real
        low, high = float(off.min()), float(off.max())
        reach = self.cam.follower.reach
        if reach is None:
            return low - BEYOND * (high - low), high + BEYOND * (high - low)
        if not self.cam.rocks:
            return -reach, reach
        return (0.0, reach) if low + high > 0 else (-reach, 0.0)

    @property
    def body(self) -> tuple[complex, complex]:
        """The lower left and the lower right corner of a cam that translates, m."""
        profile = self.curve.profile
        low = float(profile.imag.min()) - BODY * self.cam.lift
        return complex(float(profile.real.min()), low), complex(float(profile.real.max()), low)

    @property
    def corners(self) -> list[complex]:
        """The corners of all that is drawn to scale, m."""
        if self.cam.translates:
            top = float(self.curve.tip.imag.max()) + self.found.roller
            across, by = self.curve.pitch.real, self.found.roller
            return [*self.body, *(complex(x, top) for x in (across.min() - by, across.max() + by))]
        reach = max(self.reach, abs(self.sizes.pivot))
        return [complex(x, y) for x in (-reach, reach) for y in (-reach, reach)]

    def at(self, turned: float) -> tuple[complex, complex]:
        """Give the point of the pitch curve at a turn, m, and the unit normal out of the cam."""
        curve, turns = self.curve, self.curve.turned
        spot, lever = (
            complex(np.interp(turned, turns, one.real), np.interp(turned, turns, one.imag))
            for one in (curve.pitch, curve.lever)
        )
        normal = self.way(lever, turned)
        return spot, normal / abs(normal)

    @property
    def step(self) -> tuple[float, float]:
        """The longest step from one numbered position to the next: the turns of both, rad."""
        return max(pairwise([*self.contour.turned.tolist(), self.cam.turn]), key=lambda pair: tied(pair[1] - pair[0]))

    @property
    def quiet(self) -> float:
        """The direction from O, rad, about which the frame is turned to no position: the middle of the longest step."""
        return cmath.phase(self.way(self.sizes.pivot if self.cam.rocks else 1j, sum(self.step) / 2))


def profile_view(found: CamFound) -> ProfileView:
    """Give what a figure shows of a cam that the construction found."""
    course = Course(found.cam)
    turns = course.with_joints(np.linspace(0.0, found.cam.turn, MANY))
    contour = profile(course, found.sizes, found.roller, turns).contour
    return ProfileView(found, contour, tuple(_curves(found)))


def _curves(found: CamFound) -> Iterator[ShownCurve]:
    cam, sizes, away = found.cam, found.sizes, found.roller
    yield ShownCurve(WORKING, -away, path(cam, sizes, -away))
    if away:
        yield ShownCurve(PITCH, 0.0, path(cam, sizes))
        if cam.closure == GROOVE:
            yield ShownCurve(OUTER, away, path(cam, sizes, away))
