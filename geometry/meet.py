"""Meetings of lines and arcs (засечки): stateless, on one complex number or on an array of them.

Every function works with relative vectors: it is given the vector between the two loci's own points and gives back the
vectors from those points to the meeting, so that a figure far from the origin loses nothing.
"""

from typing import Any, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

Vectors: TypeAlias = npt.NDArray[np.complexfloating[Any, Any]] | complex
Sizes: TypeAlias = npt.NDArray[np.floating[Any]] | float

EPS = float(np.finfo(np.float64).eps)
# A distance reaches a meeting with a few roundings of its own: two coordinates, a difference, a root. Loci that touch
# within this many eps of the triangle's perimeter cannot be told from tangent ones, and are called a dead centre.
TANGENCY = 4.0
# Where the squared sine of a crossing is less, a rounding of a length or of the crank angle moves the velocities found
# from it by a thousandth of themselves, which can be seen on a plan: the condition does not bear them.
UNBORNE = 1000.0 * EPS


class Meeting(NamedTuple):
    """Where two loci meet: vectors to it from each locus's point, how they cross, and by how much they miss (metres).

    `across` is the moment of two vectors of the sizes `sides` that cross as the loci do: 0 at a dead centre. A miss
    above 0 makes the vectors NaN. A `clear` meeting is at all positions well away from a miss and a dead centre.
    `into_first` and `into_second` tell how many times the directions of two lines go into the vectors.
    """

    first: Vectors
    second: Vectors
    across: Sizes
    sides: tuple[Vectors | Sizes, Vectors | Sizes]
    miss: Sizes
    clear: bool
    into_first: Sizes = np.nan
    into_second: Sizes = np.nan

    @property
    def sharpness(self) -> Sizes:
        """The sine of the crossing angle: 1 is a square meeting, 0 a dead centre."""
        side, other = self.sides
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(np.abs(self.across) / (np.abs(side) * np.abs(other)))


def cross(a: Vectors, b: Vectors) -> Sizes:
    """Give ax*by - ay*bx, the moment of b about the start of a.

    >>> cross(2 + 0j, 3j)
    6.0
    """
    return a.real * b.imag - a.imag * b.real


def dot(a: Vectors, b: Vectors) -> Sizes:
    """Give ax*bx + ay*by."""
    return a.real * b.real + a.imag * b.imag


def seen_from(a: Vectors, b: Vectors) -> Vectors:
    """Give b along a and square to a, times |a|: dot(a, b) + i cross(a, b), in one multiplication.

    >>> complex(seen_from(2j, 3 + 4j))
    (8-6j)
    """
    return np.conjugate(a) * b


class Radii(NamedTuple):
    """The radii of two arcs, with all that their meetings need of them at any distance of the centres.

    `spare` is the longer radius less the shorter; `more` and `less` are what the rounding of `total` and `spare` lost.
    """

    first: Sizes
    second: Sizes
    total: Sizes
    more: Sizes
    spare: Sizes
    less: Sizes
    skew: Sizes  # half the difference of their squares
    limit: Sizes  # of the product of both margins: above it neither is near touching


def radii(first: Sizes, second: Sizes) -> Radii:
    """Take two radii for a meeting of arcs."""
    total, more = _sum(first, second)
    spare, less = _sum(np.maximum(first, second), -np.minimum(first, second))
    # Both margins together are twice the shorter radius, so that each is at most as large.
    limit = np.max((total - spare) * (2 * UNBORNE * total))
    return Radii(first, second, total, more, spare, less, 0.5 * (first - second) * (first + second), limit)


def arc_arc(base: Vectors, first: Sizes, second: Sizes, side: Sizes) -> Meeting:
    """Meet two arcs of radii `first` and `second`; `base` is the vector between their centres (засечка двух дуг).

    `side` is +1 for the meeting on the left of the ray from the first centre to the second, -1 on the right.

    >>> complex(arc_arc(6 + 0j, 5.0, 5.0, +1).first)
    (3+4j)
    """
    return two_arcs(base, radii(first, second), side)


def two_arcs(base: Vectors, arcs: Radii, side: Sizes) -> Meeting:
    """Meet two arcs as `arc_arc` does.

    The height is twice the triangle's area over its base. The area is Heron's with factors that are rounded but once,
    so that a needle triangle keeps every digit: the sum and the difference of the radii come with what their rounding
    lost (after W. Kahan, Miscalculating Area and Angles of a Needle-like Triangle).
    """
    distance, total, spare = np.abs(base), arcs.total, arcs.spare
    outer, inner = total - distance, distance - spare  # >= 0 where the three sides close
    outer += arcs.more
    inner -= arcs.less
    closing, square = outer * inner, distance * distance
    miss: Sizes = 0.0
    clear = bool(np.minimum.reduce(closing, None, initial=np.inf) > arcs.limit)
    if not clear:
        closing, miss = _settled(np.minimum(outer, inner), total + distance, closing)
        square = np.where(distance > 0, square, np.nan)
    closing *= (total + distance) * (distance + spare)
    area = np.sqrt(closing)  # of the triangle, four times
    rise = (0.5 * side) * area
    turn = np.empty(np.shape(rise), dtype=np.complex128)
    np.divide(arcs.skew, square, out=turn.real)
    np.divide(rise, square, out=turn.imag)
    middle, half = base * turn, 0.5 * base
    across = area if clear else np.where(miss > 0, 0.0, area)
    return Meeting(middle + half, middle - half, across, (arcs.first, 2.0 * arcs.second), miss, clear)


def line_arc(base: Vectors, direction: Vectors, radius: Sizes, side: Sizes) -> Meeting:
    """Meet a directed line with an arc; `base` leads from the line's point to the centre, `direction` is of size 1.

    `side` is +1 for the meeting ahead of the foot of the perpendicular from the centre, -1 behind it.

    >>> complex(line_arc(0 - 3j, 1 + 0j, 5.0, +1).second)
    (4+3j)
    """
    centre = seen_from(direction, base)
    offset = np.abs(centre.imag)
    margin, span = radius - offset, radius + offset
    clear = _all(margin > 2 * UNBORNE * radius)
    miss: Sizes = 0.0
    if not clear:
        margin, miss = _settled(margin, span, margin)
    half = np.sqrt(margin * span)
    along = side * half
    across = half if clear else np.where(miss > 0, 0.0, half)
    return Meeting(
        direction * (centre.real + along), direction * (along - 1j * centre.imag), across, (1.0, radius), miss, clear
    )


class Crossing(NamedTuple):
    """The directions of two lines and how they cross: `turn` is their moment, NaN where they are parallel."""

    first: Vectors
    second: Vectors
    across: Sizes
    turn: Sizes
    clear: bool


def crossing(first: Vectors, second: Vectors) -> Crossing:
    """Cross two directions; those that differ by no more than the rounding of a direction are parallel."""
    turned = seen_from(first, second)
    across = turn = turned.imag
    off, along = np.abs(turn), np.abs(turned.real)
    clear = bool(np.minimum.reduce(off, None, initial=np.inf) > UNBORNE * np.maximum.reduce(along, None, initial=0.0))
    if not clear:
        parallel = off <= TANGENCY * EPS * along
        across, turn = np.where(parallel, 0.0, turn), np.where(parallel, np.nan, turn)
    return Crossing(first, second, across, turn, clear)


def line_line(base: Vectors, first: Vectors, second: Vectors) -> Meeting:
    """Meet two lines of directions `first` and `second` (any sizes); `base` leads from the first's point to the other.

    Parallel lines have no meeting: NaN and sharpness 0.

    >>> complex(line_line(2 + 1j, 1 + 0j, 1j).first)
    (2+0j)
    """
    return two_lines(base, crossing(first, second))


def two_lines(base: Vectors, lines: Crossing) -> Meeting:
    """Meet two lines as `line_line` does."""
    first, second, across, turn, clear = lines
    back = np.conjugate(base)
    once, other = (back * second).imag / turn, (back * first).imag / turn
    return Meeting(first * once, second * other, across, (first, second), 0.0, clear, once, other)


def tangent_direction(base: Vectors, offset: Sizes, side: Sizes) -> Meeting:
    """Direct a slot that passes a pivot at `offset` and holds a pin; `base` leads from the pivot to the pin.

    The pin lies `offset` to the left of the line through the pivot; `side` is +1 where it lies ahead of the pivot, -1
    behind. The tangent from the pin to the circle of radius |offset| about the pivot has this direction. `first` is the
    unit direction, `second` the vector along the slot from the pivot's foot to the pin's.

    >>> complex(tangent_direction(0 + 4j, 0.0, +1).first)
    1j
    """
    distance, size = np.abs(base), np.abs(offset)
    margin, span = distance - size, distance + size
    clear = _all(margin > 2 * UNBORNE * distance)
    miss: Sizes = 0.0
    if not clear:
        margin, miss = _settled(margin, span, margin)
        distance = np.where(distance > 0, distance, np.nan)
    reach = side * np.sqrt(margin * span)
    square = distance * distance
    unit = base * (reach / square - 1j * (offset / square))
    return Meeting(unit, unit * reach, reach, (1.0, distance), miss, clear)


def lever(arm: Vectors, along: Vectors, moment: Sizes) -> Meeting:
    """Find the force along a direction that balances a moment; `arm` leads from the fulcrum to the line of action.

    `first` is the force. A line of action through the fulcrum has no moment: NaN and sharpness 0.

    >>> complex(lever(2 + 0j, 1j, -6.0).first)
    3j
    """
    across = turn = cross(arm, along)
    far, long = np.abs(arm), np.abs(along)
    through = np.abs(across) <= TANGENCY * EPS * (far * long)
    clear = not np.logical_or.reduce(through, None)
    if not clear:
        across, turn = np.where(through, 0.0, across), np.where(through, np.nan, across)
    force = along * (-moment / turn)
    return Meeting(force, force, across, (far, long), 0.0, clear)


def _sum(a: Sizes, b: Sizes) -> tuple[Sizes, Sizes]:
    """Add two sizes: the sum, and exactly what its rounding lost (D. Knuth)."""
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


def _all(truths: npt.NDArray[np.bool_] | np.bool_) -> bool:
    return bool(np.logical_and.reduce(truths, None))


def _settled(margin: Sizes, perimeter: Sizes, value: Sizes) -> tuple[Any, Any]:
    """Make a value 0 where loci touch, NaN where they miss by more than that; and tell by how much they miss."""
    touching = TANGENCY * EPS * perimeter
    gap = margin < -touching
    settled = np.where(margin <= touching, 0.0, value)
    return np.where(gap, np.nan, settled), np.where(gap, -margin, 0.0)
