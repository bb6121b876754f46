"""Where a profile crosses itself, and what the follower does when the loop is cut away (самопересечение профиля).

The profile is swept over segment by segment; each crossing is then closed in on by Newton's method on the curve itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np

from geometry.meet import EPS, cross
from plans.cam.profile.curvature import curvature
from plans.cam.profile.stretches import Span, Stretches
from plans.cam.profile.tip import Tip
from plans.cam.profile.touch import Touch
from plans.model.cam_motion import Points
from plans.model.motion import Floats

NEAR: Final = (
    40  # segments about an undercut: its loop crosses itself 1.7 times as far from its middle as it is half wide
)
STEPS: Final = 20  # of Newton's method, which needs about five
Pairs = tuple[np.ndarray, np.ndarray]


class Crossing(NamedTuple):
    """A crossing of the profile with itself: the turns between which the loop is, rad, and the point on the cam, m."""

    start: float
    end: float
    point: complex


@dataclass(frozen=True)
class Edge:
    """The profile that touches the follower, as a curve on the cam by its turn."""

    stretches: Stretches
    roller: float  # m

    def at(self, turned: Floats, before: bool = False) -> Points:
        """Give its points, m."""
        tip = Tip(self.stretches.course, self.stretches.sizes, turned, before)
        place = Touch(tip).contact if tip.cam.flat else tip.orders[0] - self.roller * tip.lever / np.abs(tip.lever)
        return on_cam(tip, place)

    def slope(self, turned: Floats) -> Points:
        """Give its derivative by the turn, m/rad."""
        tip = Tip(self.stretches.course, self.stretches.sizes, turned)
        if tip.cam.flat:
            touch = Touch(tip)
            along = -1j * tip.cam.sense * touch.normal * touch.sweep
        else:
            along = tip.trail[0] * (1 - self.roller * curvature(tip))
        return np.asarray(along * np.exp(-1j * tip.turns * turned))

    def drawn_by(self, spans: Iterable[Span]) -> tuple[Floats, Points]:
        """Give turns along it and its points there: fine about an undercut, both sides at a joint."""
        turned, points = [], []
        for row in self.stretches.grid:
            fine = [near[(row[0] < near) & (near < row[-1])] for near in map(_about, spans)]
            inner = np.unique(np.concatenate([row[:-1], *fine]))
            turned.append(np.append(inner, row[-1]))
            points.append(np.append(self.at(inner), self.at(row[-1:], before=True)))
        return np.concatenate(turned), np.concatenate(points)


def on_cam(tip: Tip, place: Points) -> Points:
    """Give the points of the cam that are at places in the frame."""
    if tip.cam.translates:
        return np.asarray(place + tip.cam.sense * tip.turned)
    return np.asarray(place * np.exp(-1j * tip.turns * tip.turned))


def in_frame(tip: Tip, point: complex) -> Points:
    """Give where a point of the cam is in the frame at each turn."""
    if tip.cam.translates:
        return np.asarray(point - tip.cam.sense * tip.turned)
    return np.asarray(point * np.exp(1j * tip.turns * tip.turned))


def _about(span: Span) -> Floats:
    middle, wide = (span.start + span.end) / 2, span.end - span.start
    return np.linspace(middle - wide, middle + wide, NEAR + 1)


def crossings(edge: Edge, spans: Sequence[Span] = ()) -> tuple[Crossing, ...]:
    """Find all crossings of the profile with itself."""
    turned, points = edge.drawn_by(spans)
    firsts, seconds = _meetings(points)
    found = [_closed(edge, *pair) for pair in zip(turned[firsts], turned[seconds], strict=True)]
    return tuple(_looped(edge, one, turned, points) for one in _once(sorted(found, key=lambda one: one[:2])))


def _looped(edge: Edge, one: Crossing, turned: Floats, points: Points) -> Crossing:
    """Tell of both parts of the profile which is the loop: that with less area in the sense in which the profile runs.

    A loop that a roller leaves runs the other way round. On a cam that translates the loop is what lies between.
    """
    cam = edge.stretches.course.cam
    inner = (one.start < turned) & (turned < one.end)
    between = points[inner] - one.point
    rest = np.concatenate([points[turned > one.end], points[turned < one.start]]) - one.point
    inside = cam.translates or cam.sense * _area(between) >= cam.sense * _area(rest)
    return one if inside else one._replace(start=one.end, end=one.start)


def _area(points: Points) -> float:
    """Give twice the area that points about a start run round, counter-clockwise above 0."""
    return float(np.sum(cross(points[:-1], points[1:])))


def _once(found: Iterable[Crossing]) -> Iterator[Crossing]:
    last: Crossing | None = None
    for one in found:
        if last is None or abs(one.start - last.start) + abs(one.end - last.end) > SAME:
            yield one
        last = one


SAME: Final = 1e-9  # rad: a crossing that two pairs of segments have found


def _meetings(points: Points) -> Pairs:
    """Find which segments cross, by a sweep over x: only those that overlap there are tried."""
    start, way = points[:-1], np.diff(points)
    left, right = np.minimum(start.real, points[1:].real), np.maximum(start.real, points[1:].real)
    order = np.argsort(left, kind="stable")
    left, right = left[order], right[order]
    found = []
    for step in range(1, len(order)):
        here = np.flatnonzero(left[step:] <= right[:-step])
        if not len(here) and not np.any(left[step:] <= np.maximum.accumulate(right)[:-step]):
            break
        one, other = order[here], order[here + step]
        found.append(np.stack([np.minimum(one, other), np.maximum(one, other)])[:, _cross(start, way, one, other)])
    firsts, seconds = np.concatenate(found, axis=1) if found else np.zeros((2, 0), dtype=int)
    apart = (seconds - firsts > 1) & (seconds - firsts < len(start) - 1)
    return firsts[apart], seconds[apart]


def _cross(start: Points, way: Points, one: np.ndarray, other: np.ndarray) -> np.ndarray:
    base, across = start[other] - start[one], cross(way[one], way[other])
    with np.errstate(divide="ignore", invalid="ignore"):
        along, back = cross(base, way[other]) / across, cross(base, way[one]) / across
    return np.asarray((along >= 0) & (along < 1) & (back >= 0) & (back < 1))


def _closed(edge: Edge, first: float, second: float) -> Crossing:
    """Close in on a crossing by Newton's method in both turns; on a corner it stays where the segments crossed."""
    pair, near = np.array([first, second]), np.array([first, second])
    far = edge.stretches.course.cam.turn / len(edge.stretches.edges) / 4
    for _ in range(STEPS):
        (a, b), (u, v) = edge.at(pair), edge.slope(pair)
        turn = cross(u, v)
        step = np.array([-cross(a - b, v), cross(u, a - b)]) / (turn or np.nan)
        if not np.all(np.abs(pair + step - near) < far):
            pair = near
            break
        pair = np.clip(pair + step, 0.0, edge.stretches.course.cam.turn)
        if np.all(np.abs(step) <= 4 * EPS * np.abs(pair)):
            break
    return Crossing(float(pair[0]), float(pair[1]), complex(edge.at(pair).mean()))
