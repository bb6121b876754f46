"""Lanes: vectors that run along one another on paper, drawn side by side (параллельное смещение векторов)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial
from typing import TypeAlias

from drawings.paper.walk import MARGIN, tied, tied_spot

Segment: TypeAlias = tuple[complex, complex]
Box: TypeAlias = tuple[float, float, float, float]  # left, bottom, right, top

EVERYWHERE: Box = (-math.inf, -math.inf, math.inf, math.inf)

APART = 3.2  # mm between two lanes: the arrowheads of both, 1.8 wide each on A1, and paper between them
NEAR = 1.0  # mm: lines of 0.7 with their axes nearer than this are one to the eye
SHARE = 0.35  # of the shorter line that may be so near: two that leave one corner are 3 mm apart at its end
SHORT = 15.0  # mm: beside a line shorter than this, only what is nearer than a fifteenth of its length is near
ABREAST = math.sin(math.radians(1)), 3.0  # lines at less than a degree are not so near for more than 3 mm
THROUGH = 0.5  # mm: a line so near the middle of all runs through it


def merging(line: Segment, other: Segment) -> bool:
    """Tell whether two lines run so near each other for so long that they are read as one.

    >>> merging((0j, 50 + 0j), (10 + 0.3j, 40 + 0.3j)), merging((0j, 50 + 0j), (0j, 30 + 30j))
    (True, False)
    """
    along, beside = line[1] - line[0], other[1] - other[0]
    shorter = min(abs(along), abs(beside))
    near = min(NEAR, NEAR * shorter / SHORT)
    run = min(_beside(line, other, near), _beside(other, line, near))
    slope, most = ABREAST
    abreast = abs((along.conjugate() * beside).imag) < slope * abs(along) * abs(beside)
    return tied(run - SHARE * shorter) > 0 or (abreast and tied(run) > most)


def crossing(line: Segment, other: Segment) -> bool:
    """Tell whether two lines cross each other between their ends."""
    return all(
        tied(((end - start).conjugate() * (a - start)).imag * ((end - start).conjugate() * (b - start)).imag) < 0
        for (start, end), (a, b) in ((line, other), (other, line))
    )


def nearest(start: complex, end: complex, spot: complex) -> complex:
    """Give the place of a piece of a line that is nearest to a spot.

    >>> nearest(0j, 4 + 0j, 3 + 2j), nearest(0j, 4 + 0j, 7 + 2j)
    ((3+0j), (4+0j))
    """
    along = end - start
    share = ((spot - start) * along.conjugate()).real / (abs(along) ** 2 or 1.0)
    return start + min(max(share, 0.0), 1.0) * along


def parallel_offsets(
    segments: Sequence[Segment], apart: float = APART, room: complex = APART * (1 + 1j), inside: Box = EVERYWHERE
) -> list[complex]:
    """Give the shift of each line, mm, that keeps it from merging with those before it; most have none.

    A shift is square to its line and leads nowhere outside a box; the lanes are `apart`, but a line between two others
    has the room of a letter, given as its width + 1j * its height, on one of its sides. Of two sides the one with fewer
    lines beside it is taken, or the outer one.
    """
    middle = sum(((start + end) / 2 for start, end in segments), 0j) / max(len(segments), 1)
    before: list[Segment] = []
    shifts: list[complex] = []
    for segment in segments:
        merges = segment[0] != segment[1] and any(merging(segment, other) for other in before)
        shifts.append(_shift(segment, before, _lanes(segment, middle, apart, room), inside) if merges else 0j)
        before.append(offset(segment, shifts[-1]))
    return shifts


def offset(segment: Segment, shift: complex) -> Segment:
    """Shift a line."""
    return segment[0] + shift, segment[1] + shift


def _lanes(segment: Segment, middle: complex, apart: float, letter: complex) -> list[tuple[complex, complex, float]]:
    """Give the shifts to try, the nearest first, the outer one of each pair first; and the room of a letter there."""
    out = _outward(segment, middle)
    room = abs(out.real) * letter.real + abs(out.imag) * letter.imag
    steps = (apart, room, apart + room, 2 * room, apart + 2 * room, 3 * room)
    return [(step * out, -step * out, room) for step in steps]


def _shift(
    segment: Segment, before: Sequence[Segment], tries: Sequence[tuple[complex, complex, float]], inside: Box
) -> complex:
    """Find the nearest lane that is free, in the box if there is one, or else without room for a letter; or none."""
    for kept, roomy in ((True, True), (True, False), (False, False)):
        for *sides, room in tries:
            free = [
                (sum(_abreast(line, other, APART) for other in before), number, shift)
                for number, shift in enumerate(sides)
                if not any(map(partial(merging, line := offset(segment, shift)), before))
                and (not kept or _within(line, inside)) and (not roomy or _roomy(line, before, 0.95 * room))
            ]  # fmt: skip
            if free:
                return min(free)[2]
    return 0j


def _within(segment: Segment, inside: Box) -> bool:
    left, bottom, right, top = inside
    ends = map(tied_spot, segment)
    return all(left <= end.real <= right and bottom <= end.imag <= top for end in ends)


def _roomy(segment: Segment, before: Sequence[Segment], room: float) -> bool:
    """Tell whether a line leaves each of those beside it, and itself, a side for its letter."""
    every = [segment, *before]
    return not any(
        len({_left(line, other) for other in every if other is not line and _abreast(line, other, room)}) > 1
        for line in every if line is segment or _abreast(line, segment, room)
    )  # fmt: skip


def _abreast(line: Segment, other: Segment, room: float) -> bool:
    """Tell whether a line has another nearer than a letter's room for most of its length: one just so far is not."""
    return tied(_beside(line, other, room - MARGIN) - abs(line[1] - line[0]) / 2) > 0


def _left(line: Segment, other: Segment) -> bool:
    """Tell whether the middle of a line is to the left of another."""
    along = line[1] - line[0]
    return tied((along.conjugate() * (sum(other) / 2 - line[0])).imag) > 0


def _outward(segment: Segment, middle: complex) -> complex:
    """Give the direction square to a line that leads away from the middle of all; of a line through it, to the right.

    >>> _outward((0j, 10j), 5 + 5j), _outward((10j, 0j), 5j)
    ((-1+0j), (1+0j))
    """
    start, end = segment
    across = 1j * (end - start) / abs(end - start)
    away = (((start + end) / 2 - middle) * across.conjugate()).real
    if tied(abs(away)) < THROUGH:
        away = across.real if tied(abs(across.real) - abs(across.imag)) > 0 else across.imag
    return across if tied(away) >= 0 else -across


def _beside(line: Segment, other: Segment, near: float) -> float:
    """Give the length for which a line is nearer to another than `near`: its part in the other's rounded strip.

    >>> _beside((0j, 8 + 0j), (0j, 4 + 0j), 1.0), _beside((0j, 8 + 0j), (2 - 4j, 2 + 4j), 1.0)
    (5.0, 2.0)
    """
    along = line[1] - line[0]
    length = abs(along)
    inside = [*_between(line, other, near), *(span for end in other for span in _around(line, end, near))]
    if not inside:
        return 0.0
    low, high = min(span[0] for span in inside), max(span[1] for span in inside)  # the strip is convex
    return length * max(min(high, 1.0) - max(low, 0.0), 0.0)


def _around(line: Segment, centre: complex, near: float) -> list[tuple[float, float]]:
    """Give the shares of a line between which it is nearer to a place than `near`."""
    along, away = line[1] - line[0], line[0] - centre
    size, across = abs(along), (along.conjugate() * away).imag
    left = (near * size) ** 2 - across**2
    if size == 0 or left <= 0:
        return []
    middle, half = -(along.conjugate() * away).real / size**2, math.sqrt(left) / size**2
    return [(middle - half, middle + half)]


def _between(line: Segment, other: Segment, near: float) -> list[tuple[float, float]]:
    """Give the shares of a line between which it lies in the strip of another, `near` to both sides, ends square."""
    size = abs(other[1] - other[0])
    if size == 0:
        return []
    along = (other[1] - other[0]) / size
    first, last = ((end - other[0]) * along.conjugate() for end in line)
    low, high = -math.inf, math.inf
    for start, end, least, most in ((first.real, last.real, 0.0, size), (first.imag, last.imag, -near, near)):
        if start == end:
            if not least <= start <= most:
                return []
            continue
        shares = sorted(((least - start) / (end - start), (most - start) / (end - start)))
        low, high = max(low, shares[0]), min(high, shares[1])
    return [(low, high)] if low < high else []
