"""Curves as SVG writes them: path data read as cubics and arcs of circles, one after another in one run (кривые)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator
from typing import TypeAlias

from drawings.measure.pathdata import PathStep, steps
from drawings.paper.limits import REACH, SheetRefused
from geometry.curve import CubicPiece, Piece, RoundPiece

# The four points of a cubic, or three points of an arc: any map of the plane can be made of points.
Spots: TypeAlias = tuple[complex, ...]
_CUBIC = 4

# Editors write about six digits of a radius: an arc with more between its two is of an ellipse.
_ROUNDNESS = 1e-5


def curve(path: str) -> list[Spots]:
    """Read path data as pieces that go on from each other: cubics by four points, arcs by three.

    >>> curve("M0 0C1 0 2 1 2 2h3")[0]
    (0j, (1+0j), (2+1j), (2+2j))
    """
    found: list[Spots] = []
    for count, step in enumerate(steps(path)):
        if step.letter in "Mm" and count > 0:
            raise SheetRefused("pieces")
        found += _spots(step, found)
    if not found:
        raise SheetRefused("no_length")
    return found


def pieces(points: Iterable[Spots]) -> Iterator[Piece]:
    """Make pieces of their points; an arc whose three points are on one line is that line."""
    for spots in points:
        yield CubicPiece(*spots) if len(spots) == _CUBIC else _round(*spots)


def _spots(step: PathStep, before: list[Spots]) -> list[Spots]:
    """Give the points of one command; a line is a cubic gone through evenly."""
    start, end, values = step.start, step.end, step.values
    match step.letter.upper():
        case "M":
            return []
        case "Z" if start == end:
            return []
        case "A":
            return [_arc(start, end, values)]
        case "C":
            return [(start, *handles(step), end)]
        case "S":
            return [(start, _mirrored(before, start), *handles(step), end)]
        case "Q":
            (near,) = handles(step)
            return [(start, start + 2 / 3 * (near - start), end + 2 / 3 * (near - end), end)]
        case "T":
            raise SheetRefused("smooth_quadratic")
    return [(start, start + (end - start) / 3, end - (end - start) / 3, end)]


def handles(step: PathStep) -> list[complex]:
    """Give the points that a cubic is drawn by beside its ends."""
    origin = step.start if step.letter.islower() else 0j
    return [origin + complex(*step.values[k : k + 2]) for k in range(0, len(step.values) - 2, 2)]


def _mirrored(before: list[Spots], start: complex) -> complex:
    """Give the handle that goes on from that of a cubic before; without one there is none."""
    return 2 * start - before[-1][2] if before and len(before[-1]) == _CUBIC else start


def _arc(start: complex, end: complex, values: list[float]) -> Spots:
    """Give the ends and the middle of an arc; a radius that is too short to reach both ends is half their distance."""
    across, up, _, large, positive = values[:5]
    if not abs(abs(across) - abs(up)) <= _ROUNDNESS * abs(across) or not 0 < abs(across) <= REACH:
        raise SheetRefused("ellipse")
    half = math.hypot((end - start).real, (end - start).imag) / 2
    radius = max(abs(across), half)
    if not 0 < half <= REACH:
        raise SheetRefused("arc_ends")
    aside = math.sqrt((radius - half) * (radius + half)) * (1 if large != positive else -1)
    sense = 1j * (end - start) / (2 * half)
    centre = (start + end) / 2 + sense * aside
    turn = 2 * math.asin(half / radius)
    sweep = (math.tau - turn if large else turn) * (1 if positive else -1)
    return start, centre + (start - centre) * cmath.exp(0.5j * sweep), end


def _round(start: complex, middle: complex, end: complex) -> Piece:
    """Give the arc through three points, in that order."""
    u, v = middle - start, end - start
    doubled_area = 2 * (u.conjugate() * v).imag
    if doubled_area == 0:
        return CubicPiece(start, start + v / 3, end - v / 3, end)
    centre = start + 1j * (v * abs(u) ** 2 - u * abs(v) ** 2) / -doubled_area
    half = cmath.phase((middle - centre) / (start - centre)), cmath.phase((end - centre) / (middle - centre))
    return RoundPiece(start, centre, sum(half))
