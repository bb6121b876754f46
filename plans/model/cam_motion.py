"""What is found of a cam, whichever road found it, and why one cannot be made (кулачок, результаты)."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.errors import ConstructionError
from plans.model.cam import GROOVE, MM, Cam, Limits
from plans.model.motion import Floats
from plans.words.words import Message, message


class CamError(ConstructionError):
    """A cam that cannot be made as it is asked for, with the message that says why and what would do.

    `key` leads from the cam to what it is about in the file.
    """

    def __init__(self, what: Message, *key: str) -> None:
        super().__init__(what)
        self.key = key

    @property
    def message(self) -> Message:
        """What is wrong."""
        found = self.args[0]
        assert isinstance(found, Message)
        return found


def still(cam: Cam) -> CamError:
    """Say that nothing moves the follower."""
    return CamError(message("refused.cam_still", name=cam.name), "follower")


def no_region(cam: Cam, limits: Limits) -> CamError:
    """Say that the limits leave no place for the centre; with L given, that none is on its arc."""
    if cam.given.centre is not None:
        return CamError(message("refused.cam_circle", name=cam.name, centre=_mm(cam.given.centre)), "sizes", "centre")
    return CamError(message("refused.cam_region", name=cam.name, limits=_angles(limits)), "limits")


def vanishing(cam: Cam, limits: Limits) -> CamError:
    """Say that the limits are so large that hardly anything is left of the cam."""
    return CamError(message("refused.cam_vanishing", name=cam.name, limits=_angles(limits)), "limits")


def too_far(cam: Cam, offset: float, base: float) -> CamError:
    """Say that the offset is no smaller than the least radius."""
    return CamError(message("refused.cam_offset", name=cam.name, offset=_mm(offset), base=_mm(base)), "sizes", "offset")


def no_triangle(cam: Cam, length: float, base: float, centre: float) -> CamError:
    """Say that the rocker does not reach the cam."""
    ends = {"least": _mm(abs(length - base)), "most": _mm(length + base)}
    sizes = {"length": _mm(length), "base": _mm(base), "centre": _mm(centre)}
    return CamError(message("refused.cam_triangle", name=cam.name, **sizes, **ends), "sizes", "centre")


def no_level(cam: Cam, base: float, centre: float) -> CamError:
    """Say that the face of a rocker is nowhere so far from the centre."""
    sizes = {"base": _mm(base), "centre": _mm(centre), "most": _mm(centre + cam.follower.face)}
    return CamError(message("refused.cam_face_level", name=cam.name, **sizes), "sizes", "base")


def no_distance(cam: Cam) -> CamError:
    """Say that the distance of centres is needed."""
    return CamError(message("refused.cam_distance", name=cam.name), "sizes")


def hard_face(cam: Cam, turned: float) -> CamError:
    """Say that a flat face cannot follow a fall of S'."""
    return CamError(message("refused.cam_hard_face", name=cam.name, turned=f"{math.degrees(turned):.6g}"), "phases")


def fast_face(cam: Cam, turned: float) -> CamError:
    """Say that a rocker's face turns as fast as the cam."""
    return CamError(message("refused.cam_fast_face", name=cam.name, turned=f"{math.degrees(turned):.6g}"), "phases")


def pivot_passed(cam: Cam, farthest: float, centre: float) -> CamError:
    """Say that the profile under the face of a rocker passes its pivot: how far it goes from O, and L, m."""
    sizes = {"farthest": _mm(farthest), "centre": _mm(centre)}
    return CamError(message("refused.cam_pivot_passed", name=cam.name, **sizes), "sizes", "centre")


def large_roller(cam: Cam, roller: float, base: float, most: float) -> CamError:
    """Say that the roller reaches over the cam's centre, and which one the curvature bears, m."""
    sizes = {"roller": _mm(roller), "base": _mm(base), "most": _mm(most)}
    return CamError(message("refused.cam_roller", name=cam.name, **sizes), "sizes", "roller")


def thin_wall(found: CamFound, wall: float, more: float, fits: int) -> CamError:
    """Say that bore and keyway leave too little, m, how much larger R_0 must be, and what bore, mm, fits."""
    cam = found.cam
    assert cam.hub is not None
    hub, kind = cam.hub, "refused.cam_wall" if wall > 0 else "refused.cam_bore"
    keyway = message("refused.cam_keyway", width=_mm(hub.width), depth=_mm(hub.depth)) if hub.width else ""
    left = {"wall": _mm(abs(wall), 4), "least": _mm(hub.wall, 4), "more": _mm(_up(more), 4)}
    cure = message("refused.cam_bore_fits" if fits else "refused.cam_bore_smaller", most=fits)
    sizes = {"bore": _mm(hub.bore), "keyway": keyway, "base": _mm(found.sizes.base, 4), "cure": cure}
    return CamError(message(kind, name=cam.name, **sizes, **left), "hub", "bore")


def no_radius(cam: Cam) -> CamError:
    """Say that no radius is the least."""
    return CamError(message("refused.cam_no_radius", name=cam.name), "limits")


def _angles(limits: Limits) -> str:
    return " / ".join(f"{math.degrees(limit):.4g}" for limit in (limits.rise, limits.back) if limit is not None)


def _up(size: float) -> float:
    """Round a size that is to help up to four digits."""
    step = 10.0 ** (math.floor(math.log10(size)) - 3)
    return math.ceil(size / step) * step


def _mm(size: float, digits: int = 6) -> str:
    return f"{MM * size:.{digits}g}"


Points = npt.NDArray[np.complex128]
SLOPE, BEND = "S'", "S''"  # names of the peaks of a law
CONSTRUCTION, ANALYSIS = "construction", "analysis"


class FollowerTravel(NamedTuple):
    """S and its derivatives by the cam's turn, (N,) each: m, m/rad, m/rad2; of a follower that rocks rad, 1, 1/rad."""

    s: Floats
    slope: Floats  # S'
    bend: Floats  # S''


HARD, SOFT = 1, 2  # orders of a shock: of the derivative of S that jumps


class Shock(NamedTuple):
    """A shock (удар): where, rad; its order, hard of a jump of S', soft of one of S''; after less before."""

    turned: float
    order: int
    jump: float


class CamSizes(NamedTuple):
    """Main sizes m: the least radius R0, the offset e, the distance of centres L and where the follower's pivot is.

    Of a flat face `base` is the distance of the face from O at the start. `pivot` is O1 - O, `initial` the rocker's
    angle at the start with the line of centres O1O, rad. A cam that translates has no sizes: all are 0.
    """

    base: float
    offset: float = 0.0
    centre: float = 0.0
    pivot: complex = 0j
    initial: float = 0.0


@dataclass(frozen=True)
class Contour:
    """The profile by points, at N turns of the cam (профиль кулачка).

    `tip` is in the frame: the point of the follower, its roller's centre, or where its face touches. `lever` is what
    stands on the profile's normal, out of the cam: OD of the book, K + i*sense*dK/dφ; of a flat face the unit normal.
    Pitch curve and profile are in the cam: as it stands at its start, turned back by `turned`. Radii of curvature are
    above 0 where the curve is convex. `pressure` is signed: above 0 where it is so on a plain rise.
    """

    turned: Floats  # rad
    travel: FollowerTravel
    tip: Points  # m
    lever: Points
    pitch: Points  # m: of a pointed or a flat follower the profile itself
    profile: Points  # m: that touches the follower
    pressure: Floats  # rad
    radius: Floats  # m: of the pitch curve
    sliding: Floats  # m/rad: speed of the follower's point along the profile, over the cam's
    outer: Points | None = None  # the other side of a groove


CUSP = 1e-12  # of R0: far above what the sum R0 + S + S'' loses, far below a radius that a workshop knows


class Extreme(NamedTuple):
    """A greatest or least value, and the turn of the cam where it is, rad."""

    value: float
    turned: float

    def cusp(self, base: float) -> Extreme:
        """Give a radius of curvature, 0 where it is but the rounding of what a radius R0 cancels: a cusp (остриё)."""
        return self if abs(self.value) > CUSP * base else self._replace(value=0.0)


class CamFlaw(NamedTuple):
    """What is wrong with a cam from one turn to another: its kind, the worst value there and where that is.

    Kinds: "undercut" (the roller is larger than the pitch curve's radius; a cusp or a corner where it ends at the turn
    at which it starts), "hollow" (likewise on the outer side of a groove), "crossing" (at both turns the profile is at
    one point), "concave" (under a flat face) and "sharp" (less than the radius asked for), "pressure" (angle beyond
    a limit, signed), "short face", "lift-off" (the spring does not hold), "outrun" (a rocker's face turns as fast as
    the cam: the worst is how many times as fast, and nothing else of the profile is told). One that goes on over the
    end of the turn starts late and ends early. The worst of the first two, of "concave" and of "sharp" is a radius, of
    a crossing how much of S is lost where the loop is cut away, of a short face how far contact goes, of a lift-off a
    force.
    """

    kind: str
    start: float
    end: float
    worst: Extreme


class Pressing(NamedTuple):
    """What presses the follower on the cam, without friction (прижатие): extremes of the force along the normal, N.

    `wear` is the greatest force times sliding speed, W; `preload` that of the spring, N or N*m, which would just hold
    the follower on the cam.
    """

    least: Extreme
    most: Extreme
    wear: Extreme
    preload: float


@dataclass(frozen=True)
class CamFound:
    """All that one road finds of one cam."""

    cam: Cam
    sizes: CamSizes
    roller: float  # m; 0 of a pointed or flat follower
    contour: Contour  # at the numbered positions
    shocks: tuple[Shock, ...] = ()
    peaks: dict[str, Extreme] = field(default_factory=dict)  # largest S' and S'' by size, signed; S'' of no hard shock
    pressure: dict[str, Extreme] = field(default_factory=dict)  # largest on a kind of phase, by its size, rad, signed
    sharpest: Extreme | None = None  # least convex radius of the pitch curve (of the profile under a flat face), m
    hollow: Extreme | None = None  # smallest concave one by size, m, below 0; None: convex throughout
    face: tuple[float, float] = (0.0, 0.0)  # m: how far contact goes to both sides of a flat follower's axis or pin
    flaws: tuple[CamFlaw, ...] = ()
    rule: str = "given"  # that the roller was taken by: "given", "curvature", "hollow", "wear"
    pressing: Pressing | None = None  # None: no load or no speed
    # R0, m, that would keep the pressure angle to its limits with the offset as it is, under a flat face the radius of
    # curvature.
    mending: float | None = None
    advised: CamSizes | None = None  # that would keep it to them, where it does not; None: it does, or no sizes do

    @property
    def grooved(self) -> bool:
        """Whether a mill as broad as the groove makes the cam, so that the path of its centre is told."""
        return self.cam.closure == GROOVE and self.roller > 0

    def made(self, at: Contour) -> Points:
        """Give the points that a workshop is told, m, (N,): of the working profile, of a groove those of its middle."""
        return at.pitch if self.grooved else at.profile
