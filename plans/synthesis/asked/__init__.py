"""What tables ask, why it cannot be met and the nearest that can, and the scene of what was found (условия заданий)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import Decimal

from plans.model.synthesis.extremes import overlap_of
from plans.synthesis.drawn import DrawnReading
from plans.synthesis.tables.demands import DemandTable

MILLIMETRES = 1000.0


def overlap(table: DemandTable) -> float | None:
    """Give the overlap rad, told as such or by the coefficient of mean speeds."""
    return radians(table.overlap) if table.time_ratio is None else overlap_of(float(table.time_ratio))


def radians(value: Decimal | None) -> float | None:
    """Give an angle rad of degrees, if it is told."""
    return None if value is None else math.radians(value)


def number(value: Decimal | None) -> float | None:
    """Give a number, if it is told."""
    return None if value is None else float(value)


def millimetres(length: float) -> str:
    """Tell a length, mm."""
    return f"{MILLIMETRES * length:.6g}"


def degrees(angle: float) -> str:
    """Tell an angle in degrees."""
    return f"{math.degrees(angle):.6g}"


def met(drawn: Sequence[DrawnReading]) -> bool:
    """Tell whether some mechanism does what is asked."""
    return any(reading.found for reading in drawn)
