"""Cams made in few words, and the textbook's (кулачки для проверок)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from plans.model.cam import DWELL, GROOVE, POINTED, RISE, ROCKING, TRANSLATING, TURN, Cam, Follower, Law, Phase
from plans.model.cam import RETURN as BACK
from plans.model.cam_motion import CamSizes
from tests.plans.cam_phases import parted

LIFT, LENGTH, SWING = 0.03, 0.12, math.radians(25)
# M2.7, M2.9, M2.10: what the figures of M2.11 to M2.14 are worked out from; mpmath from the conditions, to 17 digits.
OFFSET, START = 0.0022203576973070060, 0.032589394020104063
CENTRE = complex(0.12110477519512923, -0.062682527573578228)  # O - O1 of the exact method
FLAT_BASE = 0.047341550773669612


def phases(*parts: tuple[str, float, float, str], turn: float = TURN) -> tuple[Phase, ...]:
    """Make phases of their kind, angle in degrees, change of S and law; a last dwell fills the turn."""
    made = parted((kind, degrees, change, Law(law) if law else None) for kind, degrees, change, law in parts)
    last = made[-1]
    if last.end >= turn - 1e-12:
        return made
    return (*made, Phase(DWELL, turn - last.end, last.end, last.level + last.change, 0.0))


def usual(lift: float, up: str = "sine", down: str = "3-4-5") -> tuple[Phase, ...]:
    """Make the phases of M2.7: rise 120, dwell 30, return 90 degrees, and the rest of the turn."""
    return phases((RISE, 120, lift, up), (DWELL, 30, 0.0, ""), (BACK, 90, -lift, down))


def cam(parts: Iterable[Phase] | None = None, end: str = POINTED, sense: int = 1, **more: Any) -> Cam:
    """Make a cam of a follower that translates."""
    parts = tuple(parts) if parts is not None else usual(LIFT)
    given: dict[str, Any] = {"name": "1", "speed": None, "closure": GROOVE, "follower": Follower(TRANSLATING, end)}
    return Cam(sense=sense, phases=parts, **{**given, **more})


def rocker(end: str = POINTED, sense: int = 1, turns: int = 1, face: float = 0.0, **more: Any) -> Cam:
    """Make a cam of M2.9's rocker."""
    return cam(
        **{"parts": usual(SWING), "sense": sense, "follower": Follower(ROCKING, end, LENGTH, turns, face), **more}
    )


def offset_sizes(offset: float = OFFSET, start: float = START) -> CamSizes:
    """Give the sizes of a follower that translates by e and S0."""
    return CamSizes(math.hypot(offset, start), offset)


def pivot(own: Cam, centre: complex = CENTRE) -> CamSizes:
    """Give the sizes of a rocker by O - O1 as it stands for a cam and a rise counter-clockwise, mirrored as need be."""
    place = -centre if own.rising == 1 else np.conj(centre)
    start = place + LENGTH * own.rising * cmath.exp(-1j * own.rising * own.lift / 2)
    return CamSizes(abs(start), 0.0, abs(place), complex(place))
