"""The frames about the cells of a table that nobody has filled in, of each of its parts on paper (рамка таблицы)."""

from __future__ import annotations

import cmath
import math
from bisect import bisect
from collections.abc import Iterable, Iterator, Sequence
from types import MappingProxyType
from typing import NamedTuple, TypeAlias

from drawings.lettering.extent import bounds
from drawings.paper.strokes import Leaf, Line, Polyline, Run, Stroke, Text
from drawings.paper.walk import flat
from drawings.reading.transform import Affine

LEVEL = 0.2  # mm: a line that is out by more is no line of a table, and two that are nearer are one
SHORT = 2.0  # mm: no cell is smaller
EITHER = MappingProxyType({"0": "0", "6": "9", "8": "8", "9": "6"})  # digits that are read on their heads too


class Box(NamedTuple):
    """A box on paper, mm."""

    left: float
    low: float
    right: float
    high: float

    @property
    def corners(self) -> tuple[complex, complex, complex, complex]:
        """The corners, from the lower left on, counter-clockwise."""
        low, high = complex(0, self.low), complex(0, self.high)
        return self.left + low, self.right + low, self.right + high, self.left + high

    def holds(self, spot: complex) -> bool:
        """Tell whether a place is in it."""
        return self.left < spot.real < self.right and self.low < spot.imag < self.high


class Rule(NamedTuple):
    """A line along or up a sheet, mm: how high or how far along it lies, and between which ends."""

    at: float
    low: float
    high: float

    def passes(self, spot: float) -> bool:
        """Tell whether it passes by a place."""
        return self.low - LEVEL <= spot <= self.high + LEVEL


class Ruling(NamedTuple):
    """The lines of a sheet that is laid upright, its texts by their middles, and the middles of its other ink."""

    levels: tuple[Rule, ...]
    uprights: tuple[Rule, ...]
    texts: tuple[tuple[complex, Text], ...]
    ink: tuple[complex, ...]

    def around(self, spot: complex) -> Box | None:
        """Give the cell about a place; None where no lines are about it."""
        columns, rows = self.columns(spot.imag), self.rows(spot.real)
        k, j = bisect(columns, spot.real), bisect(rows, spot.imag)
        if not 0 < k < len(columns) or not 0 < j < len(rows):
            return None
        return Box(columns[k - 1], rows[j - 1], columns[k], rows[j])

    def columns(self, height: float) -> list[float]:
        """Give where upright lines pass by a height, from left to right."""
        return _once(one.at for one in self.uprights if one.passes(height))

    def rows(self, along: float) -> list[float]:
        """Give where level lines pass by a place along the sheet, upward."""
        return _once(one.at for one in self.levels if one.passes(along))

    def below(self, box: Box) -> float:
        """Give how far down the upright line on the left of a box goes."""
        return min(one.low for one in self.uprights if _on(one, box.left) and one.passes(box.low))

    def right_of(self, box: Box) -> float:
        """Give how far to the right the level line under a box goes."""
        return max(one.high for one in self.levels if _on(one, box.low) and one.passes(box.right))


def ruling(leaf: Leaf, moved: Affine) -> Ruling:
    """Read the ruling of a sheet that was `moved` as a whole."""
    levels, uprights, own = list[Rule](), list[Rule](), list(flat(leaf.groups))
    lines = [(one, ends) for one in own if (ends := _ends(one)) is not None]
    for start, end in ([(spot - moved.t) / moved.p for spot in ends] for _, ends in lines):
        along, middle = end - start, (start + end) / 2
        if abs(along.imag) <= LEVEL and abs(along.real) >= SHORT:
            levels.append(Rule(middle.imag, *sorted((start.real, end.real))))
        elif abs(along.real) <= LEVEL and abs(along.imag) >= SHORT:
            uprights.append(Rule(middle.real, *sorted((start.imag, end.imag))))
    ruled = {id(one) for one, _ in lines}
    spots = [((_middle(one) - moved.t) / moved.p, one) for one in own if id(one) not in ruled]
    texts = tuple((spot, _upright(one, moved)) for spot, one in spots if isinstance(one, Text))
    return Ruling(
        tuple(levels), tuple(uprights), texts, tuple(spot for spot, one in spots if not isinstance(one, Text))
    )


def _upright(text: Text, moved: Affine) -> Text:
    """Give a text as it is read on a sheet laid upright: what stands on its head there was read the wrong way round."""
    off = math.radians(text.rotation) - cmath.phase(moved.p)
    if math.cos(off) > 0 or not set(text.plain) <= set(EITHER):
        return text
    return text._replace(content=(Run("".join(EITHER[sign] for sign in reversed(text.plain))),))


def _ends(one: Stroke) -> tuple[complex, complex] | None:
    if isinstance(one, Line):
        return one.start, one.end
    points = one.points if isinstance(one, Polyline) else ()
    return (points[0], points[1]) if len(points) == 2 else None


def _middle(one: Stroke) -> complex:
    left, low, right, high = bounds(one)
    return complex(left + right, low + high) / 2


def _on(one: Rule, place: float) -> bool:
    return abs(one.at - place) <= LEVEL


def _once(places: Iterable[float]) -> list[float]:
    """Give places from the least to the greatest, those that are one once."""
    return list(_ruling_apart(sorted(places)))


def _ruling_apart(places: Iterable[float]) -> Iterator[float]:
    last = None
    for place in places:
        if last is None or place - last > LEVEL:
            yield place
            last = place


Quad: TypeAlias = tuple[complex, ...]  # the corners of a cell on paper, mm, from the lower left on, counter-clockwise


def frames(cells: Sequence[Quad]) -> tuple[Quad, ...]:
    """Give the corners of the frames about some cells; those farther apart than one is wide have frames of their own.

    >>> frames([(0j, 2 + 0j, 2 + 1j, 1j), (1j, 2 + 1j, 2 + 2j, 2j), (9j, 2 + 9j, 2 + 10j, 10j)])
    ((0j, (2+0j), (2+2j), 2j), (9j, (2+9j), (2+10j), 10j))
    """
    if not cells:
        return ()
    along = cells[0][1] - cells[0][0]
    way, gap = along / abs(along), abs(along)
    found: list[Box] = []
    for cell in cells:
        own = _about([spot / way for spot in cell])
        beside = [one for one in found if _apart(one, own) <= gap]
        found = [one for one in found if one not in beside]
        found.append(_about([spot for one in (*beside, own) for spot in one.corners]))
    return tuple(tuple(spot * way for spot in one.corners) for one in found)


def _about(spots: Sequence[complex]) -> Box:
    wide, high = [spot.real for spot in spots], [spot.imag for spot in spots]
    return Box(min(wide), min(high), max(wide), max(high))


def _apart(one: Box, other: Box) -> float:
    """Give how far two boxes are from one another, across or up."""
    across = max(one.left - other.right, other.left - one.right, 0.0)
    return max(across, one.low - other.high, other.low - one.high)
