"""What presses the follower on the cam: force at the contact, lift-off, the spring needed, wear (силы, износ, M6.2)."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from plans.cam.centre.sizes import sizing
from plans.cam.course import FollowerCourse
from plans.cam.profile.profile import curvature, curvature_slope, slip, slip_slope
from plans.cam.profile.touch import FaceTouch, Stretches, Tip, TurnSide, Value
from plans.model.cam import NO_SIZES, RETURN, RISE, Cam, FollowerLoad, Phase, interval_of
from plans.model.cam_motion import BEND, HARD, SLOPE, CamError, CamSizes, Extreme, Pressing
from plans.model.motion import Floats


def pressure(tip: Tip) -> Floats:
    """Give the pressure angle, rad."""
    if tip.cam.flat:
        return FaceTouch(tip).pressure
    return np.asarray(tip.cam.sense * np.angle(tip.lever / tip.heading))


def pressure_slope(tip: Tip) -> Floats:
    """Give its derivative by the turn."""
    if tip.cam.flat:
        return FaceTouch(tip).pressure_slope
    _, first, second, _ = tip.orders
    lever = abs(tip.turns) * first + 1j * tip.cam.sense * second
    turning = tip.cam.rising * tip.travel.slope if tip.cam.rocks else 0.0
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(tip.cam.sense * ((lever / tip.lever).imag - turning))


ALIKE = 1e-9  # of the largest: sizes that were found by a limit touch it twice, alike but for rounding


@dataclass(frozen=True)
class ProfileExtremes:
    """The extremes of a cam's profile, each with its place; corners of the law and ends of dwells are legal places."""

    stretches: Stretches

    @cached_property
    def outrun(self) -> Extreme | None:
        """Where a rocker's face turns as fast as the cam, or faster, most of all: it touches nowhere then."""
        cam = self.stretches.course.cam
        if not (cam.flat and cam.rocks):
            return None
        places = self.stretches.places(lambda tip: tip.travel.bend)
        most = self.stretches.most(lambda tip: 1 - FaceTouch(tip).lead, places)
        return most if most and most.value >= 1 else None

    @cached_property
    def peaks(self) -> dict[str, Extreme]:
        """The largest S' and S'' by their size, signed; at a hard shock S'' has none."""
        rows: dict[str, tuple[Value, Value]] = {
            SLOPE: (lambda tip: tip.travel.slope, lambda tip: tip.travel.bend),
            BEND: (lambda tip: tip.travel.bend, lambda tip: tip.jerk),
        }
        if any(shock.order == HARD for shock in self.stretches.course.shocks):
            del rows[BEND]
        found = {name: self._largest(value, self.stretches.places(slope)) for name, (value, slope) in rows.items()}
        return {name: extreme for name, extreme in found.items() if extreme is not None}

    @cached_property
    def turning(self) -> tuple[TurnSide, ...]:
        """Where the pressure angle can be largest."""
        return self.stretches.places(pressure_slope)

    @cached_property
    def pressure(self) -> dict[str, Extreme]:
        """The largest pressure angle by its size on every kind of phase that there is, signed."""
        kinds = () if self.outrun else dict.fromkeys(phase.kind for phase in self.stretches.course.cam.moving())
        return {kind: found for kind in kinds if (found := self._largest(pressure, self._turning_on(kind))) is not None}

    def _turning_on(self, kind: str) -> tuple[TurnSide, ...]:
        phases = [phase for phase in self.stretches.course.cam.phases if phase.kind == kind]
        return tuple(place for place in self.turning if any(within(place, phase) for phase in phases))

    def _largest(self, value: Value, places: tuple[TurnSide, ...]) -> Extreme | None:
        """Give the largest of a value by its size, signed: of two alike the one above 0, and the earlier."""
        found = self.stretches.most(lambda tip: np.abs(value(tip)), places)
        if found is None:
            return None
        signed = self.stretches.read(value, places)
        alike = np.flatnonzero(np.abs(signed) >= found.value * (1 - ALIKE))
        best = min(alike.tolist(), key=lambda k: (signed[k] < 0, places[k].turned))
        return Extreme(float(signed[best]), places[best].turned)

    @cached_property
    def bends(self) -> tuple[TurnSide, ...]:
        """Where the curve can be sharpest."""
        flat = self.stretches.course.cam.flat
        return self.stretches.places((lambda tip: FaceTouch(tip).radius_slope) if flat else curvature_slope)

    @cached_property
    def sharpest(self) -> Extreme | None:
        """The least convex radius of the theoretical profile; of the profile under a flat face the least, signed."""
        if self.outrun:
            return None
        if self.stretches.course.cam.flat:
            found = self.stretches.most(lambda tip: -FaceTouch(tip).radius, self.bends)
            return found and Extreme(-found.value, found.turned).cusp(self.stretches.sizes.base)
        found = self.stretches.most(curvature, self.bends)
        return Extreme(1 / found.value, found.turned) if found and found.value > 0 else None

    @cached_property
    def hollow(self) -> Extreme | None:
        """The smallest hollow radius by size, below 0."""
        if self.stretches.course.cam.flat:
            return None
        found = self.stretches.most(lambda tip: -curvature(tip), self.bends)
        return Extreme(-1 / found.value, found.turned) if found and found.value > 0 else None

    @cached_property
    def face(self) -> tuple[float, float]:
        """Where contact on a flat face is farthest to both sides, m: the least and the greatest place."""
        if not self.stretches.course.cam.flat or self.outrun:
            return 0.0, 0.0
        places = self.stretches.places(lambda tip: FaceTouch(tip).place_slope)
        found = self.stretches.read(lambda tip: FaceTouch(tip).place, places)
        return float(np.nanmin(found)), float(np.nanmax(found))


def within(place: TurnSide, phase: Phase) -> bool:
    """Tell whether a place belongs to a phase: on a joint by its side.

    >>> within(TurnSide(1.0, before=True), Phase("dwell", 1.0, 0.0, 0.0, 0.0))
    True
    """
    if place.before:
        return phase.start < place.turned <= phase.end
    return phase.start <= place.turned < phase.end


def base_needed(stretches: Stretches) -> float | None:
    """Give R0, m, with which the pressure angle keeps to its limits; None of a rocker, a flat face, a cam on a bar.

    Every position asks for S0 >= (S' - e)/tan α - S with both limits α: the lines of the S-S' diagram through O at the
    offset e.
    """
    cam = stretches.course.cam
    intervals = {kind: interval for kind in (RISE, RETURN) if (interval := interval_of(cam, kind)) is not None}
    if cam.rocks or cam.flat or cam.translates or not intervals:
        return None
    asked = [_height(stretches, kind, 1 / math.tan(end)) for kind, interval in intervals.items() for end in interval]
    return math.hypot(max(0.0, *asked), stretches.sizes.offset)


def base_convex(extremes: ProfileExtremes) -> float | None:
    """Give R0, m, with which the profile under a flat face is convex and as its limit asks; None where none does.

    R0 is added to the radius of curvature everywhere. A rocker's is not, and where S' falls at once no R0 helps.
    """
    course, sharpest = extremes.stretches.course, extremes.sharpest
    falls = any(shock.order == HARD and shock.jump < 0 for shock in course.shocks)
    if course.cam.rocks or not course.cam.flat or sharpest is None or falls:
        return None
    return extremes.stretches.sizes.base - sharpest.value + course.cam.limits.curvature


def sizes_advised(cam: Cam) -> CamSizes | None:
    """Give the sizes that the limits alone would give; None where there are none, of a flat face, of a cam on a bar."""
    if cam.flat or cam.translates:
        return None
    try:
        return sizing(FollowerCourse(replace(cam, given=NO_SIZES))).sizes
    except CamError:
        return None


def _height(stretches: Stretches, kind: str, slope: float) -> float:
    """Give the S0 that the positions on a kind of phase ask for, to one side."""
    offset = stretches.sizes.offset

    def height(tip: Tip) -> Floats:
        asked = (tip.travel.slope - offset) * slope - tip.travel.s
        return np.where(on(tip, kind), asked, -np.inf)

    places = stretches.places(lambda tip: tip.travel.bend * slope - tip.travel.slope)
    found = stretches.most(height, places)
    return found.value if found else 0.0


def on(tip: Tip, kind: str) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Tell which turns are on a kind of phase: on a joint by the side that is taken."""
    sides = [tip.within(phase) for phase in tip.cam.phases if phase.kind == kind]
    return np.any(sides, axis=0) if sides else np.zeros(len(tip.turned), dtype=bool)


NOTHING = Extreme(np.nan, 0.0)  # of a force that no turn bears: the normal stands across the follower's way


@dataclass(frozen=True)
class Contact:
    """The contact of a loaded follower with a cam that goes at its speed, without friction."""

    load: FollowerLoad
    speed: float
    roller: float  # m

    def resistance(self, tip: Tip) -> Floats:
        """Give what the cam overcomes along the follower's way, N; of a rocker its moment, N*m."""
        s, _, bend = tip.travel
        load = self.load
        return load.mass * self.speed**2 * bend + load.preload + load.stiffness * s + load.force

    def resistance_slope(self, tip: Tip) -> Floats:
        """Give its derivative by the turn."""
        return self.load.mass * self.speed**2 * tip.jerk + self.load.stiffness * tip.travel.slope

    def force(self, tip: Tip) -> Floats:
        """Give the force on the follower along the normal, N: below 0 the cam would have to pull."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return self.resistance(tip) / _arm(tip)

    def force_slope(self, tip: Tip) -> Floats:
        """Give its derivative by the turn."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return (self.resistance_slope(tip) - self.force(tip) * _arm_slope(tip)) / _arm(tip)

    def wear(self, tip: Tip) -> Floats:
        """Give force times sliding speed, W: friction takes it times its coefficient, and what wears goes by it."""
        return np.abs(self.force(tip) * self._slip(tip)) * self.speed

    def wear_slope(self, tip: Tip) -> Floats:
        """Give the derivative of that by the turn, of any sign and in any scale: where it vanishes matters."""
        return self.force_slope(tip) * self._slip(tip) + self.force(tip) * self._slip_slope(tip)

    def _slip(self, tip: Tip) -> Floats:
        return FaceTouch(tip).slip if tip.cam.flat else slip(tip, tip.lever, self.roller)

    def _slip_slope(self, tip: Tip) -> Floats:
        return FaceTouch(tip).slip_slope if tip.cam.flat else slip_slope(tip, self.roller)


def contact_of(cam: Cam, roller: float) -> Contact | None:
    """Give the contact, where the scene asks for it: with a load and a speed."""
    return None if cam.load is None or cam.speed is None else Contact(cam.load, cam.speed, roller)


def pressing(contact: Contact, stretches: Stretches) -> Pressing:
    """Give the extremes of the force and of the wear, and the preload that holds the follower on the cam."""
    forces = stretches.places(contact.force_slope)
    low = stretches.most(lambda tip: -contact.force(tip), forces)
    lack = stretches.most(lambda tip: -contact.resistance(tip), stretches.places(contact.resistance_slope))
    return Pressing(
        least=Extreme(-low.value, low.turned) if low else NOTHING,
        most=stretches.most(contact.force, forces) or NOTHING,
        wear=stretches.most(contact.wear, stretches.places(contact.wear_slope)) or NOTHING,
        preload=contact.load.preload + max(lack.value if lack else 0.0, 0.0),
    )


def _arm(tip: Tip) -> Floats:
    """Give what the force is multiplied by along the follower's way: cos α, of a rocker its arm about the pivot, m."""
    if tip.cam.flat:
        return FaceTouch(tip).place if tip.cam.rocks else np.ones_like(tip.turned)
    return _length(tip) * np.cos(pressure(tip))


def _arm_slope(tip: Tip) -> Floats:
    if tip.cam.flat:
        return FaceTouch(tip).place_slope if tip.cam.rocks else np.zeros_like(tip.turned)
    return -_length(tip) * np.sin(pressure(tip)) * pressure_slope(tip)


def _length(tip: Tip) -> float:
    return tip.cam.follower.length or 0.0 if tip.cam.rocks else 1.0
