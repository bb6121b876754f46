"""Where a flat face touches the cam, and how the profile bends there (плоский толкатель: место касания).

The face touches where the perpendicular from the relative instant centre of cam and follower meets it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plans.cam.profile.tip import Tip, arm
from plans.model.cam_motion import Points
from plans.model.motion import Floats


@dataclass(frozen=True)
class Touch:
    """The contact of a flat face at N turns of the cam: where along the face, the profile's radius, how it slides.

    Of a rocker the place is counted along the face from under its pivot, of one that translates from its axis, to where
    the cam carries it on a rise.
    """

    tip: Tip

    @cached_property
    def normal(self) -> Points:
        """The unit normal out of the cam."""
        return self.tip.heading

    @cached_property
    def lead(self) -> Floats:
        """How fast the cam turns under a rocker's face, in shares of its own speed."""
        return 1 - self.tip.cam.follower.sense * self.tip.travel.slope

    @cached_property
    def place(self) -> Floats:
        """Where the face touches, m."""
        return self._places[0] if self.tip.cam.rocks else self.tip.travel.slope

    @cached_property
    def place_slope(self) -> Floats:
        """Its derivative by the turn, m/rad."""
        return self._places[1] if self.tip.cam.rocks else self.tip.travel.bend

    @cached_property
    def _places(self) -> tuple[Floats, Floats, Floats]:
        """Give a rocker's place of contact and its derivatives: foot of O under the face, over the lead."""
        cam, (_, slope, bend), jerk = self.tip.cam, self.tip.travel, self.tip.jerk
        by, along = 1j * cam.rising, arm(cam, self.tip.travel.s)
        pivot, sense = np.conj(self.tip.sizes.pivot), cam.follower.sense
        foot = -(along * pivot).real
        foot_1 = -(by * slope * along * pivot).real
        foot_2 = -((by * bend - slope**2) * along * pivot).real
        place = foot / self.lead
        place_1 = (foot_1 + place * sense * bend) / self.lead
        return place, place_1, (foot_2 + 2 * place_1 * sense * bend + place * sense * jerk) / self.lead

    @cached_property
    def contact(self) -> Points:
        """Where the face touches, in the frame."""
        tip = self.tip
        if not tip.cam.rocks:
            return np.asarray(tip.cam.sense * self.place + 1j * self.height)
        return tip.sizes.pivot + tip.cam.follower.face * self.normal + self.place * arm(tip.cam, tip.travel.s)

    @property
    def sweep(self) -> Floats:
        """How fast contact goes along the profile, m/rad: above 0 against the cam's rotation, as it should."""
        return self._sweeps[0] if self.tip.cam.rocks else self.radius

    @cached_property
    def height(self) -> Floats:
        """The distance of the face from O along its normal, m."""
        tip = self.tip
        if not tip.cam.rocks:
            return tip.sizes.base + tip.travel.s
        return np.asarray((self.normal * np.conj(tip.sizes.pivot)).real + tip.cam.follower.face)

    @cached_property
    def radius(self) -> Floats:
        """The radius of curvature of the profile, m: below 0 it would be hollow."""
        if not self.tip.cam.rocks:
            return self.tip.sizes.base + self.tip.travel.s + self.tip.travel.bend
        return self._sweeps[0] / self.lead

    @cached_property
    def radius_slope(self) -> Floats:
        """Its derivative by the turn, m/rad."""
        if not self.tip.cam.rocks:
            return self.tip.travel.slope + self.tip.jerk
        sweep, slope = self._sweeps
        return (slope + sweep / self.lead * self.tip.cam.follower.sense * self.tip.travel.bend) / self.lead

    @cached_property
    def _sweeps(self) -> tuple[Floats, Floats]:
        """Give how fast contact goes along the profile, m/rad, and the derivative of that: of a rocker's face."""
        cam, (_, slope, bend) = self.tip.cam, self.tip.travel
        place, place_1, place_2 = self._places
        by, w, back = 1j * cam.rising, 1j * cam.sense, np.conj(self.normal)
        along, face = arm(cam, self.tip.travel.s), cam.follower.face * self.normal
        turn, turn_1 = by * slope, by * bend - slope**2
        first = turn * face + (place_1 + place * turn) * along
        second = turn_1 * face + (place_2 + 2 * place_1 * turn + place * turn_1) * along
        return (w * (first - w * self.contact) * back).real, (w * (second - w * first) * back).real

    @cached_property
    def slip(self) -> Floats:
        """How fast the face slips on the cam, m/rad: the distance of contact from the relative instant centre."""
        follower = self.tip.cam.follower
        return self.height - (follower.sense * self.tip.travel.slope * follower.face if self.tip.cam.rocks else 0.0)

    @cached_property
    def slip_slope(self) -> Floats:
        """Its derivative by the turn."""
        tip, follower = self.tip, self.tip.cam.follower
        if not tip.cam.rocks:
            return tip.travel.slope
        by = 1j * tip.cam.rising * tip.travel.slope
        lift = (by * self.normal * np.conj(tip.sizes.pivot)).real
        return np.asarray(lift - follower.sense * tip.travel.bend * follower.face)

    @cached_property
    def pressure(self) -> Floats:
        """The angle from the way of the point of contact, when S grows, to the normal, rad."""
        if not self.tip.cam.rocks:
            return np.zeros_like(self.tip.turned)
        follower = self.tip.cam.follower
        return -follower.sense * np.arctan2(follower.face, self.place)

    @cached_property
    def pressure_slope(self) -> Floats:
        """Its derivative by the turn."""
        if not self.tip.cam.rocks:
            return np.zeros_like(self.tip.turned)
        follower = self.tip.cam.follower
        return follower.sense * follower.face * self.place_slope / (self.place**2 + follower.face**2)
