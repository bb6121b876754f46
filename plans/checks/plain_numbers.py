"""Numbers as plain data: null at gaps, no -0 (числа)."""

from __future__ import annotations

import math
from typing import Any

from plans.model.motion import Gap


def plain(values: Any) -> list[float | None]:
    """Give numbers, null for NaN and for what is infinite, and no -0."""
    return [value if math.isfinite(value) else None for value in (values + 0.0).tolist()]


def pairs(values: Any) -> list[list[float] | None]:
    """Give vectors as [x, y], null for NaN."""
    both = zip((values.real + 0.0).tolist(), (values.imag + 0.0).tolist(), strict=True)
    return [None if math.isnan(x) or math.isnan(y) else [x, y] for x, y in both]


def gap_numbers(gap: Gap) -> dict[str, Any]:
    """Give a gap as plain data."""
    return {**gap._asdict(), "where": str(gap.where), "advice": str(gap.advice)}
