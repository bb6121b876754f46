"""The profile of a cam on a written sheet, as a curve in the cam (измеренный профиль кулачка)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass

from drawings.measure.curvedata import pieces
from drawings.measure.marks import SheetMark
from drawings.measure.pathdata import number
from drawings.paper.limits import SheetRefused
from geometry.curve import Piece, gaps


@dataclass(frozen=True)
class MeasuredProfile:
    """A profile: what it is called, its pieces m in the cam as it stands at its start, and what it states of itself.

    `deviation` is how far the sheet says its cubics are from the exact profile, m; `quantum` how far rounding on paper
    may have moved its points, m.
    """

    plan: str
    quantity: str
    name: str
    pieces: tuple[Piece, ...]
    deviation: float
    scale: float  # m to the mm
    quantum: float

    @property
    def gap(self) -> float:
        """The widest gap between its pieces, m, as it goes on and comes back."""
        return gaps(self.pieces, closed=True)


def profile(mark: SheetMark, pole: complex, scale: float, resolution: float) -> MeasuredProfile:
    """Give a profile from its mark, whose centre is at a place on paper, where points are rounded so much, mm."""
    turn = cmath.exp(-1j * math.radians(_stated(mark, "turned", 0.0)))
    placed = (piece.placed(scale * turn, -pole * scale * turn) for piece in pieces(_parts(mark)))
    plan, quantity, name = (mark.data.get(name, "") for name in ("plan", "quantity", "name"))
    deviation = _stated(mark, "deviation")
    if not deviation >= 0:
        raise SheetRefused(f"{mark.who}: its deviation {deviation} is below zero")
    return MeasuredProfile(plan, quantity, name, tuple(placed), deviation, scale, resolution * scale)


def _parts(mark: SheetMark) -> Iterator[tuple[complex, ...]]:
    """Give the points of each piece."""
    place = 0
    for count in mark.parts:
        yield mark.points[place : place + count]
        place += count


def _stated(mark: SheetMark, name: str, default: float | None = None) -> float:
    try:
        return default if default is not None and name not in mark.data else number(mark.data.get(name, ""))
    except SheetRefused as refused:
        raise SheetRefused(f"{mark.who}: its {name}: {refused.reason}") from refused
