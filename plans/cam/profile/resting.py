"""What the follower really does where a loop of the profile is cut away (действительный закон при подрезании).

The cutter takes the loop off, and a corner is left where the profile crosses itself: the follower rests on it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple

import numpy as np

from geometry.meet import EPS, cross
from plans.cam.profile.profile import CamOutline
from plans.cam.profile.touch import Stretches, Tip, TurnSpan, guide_start
from plans.model.cam_motion import Extreme, Points
from plans.model.motion import Floats

# Segments about an undercut: its loop crosses itself 1.7 times as far from its middle as it is half wide.
NEAR: Final = 40
STEPS: Final = 20  # of Newton's method, which needs about five
# A loop that is shorter, in shares of the turn, is a cusp: a roller larger than the radius by 1e-9 leaves one as wide.
CUSP: Final = 5e-6
SAME: Final = 1e-9  # rad, or of a chord: what is nearer is one
Pairs = tuple[np.ndarray, np.ndarray]


class SelfCrossing(NamedTuple):
    """A crossing of the profile with itself: the turns between which the loop is, rad, and the point on the cam, m."""

    start: float
    end: float
    point: complex


class ProfileChords(NamedTuple):
    """Chords of the profile: the turn at which each starts, rad, its start and way, m, and its stretch."""

    turned: Floats
    start: Points
    way: Points
    row: np.ndarray


@dataclass(frozen=True)
class ProfileEdge:
    """The profile that touches the follower, as a curve on the cam by its turn."""

    stretches: Stretches
    roller: float  # m

    @property
    def _outline(self) -> CamOutline:
        return CamOutline(self.stretches.course, self.stretches.sizes, -self.roller)

    def at(self, turned: Floats, before: bool = False) -> Points:
        """Give its points, m."""
        return self._outline.at(turned, before).at

    def slope(self, turned: Floats) -> Points:
        """Give its derivative by the turn, m/rad."""
        spot = self._outline.at(turned)
        return np.asarray(spot.tangent * spot.speed)

    def chords(self, spans: Iterable[TurnSpan]) -> ProfileChords:
        """Divide it into chords, fine about an undercut; none goes from one side of a joint to the other."""
        spots = [_about(span) for span in spans]
        rows = [self._row(k, row, spots) for k, row in enumerate(self.stretches.grid)]
        return ProfileChords(*(np.concatenate(parts) for parts in zip(*rows, strict=True)))

    def _row(self, number: int, row: Floats, spots: Sequence[Floats]) -> ProfileChords:
        fine = [near[(row[0] < near) & (near < row[-1])] for near in spots]
        turned = np.unique(np.concatenate([row[:-1], *fine]))
        points = np.append(self.at(turned), self.at(row[-1:], before=True))
        return ProfileChords(turned, points[:-1], np.diff(points), np.full(len(turned), number))


def _about(span: TurnSpan) -> Floats:
    middle, wide = (span.start + span.end) / 2, span.end - span.start
    return np.linspace(middle - wide, middle + wide, NEAR + 1)


def crossings(edge: ProfileEdge, spans: Sequence[TurnSpan] = ()) -> tuple[SelfCrossing, ...]:
    """Find all crossings of the profile with itself."""
    chords = edge.chords(spans)
    found = [crossing for pair in zip(*_meetings(chords), strict=True) if (crossing := _closed(edge, chords, *pair))]
    found.sort(key=lambda crossing: crossing[:2])
    return tuple(_looped(edge, crossing, chords) for crossing in _once(found))


def _looped(edge: ProfileEdge, crossing: SelfCrossing, chords: ProfileChords) -> SelfCrossing:
    """Tell of both parts of the profile which is the loop: that with less area in the sense in which the profile runs.

    A loop that a roller leaves runs the other way round. On a cam that translates the loop is what lies between.
    """
    cam, turned, points = edge.stretches.course.cam, chords.turned, chords.start
    inner = (crossing.start < turned) & (turned < crossing.end)
    between = points[inner] - crossing.point
    rest = np.concatenate([points[turned > crossing.end], points[turned < crossing.start]]) - crossing.point
    inside = cam.translates or cam.sense * _area(between) >= cam.sense * _area(rest)
    return crossing if inside else crossing._replace(start=crossing.end, end=crossing.start)


def _area(points: Points) -> float:
    """Give twice the area that points about a start run round, counter-clockwise above 0."""
    return float(np.sum(cross(points[:-1], points[1:])))


def _once(found: Iterable[SelfCrossing]) -> Iterator[SelfCrossing]:
    last: SelfCrossing | None = None
    for crossing in found:
        if last is None or abs(crossing.start - last.start) + abs(crossing.end - last.end) > SAME:
            yield crossing
        last = crossing


def _meetings(chords: ProfileChords) -> Pairs:
    """Find which chords cross, by a sweep over x: only those that overlap there are tried."""
    ends = chords.start + chords.way
    left, right = np.minimum(chords.start.real, ends.real), np.maximum(chords.start.real, ends.real)
    order = np.argsort(left, kind="stable")
    left, right = left[order], right[order]
    reach = np.maximum.accumulate(right)
    found = [np.zeros((2, 0), dtype=int)]
    for step in range(1, len(order)):
        here = np.flatnonzero(left[step:] <= right[:-step])
        if not len(here) and not np.any(left[step:] <= reach[:-step]):
            break
        pair = np.sort(np.stack([order[here], order[here + step]]), axis=0)
        found.append(pair[:, _cross(chords, *pair)])
    firsts, seconds = np.concatenate(found, axis=1)
    return firsts, seconds


def _cross(chords: ProfileChords, chord: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Tell which pairs cross and have no end in common."""
    start, way = chords.start, chords.way
    base, across = start[other] - start[chord], np.asarray(cross(way[chord], way[other]))
    with np.errstate(divide="ignore", invalid="ignore"):
        along, back = cross(base, way[other]) / across, cross(base, way[chord]) / across
    ends = np.minimum(np.abs(base - way[chord]), np.abs(base + way[other]))
    apart = ends > SAME * np.abs(way[chord])
    return np.asarray(apart & (along >= 0) & (along < 1) & (back >= 0) & (back < 1))


def _closed(edge: ProfileEdge, chords: ProfileChords, chord: int, other: int) -> SelfCrossing | None:
    """Close in on a crossing by Newton's method, each turn on its own stretch.

    None where the chords cross and the curve does not: about a cusp.
    """
    pair, rows = chords.turned[[chord, other]], chords.row[[chord, other]]
    low, high = edge.stretches.edges[rows], np.nextafter(edge.stretches.edges[rows + 1], 0.0)
    gap = np.inf
    for _ in range(STEPS):
        (a, b), (u, v) = edge.at(pair), edge.slope(pair)
        gap, turn = abs(a - b), np.asarray(cross(u, v))
        step = np.array([-cross(a - b, v), cross(u, a - b)]) / (turn or np.nan)
        if np.isnan(step).any() or np.all(np.abs(step) <= 2 * EPS * np.abs(pair)):
            break
        pair = np.clip(pair + step, low, high)
    first, second = pair.tolist()
    cam, wide = edge.stretches.course.cam, second - first  # of a cam that turns the other part may be the cusp
    cusp = min(wide, wide if cam.translates else cam.turn - wide) < CUSP * cam.turn
    if cusp or gap > SAME * np.abs(chords.way[[chord, other]]).max():
        return None
    return SelfCrossing(first, second, complex(edge.at(pair).mean()))


LOOKS: Final = 129  # turns over a loop, looked at again between the neighbours of the greatest
ROUNDS: Final = 5
NOTHING: Final = 1e-9  # of the lift: a loss so small is what rounding makes of a corner on which nothing is lost


def resting(stretches: Stretches, roller: float, corner: complex, turned: Floats) -> Floats:
    """Give S with which the follower rests on a corner of the cam, (N,); NaN where it cannot."""
    tip = Tip(stretches.course, stretches.sizes, turned)
    place = tip.in_frame(corner)
    with np.errstate(invalid="ignore"):
        return _rocker(tip, place, roller) if tip.cam.rocks else _upright(tip, place, roller)


def _upright(tip: Tip, place: np.ndarray, roller: float) -> Floats:
    if tip.cam.flat:
        return np.asarray(place.imag - tip.sizes.base)
    aside = place.real - tip.cam.sense * tip.sizes.offset
    return np.asarray(place.imag + np.sqrt(roller**2 - aside**2) - guide_start(tip.sizes))


def _rocker(tip: Tip, place: np.ndarray, roller: float) -> Floats:
    """Give it for a rocker: the corner is at the roller's radius from its pin, or lies on its face."""
    follower, way = tip.cam.follower, place - tip.sizes.pivot
    size = np.abs(way)
    if tip.cam.flat:
        along = way / (np.sqrt(size**2 - follower.face**2) + 1j * tip.cam.rising * follower.face)
    else:
        length = follower.length or 0.0
        lifted = np.arccos((length**2 + size**2 - roller**2) / (2 * length * size))
        along = way / size * np.exp(1j * tip.cam.rising * lifted)
    return np.asarray(tip.cam.lift / 2 + tip.cam.rising * np.angle(along * tip.cam.rising))


def loss(stretches: Stretches, roller: float, crossing: SelfCrossing) -> Extreme:
    """Give how much of S is lost at most on a loop that is cut away, and where."""
    cam, (start, end, point) = stretches.course.cam, crossing
    end += cam.turn if end < start else 0.0
    best = Extreme(0.0, start)
    for _ in range(ROUNDS):
        turned = np.linspace(start, end, LOOKS)
        turns = np.where(turned > cam.turn, turned - cam.turn, turned)
        lost = stretches.course.at(turns).s - resting(stretches, roller, point, turns)
        if np.isnan(lost).all():
            return Extreme(float("nan"), crossing.start)
        place = int(np.nanargmax(lost))
        best = max(best, Extreme(float(lost[place]), float(turns[place])))
        start, end = turned[max(place - 1, 0)], turned[min(place + 1, LOOKS - 1)]
    return best if best.value > NOTHING * cam.lift else Extreme(0.0, crossing.start)
