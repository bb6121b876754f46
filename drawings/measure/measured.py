"""Marks as they were measured on a sheet, in true units, with what they state of themselves (измеренные знаки)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple


class MarkKey(NamedTuple):
    """What a vector or point is called."""

    plan: str
    quantity: str
    name: str
    position: int | None = None


@dataclass(frozen=True)
class MeasuredMark:
    """A mark of a sheet: what it is called, its value by measurement and as stated, in true units."""

    plan: str
    quantity: str
    name: str
    position: int | None
    value: complex
    stated: complex
    unit: str
    scale: float

    @property
    def key(self) -> MarkKey:
        """What it is called."""
        return MarkKey(self.plan, self.quantity, self.name, self.position)


@dataclass(frozen=True)
class MeasuredVector(MeasuredMark):
    """A vector: its ends on the sheet (mm, y up)."""

    start: complex
    end: complex

    @property
    def reach(self) -> float:
        """How far from the sheet's corner its ends are (mm), which its rounding is a share of."""
        return abs(self.start) + abs(self.end)


@dataclass(frozen=True)
class MeasuredPoint(MeasuredMark):
    """A point: its place on the sheet (mm, y up); its value is measured from the pole."""

    at: complex

    @property
    def reach(self) -> float:
        """How far from the sheet's corner it is (mm), which its rounding is a share of."""
        return abs(self.at)
