"""Segments: the straight lines of a sheet that may be vectors, and at which end each has its arrowhead (отрезки)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

from drawings.grading.seeing.onlooker import BEGIN, END
from drawings.paper.strokes import Fill, Leaf, Line, Polyline, Stroke
from drawings.paper.walk import flat, groups

FORCE = "force"  # the kind of marks that are not to scale
TIP = 1.0  # mm: how far the tip of an arrowhead may be from the end of its line
HEAD = 12.0  # mm: a larger filled figure is no arrowhead
JOINED = 2.0  # mm: ends of arrows that are nearer to each other are at one place


class Segment(NamedTuple):
    """A straight line, and whether it has an arrowhead, to which it goes."""

    start: complex
    end: complex
    headed: bool = False


def segments(leaf: Leaf, heads: Mapping[int, Collection[str]]) -> list[Segment]:
    """Give the straight lines of a sheet; one with an arrowhead goes to it, with two both ways, another as drawn.

    Our own arrows of forces are left out: they are not to scale, and no side of a polygon that bears their letters.
    """
    own = list(flat(leaf.groups))
    tips = [spot for one in own for spot in _tips(one)]
    unscaled = {id(one) for group in groups(leaf.groups) if group.data.get("kind") == FORCE for one in group.strokes}
    straight = [one for one in own if (isinstance(one, Line) or _straight(one)) and id(one) not in unscaled]
    double = [one for one in straight if {BEGIN, END} <= set(heads.get(id(one), ()))]
    back = (Segment(end, start, True) for start, end, _ in (_segment(one, heads, tips) for one in double))
    return [*(_segment(one, heads, tips) for one in straight), *back]


def _straight(one: Stroke) -> bool:
    return isinstance(one, Polyline) and len(one.points) == 2 and one.style.colour != "none"


def _tips(one: Stroke) -> Iterator[complex]:
    """Give the corners of what may be an arrowhead: a small filled figure of three or four of them."""
    points = one.points if isinstance(one, Fill | Polyline) else ()
    if isinstance(one, Polyline) and one.style.fill == "none":
        return
    if 3 <= len(points) <= 5 and max(abs(a - b) for a, b in pairwise((*points, points[0]))) <= HEAD:
        yield from points


def _segment(one: Stroke, heads: Mapping[int, Collection[str]], tips: Sequence[complex]) -> Segment:
    start, end = (one.start, one.end) if isinstance(one, Line) else one.points  # type: ignore[union-attr]
    marked = heads.get(id(one), ())
    at_end = END in marked or _near(end, tips)
    at_start = BEGIN in marked or _near(start, tips)
    if at_start and not at_end:
        return Segment(end, start, True)
    return Segment(start, end, at_end)


def _near(spot: complex, tips: Sequence[complex]) -> bool:
    return any(abs(spot - tip) <= TIP for tip in tips)


def figures(own: Sequence[Segment]) -> list[list[Segment]]:
    """Put together the segments with arrowheads that hang together by their ends."""
    found: list[list[Segment]] = []
    for one in (one for one in own if one.headed):
        touched = [figure for figure in found if any(_touch(one, other) for other in figure)]
        found = [figure for figure in found if figure not in touched]
        found.append([one, *(part for figure in touched for part in figure)])
    return found


def _touch(one: Segment, other: Segment) -> bool:
    return any(abs(a - b) <= JOINED for a in (one.start, one.end) for b in (other.start, other.end))
