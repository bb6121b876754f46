"""The letters and units of a cam's motion: travel, its derivatives, the turn (обозначения движения толкателя)."""

from __future__ import annotations

import math
from typing import NamedTuple

from plans.cam.dimensions import RATIO, dimensions
from plans.model.cam import Cam

ACCELERATION, VELOCITY, TRAVEL = "acceleration", "velocity", "travel"


class Told(NamedTuple):
    """The unit that a table tells a quantity in, "" of what has none, and how many of it are one of SI."""

    unit: str
    size: float


TOLD = {"m": Told("mm", 1000.0), "rad": Told("°", math.degrees(1)), RATIO: Told("", 1.0), "1/rad": Told("", 1.0)}
TOLD |= {"m/rad": TOLD["m"], "m/rad2": TOLD["m"]}


def letters(cam: Cam) -> tuple[str, str]:
    """Give the letter of the follower's travel and that of the cam's turn."""
    return "ψ" if cam.rocks else "S", "x" if cam.translates else "φ"


def units(cam: Cam) -> dict[str, str]:
    """Give the units of the rows: of travel, then once and twice over that of the cam's turn."""
    return dict(zip((TRAVEL, VELOCITY, ACCELERATION), dimensions(cam), strict=True))


def ways_told(cam: Cam) -> tuple[Told, ...]:
    """Give how a table tells S, S' and S''."""
    return tuple(TOLD.get(unit, Told(unit, 1.0)) for unit in dimensions(cam))
