"""What is found of a cam, whichever road found it: travel, sizes, contour, extremes, flaws (кулачок, результаты)."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from plans.model.cam import Cam
from plans.model.motion import Floats

Points = npt.NDArray[np.complex128]
SLOPE, BEND = "S'", "S''"  # names of the peaks of a law
CONSTRUCTION, ANALYSIS = "construction", "analysis"


class Travel(NamedTuple):
    """S and its derivatives by the cam's turn, (N,) each: m, m/rad, m/rad2; of a follower that rocks rad, 1, 1/rad."""

    s: Floats
    slope: Floats  # S'
    bend: Floats  # S''


class Shock(NamedTuple):
    """A shock (удар): where, rad; `order` 1 is hard, a jump of S', 2 is soft, a jump of S''; after less before."""

    turned: float
    order: int
    jump: float


class Sizes(NamedTuple):
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
    travel: Travel
    tip: Points  # m
    lever: Points
    pitch: Points  # m: of a pointed or a flat follower the profile itself
    profile: Points  # m: that touches the follower
    pressure: Floats  # rad
    radius: Floats  # m: of the pitch curve
    sliding: Floats  # m/rad: speed of the follower's point along the profile, over the cam's
    outer: Points | None = None  # the other side of a groove


class Extreme(NamedTuple):
    """A greatest or least value, and the turn of the cam where it is, rad."""

    value: float
    turned: float


class Flaw(NamedTuple):
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

    by: str
    cam: Cam
    sizes: Sizes
    roller: float  # m; 0 of a pointed or flat follower
    contour: Contour  # at the numbered positions
    shocks: tuple[Shock, ...] = ()
    peaks: dict[str, Extreme] = field(default_factory=dict)  # largest S' and S'' by size, signed; S'' of no hard shock
    pressure: dict[str, Extreme] = field(default_factory=dict)  # largest on a kind of phase, by its size, rad, signed
    sharpest: Extreme | None = None  # least convex radius of the pitch curve (of the profile under a flat face), m
    hollow: Extreme | None = None  # smallest concave one by size, m, below 0; None: convex throughout
    face: tuple[float, float] = (0.0, 0.0)  # m: how far contact goes to both sides of a flat follower's axis or pin
    flaws: tuple[Flaw, ...] = ()
    rule: str = "given"  # that the roller was taken by: "given", "curvature", "hollow", "wear"
    pressing: Pressing | None = None  # None: no load or no speed
    mending: float | None = None  # R0, m, that would keep the pressure angle to its limits with the offset as it is
    advised: Sizes | None = None  # that would keep it to them, where it does not; None: it does, or no sizes do
