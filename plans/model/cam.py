"""The cam as it is asked for: phases, laws, follower, limits, given sizes, loads (кулачковый механизм, задание).

Values alone, SI and radians. The cam's turn φ is counted from the beginning of its first phase, from 0, in the sense of
its rotation; of a cam that translates φ is its travel, m, and "angle" stands for a length. What the follower travels is
S: m, or rad of one that rocks.

The frame of every drawing: O, the cam's centre, is the origin, x to the right, y up; the rise is upwards. `sense` is +1
of a cam that turns counter-clockwise, -1 of one that turns clockwise; a cam that translates goes to the left with +1.
The axis of a follower that translates stands at x = sense*e. A rocker lies level at mid-swing, pointing away from its
pivot to the right if it rises counter-clockwise, to the left if clockwise.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

TURN = 2 * math.pi
MM = 1000.0  # of a metre
RISE, DWELL, RETURN = "rise", "dwell", "return"
TRANSLATING, ROCKING = "translating", "rocking"
POINTED, ROLLER, FLAT = "pointed", "roller", "flat"
FORCE, GROOVE = "force", "groove"
LAWS = (
    "constant velocity",
    "constant acceleration",
    "cosine",
    "sine",
    "3-4-5",
    "4-5-6-7",
    "trapezoid",
    "modified trapezoid",
    "modified sine",
)
TABLE, SHAPE = "table", "shape"  # laws that the user gives: by S over φ, by the shape of the acceleration
LINES, CUBICS = "lines", "cubics"  # what joins the points of a table
# What smoothing is meant: a table's curve is the least of softness * (integral of s''^2) + (sum of squared departures)
# that departs by its tolerance at most, of these softnesses the greatest; each is 2 ** 0.25 times the one before.
SOFTNESSES = tuple(2.0 ** (k / 4) for k in range(-240, 25))


class Law(NamedTuple):
    """A law of motion over one phase (закон движения): its name, and what it needs beside that.

    `first` is the share of the phase that accelerates under constant acceleration; `points` are shares of the phase,
    rising from 0 to 1, with the share of the lift of a table (from 0 to 1), or with the acceleration in any scale of a
    shape (two points at one share are a jump). `through` says what joins a table's points; a `tolerance` above 0, in
    shares of the lift, lets a table be smoothed by so much at most.
    """

    name: str
    first: float = 0.5
    points: tuple[tuple[float, float], ...] = ()
    through: str = CUBICS
    tolerance: float = 0.0


class Phase(NamedTuple):
    """A phase of the cam (фаза): its kind, angle, start and the follower's level there, its change of S, its law."""

    kind: str
    angle: float  # rad
    start: float  # rad
    level: float  # S at its start
    change: float  # of S: above 0 on a rise, below 0 on a return, 0 on a dwell
    law: Law | None = None  # None of a dwell
    stop: float | None = None  # rad: where the next phase starts, if a rounding lies between that and start + angle

    @property
    def end(self) -> float:
        """Where it ends, rad."""
        return self.start + self.angle if self.stop is None else self.stop


class Follower(NamedTuple):
    """The follower (толкатель): how it moves, what touches the cam, its sizes m.

    `sense` of one that rocks is +1 where it turns on the rise as the cam does, -1 against it. `length` is from its
    pivot to its tip or its roller's centre. `face` is how far a flat one that rocks stands off its pivot, above 0 away
    from the cam. `reach` is how far a flat face goes to both sides of its axis, of one that rocks from under its pivot;
    None: as far as need be.
    """

    motion: str
    end: str
    length: float | None = None
    sense: int = 1
    face: float = 0.0
    reach: float | None = None


class PermittedAngles(NamedTuple):
    """The least and the greatest pressure angle that are permitted, rad, the least below 0 (5.30)."""

    low: float
    high: float


class Limits(NamedTuple):
    """What the sizes must keep to: the pressure angle on rise and return, rad above 0, the least curvature radius m."""

    rise: float | None = None
    back: float | None = None
    curvature: float = 0.0  # of the profile under a flat face

    def shared(self, share: float) -> Limits:
        """Give so large a share of the limits of the pressure angle."""
        return self._replace(rise=self.rise and share * self.rise, back=self.back and share * self.back)

    def of(self, kind: str) -> float | None:
        """Give the limit of the pressure angle on a kind of phase."""
        return {RISE: self.rise, RETURN: self.back}.get(kind)

    def interval(self, kind: str, closure: str) -> PermittedAngles | None:
        """Give what is permitted on a kind of phase: in a groove from -back to rise on both kinds of phase (5.30).

        A spring drives the return, which nothing limits; on the rise it is held to both sides alike. A limit that
        stands alone is of its own phases, to both sides.
        """
        asked = self.of(kind)
        if asked is None or (closure == FORCE and kind == RETURN):
            return None
        if closure == FORCE or self.rise is None or self.back is None:
            return PermittedAngles(-asked, asked)
        return PermittedAngles(-self.back, self.rise)


class GivenSizes(NamedTuple):
    """Main sizes m that the scene gives: least radius R0, offset e, distance of centres L; None: to be found."""

    base: float | None = None
    offset: float | None = None  # e, above 0 where it lowers the pressure angle on the rise
    centre: float | None = None


class FollowerLoad(NamedTuple):
    """What the follower bears, against its rise: kg, N, N/m; of one that rocks kg*m2, N*m, N*m/rad."""

    mass: float = 0.0
    force: float = 0.0
    preload: float = 0.0  # of the spring at the start
    stiffness: float = 0.0


class Hub(NamedTuple):
    """How a cam sits on its shaft (посадка на вал): the bore, and the keyway in the hub; m.

    `depth` goes out from the bore (t_2); a keyway of no width is none. `angle`, rad, is that of the keyway's axis from
    the zero ray, against the rotation.
    """

    bore: float  # diameter
    width: float
    depth: float
    angle: float = 0.0
    length: float | None = None  # along the shaft
    standard: bool = False  # whether width and depth are those of the standard for the bore
    wall: float = 0.0  # the least that must be left to the profile


LEAST_BASE = 1e-3  # of the follower's way: where the limits ask for a smaller R0, they ask for no cam
NO_LIMITS, NO_SIZES = Limits(), GivenSizes()
BOOK_LIMITS = {TRANSLATING: math.radians(30), ROCKING: math.radians(45)}  # 5.9.3


@dataclass(frozen=True)
class Cam:
    """One cam that is asked for (кулачок): all that the scene says of it."""

    name: str
    sense: int
    speed: float | None  # rad/s above 0 (m/s of one that translates); None: not asked
    phases: tuple[Phase, ...]
    follower: Follower
    closure: str
    limits: Limits = NO_LIMITS
    given: GivenSizes = NO_SIZES
    roller: float | None = None  # radius m; None: by rule
    setting: float = 0.0  # rad: turn of the main shaft at which its first phase begins
    translates: bool = False  # the cam itself
    divisions: int = 8  # parts of a phase that moves the follower
    load: FollowerLoad | None = None
    hub: Hub | None = None
    angles: tuple[Fraction, ...] = ()  # of the phases in degrees, exact; empty of a cam that translates
    coordinates: int = 360  # parts of the turn at which the profile is told by coordinates
    tolerance: float = 1e-7  # m: how far a drawn piece of the profile may be from the exact one

    @property
    def turn(self) -> float:
        """The whole turn, rad; of a cam that translates its whole travel, m."""
        return self.phases[-1].end if self.translates else TURN

    @property
    def lift(self) -> float:
        """The greatest S, m or rad (ход толкателя)."""
        return max(max(phase.level, phase.level + phase.change) for phase in self.phases)

    @property
    def way(self) -> float:
        """How far the follower's tip goes, m."""
        return self.lift * (self.follower.length or 0.0) if self.rocks else self.lift

    @property
    def rocks(self) -> bool:
        """Whether the follower rocks."""
        return self.follower.motion == ROCKING

    @property
    def told(self) -> dict[str, tuple[float, str]]:
        """What else the scene gives of the follower, by its letter, with its unit: sizes mm, the load SI."""
        end, load = self.follower, self.load or FollowerLoad()
        lengths = {"l": end.length, "b": end.reach, "h": end.face, "[ρ_{min}]": self.limits.curvature}
        names = ("J", "M", "M_0", "c") if self.rocks else ("m", "F", "F_0", "c")
        units = ("kg*m2", "N*m", "N*m", "N*m/rad") if self.rocks else ("kg", "N", "N", "N/m")
        every = {letter: (MM * (size or 0.0), "mm") for letter, size in lengths.items()}
        every |= {letter: (size, unit) for letter, size, unit in zip(names, load, units, strict=True)}
        return {letter: size for letter, size in every.items() if size[0]}

    @property
    def flat(self) -> bool:
        """Whether a flat face touches the cam."""
        return self.follower.end == FLAT

    @property
    def pressed(self) -> bool:
        """Whether it has a pressure angle: a flat face that translates, or goes through its pivot, is met square."""
        return not self.flat or (self.rocks and self.follower.face != 0.0)

    @property
    def rising(self) -> int:
        """The sense in which a rocker turns on the rise: +1 counter-clockwise."""
        return self.sense * self.follower.sense

    def moving(self) -> Iterator[Phase]:
        """Give the phases over which the follower moves."""
        return (phase for phase in self.phases if phase.kind != DWELL)

    @property
    def sized(self) -> bool:
        """Whether no main size is left to be found."""
        if self.translates:
            return True
        other = self.given.centre if self.rocks else self.given.offset
        return self.given.base is not None and (other is not None or (not self.rocks and (self.flat or self.unlimited)))

    @property
    def eased(self) -> bool:
        """Whether e or L is left to be chosen at an R0 that is given: that of the least pressure angle."""
        return self.given.base is not None and not (self.sized or self.flat)

    @property
    def unlimited(self) -> bool:
        """Whether the scene limits no pressure angle."""
        return self.limits.rise is None and self.limits.back is None


def limits_of(cam: Cam) -> Limits:
    """Give the limits that sizes are found for: the book's where the scene has none.

    A spring drives the return, so that closure by force limits the rise alone. Sizes that are given are held to the
    limits of the scene alone.
    """
    kept = cam.limits._replace(back=None) if cam.closure == FORCE else cam.limits
    if cam.sized or cam.flat:
        return kept
    usual = BOOK_LIMITS[cam.follower.motion]
    return kept._replace(rise=kept.rise or usual, back=None if cam.closure == FORCE else kept.back or usual)


def interval_of(cam: Cam, kind: str) -> PermittedAngles | None:
    """Give what a cam's pressure angle is held to on a kind of phase; None where the scene limits nothing there."""
    return None if cam.unlimited else limits_of(cam).interval(kind, cam.closure)


RATIO = "1"  # the unit of what has none
UNITS = {  # whether the follower rocks and whether the cam translates
    (False, False): ("m", "m/rad", "m/rad2"),
    (False, True): ("m", RATIO, "1/m"),
    (True, False): ("rad", RATIO, "1/rad"),
    (True, True): ("rad", "rad/m", "rad/m2"),
}


def dimensions(cam: Cam) -> tuple[str, str, str]:
    """Give the units of S, S' and S''."""
    return UNITS[cam.rocks, cam.translates]
