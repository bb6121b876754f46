"""Cams whose profiles tests draw, and where their followers' points are by formulas in complex numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np

from drawings.figures.cam.profile_view import ProfileView, profile_view
from plans.cam.course import Course, positions
from plans.cam.profile.findings import cam_found
from plans.model.cam import (
    DWELL,
    FLAT,
    FORCE,
    GROOVE,
    POINTED,
    RETURN,
    RISE,
    ROCKING,
    ROLLER,
    TRANSLATING,
    TURN,
    Cam,
    Follower,
    Law,
)
from plans.model.cam_motion import Sizes
from plans.model.motion import Complexes, Floats
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


def levers(one: Cam, sizes: Sizes, turned: Floats) -> tuple[Complexes, Complexes]:
    """Give the follower's point in the frame and what stands on the normal there, (N,) each, m."""
    travel, sense = Course(one).at(turned), one.sense
    if one.rocks:
        arm = one.rising * np.exp(1j * one.rising * (travel.s - one.lift / 2))
        if one.flat:
            normal, slope = 1j * one.rising * arm, one.rising * travel.slope
            far = sense * (1j * sizes.pivot * normal.conj()).real / (one.rising * (slope - sense))
            return sizes.pivot + one.follower.face * normal + far * arm, normal
        length = one.follower.length or 0.0
        tip = sizes.pivot + length * arm
        return tip, tip + 1j * sense * (1j * one.rising * length * arm * travel.slope)
    if one.flat:
        return sense * travel.slope + 1j * (sizes.base + travel.s), np.full(len(turned), 1j)
    if one.translates:
        return 1j * travel.s, 1j - sense * travel.slope
    start = math.sqrt(sizes.base**2 - sizes.offset**2)
    tip = sense * sizes.offset + 1j * (start + travel.s)
    return tip, tip - sense * travel.slope


def view(one: Cam, sizes: Sizes, roller: float = 0.0) -> ProfileView:
    """Give a cam with all that its figure shows."""
    own = replace(one, roller=roller)
    return profile_view(cam_found(Course(own), sizes, positions(own)))


def triangle(one: Cam, base: float, centre: float) -> Sizes:
    """Give the sizes of a rocker of some least radius and distance of centres."""
    length, arm = one.follower.length or 0.0, one.rising * complex(math.cos(one.lift / 2), 0)
    arm -= 1j * math.sin(one.lift / 2)
    inner = math.acos((length**2 + centre**2 - base**2) / (2 * length * centre))
    # From the pivot the arm points along `arm`; O lies below it.
    way = arm / abs(arm) * complex(math.cos(inner), -one.rising * math.sin(inner))
    return Sizes(base, 0.0, centre, -centre * way, inner)


OFFSET = Sizes(0.03266494437, 0.002220357697)
WIDE = Sizes(0.045, 0.012)
RADIAL = Sizes(0.04)
UNDER = Sizes(0.047341550770)
R_OFFSET = 0.01306597775
ROCKER = Sizes(0.03692159408, 0.0, 0.1363651929, -(0.1211047752 - 0.06268252757j), math.radians(14.86559732))

TO_ROLLER, TO_POINT, TO_FLAT = (Follower(TRANSLATING, end) for end in (ROLLER, POINTED, FLAT))


def groove(sense: int = 1) -> ProfileView:
    """Give the offset roller in a groove of M2.7 and M2.14."""
    return view(cam(TO_ROLLER, closure=GROOVE, sense=sense), OFFSET, R_OFFSET)


def offset(sense: int = 1) -> ProfileView:
    """Give an offset roller held by a spring."""
    return view(cam(TO_ROLLER, sense=sense), WIDE, 0.012)


def radial() -> ProfileView:
    """Give a radial pointed follower."""
    return view(cam(TO_POINT, laws=("constant acceleration", "cosine")), RADIAL)


def rocker(sense: int = 1, turns: int = 1) -> ProfileView:
    """Give the rocker with a roller of M2.9; against the cam another one."""
    one = cam(Follower(ROCKING, ROLLER, 0.12, turns), SWING, GROOVE, sense=sense)
    sizes = ROCKER if turns == 1 else triangle(one, 0.05, 0.15)
    if turns == 1 and sense < 0:
        sizes = sizes._replace(pivot=-sizes.pivot.conjugate())
    return view(one, sizes, 0.01)


def flat() -> ProfileView:
    """Give the flat follower of M2.10."""
    return view(cam(TO_FLAT), UNDER)


def flat_rocker() -> ProfileView:
    """Give a flat rocker."""
    one, pivot = cam(Follower(ROCKING, FLAT, 0.12, 1, 0.005), math.radians(15)), -0.12 + 0.05j
    sizes = Sizes(0.0, 0.0, abs(pivot), pivot)
    tip, normal = levers(one, sizes, np.zeros(1))
    return view(one, sizes._replace(base=float((tip * normal.conj()).real[0])))


def wedge() -> ProfileView:
    """Give a cam that translates."""
    return view(cam(TO_ROLLER, angles=(60.0, 20.0, 50.0, 20.0), translates=True), Sizes(0.0), 0.008)


def undercut() -> ProfileView:
    """Give a roller larger than the pitch curve lets it be."""
    return view(cam(TO_ROLLER, angles=(60.0, 20.0, 60.0, 220.0)), Sizes(0.04, 0.006), 0.025)


EVERY = {
    "groove": groove,
    "offset": offset,
    "rocker": rocker,
    "clockwise": lambda: groove(-1),
    "flat": flat,
    "against": lambda: rocker(1, -1),
    "wedge": wedge,
    "clockwise rocker": lambda: rocker(-1),
    "flat rocker": flat_rocker,
    "radial": radial,
    "undercut": undercut,
}


@cache
def view_of(name: str) -> ProfileView:
    """Give one of them, made once."""
    return EVERY[name]()
