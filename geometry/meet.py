"""Meetings of lines and arcs (засечки): stateless, on one complex number or on an array of them.

Every function works with relative vectors: it is given the vector between the two loci's own points and gives back the
vectors from those points to the meeting, so that a figure far from the origin loses nothing.
"""

from __future__ import annotations

from typing import Any, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

Vectors: TypeAlias = npt.NDArray[np.complexfloating[Any, Any]] | complex
Sizes: TypeAlias = npt.NDArray[np.floating[Any]] | float

EPS = float(np.finfo(np.float64).eps)
# A distance reaches a meeting with a few roundings of its own: two coordinates, a difference, a root. Loci that touch
# within this many eps of the triangle's perimeter cannot be told from tangent ones, and are called a dead centre.
TANGENCY = 4.0


class Meeting(NamedTuple):
    """Where two loci meet: vectors to it from each locus's point, sharpness, and by how much they miss (metres).

    Sharpness is the sine of the crossing angle: 1 is a square meeting, 0 a dead centre. A miss above 0 makes the
    vectors NaN.
    """

    first: Vectors
    second: Vectors
    sharpness: Sizes
    miss: Sizes


def cross(a: Vectors, b: Vectors) -> Sizes:
    """Give ax*by - ay*bx, the moment of b about the start of a.

    >>> cross(2 + 0j, 3j)
    6.0
    """
    return a.real * b.imag - a.imag * b.real


def dot(a: Vectors, b: Vectors) -> Sizes:
    """Give ax*bx + ay*by."""
    return a.real * b.real + a.imag * b.imag


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN, and told by its miss
def arc_arc(base: Vectors, first: Sizes, second: Sizes, side: Sizes) -> Meeting:
    """Meet two arcs of radii `first` and `second`; `base` is the vector between their centres (засечка двух дуг).

    `side` is +1 for the meeting on the left of the ray from the first centre to the second, -1 on the right. The
    height is twice Kahan's area of the triangle over its base, so that a needle triangle keeps every digit
    (W. Kahan, Miscalculating Area and Angles of a Needle-like Triangle).

    >>> complex(arc_arc(6 + 0j, 5.0, 5.0, +1).first)
    (3+4j)
    """
    distance = np.abs(base)
    long, short = np.maximum(first, second), np.minimum(first, second)
    a, c = np.maximum(long, distance), np.minimum(short, distance)
    b = np.maximum(short, np.minimum(long, distance))
    spare = a - b
    margin = c - spare  # >= 0 where the three sides close a triangle
    perimeter = a + (b + c)
    touching = TANGENCY * EPS * perimeter
    gap = margin < -touching
    closes = np.where(gap, np.nan, np.where(margin <= touching, 0.0, margin))
    half = 0.5 * np.sqrt(perimeter * closes * (c + spare) * (a + (b - c)))  # twice the area
    skew = (first - second) * (first + second) / distance
    rise = 1j * (side * (half / distance / distance))
    return Meeting(
        base * (0.5 * (distance + skew) / distance + rise),
        base * (rise - 0.5 * (distance - skew) / distance),
        np.where(gap, 0.0, half / (first * second)),
        np.where(gap, -margin, 0.0),
    )


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN, and told by its miss
def line_arc(base: Vectors, direction: Vectors, radius: Sizes, side: Sizes) -> Meeting:
    """Meet a directed line with an arc; `base` leads from the line's point to the centre, `direction` is of size 1.

    `side` is +1 for the meeting ahead of the foot of the perpendicular from the centre, -1 behind it.

    >>> complex(line_arc(0 - 3j, 1 + 0j, 5.0, +1).second)
    (4+3j)
    """
    height = -cross(direction, base)  # signed distance of the line from the centre, positive on the left
    offset = np.abs(height)
    margin = radius - offset
    touching = TANGENCY * EPS * (radius + offset)
    dead = np.abs(margin) <= touching
    half = np.sqrt(np.where(dead, 0.0, np.maximum(margin, 0.0)) * (radius + offset))
    gap = margin < -touching
    lost = np.where(gap, np.nan, 1.0)
    along = side * half
    return Meeting(
        direction * ((dot(direction, base) + along) * lost),
        direction * (along * lost + 1j * height),
        half / radius,
        np.where(gap, -margin, 0.0),
    )


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN, and told by its miss
def line_line(base: Vectors, first: Vectors, second: Vectors) -> Meeting:
    """Meet two lines of directions `first` and `second` (any sizes); `base` leads from the first's point to the other.

    Lines whose directions differ by no more than the rounding of a direction are parallel: NaN and sharpness 0.

    >>> complex(line_line(2 + 1j, 1 + 0j, 1j).first)
    (2+0j)
    """
    turn = cross(first, second)
    size = np.abs(first) * np.abs(second)
    sharpness = np.abs(turn) / size
    parallel = sharpness <= TANGENCY * EPS
    turn = np.where(parallel, np.nan, turn)
    return Meeting(
        first * (cross(base, second) / turn),
        second * (cross(base, first) / turn),
        np.where(parallel, 0.0, sharpness),
        np.zeros_like(sharpness),
    )


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN, and told by its miss
def tangent_direction(base: Vectors, offset: Sizes, side: Sizes) -> Meeting:
    """Direct a slot that passes a pivot at `offset` and holds a pin; `base` leads from the pivot to the pin.

    The pin lies `offset` to the left of the line through the pivot; `side` is +1 where it lies ahead of the pivot, -1
    behind. The tangent from the pin to the circle of radius |offset| about the pivot has this direction. `first` is the
    unit direction, `second` the vector along the slot from the pivot's foot to the pin's.

    >>> complex(tangent_direction(0 + 4j, 0.0, +1).first)
    1j
    """
    distance = np.abs(base)
    margin = distance - np.abs(offset)
    touching = TANGENCY * EPS * (distance + np.abs(offset))
    dead = np.abs(margin) <= touching
    reach = side * np.sqrt(np.where(dead, 0.0, np.maximum(margin, 0.0)) * (distance + np.abs(offset)))
    gap = margin < -touching
    square = np.where(gap | (distance == 0), np.nan, distance)
    unit = (base / square) * ((reach - 1j * offset) / square)
    return Meeting(unit, unit * reach, np.abs(reach) / square, np.where(gap, -margin, 0.0))
