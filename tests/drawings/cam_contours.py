"""Cams whose profiles tests draw, of the methods and odd ones; how far places are from a profile."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import shapely

from drawings.cam.profile_view import ProfileView, profile_view
from geometry.curve import Piece, sampled
from plans.cam.course import FollowerCourse, positions
from plans.cam.profile.findings import cam_found
from plans.model.cam import DWELL, FORCE, GROOVE, RETURN, RISE, ROCKING, ROLLER, TRANSLATING, TURN, Cam, Follower, Law
from plans.model.cam_motion import CamSizes, Points
from plans.model.motion import Floats
from tests.plans import cam_phases

LIFT = 0.03
SWING = math.radians(25)


def cam(
    follower: Follower,
    lift: float = LIFT,
    closure: str = FORCE,
    laws: tuple[str, str] = ("sine", "3-4-5"),
    angles: Sequence[float] = (120.0, 30.0, 90.0, 120.0),
    sense: int = 1,
    translates: bool = False,
) -> Cam:
    """Make a cam of a rise, a dwell, a return and a dwell; of one that translates the angles are millimetres."""
    kinds = zip((RISE, DWELL, RETURN, DWELL), angles, (Law(laws[0]), None, Law(laws[1]), None), strict=True)
    phases = cam_phases.phases(kinds, lift, 0.360 if translates else TURN)
    return Cam("K1", sense, 10.0, phases, follower, closure, translates=translates)


def view(one: Cam, sizes: CamSizes, roller: float = 0.0) -> ProfileView:
    """Give a cam with all that its figure shows."""
    own = replace(one, roller=roller)
    return profile_view(cam_found(FollowerCourse(own), sizes, positions(own)))


OFFSET = CamSizes(0.03266494437, 0.002220357697)
R_OFFSET = 0.01306597775
ROCKER = CamSizes(0.03692159408, 0.0, 0.1363651929, -(0.1211047752 - 0.06268252757j), math.radians(14.86559732))

TO_ROLLER = Follower(TRANSLATING, ROLLER)


def groove(sense: int = 1) -> ProfileView:
    """Give the offset roller in a groove of M2.7 and M2.14."""
    return view(cam(TO_ROLLER, closure=GROOVE, sense=sense), OFFSET, R_OFFSET)


def wedge() -> ProfileView:
    """Give a cam that translates."""
    return view(cam(TO_ROLLER, angles=(60.0, 20.0, 50.0, 20.0), translates=True), CamSizes(0.0), 0.008)


def undercut() -> ProfileView:
    """Give a roller larger than the pitch curve lets it be."""
    return view(cam(TO_ROLLER, angles=(60.0, 20.0, 60.0, 220.0)), CamSizes(0.04, 0.006), 0.025)


def rocker() -> ProfileView:
    """Give the rocker with a roller of M2.9."""
    return view(cam(Follower(ROCKING, ROLLER, 0.12), SWING, GROOVE), ROCKER, 0.01)


EVERY = {"groove": groove, "clockwise": lambda: groove(-1), "rocker": rocker, "wedge": wedge, "undercut": undercut}


@cache
def view_of(name: str) -> ProfileView:
    """Give one of them, made once."""
    return EVERY[name]()


def apart(pieces: tuple[Piece, ...], spots: Points, sag: float) -> Floats:
    """Give how far points, (N,) m, are from a profile whose chords may be off it by a sag."""
    line = shapely.LineString([(spot.real, spot.imag) for spot in sampled(pieces, sag)])
    return shapely.distance(line, shapely.points(spots.real, spots.imag))
