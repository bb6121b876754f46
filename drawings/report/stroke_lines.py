"""The working stroke in the report: which way it goes, how long it takes, and the crank's angles over it (ход)."""

from __future__ import annotations

import numpy as np

from drawings.lettering.words import fixed
from plans.linkage.extreme import EQUAL
from plans.model.mechanism import Mechanism, Output
from plans.model.working import ways
from plans.words.words import Message, message, word

PLACES = 4  # decimals of an angle in degrees


def stroke_line(
    mechanism: Mechanism, output: Output, reach: tuple[float, float], angles: tuple[float, float], language: str
) -> str:
    """Say which way the working stroke goes, and how far the crank turns over it and over the idle one."""
    work, idle = (fixed(float(np.degrees(angle)), language, PLACES) for angle in angles)
    way = tuple(message(f"way.{name}") for name in ways(mechanism, output, *reach))
    return word(language, "report.working", time=_time(*angles), ways=way, work=work, idle=idle)


def _time(work: float, idle: float) -> Message:
    """Say whether the working stroke takes longer than the idle one."""
    if abs(work - idle) < EQUAL:
        return message("way.equal")
    return message("way.slower" if work > idle else "way.faster")
