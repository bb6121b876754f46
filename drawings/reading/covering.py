"""Covering: what lies under a later area in the colour of paper, or off the paper, is not seen (перекрытие).

An area of ink hides nothing unseen: it is seen itself where it lies, as an arrowhead is over the end of its line.
"""

from __future__ import annotations

import cmath
import math
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Sequence
from functools import cache, lru_cache
from itertools import chain, pairwise
from typing import NamedTuple, TypeAlias

import numpy as np

from drawings.paper.strokes import Arc, Box, Circle, Curve, Fill, Group, Leaf, Line, LineStyle, Polyline, Stroke, Text
from drawings.reading.alphabet import notations, shape
from drawings.reading.visibility import Unseen, dark

COVERED, OUTSIDE = "covered", "outside"
# A stroke is looked at in the middles of so many equal parts; it is gone where most of them are.
_PARTS = 5
_CELL = 10.0  # mm: areas are looked up by the squares of the paper that they reach into
_MANY = 400  # squares: an area of more is looked at everywhere; areas: of more each stroke is looked at closely
_GAP, _BLANK = 2.0, 4.0  # d: between letters, and the width of one that the alphabet does not have
_MIDDLE, _WIDEST = 3j, 13.0  # d: how high the middles of letters lie; no letter of the alphabet is wider
_FACETS = 8  # of a round piece of an outline
_WHOLE = (complex(-math.inf, -math.inf), complex(math.inf, math.inf))  # the plane

_Cell: TypeAlias = tuple[float, float]  # whole numbers


class _Cover(NamedTuple):
    """An area that hides what was drawn before it: a round one about its only corner, or a polygon."""

    order: int
    corners: tuple[complex, ...]
    radius: float
    box: Box

    @property
    def wide(self) -> float:
        """From corner to corner, however the area is turned, mm."""
        return 2 * self.radius + max(abs(a - b) for a in self.corners for b in self.corners)

    def holds(self, spot: complex) -> bool:
        left, low, right, high = self.box
        if not (left < spot.real < right and low < spot.imag < high):
            return False
        if len(self.corners) == 1:
            return abs(spot - self.corners[0]) < self.radius
        sides = pairwise((*self.corners, self.corners[0]))
        return sum(crosses(a - spot, b - spot) for a, b in sides) % 2 == 1


def veiled(
    leaf: Leaf, clear: Collection[int] = (), gone: Collection[int] = (), among: Collection[int] | None = None
) -> Iterator[Unseen]:
    """Give what of a leaf, or `among` some strokes of it, is covered or off the paper.

    Of strokes by their ids: areas of `clear` let show through what is under them, those of `gone` are not painted.
    """
    strokes, names, idle = list[Stroke](), list[str](), {*clear, *gone}
    _unfold(leaf.groups, "", strokes, names)
    areas = [area for k, stroke in enumerate(strokes) if id(stroke) not in idle for area in _areas(k, stroke)]
    wide, cells = _squares(areas)
    asked = range(len(strokes)) if among is None else [k for k, stroke in enumerate(strokes) if id(stroke) in among]
    for order in _doubtful([strokes[k] for k in asked], asked, leaf, areas):
        if reason := _reason(order, strokes[order], leaf, wide, cells):
            yield Unseen(strokes[order], reason, names[order])


def _doubtful(strokes: Sequence[Stroke], orders: Sequence[int], leaf: Leaf, areas: Sequence[_Cover]) -> list[int]:
    """Give the orders of the strokes that may be off the paper or under a later area, as the boxes of all tell."""
    if len(areas) > _MANY or not strokes:
        return list(orders)
    reaches = [_reach(stroke) for stroke in strokes]
    spots, begun = np.array([*chain.from_iterable(reaches)]), np.cumsum([0, *map(len, reaches[:-1])])
    left, low = (np.minimum.reduceat(part, begun) for part in (spots.real, spots.imag))
    right, high = (np.maximum.reduceat(part, begun) for part in (spots.real, spots.imag))
    ranks = np.array(orders)
    found = ~((left >= 0) & (low >= 0) & (right <= leaf.width) & (high <= leaf.height))
    for order, _, _, (west, south, east, north) in areas:
        found |= (ranks < order) & (left < east) & (right > west) & (low < north) & (high > south)
    return [order for order, doubtful in zip(orders, found.tolist(), strict=True) if doubtful]


def _reach(stroke: Stroke) -> Sequence[complex]:
    """Give corners of a box in which all that is looked at of a stroke is for certain; of a curve any box."""
    match stroke:
        case Text():
            turn = _turn(stroke.rotation) * (stroke.size / 10)
            middle = stroke.at + _MIDDLE * turn
            return middle, middle + len(stroke.plain) * (_WIDEST + _GAP) * turn
        case Line():
            return stroke[:2]
        case Circle() | Arc():
            half = stroke.radius * (1 + 1j)
            return stroke.centre - half, stroke.centre + half
        case Polyline() | Fill():
            return stroke.points or _WHOLE
    return _WHOLE


@lru_cache(maxsize=256)
def _turn(rotation: float) -> complex:
    return cmath.rect(1, math.radians(rotation))


def small(leaf: Leaf, most: float) -> set[int]:
    """Give the strokes, by their ids, that fill no area wider than a symbol of so many mm from corner to corner."""
    strokes = list[Stroke]()
    _unfold(leaf.groups, "", strokes, [])
    return {id(stroke) for stroke in strokes if all(area.wide <= most for area in _areas(0, stroke))}


def _reason(order: int, stroke: Stroke, leaf: Leaf, wide: Sequence[_Cover], cells: dict[_Cell, list[_Cover]]) -> str:
    spots = _spots(stroke)
    most = 0 if isinstance(stroke, Text) else len(spots) // 2  # of lettering each letter counts
    width, height = leaf.width, leaf.height
    if sum([not (0 <= spot.real <= width and 0 <= spot.imag <= height) for spot in spots]) > most:
        return OUTSIDE
    over, under = [area for area in wide if area.order > order], 0
    for spot in spots:
        near = cells.get((spot.real // _CELL, spot.imag // _CELL), ())
        if near or over:
            under += any(area.order > order and area.holds(spot) for area in (*near, *over))
    return COVERED if under > most else ""


def _unfold(groups: Iterable[Stroke], name: str, strokes: list[Stroke], names: list[str]) -> None:
    """List the strokes within groups in their order, and beside them the name of the innermost group that has one."""
    for stroke in groups:
        if isinstance(stroke, Group):
            _unfold(stroke.strokes, stroke.name or name, strokes, names)
        else:
            strokes.append(stroke)
            names.append(name)


def _squares(areas: Iterable[_Cover]) -> tuple[list[_Cover], dict[_Cell, list[_Cover]]]:
    """Give areas by the squares that they reach into; those that reach into very many by themselves."""
    wide, cells = [], defaultdict[_Cell, list[_Cover]](list)
    for area in areas:
        left, low, right, high = (int(side // _CELL) for side in area.box)
        if (right - left + 1) * (high - low + 1) > _MANY:
            wide.append(area)
            continue
        for across in range(left, right + 1):
            for up in range(low, high + 1):
                cells[across, up].append(area)
    return wide, cells


def _areas(order: int, stroke: Stroke) -> Sequence[_Cover]:
    """Give what a stroke fills; a broad line in the colour of paper fills what lies under it."""
    if isinstance(stroke, Text | Group):
        return ()
    pale, white = _hides(stroke.style)
    return [*_filled(order, stroke, pale, white)] if pale or white else ()


def _filled(order: int, stroke: Stroke, pale: bool, white: bool) -> Iterator[_Cover]:
    assert not isinstance(stroke, Text | Group)
    if pale:
        if isinstance(stroke, Circle):
            yield _area(order, (stroke.centre,), stroke.radius)
        elif len(around := tuple(corners(stroke))) > 2:
            yield _area(order, around, 0.0)
    if white:
        half = stroke.style.width / 2
        for a, b in pairwise(corners(stroke)):
            side = (b - a) / abs(b - a) * 1j * half if a != b else 0j
            yield _area(order, (a + side, b + side, b - side, a - side), 0.0)


@lru_cache(maxsize=256)
def _hides(style: LineStyle) -> tuple[bool, bool]:
    """Tell whether a filling is in the colour of paper, and whether a line is."""
    line = style.colour != "none" and style.width > 0 and not dark(style.colour)
    return style.fill != "none" and not dark(style.fill), line


def _area(order: int, corners: tuple[complex, ...], radius: float) -> _Cover:
    across, up = [corner.real for corner in corners], [corner.imag for corner in corners]
    box = min(across) - radius, min(up) - radius, max(across) + radius, max(up) + radius
    return _Cover(order, corners, radius, box)


def corners(stroke: Stroke) -> Iterator[complex]:
    """Give the corners of an outline, round ones in facets."""
    match stroke:
        case Line(start, end):
            yield from (start, end)
        case Polyline() | Fill():
            yield from stroke.points
            if isinstance(stroke, Polyline) and stroke.closed:
                yield stroke.points[0]
        case Arc():
            yield from (stroke.at(k / _FACETS) for k in range(_FACETS + 1))
        case Circle(centre, radius):
            yield from (centre + cmath.rect(radius, math.tau * k / _FACETS) for k in range(_FACETS + 1))
        case Curve():
            yield from (piece.at(k / _FACETS) for piece in stroke.pieces for k in range(_FACETS))
            yield stroke.pieces[-1].at(1.0)


def _spots(stroke: Stroke) -> list[complex]:
    """Give places by which a stroke is looked at: the middles of its parts, of lettering of each letter."""
    match stroke:
        case Line(start, end):
            return [start + (end - start) * share for share in _SHARES]
        case Arc():
            return [stroke.at(share) for share in _SHARES]
        case Circle(centre, radius):
            return [centre + cmath.rect(radius, math.tau * share) for share in _SHARES]
        case Polyline() | Fill():
            return _thinned([(a + b) / 2 for a, b in pairwise(corners(stroke))])
        case Curve():
            return _thinned([piece.at(share) for piece in stroke.pieces for share in _SHARES])
        case Text():
            return list(_letters(stroke))
    return []


_SHARES = tuple((k + 0.5) / _PARTS for k in range(_PARTS))


def _thinned(spots: list[complex]) -> list[complex]:
    return spots if len(spots) <= 2 * _PARTS else spots[:: len(spots) // (2 * _PARTS) + 1]


def _letters(text: Text) -> Iterator[complex]:
    turn, pen = cmath.rect(1, math.radians(text.rotation)), text.size / 10
    middle, along = text.at + _MIDDLE * pen * turn, 0.0
    for run in text.runs:
        thick = pen if run.level == 0 else pen * 0.7
        for letter in run.text:
            width = _width(letter)
            if not letter.isspace():
                yield middle + turn * (along + width * thick / 2)
            along += (width + _GAP) * thick


@cache
def _width(letter: str) -> float:
    return shape(letter).width if letter in notations() else _BLANK


def crosses(a: complex, b: complex) -> bool:
    """Tell whether a side, seen from a spot, crosses the ray that goes right from it."""
    if (a.imag > 0) == (b.imag > 0):
        return False
    return a.real + (b.real - a.real) * a.imag / (a.imag - b.imag) > 0
