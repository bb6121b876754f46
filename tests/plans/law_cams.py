"""Cams of which only the laws matter: phases one after another, a plain follower."""

from __future__ import annotations

import math

from plans.model.cam import (
    DWELL,
    FORCE,
    LAWS,
    POINTED,
    RETURN,
    RISE,
    SHAPE,
    TABLE,
    TRANSLATING,
    TURN,
    Cam,
    Follower,
    Law,
    Phase,
)
from tests.plans import cam_phases

LIFT, RISING = 0.03, math.radians(120)  # of the worked examples
SPEED = 300 * TURN / 60
NOISY = tuple((k / 24, (10 * x**3 - 15 * x**4 + 6 * x**5) + 0.004 * math.sin(97.0 * k) * (0 < k < 24))
              for k in range(25) for x in (k / 24,))  # fmt: skip
READINGS = ((0.0, 0.0), (0.1, 0.02), (0.3, 0.2), (0.55, 0.62), (0.8, 0.95), (1.0, 1.0))
LINES = Law(TABLE, points=READINGS, through="lines")
RULER = Law(TABLE, points=READINGS)
SMOOTH = Law(TABLE, points=NOISY, tolerance=0.01)
BLOCKS = Law(SHAPE, points=((0, 0), (0.1, 2), (0.4, 2), (0.4, -1), (0.9, -1), (1, -3)))  # areas of 0.7 each
STEADY = Law("constant acceleration", first=0.3)
NAMED = tuple(map(Law, LAWS))
EVERY = (*NAMED, STEADY, LINES, RULER, SMOOTH, BLOCKS)


def phases(*listed: tuple[str, float, Law | None], lift: float = LIFT, whole: float = TURN) -> tuple[Phase, ...]:
    """Give phases one after another, each by its kind, its angle in degrees (360 to the whole turn), its law."""
    return cam_phases.phases(listed, lift, whole)


def law_cam(*listed: tuple[str, float, Law | None], lift: float = LIFT, divisions: int = 8, **more: object) -> Cam:
    """Give a cam with some phases."""
    own = {"translates": False, "follower": Follower(TRANSLATING, POINTED), **more}
    found = phases(*listed, lift=lift, whole=0.3 if own["translates"] else TURN)
    return Cam("K", 1, SPEED, found, closure=FORCE, divisions=divisions, **own)  # type: ignore[arg-type]


def usual(law: Law, back: Law | None = None, **more: object) -> Cam:
    """Give the cam of the worked examples: rise 120, dwell 30, return 90, dwell 120 degrees."""
    return law_cam((RISE, 120, law), (DWELL, 30, None), (RETURN, 90, back or law), (DWELL, 120, None), **more)  # type: ignore[arg-type]
