"""Similarity: how strokes that belong together were moved, turned and scaled as one (преобразование подобия)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from typing import NamedTuple

from drawings.collation.items import Ink, Item, spots
from drawings.collation.matching import alike
from drawings.measure.transform import Affine
from drawings.paper.strokes import Circle

MORE = 2  # times the rounding: of what an editor wrote anew, both places are rounded

LINES = 2  # that show how they were stretched
FLAT = 1e-9  # of points as good as on one line: their spread across it is a thirty-thousandth of that along it


class Shift(NamedTuple):
    """How a part of a sheet was moved: its map, a similarity or not, and how far it moves what goes farthest, mm."""

    by: Affine
    farthest: float

    @property
    def scale(self) -> float:
        """How many times as large it makes what it moves."""
        return abs(self.by.p)

    @property
    def how(self) -> str:
        """Say whether it moves, mirrors, or stretches in one direction."""
        if not self.by.stretched and abs(self.by.p) > abs(self.by.q):
            return "moved"
        return "mirrored" if abs(self.by.q) > abs(self.by.p) else "stretched"

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
    z, w = [a - centre for a in ours], [b - target for b in theirs]
    spread = sum(abs(a) ** 2 for a in z)
    p = _times(w, [a.conjugate() for a in z]) / spread if spread else 1
    return Affine(complex(p), 0j, target - p * centre)


def stretch_of(right: Sequence[Item], there: Sequence[Item], rounding: float) -> Shift | None:
    """Find how lines were stretched or mirrored as one, one to one in their order; None where they were not."""
    if len(right) != len(there) or len(right) < LINES:
        return None
    ours = [spot for item in right for spot in spots(item.stroke)]
    theirs = [spot for item in there for spot in spots(item.stroke)]
    by = _sheared(ours, theirs)
    if by is None or not max(abs(by(a) - b) for a, b in zip(ours, theirs, strict=True)) <= MORE * rounding * _reach(by):
        return None
    return Shift(by, max(abs(a - b) for a, b in zip(ours, theirs, strict=True)))


def _sheared(ours: Sequence[complex], theirs: Sequence[complex]) -> Affine | None:
    """Fit a map of the plane by least squares; None where all points are on one line."""
    centre, target = sum(ours) / len(ours), sum(theirs) / len(theirs)
    z, w = [a - centre for a in ours], [b - target for b in theirs]
    back = [a.conjugate() for a in z]
    spread, lean = sum(abs(a) ** 2 for a in z), _times(back, back)
    area = spread**2 - abs(lean) ** 2
    if not area > FLAT * spread**2:
        return None
    straight, turned = _times(w, back), _times(w, z)
    p, q = (straight * spread - turned * lean) / area, (turned * spread - straight * lean.conjugate()) / area
    return Affine(p, q, target - p * centre - q * centre.conjugate())


def _reach(by: Affine) -> float:
    """Give how many times as long a map makes what it makes longest, and 1 at the least."""
    return max(1.0, abs(by.p) + abs(by.q))


def _times(a: Sequence[complex], b: Sequence[complex]) -> complex:
    return sum((x * y for x, y in zip(a, b, strict=True)), 0j)


def looks_alike(right: Sequence[Item], there: Sequence[Item], scale: float) -> bool:
    """Tell whether strokes that were moved as one still look as they must, their lines as wide or scaled with them."""
    pairs = [(a.stroke, b.stroke) for a, b in zip(right, there, strict=True)]
    return all(alike(a, b) for a, b in pairs) or all(alike(_wider(a, scale), b) for a, b in pairs)


def _wider(stroke: Ink, scale: float) -> Ink:
    """Give a stroke with its line so many times as wide, and its dashes so many times as long."""
    style = stroke.style._replace(
        width=stroke.style.width * scale, dash=tuple(one * scale for one in stroke.style.dash)
    )
    return stroke._replace(style=style)
