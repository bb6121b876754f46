"""The involute pair (эвольвентная передача): two wheels cut by one rack, and what either road finds of them.

Values alone, SI: m and radians. The pole P is the origin, the line of centres the y axis, wheel 1 below; the line of
action rises to the right. Of an internal wheel the spaces are told as the teeth of an outer wheel would be.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

from plans.model.motion import Gap

EPS = 2.0**-52
PINS = {False: (1.7, 1.92), True: (1.5, 1.68)}  # diameters for outer wheels, for rings, in modules: usual, larger
HALVINGS = 60  # of an interval: the last is one rounding
TIP_ROUNDING = 0.38  # of the module: the radius of the rack's rounded tip by GOST 13755
# Of the rack's first choice by GOST 9563-60, mm, and its second.
MODULES = (
    0.05, 0.06, 0.08, 0.1, 0.12, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.8,
    1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 12, 16, 20, 25, 32, 40, 50, 60, 80, 100,
)  # fmt: skip
SECOND = (
    0.055, 0.07, 0.09, 0.11, 0.14, 0.18, 0.22, 0.28, 0.35, 0.45, 0.55, 0.7, 0.9,
    1.125, 1.375, 1.75, 2.25, 2.75, 3.5, 4.5, 5.5, 7, 9, 11, 14, 18, 22, 28, 36, 45, 55, 70, 90,
)  # fmt: skip


class Rack(NamedTuple):
    """The basic rack (исходный контур): module m, angle rad, head and clearance in modules."""

    module: float
    angle: float
    head: float = 1.0
    clearance: float = 0.25

    @property
    def pitch(self) -> float:
        """The pitch p, m."""
        return math.pi * self.module

    @property
    def base_pitch(self) -> float:
        """The base pitch p_b, m."""
        return self.pitch * math.cos(self.angle)

    @property
    def rounding(self) -> float:
        """The radius of its tip's corner, in modules: no larger than the clearance and the tip have room for."""
        sine, slope = math.sin(self.angle), math.tan(self.angle)
        wide = (math.pi / 4 - (self.head + self.clearance) * slope) / (math.cos(self.angle) - (1 - sine) * slope)
        return min(TIP_ROUNDING, self.clearance / (1 - sine), wide)

    @property
    def straight(self) -> float:
        """How deep below its mean line the flank is straight, in modules."""
        return self.head + self.clearance - self.rounding * (1 - math.sin(self.angle))

    @property
    def land(self) -> float:
        """How far from the middle of its tip a corner's centre lies, in modules."""
        return max(math.pi / 4 - self.straight * math.tan(self.angle) - self.rounding * math.cos(self.angle), 0.0)


class GearWheel(NamedTuple):
    """A wheel of the pair as it is given: teeth z, shift x in modules, whether its teeth point inward."""

    rack: Rack
    number: int
    teeth: int
    shift: float
    internal: bool = False

    @property
    def radius(self) -> float:
        """The radius r of the pitch circle (делительная окружность), m."""
        return self.rack.module * self.teeth / 2

    @property
    def base(self) -> float:
        """The radius r_b of the base circle (основная окружность), m."""
        return self.radius * math.cos(self.rack.angle)

    @property
    def width(self) -> float:
        """The thickness s of a tooth, of an internal wheel the width e of a space, on the pitch circle, m."""
        return self.rack.module * (math.pi / 2 + 2 * self.shift * math.tan(self.rack.angle))

    @property
    def inward(self) -> int:
        """-1 of an internal wheel."""
        return -1 if self.internal else 1

    @property
    def pins(self) -> tuple[float, ...]:
        """The diameters of the pins by which it may be measured, the usual first, m."""
        return tuple(size * self.rack.module for size in PINS[self.internal])

    @property
    def spanned(self) -> int:
        """Over how many teeth, of a ring spaces, the common normal ends nearest to the circle r + x m."""
        cosine = min(self.base / max(self.radius + self.shift * self.rack.module, self.base), 1.0)
        wide = (
            math.tan(math.acos(cosine)) - self.width / (2 * self.radius) - math.tan(self.rack.angle) + self.rack.angle
        )
        return max(math.floor(self.teeth / math.pi * wide + 1.5), 1)

    def corner(self, root: float) -> float:
        """Give the radius of the tool's corner that rounds the spaces of an internal wheel, m: the rack's, or less.

        Two corners of a narrow space meet in its middle; 0 where it comes to a point above its root circle.
        """
        low, high = 0.0, self.rack.rounding * self.rack.module
        for _ in range(HALVINGS if self._free(root, high) < 0 else 0):
            middle = (low + high) / 2
            low, high = (middle, high) if self._free(root, middle) > 0 else (low, middle)
        return low if self._free(root, high) < 0 else high

    def _free(self, root: float, corner: float) -> float:
        """Give the angle from the middle of an internal wheel's space to the centre of a corner, rad."""
        slope = math.sqrt(max(((root - corner) / self.base) ** 2 - 1, 0.0))
        half = self.width / (2 * self.radius) + math.tan(self.rack.angle) - self.rack.angle
        return half - corner / self.base - slope + math.atan(slope)


@dataclass(frozen=True)
class InvolutePair:
    """What is given of a pair: its rack, both wheels; what its shifts were chosen for, where they were."""

    rack: Rack
    teeth: tuple[int, int]
    shifts: tuple[float, float]
    internal: bool = False
    aims: tuple[str, ...] = ()

    @property
    def wheels(self) -> tuple[GearWheel, GearWheel]:
        """The wheels, the driving one first."""
        first, second = zip(self.teeth, self.shifts, strict=True)
        return GearWheel(self.rack, 1, *first), GearWheel(self.rack, 2, *second, internal=self.internal)

    @property
    def sense(self) -> int:
        """+1 of external gearing, -1 of internal."""
        return -1 if self.internal else 1

    @property
    def total(self) -> float:
        """The shift that moves the axes apart, in modules: the sum of the shifts, of an internal pair x_2 - x_1."""
        first, second = self.shifts
        return second + self.sense * first

    @property
    def standard(self) -> float:
        """The centre distance a without shift, m."""
        return self.rack.module * (self.teeth[1] + self.sense * self.teeth[0]) / 2

    @property
    def tip_relief(self) -> float:
        """What the teeth of an internal wheel are shortened by lest they meet the pinion's fillet, in modules."""
        return max(0.25 - 0.125 * self.shifts[1], 0.0) if self.internal else 0.0


class WheelSizes(NamedTuple):
    """The sizes of a wheel in its pair, m: operating, tip and root radius, thickness of a tooth at tip and elsewhere.

    `chord` and `height` are the constant chord and its height, `span` is the common normal, `over` the size over pins
    of diameter `pin`, of a ring between them; `sliding` is the specific sliding at the tooth's foot. NaN is of none.
    """

    operating: float
    tip: float
    root: float
    thickness: float  # of a tooth on the pitch circle
    operating_thickness: float
    tip_thickness: float
    chord: float
    height: float
    span: float
    pin: float
    over: float
    sliding: float


class PairSizes(NamedTuple):
    """The sizes of a pair by one road: angle of action rad, centre distance m, the active part, both wheels."""

    by: str
    angle: float
    distance: float
    active: float  # the length of B1B2, m
    ratio: float  # the contact ratio
    wheels: tuple[WheelSizes, WheelSizes]

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """Where nothing is found: a pair that is drawn has no gap."""
        return ()
