"""The contour of a cam by the follower's course, and where the follower touches it (профиль кулачка)."""

from __future__ import annotations

import cmath
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from plans.analytic.cam.laws import travel
from plans.model.cam import GROOVE, Cam, FollowerLoad
from plans.model.cam_motion import CamSizes, Contour, FollowerTravel, Points
from plans.model.motion import Floats


class ContactForces(NamedTuple):
    """A loaded follower on a cam that goes at its speed, without friction."""

    load: FollowerLoad
    speed: float
    roller: float  # m

    def along(self, curve: ContourValues) -> Floats:
        """Give what the cam overcomes along the follower's way, N; of a rocker its moment, N*m."""
        s, _, bend = curve.travel
        spring = self.load.preload + s * self.load.stiffness
        return np.asarray(self.load.force + spring + bend * (self.load.mass * self.speed * self.speed))

    def normal(self, curve: ContourValues) -> Floats:
        """Give the force along the normal, N: its point goes by OD's part along the way for a unit of the normal's."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(self.along(curve) / self._gear(curve))

    @staticmethod
    def _gear(curve: ContourValues) -> Floats:
        """Give how far the point of contact goes along the normal while S grows by 1."""
        if curve.cam.flat:
            return curve.place if curve.cam.rocks else np.ones_like(curve.turned)
        return (curve.length if curve.cam.rocks else 1.0) * curve.parts[1] / curve.speed

    def wear(self, curve: ContourValues) -> Floats:
        """Give force times sliding speed, W."""
        return np.abs(self.normal(curve) * curve.slip(self.roller)) * self.speed


def forces_of(cam: Cam, roller: float) -> ContactForces | None:
    """Give the forces, where the scene asks for them: with a load and a speed."""
    return None if cam.load is None or cam.speed is None else ContactForces(cam.load, cam.speed, roller)


def mirrored(cam: Cam, points: Points) -> Points:
    """Mirror points of a cam that turns clockwise in the y axis, and back."""
    return points if cam.sense > 0 else -np.conj(points)


@dataclass(frozen=True)
class ContourValues:
    """What the closed forms give at N turns of a cam, (N,) each; `before` takes the sides before a joint."""

    cam: Cam
    sizes: CamSizes
    turned: Floats
    before: bool = False

    @cached_property
    def travel(self) -> FollowerTravel:
        """S, S', S''."""
        return travel(self.cam, self.turned, self.before)

    @cached_property
    def height(self) -> Floats:
        """S0 + S over O."""
        base, offset = self.sizes.base, self.sizes.offset
        return np.asarray((base * base - offset * offset) ** 0.5 + self.travel.s)

    @cached_property
    def theta(self) -> Floats:
        """The direction of a rocker from its pivot, rad."""
        swung = self.travel.s - self.cam.lift / 2
        return swung if self.cam.follower.sense > 0 else np.pi - swung

    @property
    def rates(self) -> tuple[Floats, Floats]:
        """θ' and θ''."""
        return self.cam.follower.sense * self.travel.slope, self.cam.follower.sense * self.travel.bend

    @cached_property
    def pivot(self) -> tuple[float, float]:
        """The distance of centres, and the direction of the pivot from O."""
        size, angle = cmath.polar(self.sizes.pivot)
        return size, angle if self.cam.sense > 0 else np.pi - angle

    @cached_property
    def delta(self) -> Floats:
        """δ, rad."""
        return self.theta - self.pivot[1]

    @property
    def length(self) -> float:
        """The length of the rocker, m."""
        return self.cam.follower.length or 0.0

    @cached_property
    def tip(self) -> tuple[Floats, Floats]:
        """x and y of the tip, or of contact under a flat face."""
        if self.cam.flat:
            return self._contact
        if not self.cam.rocks:
            return np.full_like(self.turned, self.sizes.offset), self.height
        size, angle = self.pivot
        x = size * np.cos(angle) + self.length * np.cos(self.theta)
        return x, size * np.sin(angle) + self.length * np.sin(self.theta)

    @cached_property
    def parts(self) -> tuple[Floats, Floats]:
        """OD across the way of the tip, and along it: their ratio is the tangent of the pressure angle."""
        if not self.cam.rocks:
            upright = self.travel.slope - self.sizes.offset, self.height
            return (self.travel.slope, np.ones_like(self.turned)) if self.cam.translates else upright
        rate, sense = self.rates[0], self.cam.follower.sense
        if self.cam.translates:
            return -sense * (np.sin(self.theta) - self.length * rate), sense * np.cos(self.theta)
        across = self.length * (1 - rate) + self.pivot[0] * np.cos(self.delta)
        return -sense * across, -sense * self.pivot[0] * np.sin(self.delta)

    @cached_property
    def speed(self) -> Floats:
        """How fast the tip goes along its curve on the cam, m/rad."""
        return np.hypot(*self.parts)

    @cached_property
    def way(self) -> Floats:
        """The direction in which the tip goes when S grows, rad."""
        turned = np.full_like(self.turned, np.pi / 2)
        return self.theta + self.cam.follower.sense * np.pi / 2 if self.cam.rocks else turned

    @cached_property
    def normal(self) -> Floats:
        """The direction of the normal out of the cam, rad."""
        return self.way if self.cam.flat else self.way + np.arctan2(*self.parts)

    @cached_property
    def pressure(self) -> Floats:
        """The pressure angle, rad: (5.28), and of a rocker by its own triangle."""
        if not self.cam.flat:
            return np.arctan2(*self.parts)
        if not self.cam.rocks:
            return np.zeros_like(self.turned)
        return -self.cam.follower.sense * np.arctan2(self.cam.follower.face, self.place)

    @cached_property
    def curvature(self) -> Floats:
        """1 over the radius of curvature of the tip's curve, 1/m."""
        return self._turning / self.speed**3

    @property
    def _turning(self) -> Floats:
        """Give speed times how fast the normal turns."""
        if not self.cam.rocks:
            _, slope, bend = self.travel
            if self.cam.translates:
                return -bend
            a, b = self.height, slope - self.sizes.offset
            return a * a + b * (2 * slope - self.sizes.offset) - a * bend
        (rate, bend), length = self.rates, self.length
        if self.cam.translates:
            return -length * (length * rate**3 + bend * np.cos(self.theta) - rate**2 * np.sin(self.theta))
        lead, centre, cosine = 1 - rate, self.pivot[0], np.cos(self.delta)
        mixed = lead * (1 + lead) * cosine + bend * np.sin(self.delta)
        return np.asarray(centre**2 + length**2 * lead**3 + length * centre * mixed)

    @cached_property
    def radius(self) -> Floats:
        """The radius of curvature, m; under a flat face that of the profile."""
        if not self.cam.flat:
            with np.errstate(divide="ignore"):
                return np.asarray(1 / self.curvature)
        if not self.cam.rocks:
            return self.sizes.base + self.travel.s + self.travel.bend
        (rate, bend), lead = self.rates, self.lead
        out, aside = self._centre
        return out + self.cam.follower.face + bend * aside / lead**3 - rate**2 * out / lead**2

    @property
    def lead(self) -> Floats:
        """1 - θ' of a rocker."""
        return 1 - self.rates[0]

    @property
    def _centre(self) -> tuple[Floats, Floats]:
        """Give the pivot's place along the normal of its face, and along the face to the left of the normal."""
        off = self.pivot[1] - self.way
        return self.pivot[0] * np.cos(off), self.pivot[0] * np.sin(off)

    @cached_property
    def place(self) -> Floats:
        """Where a flat face touches, from its axis or from under its pivot, m."""
        if not self.cam.rocks:
            return self.travel.slope
        return self.cam.follower.sense * self._centre[1] / self.lead

    @property
    def _contact(self) -> tuple[Floats, Floats]:
        """Give the contact of a flat face: by its support function, the distance of the face from O."""
        if not self.cam.rocks:
            return self.travel.slope, self.sizes.base + self.travel.s
        out, aside = self._centre
        far, along = out + self.cam.follower.face, -self.rates[0] * aside / self.lead
        cosine, sine = np.cos(self.way), np.sin(self.way)
        return far * cosine - along * sine, far * sine + along * cosine

    def slip(self, roller: float) -> Floats:
        """How fast the follower's surface slips on the cam, m/rad; a roller as if it were stuck on its pin."""
        turning = self.rates[0] if self.cam.rocks else 0.0
        if self.cam.flat:
            far = self._centre[0] + self.cam.follower.face if self.cam.rocks else self.sizes.base + self.travel.s
            return np.asarray(far - turning * self.cam.follower.face)
        return np.asarray(self.speed - roller * ((0.0 if self.cam.translates else 1.0) - turning))

    def edge(self, away: float) -> Points:
        """Give points on the cam, as it stands for them, `away` m out along the normal."""
        x, y = self.tip
        return self._back(x + away * np.cos(self.normal), y + away * np.sin(self.normal))

    def _back(self, x: Floats, y: Floats) -> Points:
        """Turn points of the frame back by the cam's turn, or shift them by its travel."""
        if self.cam.translates:
            return np.asarray(x + self.turned + 1j * y)
        cosine, sine = np.cos(self.turned), np.sin(self.turned)
        return np.asarray(x * cosine + y * sine + 1j * (y * cosine - x * sine))


def contour(cam: Cam, sizes: CamSizes, roller: float, turned: Floats, before: bool = False) -> Contour:
    """Give the profile at turns of the cam, rad, (N,)."""
    curve = ContourValues(cam, sizes, np.asarray(turned, dtype=float), before)
    x, y = curve.tip
    size = np.ones_like(curve.turned) if cam.flat else curve.speed
    return Contour(
        turned=curve.turned,
        travel=curve.travel,
        tip=mirrored(cam, x + 1j * y),
        lever=mirrored(cam, size * np.exp(1j * curve.normal)),
        pitch=mirrored(cam, curve.edge(0.0)),
        profile=mirrored(cam, curve.edge(-roller)),
        pressure=curve.pressure,
        radius=curve.radius,
        sliding=np.abs(curve.slip(roller)),
        outer=mirrored(cam, curve.edge(roller)) if cam.closure == GROOVE and not cam.flat else None,
    )
