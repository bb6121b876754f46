"""The involute pair by formulas (геометрический расчёт; GOST 16532-70, 19274-73): no curve is drawn."""

from __future__ import annotations

import math

import numpy as np

from plans.model.involute import HALVINGS, GearWheel, InvolutePair, PairSizes, WheelSizes
from plans.model.motion import Complexes, Floats

ANALYSIS = "analysis"
STEPS = 30  # of Newton's method: it doubles its digits with each


def inv(angle: float) -> float:
    """Give the involute function (эвольвентная функция).

    >>> round(inv(math.radians(20)), 6)
    0.014904
    """
    return math.tan(angle) - angle


def angle_of(value: float) -> float:
    """Give the angle whose involute function is a value of zero or above; NaN below.

    >>> round(math.degrees(angle_of(inv(math.radians(25)))), 12)
    25.0
    """
    if value <= 0:
        return 0.0 if value == 0 else math.nan
    angle = math.atan(math.cbrt(3 * value) + value)  # above the root, for small values and for large ones
    for _ in range(STEPS):
        step = (inv(angle) - value) / math.tan(angle) ** 2
        angle -= step
        if abs(step) <= 1e-16 * angle:
            break
    return angle


def solve(pair: InvolutePair) -> PairSizes:
    """Find all sizes of a pair."""
    return _Formulas(pair).sizes


class _Formulas:
    """A pair by formulas."""

    def __init__(self, pair: InvolutePair) -> None:
        self.pair, self.rack = pair, pair.rack
        span = pair.teeth[1] + pair.sense * pair.teeth[0]
        self.angle = angle_of(inv(self.rack.angle) + 2 * pair.total * math.tan(self.rack.angle) / span)
        self.distance = pair.standard * math.cos(self.rack.angle) / math.cos(self.angle)
        self.far = self.distance * math.sin(self.angle)  # N1N2
        self.levelled = pair.total - (self.distance - pair.standard) / self.rack.module  # Δy

    @property
    def sizes(self) -> PairSizes:
        (first, second), tangent = self.pair.wheels, math.tan(self.angle)
        # Of an internal wheel the tip is nearer to its base circle, and the line of action goes on beyond
        ratio = sum(one.inward * one.teeth * (self.roll(one) - tangent) for one in (first, second)) / math.tau
        wheels = self._wheel(first), self._wheel(second)
        return PairSizes(ANALYSIS, self.angle, self.distance, ratio * self.rack.base_pitch, ratio, wheels)

    def tip(self, wheel: GearWheel) -> float:
        """Give the tip radius, m: teeth of outer wheels are shortened by Δy, of a ring by k_2 - Δy."""
        high = self.rack.head + wheel.inward * wheel.shift
        if not self.pair.internal:
            high -= self.levelled
        elif wheel.internal:
            high += self.levelled - self.pair.tip_relief
        return wheel.radius + wheel.inward * self.rack.module * high

    def root(self, wheel: GearWheel) -> float:
        """Give the root radius, m."""
        deep = self.rack.head + self.rack.clearance - wheel.inward * wheel.shift
        return wheel.radius - wheel.inward * self.rack.module * deep

    def roll(self, wheel: GearWheel) -> float:
        """Give the tangent of the profile angle at the tip."""
        return math.sqrt(max((self.tip(wheel) / wheel.base) ** 2 - 1, 0.0))

    def facing(self, wheel: GearWheel, curvature: float) -> float:
        """Give the radius of curvature of the other flank where that of a wheel is known, m."""
        if not self.pair.internal:
            return self.far - curvature
        return curvature - self.far if wheel.internal else curvature + self.far

    def _sliding(self, wheel: GearWheel) -> float:
        """Give the specific sliding at the foot: 1 less the ratio of the velocities along the flanks."""
        other = self.pair.wheels[2 - wheel.number]
        own = self.facing(other, other.base * self.roll(other))
        return 1 - wheel.teeth / other.teeth * self.facing(wheel, own) / own

    def _wheel(self, wheel: GearWheel) -> WheelSizes:
        tip = self.tip(wheel)
        chord, height = self._chord(wheel, tip)
        operating = wheel.base / math.cos(self.angle)
        thickness = math.tau * wheel.radius / wheel.teeth - wheel.width if wheel.internal else wheel.width
        return WheelSizes(
            operating, tip, self.root(wheel), thickness, self._thick(wheel, self.angle, operating),
            self._thick(wheel, math.atan(self.roll(wheel)), tip), chord, height,
            self._span(wheel), *self._over(wheel, tip), self._sliding(wheel),
        )  # fmt: skip

    def _thick(self, wheel: GearWheel, angle: float, radius: float) -> float:
        """Give the thickness of a tooth on a circle, by the profile angle there."""
        half = wheel.width / (2 * wheel.radius) + inv(self.rack.angle) - inv(angle)
        return radius * (math.tau / wheel.teeth - 2 * half if wheel.internal else 2 * half)

    def _chord(self, wheel: GearWheel, tip: float) -> tuple[float, float]:
        """Give the constant chord and its height, where it ends on the involute; an internal wheel has none."""
        sine, cosine = math.sin(self.rack.angle), math.cos(self.rack.angle)
        if wheel.internal or not self._within(wheel, wheel.radius * sine + wheel.width * cosine / 2):
            return math.nan, math.nan
        chord = wheel.width * cosine**2
        return chord, tip - wheel.radius - chord * math.tan(self.rack.angle) / 2

    def _span(self, wheel: GearWheel) -> float:
        """Give the length of the common normal, m."""
        arc = math.pi * (wheel.spanned - 0.5) + 2 * wheel.shift * math.tan(self.rack.angle)
        return self.rack.module * math.cos(self.rack.angle) * (arc + wheel.teeth * inv(self.rack.angle))

    def _over(self, wheel: GearWheel, tip: float) -> tuple[float, float]:
        """Give the first pins that touch the flanks and stand over the tips, and the size over them or between, m."""
        half = wheel.width / (2 * wheel.radius) + inv(self.rack.angle)
        free = half if wheel.internal else half - math.pi / wheel.teeth
        across = math.cos(math.pi / 2 / wheel.teeth) if wheel.teeth % 2 else 1.0
        for pin in wheel.pins:
            angle = angle_of(free + wheel.inward * pin / (2 * wheel.base))
            far = 2 * wheel.base / math.cos(angle) * across
            size, touched = far + wheel.inward * pin, wheel.base * math.tan(angle) - wheel.inward * pin / 2
            if self._within(wheel, touched) and (size - 2 * tip) * wheel.inward > 0:
                return pin, size
        return math.nan, math.nan

    def _within(self, wheel: GearWheel, curvature: float) -> bool:
        """Tell whether the involute of a wheel reaches a radius of curvature, m."""
        end, tip = foot(wheel, self.root(wheel)), self.roll(wheel)
        return (curvature / wheel.base - end) * (curvature / wheel.base - tip) <= 0


def flank(wheel: GearWheel, tip: float, root: float, count: int) -> Complexes:
    """Give the right side of a space, its middle on the y axis above the wheel's centre, m.

    So many points of what the tool's corner leaves, from the root circle; then an involute by its polar equation.
    """
    half = wheel.width / (2 * wheel.radius) + inv(wheel.rack.angle)  # of a tooth, of a ring's space, at the base circle
    high = math.sqrt((tip / wheel.base) ** 2 - 1)
    begin = foot(wheel, root)
    if wheel.internal:
        rolls = np.linspace(begin, high, count)[1:]
        spots = _polar(wheel.base, rolls, half - rolls + np.arctan(rolls))
        return np.concatenate([_ring_corner(wheel, half, root, count), spots])
    depth = (wheel.rack.straight - wheel.shift) * wheel.rack.module
    low, up = wheel.rack.angle, math.pi / 2  # the normals of the fillet where it joins the involute or crosses it
    for _ in range(HALVINGS if begin < 0 else 0):
        lean = (low + up) / 2
        spot = complex(_trochoid(wheel, depth, np.array([lean]))[0])
        roll = math.sqrt(max((abs(spot) / wheel.base) ** 2 - 1, 0.0))
        beyond = roll > 0 and math.atan2(spot.real, spot.imag) < math.pi / wheel.teeth - half + roll - math.atan(roll)
        low, up = (lean, up) if beyond else (low, lean)
    begin = roll if begin < 0 else begin
    rolls = np.linspace(begin, high, count)[1:]
    spots = _polar(wheel.base, rolls, math.pi / wheel.teeth - half + rolls - np.arctan(rolls))
    return np.concatenate([_trochoid(wheel, depth, np.linspace(math.pi / 2, low, count)), spots])


def foot(wheel: GearWheel, root: float) -> float:
    """Give the tangent of the profile angle where the involute begins: below 0 of a wheel that is undercut."""
    if wheel.internal:
        corner = wheel.corner(root)
        return (math.sqrt((root - corner) ** 2 - wheel.base**2) + corner) / wheel.base
    depth = (wheel.rack.straight - wheel.shift) * wheel.rack.module
    return math.tan(wheel.rack.angle) - depth / math.sin(wheel.rack.angle) / wheel.base


def _polar(base: float, rolls: Floats, off: Floats) -> Complexes:
    return np.asarray(1j * base * np.sqrt(1 + rolls**2) * np.exp(-1j * off))


def _trochoid(wheel: GearWheel, depth: float, lean: Floats) -> Complexes:
    """Give the curve at the corner's radius beside the path of its centre: it begins square to the root circle."""
    rack, r = wheel.rack, wheel.radius
    corner = rack.rounding * rack.module
    over = depth - corner * math.sin(rack.angle)  # from the pitch line down to the path of the corner's centre
    across = over / np.tan(lean)  # of the corner's centre c by the normal: c' = r + i c
    turned = (across - rack.land * rack.module) / r
    return np.asarray((across + 1j * (r - over) + corner * np.exp(-1j * lean)) * np.exp(1j * turned))


def _ring_corner(wheel: GearWheel, half: float, root: float, count: int) -> Complexes:
    """Give the arc between root circle and involute of an internal wheel."""
    corner, low = wheel.corner(root), foot(wheel, root)
    string = low * wheel.base - corner
    off = half - corner / wheel.base - string / wheel.base + math.atan(string / wheel.base)
    lean = np.linspace(off, half - low + math.pi / 2, count)  # of the corner's radius, from the y axis
    return np.asarray(1j * ((root - corner) * np.exp(-1j * off) + corner * np.exp(-1j * lean)))


def sliding(pair: InvolutePair, places: Floats) -> tuple[Floats, Floats]:
    """Give the specific sliding of both wheels at distances from N1 along the line of action, m."""
    far = _Formulas(pair).far
    others = far - places if pair.sense > 0 else far + places
    ratio = pair.teeth[0] / pair.teeth[1]
    return np.asarray(1 - ratio * others / places), np.asarray(1 - places / (ratio * others))
