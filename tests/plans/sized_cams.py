"""Cams of the worked examples: a sine rise of 120 degrees, a dwell of 30, a 3-4-5 return of 90, a dwell of 120."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from plans.model.cam import (
    DWELL,
    FLAT,
    GROOVE,
    POINTED,
    RETURN,
    RISE,
    ROCKING,
    TRANSLATING,
    Cam,
    Follower,
    Law,
    Limits,
    Phase,
)
from tests.plans import cam_phases

SINE, POLYNOMIAL = Law("sine"), Law("3-4-5")
LIFT, SWING, ARM = 0.03, math.radians(25), 0.12


def phases(lift: float = LIFT, rise: Law = SINE, back: Law = POLYNOMIAL) -> tuple[Phase, ...]:
    """Give the phases of the examples."""
    return cam_phases.phases(((RISE, 120, rise), (DWELL, 30, None), (RETURN, 90, back), (DWELL, 120, None)), lift)


def degrees(rise: float | None = None, back: float | None = None, curvature: float = 0.0) -> Limits:
    """Give limits in degrees, and m."""
    return Limits(*(None if one is None else math.radians(one) for one in (rise, back)), curvature)


def translating(sense: int = 1, lift: float = LIFT, **more: Any) -> Cam:
    """Give a cam with a pointed follower that translates, in a groove; limits +30 and -40 degrees."""
    own = Cam("K1", sense, 10.0, phases(lift), Follower(TRANSLATING, POINTED), GROOVE, degrees(30, 40))
    return replace(own, **more)


def rocking(sense: int = 1, turns: int = 1, length: float = ARM, **more: Any) -> Cam:
    """Give a cam with a pointed rocker, in a groove; limits +-45 degrees."""
    follower = Follower(ROCKING, POINTED, length, turns)
    return replace(Cam("K2", sense, 10.0, phases(SWING), follower, GROOVE, degrees(45, 45)), **more)


def flat(sense: int = 1, **more: Any) -> Cam:
    """Give a cam with a flat follower that translates; least radius of curvature 5 mm."""
    return replace(
        translating(sense), **{"follower": Follower(TRANSLATING, FLAT), "limits": degrees(curvature=0.005), **more}
    )


def flat_rocker(sense: int = 1, turns: int = 1, face: float = 0.005, swing: float = 15, **more: Any) -> Cam:
    """Give a cam with a flat rocker; least radius of curvature 5 mm."""
    follower = Follower(ROCKING, FLAT, 0.1, turns, face)
    own = replace(flat(sense), follower=follower, phases=phases(math.radians(swing)))
    return replace(own, **more)
