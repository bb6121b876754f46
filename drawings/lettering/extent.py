"""The box around strokes and lettering, and which of many numbers have room to be written (габарит, прореживание)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Sequence

from drawings.lettering.lettering import text_reach, text_width
from drawings.paper.strokes import (
    LEAN,
    TURN,
    Arc,
    Box,
    Circle,
    Curve,
    Fill,
    Group,
    Line,
    Polyline,
    SheetError,
    Stroke,
    Text,
)
from drawings.paper.walk import flat, tied
from geometry.curve import sampled


def every(least: float, whole: int) -> int:
    """Choose how many positions apart numbers stand: a divisor of the whole turn, if one is not much above the least.

    >>> every(1.4, 24), every(4.1, 24), every(2.0, 23)
    (2, 6, 2)
    """
    first = max(math.ceil(tied(least)), 1)
    return next((step for step in range(first, 2 * first) if whole % step == 0), first)


def numbered(places: Sequence[complex], length: float, apart: float, first: Iterable[int] = ()) -> tuple[int, ...]:
    """Choose which places on a curve of some length, mm, bear their numbers: those named first always.

    Where all have room, that is all; else every so many, and none nearer than `apart` mm to another. A gap has none.

    >>> numbered([0j, 5 + 0j, 10 + 0j, 15 + 0j], 20.0, 4.0), numbered([0j, 5 + 0j, 10 + 0j, 15 + 0j], 20.0, 8.0, (3,))
    ((0, 1, 2, 3), (3, 0))
    """
    free = [k for k, place in enumerate(places) if not math.isnan(abs(place))]
    kept = [k for k in first if k in set(free)]
    step = every(apart * len(places) / length, len(places)) if length and places else 1
    if step == 1:
        return tuple(free)
    return spaced(places, apart, [k for k in free if k % step == 0], kept)


def spaced(
    places: Sequence[complex], apart: float, order: Iterable[int] | None = None, first: Iterable[int] = ()
) -> tuple[int, ...]:
    """Choose places that are no nearer than `apart` to one another: those named first always, then in an order.

    >>> spaced([1.0, 1.2, 3.0, 2.9], 0.5), spaced([1.0, 1.2, 3.0, 2.9], 0.5, (3, 2, 1), (0,))
    ((0, 2), (0, 3))
    """
    kept = [*first]
    for k in range(len(places)) if order is None else order:
        if all(tied(abs(places[k] - places[other]) - apart) >= 0 for other in kept):
            kept.append(k)
    return tuple(kept)


GRAIN = 0.01  # mm that a curve may reach beyond its box: a twentieth of the finest line


def bounds(stroke: Stroke) -> Box:
    """Give the box (left, bottom, right, top) around a stroke's geometry, line width not counted.

    >>> bounds(Group((Line(1 + 1j, 3 + 0j), Circle(0j, 1))))
    (-1.0, -1.0, 3.0, 1.0)
    """
    match stroke:
        case Line():
            return _around((stroke.start, stroke.end))
        case Polyline() | Fill():
            return _around(stroke.points)
        case Circle():
            reach = stroke.radius * (1 + 1j)
            return _around((stroke.centre - reach, stroke.centre + reach))
        case Arc():
            return _around(_extremes(stroke))
        case Curve(pieces):
            return _around(sampled(pieces, GRAIN))
        case Text():
            return _around(_corners(stroke))
        case Group():
            boxes = [bounds(inner) for inner in flat(stroke.strokes)]
            return _around([complex(*box[:2]) for box in boxes] + [complex(*box[2:]) for box in boxes])


def _around(points: tuple[complex, ...] | list[complex]) -> Box:
    if not points:
        raise SheetError("an empty group or chain has no bounds")
    across, up = [point.real for point in points], [point.imag for point in points]
    return min(across), min(up), max(across), max(up)


def _extremes(arc: Arc) -> list[complex]:
    """An arc reaches its box at its ends and at the quarter points that it passes."""
    first = math.ceil(arc.start_angle / (TURN / 4))
    last = math.floor((arc.start_angle + arc.sweep) / (TURN / 4))
    quarters = [arc.centre + arc.radius * 1j ** (k % 4) for k in range(first, last + 1)]
    return [arc.at(0), arc.at(1), *quarters]


def _corners(text: Text) -> tuple[complex, ...]:
    """Give the corners of a text's box; slanted letters lean past its end, their tails before its start."""
    width = text_width(text)
    left = {"start": 0.0, "middle": -width / 2, "end": -width}[text.anchor]
    bottom, top = text_reach(text)
    back, lean = (LEAN * bottom, LEAN * top) if text.slanted else (0.0, 0.0)
    turn = cmath.rect(1, math.radians(text.rotation))
    return tuple(text.at + complex(x, y) * turn for x in (left + back, left + width + lean) for y in (bottom, top))
