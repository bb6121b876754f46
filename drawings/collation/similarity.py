"""Similarity: how strokes that belong together were moved, turned and scaled as one (преобразование подобия)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from typing import NamedTuple

from drawings.collation.items import Item
from drawings.collation.matching import alike
from drawings.collation.spots import spots
from drawings.measure.transform import Affine
from drawings.paper.strokes import Circle

MORE = 2  # times the rounding: of what an editor wrote anew, both places are rounded


class Shift(NamedTuple):
    """A similarity of a part of a sheet: its map, and how far it moves what it moves farthest, mm."""

    by: Affine
    farthest: float

    @property
    def scale(self) -> float:
        """How many times as large it makes what it moves."""
        return abs(self.by.p)

    @property
    def turn(self) -> float:
        """The angle by which it turns what it moves, degrees, counter-clockwise."""
        return math.degrees(cmath.phase(self.by.p))


def shift_of(right: Sequence[Item], there: Sequence[Item], rounding: float) -> Shift | None:
    """Find the similarity that brings strokes onto others, one to one in their order; None where there is none."""
    if len(right) != len(there) or not right:
        return None
    if not all(_of_one_kind(ours, theirs) for ours, theirs in zip(right, there, strict=True)):
        return None
    ours = [spot for item in right for spot in spots(item.stroke)]
    theirs = [spot for item in there for spot in spots(item.stroke)]
    by = _fitted(ours, theirs)
    off = max(abs(by(a) - b) for a, b in zip(ours, theirs, strict=True))
    allowed = MORE * rounding * max(1.0, abs(by.p))
    if not (off <= allowed and _round_off(right, there, abs(by.p)) <= allowed):
        return None
    return Shift(by, max(abs(a - b) for a, b in zip(ours, theirs, strict=True)))


def _round_off(right: Sequence[Item], there: Sequence[Item], scale: float) -> float:
    """Give how far radii of circles are off that were drawn so many times as large, mm."""
    pairs = ((ours.stroke, theirs.stroke) for ours, theirs in zip(right, there, strict=True))
    off = (abs(a.radius * scale - b.radius) for a, b in pairs if isinstance(a, Circle) and isinstance(b, Circle))
    return max(off, default=0.0)


def _of_one_kind(ours: Item, theirs: Item) -> bool:
    return ours.what == theirs.what and ours.name == theirs.name and _as_many(ours, theirs)


def _as_many(ours: Item, theirs: Item) -> bool:
    return type(ours.stroke) is type(theirs.stroke) and len(spots(ours.stroke)) == len(spots(theirs.stroke))


def _fitted(ours: Sequence[complex], theirs: Sequence[complex]) -> Affine:
    """Fit a similarity by least squares; a mere shift where the points are all one."""
    centre, target = sum(ours) / len(ours), sum(theirs) / len(theirs)
    spread = sum(abs(a - centre) ** 2 for a in ours)
    p = (
        sum((b - target) * (a - centre).conjugate() for a, b in zip(ours, theirs, strict=True)) / spread
        if spread
        else 1
    )
    return Affine(complex(p), 0j, target - p * centre)


def looks_alike(right: Sequence[Item], there: Sequence[Item]) -> bool:
    """Tell whether strokes that were moved as one still look as they must."""
    return all(alike(a.stroke, b.stroke) for a, b in zip(right, there, strict=True))
