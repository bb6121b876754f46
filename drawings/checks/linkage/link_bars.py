"""What a link is drawn of, in its own frame: its bars, and what a slot hangs on that no bar lies along (звенья)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from itertools import combinations, pairwise

from drawings.figures.linkage.masses import is_centre
from plans.model.mechanism import Mechanism, Slide, Way

STRAIGHT = 1e-9  # share of a link's length: points of a link that are so near to one line lie on it
Bar = tuple[complex, complex]


def bars(mechanism: Mechanism, link: int) -> list[Bar]:
    """Give the bars of a link in its own frame: one through points on a line, else the sides about its points."""
    spots = jointed(mechanism, link)
    if len(spots) < 2:
        return []
    first, last = max(combinations(spots, 2), key=lambda pair: abs(pair[1] - pair[0]))
    if all(_off(spot, first, last) <= STRAIGHT * abs(last - first) for spot in spots):
        return [(first, last)]
    middle = sum(spots) / len(spots)
    around = sorted(spots, key=lambda spot: cmath.phase((spot - middle) / (last - first)))
    return list(pairwise([*around, around[0]]))


def jointed(mechanism: Mechanism, link: int) -> list[complex]:
    """Give the points that the bars of a link run through, in its own frame; a mass centre is a mark beside them."""
    points = mechanism.links[link].points
    joints = [spot for name, spot in points.items() if not is_centre(name) or name in mechanism.hinges]
    return list(dict.fromkeys(joints if len(joints) > 1 else points.values()))


def flat(slide: Slide, ends: Bar) -> bool:
    """Tell whether a bar of the owner lies on its slide's line."""
    way = slide.on_owner
    return all(_off(end, way.through, way.through + way.direction) <= STRAIGHT * abs(ends[1] - ends[0]) for end in ends)


def hanging(mechanism: Mechanism, slide: Slide) -> Bar:
    """Give what a slot without a bar along it hangs on: a spot of its owner, and its foot on the slot's line.

    Both are one where the line passes through a point of the link or crosses a bar of it; else the spot is the first of
    the points nearest to the line.
    """
    way, spots = slide.on_owner, jointed(mechanism, slide.owner)
    off = [abs(_along(way, spot).imag) for spot in spots]
    size = STRAIGHT * max(abs(_along(way, spot)) for spot in spots)
    point = next(spot for spot, away in zip(spots, off, strict=True) if away <= min(off) + size)
    if min(off) <= size:
        return point, point
    for crossed in _crossings(way, bars(mechanism, slide.owner)):
        return crossed, crossed
    return point, way.through + _along(way, point).real * way.direction


def _crossings(way: Way, lines: list[Bar]) -> Iterator[complex]:
    for start, end in lines:
        first, last = _along(way, start).imag, _along(way, end).imag
        if first * last < 0:
            yield start + (end - start) * first / (first - last)


def _along(way: Way, spot: complex) -> complex:
    return (spot - way.through) / way.direction


def _off(spot: complex, start: complex, end: complex) -> float:
    return abs(((spot - start) * (end - start).conjugate()).imag) / abs(end - start)
