"""The tip of the follower in the frame, and its derivatives by the cam's turn (движение острия толкателя).

The tip is the point, the roller's centre, or the place where a flat face touches. The curve that it leaves on the cam
is followed too: its derivatives are those of the tip less what the cam itself has gone, both seen in the frame.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import cast

import numpy as np
import numpy.typing as npt

from geometry.meet import Vectors
from plans.cam.course import Course
from plans.cam.laws import law_of
from plans.model.cam import Cam, Phase
from plans.model.cam_motion import Points, Sizes, Travel
from plans.model.motion import Floats


def guide_start(sizes: Sizes) -> float:
    """Give S0, the height of the tip above O at the start of a follower that translates, m."""
    return math.sqrt((sizes.base - sizes.offset) * (sizes.base + sizes.offset))


def arm(cam: Cam, s: Floats) -> Points:
    """Give the unit direction of a rocker from its pivot; at mid-swing it is level, whence it rises."""
    return np.asarray(cam.rising * np.exp(1j * cam.rising * (s - cam.lift / 2)))


@dataclass(frozen=True)
class Tip:
    """The tip at N turns of the cam: K and its derivatives to the third, and those of its curve on the cam.

    `before` takes the sides before a joint, where the law has a jump.
    """

    course: Course
    sizes: Sizes
    turned: Floats  # rad
    before: bool = False

    @property
    def cam(self) -> Cam:
        """The cam."""
        return self.course.cam

    @cached_property
    def travel(self) -> Travel:
        """S, S', S''."""
        return self.course.at(self.turned, self.before)

    @cached_property
    def jerk(self) -> Floats:
        """S''', m/rad3."""
        found = np.zeros_like(self.turned)
        for one in self.cam.moving():
            here = self.within(one)
            if one.law is not None:
                share = np.clip((self.turned[here] - one.start) / one.angle, 0.0, 1.0)
                found[here] = one.change / one.angle**3 * law_of(one.law).at(share, 3, self.before)
        return found

    def within(self, phase: Phase) -> npt.NDArray[np.bool_]:
        """Tell which turns lie in a phase, (N,): at its ends by the side that is taken."""
        phi = self.turned
        if self.before:
            return np.asarray((phase.start < phi) & (phi <= phase.end))
        return np.asarray((phase.start <= phi) & (phi < phase.end))

    @cached_property
    def heading(self) -> Points:
        """The unit direction in which the tip goes when S grows."""
        if not self.cam.rocks:
            return np.full_like(self.travel.s, 1j, dtype=complex)
        return np.asarray(1j * self.cam.rising * arm(self.cam, self.travel.s))

    @property
    def turns(self) -> float:
        """How the cam turns as φ grows: +1 counter-clockwise, -1 clockwise, 0 of one that translates."""
        return 0.0 if self.cam.translates else float(self.cam.sense)

    @cached_property
    def orders(self) -> tuple[Points, Points, Points, Points]:
        """K, K', K'', K''' of a pointed follower or a roller."""
        s, slope, bend = self.travel
        if not self.cam.rocks:
            start = complex(self.cam.sense * self.sizes.offset, guide_start(self.sizes))
            return _points(start + 1j * s, 1j * slope, 1j * bend, 1j * self.jerk)
        by = 1j * self.cam.rising
        reach = (self.cam.follower.length or 0.0) * arm(self.cam, s)
        first, second = by * slope, by * bend - slope**2
        third = by * self.jerk - 3 * slope * bend - by * slope**3
        return _points(self.sizes.pivot + reach, first * reach, second * reach, third * reach)

    @cached_property
    def trail(self) -> tuple[Points, Points, Points]:
        """Derivatives by φ of the curve that the tip leaves on the cam, as they stand in the frame."""
        k, first, second, third = self.orders
        w = 1j * self.turns
        if self.cam.translates:
            return first + self.cam.sense, second, third
        return first - w * k, second - 2 * w * first - k, third - 3 * w * second - 3 * first + w * k

    @cached_property
    def lever(self) -> Points:
        """OD of the book, square to the curve, out of the cam; its size is how fast the tip goes along it, m/rad."""
        return np.asarray(1j * self.cam.sense * self.trail[0])

    def on_cam(self, place: Points) -> Points:
        """Give the points of the cam, m, that are at places in the frame, (N,)."""
        if self.cam.translates:
            return np.asarray(place + self.cam.sense * self.turned)
        return np.asarray(place * np.exp(-1j * self.turns * self.turned))

    def in_frame(self, point: complex) -> Points:
        """Give where a point of the cam is in the frame at each turn, (N,) m."""
        if self.cam.translates:
            return np.asarray(point - self.cam.sense * self.turned)
        return np.asarray(point * np.exp(1j * self.turns * self.turned))


def _points(*orders: Vectors) -> tuple[Points, Points, Points, Points]:
    return cast(tuple[Points, Points, Points, Points], orders)
