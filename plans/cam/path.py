"""The profile as a path of true arcs and cubics (путь профиля): a dwell is an arc about O, the rest cubics in between.

A cubic takes the outline's points and tangents at its two ends. Of two it is the nearer one: that runs through the ends
as fast as the outline does, or that is curved there as the outline is. How far it is from the outline is measured.
Loops and cusps are gone through as they are; where the outline jumps, at a corner of the law, an arc about the tip's
place or a straight line joins its two sides.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from geometry.curve import CubicPiece, Piece, RoundPiece, straight
from plans.cam.course import FollowerCourse
from plans.cam.profile.profile import CamOutline, OutlineSpot
from plans.model.cam import DWELL, Cam
from plans.model.cam_motion import CamSizes, Points
from plans.model.motion import Floats

PIECES = 72  # to the turn at first: 5 degrees each
SAMPLES = 16  # places within a piece at which it is measured
ROUNDS = 8  # a piece is halved so many times at the most: it is then 4e9 times nearer, or rounding is in the way
STEPS = 4  # of Gauss and Newton: the even handles, and even shares, are near already
TINY = 1e-300  # keeps a cubic of one point from being divided by its speed
CLOSED = 1e-9  # of R0: what the outline's ends may miss each other by through rounding, and is no jump


class PathCut(NamedTuple):
    """Where a path is cut: the turn, rad, and the point of the outline there, m."""

    turned: float
    spot: complex


@dataclass(frozen=True)
class ProfilePath:
    """A path in the cam (профиль кусками): pieces m, the turns at which they begin, how far off they are measured."""

    pieces: tuple[Piece, ...]
    starts: tuple[float, ...]  # rad
    deviation: float  # m
    closed: bool

    def between(self, low: PathCut, high: PathCut, turn: float) -> tuple[Piece, ...]:
        """Give its pieces between two turns of the whole `turn`, rad."""
        ends = (*self.starts[1:], turn)
        cut = (_cut(*part, low, high) for part in zip(self.pieces, self.starts, ends, strict=True))
        return tuple(piece for piece in cut if piece is not None)


class _Cubics(NamedTuple):
    """Cubics as columns, (N,) each."""

    start: Points
    first: Points
    second: Points
    end: Points

    def at(self, share: Floats) -> Points:
        left = 1 - share
        ends = left**3 * self.start + share**3 * self.end
        return np.asarray(ends + 3 * left * share * (left * self.first + share * self.second))

    def rate(self, share: Floats) -> Points:
        left = 1 - share
        ends = left**2 * (self.first - self.start) + share**2 * (self.end - self.second)
        return np.asarray(3 * ends + 6 * left * share * (self.second - self.first))


def path(cam: Cam, sizes: CamSizes, away: float = 0.0, pieces: int = PIECES, exact: bool = True) -> ProfilePath:
    """Give the path that lies `away` m outward of the pitch curve, each cubic within the cam's tolerance.

    Of a path that need not be `exact` no piece is halved: it has its pieces to the turn, and tells how far it is off.
    """
    course = FollowerCourse(cam)
    outline = CamOutline(course, sizes, away)
    parts: list[_Part] = []
    spans = [(start, end, _rests(cam, (start + end) / 2)) for start, end in pairwise(course.joints)]
    parts += (_dwelt(outline, start, end) for start, end, rests in spans if rests)
    parts += _between(outline, [(start, end) for start, end, rests in spans if not rests], pieces, exact)
    turned, found, off = zip(*_joined(outline, sorted(parts, key=lambda part: part[0])), strict=True)
    return ProfilePath(found, turned, max(off), not cam.translates)


def _cut(piece: Piece, start: float, end: float, low: PathCut, high: PathCut) -> Piece | None:
    """Cut a piece to what lies between two turns; None: nothing of it does."""
    if start == end:
        return piece if low.turned < start <= high.turned else None
    first, last = (_share(piece, start, end, bound) for bound in (low, high))
    return piece.part(first, last) if first < last else None


def _share(piece: Piece, start: float, end: float, bound: PathCut) -> float:
    """Give the share of a piece at a turn, 0 or 1 of one beyond it."""
    if not start < bound.turned < end:
        return float(bound.turned >= end)
    return piece.nearest(bound.spot, (bound.turned - start) / (end - start))


_Part = tuple[float, Piece, float]


def _rests(cam: Cam, turned: float) -> bool:
    """Tell whether the follower rests at a turn; at a joint itself the end of a phase is rounded."""
    return cam.lift == 0 or any(phase.kind == DWELL and phase.start < turned < phase.end for phase in cam.phases)


def _between(outline: CamOutline, spans: list[tuple[float, float]], pieces: int, exact: bool) -> Iterator[_Part]:
    """Give the cubics over spans between joints of the course."""
    if not spans:
        return
    tolerance, whole = outline.cam.tolerance, outline.cam.turn
    counts = [max(math.ceil(round((end - start) / whole * pieces, 9)), 1) for start, end in spans]
    edges = [np.linspace(*span, count + 1) for span, count in zip(spans, counts, strict=True)]
    low, high = (np.concatenate([span[cut] for span in edges]) for cut in (np.s_[:-1], np.s_[1:]))
    cubics, off = _fitted(outline, low, high)
    for _ in range(ROUNDS if exact else 0):
        if not (wide := off > tolerance).any():
            break
        middle = (low + high)[wide] / 2
        low, high = (np.sort(np.concatenate([column, middle])) for column in (low, high))
        cubics, off = _fitted(outline, low, high)
    found = (CubicPiece(*cubic) for cubic in zip(*(column.tolist() for column in cubics), strict=True))
    yield from zip(low.tolist(), found, off.tolist(), strict=True)


def _dwelt(outline: CamOutline, start: float, end: float) -> _Part:
    """Give the arc about O along which the follower rests; of a cam that translates the straight line."""
    spot = complex(outline.at(np.array([start])).at[0])
    if outline.cam.translates:
        return start, straight(spot, complex(outline.at(np.array([end]), before=True).at[0])), 0.0
    return start, RoundPiece(spot, 0j, -outline.cam.sense * (end - start)), 0.0


def _joined(outline: CamOutline, parts: list[_Part]) -> Iterator[_Part]:
    """Give the pieces with those that lead over from each to the next one where the outline jumps."""
    following = [*parts[1:], *([] if outline.cam.translates else parts[:1])]
    for place, part in enumerate(parts):
        yield part
        if place < len(following):
            after = following[place]
            turned = after[0] or outline.cam.turn
            yield from _jump(outline, turned, part[1].end, after[1].start)


def _jump(outline: CamOutline, turned: float, start: complex, end: complex) -> Iterator[_Part]:
    if abs(end - start) <= CLOSED * max(abs(start), abs(end)):
        return
    if outline.cam.flat:
        yield turned, straight(start, end), 0.0
        return
    tip = outline.tip(turned)
    yield turned, RoundPiece(start, tip, float(np.angle((end - tip) / (start - tip)))), 0.0


def _fitted(outline: CamOutline, low: Floats, high: Floats) -> tuple[_Cubics, Floats]:
    """Give the cubics between turns, and how far each is from the outline, m."""
    first, last = outline.at(low), outline.at(high, before=True)
    shares = np.arange(1, SAMPLES + 1) / (SAMPLES + 1)
    between = outline.at((low[:, None] + (high - low)[:, None] * shares).ravel())
    points, tangents = between.at.reshape(-1, SAMPLES), between.tangent.reshape(-1, SAMPLES)
    handles = _Handles(first, last)
    even = handles.even(high - low)
    either = [handles.cubics(*lengths) for lengths in (even, handles.nearest(*even, points, tangents, shares))]
    off = [np.abs(_apart(cubic, points, shares)[1]).max(axis=1) for cubic in either]
    better = off[1] < off[0]
    cubics = _Cubics(*(np.where(better, fitted, plain) for plain, fitted in zip(*either, strict=True)))
    return cubics, np.where(better, off[1], off[0])


class _Handles(NamedTuple):
    """The ends of cubics, whose handles go along the tangents there; lengths (N,) m."""

    first: OutlineSpot
    last: OutlineSpot

    def even(self, angles: Floats) -> tuple[Floats, Floats]:
        """Give the handles of cubics that run through their ends as fast as the outline."""
        return self.first.speed * angles / 3, self.last.speed * angles / 3

    def cubics(self, a: Floats, b: Floats) -> _Cubics:
        first, last = self.first, self.last
        return _Cubics(first.at, first.at + a * first.tangent, last.at - b * last.tangent, last.at)

    def nearest(self, a: Floats, b: Floats, points: Points, tangents: Points, shares: Floats) -> tuple[Floats, Floats]:
        """Give the handles of cubics that pass by points of the outline, (N, M), at the least sum of squares."""
        even, (leaving, coming) = (a, b), (end.tangent[:, None] for end in (self.first, self.last))
        with np.errstate(all="ignore"):  # of a straight piece any handles are as good: its even ones stay
            for _ in range(STEPS):
                near, apart = _apart(self.cubics(a, b), points, shares)
                over = _along(1j * tangents, apart)
                p = _along(1j * tangents, 3 * near * (1 - near) ** 2 * leaving)
                q = _along(1j * tangents, -3 * near**2 * (1 - near) * coming)
                pp, pq, qq, pr, qr = ((x * y).sum(axis=1) for x, y in ((p, p), (p, q), (q, q), (p, over), (q, over)))
                whole = pp * qq - pq**2
                a, b = a - (pr * qq - qr * pq) / whole, b - (qr * pp - pr * pq) / whole
            sound = np.isfinite(a * b)
        return np.where(sound, a, even[0]), np.where(sound, b, even[1])


def _apart(cubics: _Cubics, points: Points, shares: Floats) -> tuple[Floats, Points]:
    """Give the shares of cubics that are nearest to points beside them, (N, M), and the ways from the points there."""
    wide = _Cubics(*(column[:, None] for column in cubics))
    near = np.broadcast_to(shares, points.shape)
    for _ in range(STEPS):
        rate, apart = wide.rate(near), points - wide.at(near)
        near = np.clip(near + _along(rate, apart) / np.maximum(np.abs(rate) ** 2, TINY), 0.0, 1.0)
    return near, wide.at(near) - points


def _along(direction: Points, way: Points) -> Floats:
    return np.asarray((direction.conjugate() * way).real)
