"""The outline of a figure, in bands: where its lines can be in its box, and where it is bare (очертание фигуры)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby, pairwise
from typing import NamedTuple

from drawings.paper.ties import tied, tied_spot

BANDS = 8  # of equal height, from below


class Band(NamedTuple):
    """What may be inked between two heights of the box of a figure: shares of the box, from its left and from below."""

    low: float
    high: float
    left: float
    right: float


WHOLE = (Band(0.0, 1.0, 0.0, 1.0),)


def outline(values: Sequence[complex]) -> tuple[Band, ...]:
    """Give what the convex hull of points takes of their box; alike bands are one.

    >>> outline([0j, 8 + 0j, 8 + 8j])[0], outline([0j, 1 + 0j, 1 + 1j, 1j])
    (Band(low=0.0, high=0.125, left=0.0, right=1.0), (Band(low=0.0, high=1.0, left=0.0, right=1.0),))
    """
    left, low = min(v.real for v in values), min(v.imag for v in values)
    wide, high = max(v.real for v in values) - left, max(v.imag for v in values) - low
    if not wide or not high:
        return WHOLE
    hull = _hull({tied_spot(complex((v.real - left) / wide, (v.imag - low) / high)) for v in values})
    return tuple(_joined(_band(hull, k / BANDS, (k + 1) / BANDS) for k in range(BANDS)))


def traced(lines: Sequence[Sequence[complex]], values: Sequence[complex]) -> tuple[Band, ...]:
    """Give what lines, each from point to point, take of the box of some points: no more than they cross of a band.

    >>> traced([[0j, 8j], [8j, 8 + 8j]], [0j, 8 + 8j])[0]
    Band(low=0.0, high=0.875, left=0.0, right=0.0)
    """
    left, low = min(v.real for v in values), min(v.imag for v in values)
    wide, high = max(v.real for v in values) - left, max(v.imag for v in values) - low
    if not wide or not high:
        return WHOLE
    shares = [[tied_spot(complex((v.real - left) / wide, (v.imag - low) / high)) for v in line] for line in lines]
    bands = (_crossed(shares, k / BANDS, (k + 1) / BANDS) for k in range(BANDS))
    return tuple(_joined(band for band in bands if band is not None))


def _crossed(lines: Sequence[Sequence[complex]], low: float, high: float) -> Band | None:
    """Give between what sides lines are between two heights, if any is."""
    sides = [side for line in lines for side in _sides(line, low, high)]
    return Band(low, high, tied(min(sides)), tied(max(sides))) if sides else None


def _joined(bands: Iterator[Band]) -> Iterator[Band]:
    for (left, right), alike in groupby(bands, key=lambda band: (band.left, band.right)):
        own = list(alike)
        yield Band(own[0].low, own[-1].high, left, right)


def _band(hull: Sequence[complex], low: float, high: float) -> Band:
    """Give between what sides a hull lies between two heights."""
    sides = list(_sides([*hull, hull[0]], low, high))
    return Band(low, high, tied(min(sides)), tied(max(sides)))


def _sides(line: Sequence[complex], low: float, high: float) -> Iterator[float]:
    """Give the abscissas of the points of a line between two heights, and of where it crosses these."""
    yield from (point.real for point in line if low <= point.imag <= high)
    for one, other in pairwise(line):
        for y in (low, high):
            if (one.imag - y) * (other.imag - y) < 0:
                yield (one + (other - one) * (y - one.imag) / (other.imag - one.imag)).real


def _hull(points: set[complex]) -> list[complex]:
    """Give the corners of the convex hull, counterclockwise."""
    ordered = sorted(points, key=lambda point: (point.real, point.imag))
    return [*_chain(ordered)[:-1], *_chain(ordered[::-1])[:-1]]


def _chain(ordered: Sequence[complex]) -> list[complex]:
    chain: list[complex] = []
    for point in ordered:
        while len(chain) > 1 and not _left(chain[-2], chain[-1], point):
            chain.pop()
        chain.append(point)
    return chain


def _left(start: complex, middle: complex, end: complex) -> bool:
    return ((middle - start).conjugate() * (end - middle)).imag > 0
