"""Cams for the tests, built without a scene."""

from __future__ import annotations

import math
from itertools import product
from typing import TypeAlias

from plans.model.cam import (
    DWELL,
    FLAT,
    GROOVE,
    POINTED,
    RETURN,
    RISE,
    ROCKING,
    ROLLER,
    TRANSLATING,
    Cam,
    Follower,
    Law,
    Phase,
)
from plans.model.cam_motion import CamSizes
from tests.plans import cam_phases

USUAL = ((RISE, 120.0, "sine"), (DWELL, 30.0, ""), (RETURN, 90.0, "3-4-5"), (DWELL, 120.0, ""))
FLAT_USUAL = ((RISE, 140.0, "sine"), (DWELL, 20.0, ""), (RETURN, 140.0, "cosine"), (DWELL, 60.0, ""))
LIFT, SWING, LENGTH, ROLLER_RADIUS = 0.03, math.radians(25), 0.12, 0.010
PIVOT = complex(0.125, -0.065)  # O less O1 of a rocker that rises counter-clockwise

Case: TypeAlias = tuple[Cam, CamSizes]


def phases(listed: tuple[tuple[str, float, str], ...], lift: float, whole: float = 2 * math.pi) -> tuple[Phase, ...]:
    """Give phases one after another: kind, angle in degrees (360 to the whole turn), name of the law."""
    return cam_phases.phases(((kind, angle, Law(name) if name else None) for kind, angle, name in listed), lift, whole)


def cam(motion: str = TRANSLATING, end: str = ROLLER, sense: int = 1, with_cam: int = 1, **given: object) -> Cam:
    """Give a usual cam with a follower."""
    rocks = motion == ROCKING
    follower = Follower(motion, end, LENGTH if rocks else None, with_cam, 0.004 if rocks and end == FLAT else 0.0)
    listed = FLAT_USUAL if end == FLAT else USUAL
    lift = SWING if rocks else LIFT
    own: dict[str, object] = {"phases": phases(listed, lift), "closure": "force", "follower": follower}
    return Cam(**({"name": "K", "sense": sense, "speed": None} | own | given))  # type: ignore[arg-type]


def sizes(one: Cam, offset: float = 0.012, base: float = 0.05) -> CamSizes:
    """Give sizes that every usual cam can have."""
    if one.translates:
        return CamSizes(0.0)
    if not one.rocks:
        return CamSizes(0.09 if one.flat else base, 0.0 if one.flat else offset)
    pivot = -PIVOT if one.rising == 1 else PIVOT.conjugate()
    pivot = pivot if not one.flat else complex(-one.rising * 0.12, 0.15)
    return CamSizes(abs(pivot), 0.0, abs(pivot), pivot)


def every() -> list[Case]:
    """Give every follower with both senses of the cam, and both signs of its offset or both senses of its rocker."""
    found: list[Case] = []
    for end, sense, sign in product((POINTED, ROLLER, FLAT), (1, -1), (1, -1)):
        plain = cam(TRANSLATING, end, sense)
        found.append((plain, sizes(plain, 0.012 * sign)))
        rocker = cam(ROCKING, end, sense, sign)
        found.append((rocker, sizes(rocker)))
    for sense, sign in product((1, -1), (1, -1)):
        groove = cam(TRANSLATING, ROLLER, sense, closure=GROOVE)
        found.append((groove, sizes(groove, 0.012 * sign)))
        groove = cam(ROCKING, ROLLER, sense, sign, closure=GROOVE)
        found.append((groove, sizes(groove)))
    for end, sense in product((POINTED, ROLLER), (1, -1)):
        slide = cam(TRANSLATING, end, sense, translates=True, phases=phases(USUAL, LIFT, 0.3))
        found.append((slide, sizes(slide)))
    return found


def titled(case: Case) -> str:
    """Name a case for a test's id."""
    one, own = case
    sign = "with" if one.follower.sense > 0 and own.offset >= 0 else "against"
    return (
        f"{'slide' if one.translates else one.follower.motion}-{one.follower.end}-{one.closure}-{one.sense:+d}-{sign}"
    )


def roller_of(one: Cam) -> float:
    """Give the radius of a case's roller, m."""
    return ROLLER_RADIUS if one.follower.end == ROLLER else 0.0
