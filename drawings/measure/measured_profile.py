"""The profile of a cam on a written sheet, as a curve in the cam (измеренный профиль кулачка)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass

from drawings.measure.curvedata import pieces
from drawings.measure.marks import SheetMark
from drawings.measure.measured import MeasuredMark
from drawings.measure.pathdata import number
from drawings.paper.limits import SheetRefused
from geometry.curve import Piece, gaps

PARTS = 8  # of a piece, at which it is looked at


@dataclass(frozen=True)
class MeasuredProfile(MeasuredMark):
    """A profile: its pieces m in the cam as it stands at its start; its value is the place where it begins.

    The pieces lie as the stated value of their beginning says: the cam's centre on paper is rounded more than they are.
    `deviation` is how far the sheet says its cubics are from the exact profile, m; `quantum` how far rounding on paper
    may have moved its points, m.
    """

    at: complex  # where it begins on paper, mm
    pieces: tuple[Piece, ...]
    deviation: float
    quantum: float

    @property
    def reach(self) -> float:
        """How far from the sheet's corner it begins (mm), which its rounding is a share of."""
        return abs(self.at)

    @property
    def places(self) -> tuple[complex, ...]:
        """Places along its pieces, m."""
        inner = [piece.at(k / PARTS) for piece in self.pieces for k in range(PARTS)]
        return *inner, self.pieces[-1].end

    @property
    def gap(self) -> float:
        """The widest gap between its pieces, m, as it goes on and comes back."""
        return gaps(self.pieces, closed=True)


def profile(mark: SheetMark, pole: complex, scale: float, stated: complex, resolution: float) -> MeasuredProfile:
    """Give a profile from its mark, whose centre is at a place on paper, where points are rounded so much, mm."""
    turn = scale * cmath.exp(-1j * math.radians(_number(mark, "turned", 0.0)))
    start = mark.points[0]
    deviation = _number(mark, "deviation")
    if not deviation >= 0:
        raise SheetRefused("deviation", who=mark.who, size=deviation)
    return MeasuredProfile(
        plan=mark.data.get("plan", ""),
        quantity=mark.data.get("quantity", ""),
        name=mark.data.get("name", ""),
        position=None,
        value=(start - pole) * turn,
        stated=stated,
        unit=mark.data.get("unit", ""),
        scale=scale,
        at=start,
        pieces=tuple(piece.placed(turn, stated - start * turn) for piece in pieces(_parts(mark))),
        deviation=deviation,
        quantum=resolution * scale,
    )


def _parts(mark: SheetMark) -> Iterator[tuple[complex, ...]]:
    """Give the points of each piece."""
    place = 0
    for count in mark.parts:
        yield mark.points[place : place + count]
        place += count


def _number(mark: SheetMark, name: str, default: float | None = None) -> float:
    try:
        return default if default is not None and name not in mark.data else number(mark.data.get(name, ""))
    except SheetRefused as refused:
        raise SheetRefused("data", who=mark.who, name=name, why=refused.reason) from refused
