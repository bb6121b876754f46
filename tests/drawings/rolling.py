"""Rolling: a follower is rolled over the profile as it was read from a sheet, and its law comes back (обкатка профиля).

Nothing of the construction is used: the pieces are those of the file, the follower's sizes those of the analysis. At
each turn of the cam every point of the profile would lift the follower to some S; it stands at the highest of them, and
in a groove, held by the other flank, at the lowest of that. A point or an edge stands where its way meets the profile.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from geometry.curve import CubicPiece, Piece, RoundPiece, straight
from plans.model.cam import POINTED, TURN, Cam
from plans.model.cam_motion import Points, Sizes
from plans.model.motion import Floats

FACET = 1 / 72  # of a turn of an arc, or of the length of a profile: what is longer is looked through in parts
LOOKED = 8  # places on a piece that are looked at first
CLOSER = 8  # rounds of looking closer, each at so many places to either side of the best, up to its neighbours
NEAR = np.linspace(-1.0, 1.0, 2 * LOOKED + 1)
BEYOND, TINY = 1e-6, 1e-4  # m that an open profile is continued by; of a piece: so short it is straight
TOPS = 3  # places that are looked at closer
AT_ONCE = 256  # points that are held against all of a profile together
NOWHERE = -math.inf
AWAY = -1e6  # m or rad: an S below all, less how far a roller is from what it does not come to: so it is led there


@dataclass(frozen=True)
class _Track:
    """A profile as columns of pieces, gone along by a parameter from 0 to their number."""

    pieces: tuple[Piece, ...]
    closed: bool

    @cached_property
    def _split(self) -> list[Piece]:
        longest = FACET * sum(map(_length, self.pieces))
        return [part for piece in self.pieces for part in _facets(piece, longest)]

    @cached_property
    def _cubics(self) -> Points:
        return np.array([piece if isinstance(piece, CubicPiece) else (0j,) * 4 for piece in self._split])

    @cached_property
    def _arcs(self) -> tuple[Points, Points, Floats]:
        rows = [
            (p.centre, p.start - p.centre, p.sweep) if isinstance(p, RoundPiece) else (0j, 0j, 0.0) for p in self._split
        ]
        centres, arms, sweeps = (np.array(column) for column in zip(*rows, strict=True))
        return centres, arms, sweeps

    @property
    def count(self) -> int:
        """The number of pieces, arcs split."""
        return len(self._split)

    def at(self, along: Floats) -> Points:
        """Give points (...,) of the profile in the cam, m."""
        place = np.mod(along, self.count) if self.closed else np.clip(along, 0.0, self.count)
        which = np.minimum(place.astype(int), self.count - 1)
        share = place - which
        left = 1 - share
        a, b, c, d = np.moveaxis(self._cubics[which], -1, 0)
        centre, arm, sweep = (column[which] for column in self._arcs)
        cubic = left**3 * a + 3 * left * share * (left * b + share * c) + share**3 * d
        return np.asarray(cubic + centre + arm * np.exp(1j * sweep * share))

    @cached_property
    def looked(self) -> Floats:
        """Where it is looked at first."""
        return np.arange(self.count * LOOKED + (0 if self.closed else 1)) / LOOKED


def _continued(pieces: tuple[Piece, ...]) -> tuple[Piece, ...]:
    """Give an open profile with straight ends: a follower over its very end must not miss it by its rounding."""
    start, end = pieces[0].start, pieces[-1].end
    back, onward = start - pieces[0].at(TINY), end - pieces[-1].at(1 - TINY)
    before, after = start + BEYOND * back / abs(back), end + BEYOND * onward / abs(onward)
    return (straight(before, start), *pieces, straight(end, after))


def _length(piece: Piece) -> float:
    """Give the length of an arc, and of the chain of points that leads a cubic."""
    if isinstance(piece, RoundPiece):
        return piece.radius * abs(piece.sweep)
    return sum(abs(end - start) for start, end in pairwise(piece))


def _facets(piece: Piece, longest: float) -> list[Piece]:
    """Divide an arc by its turn; a cubic, as a dwell of a cam that translates is one, by its length."""
    if isinstance(piece, CubicPiece):
        count = max(math.ceil(_length(piece) / longest), 1) if longest else 1
        return [_part(piece, k / count, (k + 1) / count) for k in range(count)] if count > 1 else [piece]
    count = max(math.ceil(abs(piece.sweep) / (TURN * FACET)), 1)
    return [RoundPiece(piece.at(k / count), piece.centre, piece.sweep / count) for k in range(count)]


def _part(piece: CubicPiece, low: float, high: float) -> CubicPiece:
    """Give a part of a cubic as a cubic (построение де Кастельжо)."""
    return CubicPiece(*(_led(piece, [low] * (3 - k) + [high] * k) for k in range(4)))


def _led(points: Sequence[complex], shares: Sequence[float]) -> complex:
    for share in shares:
        points = [(1 - share) * one + share * other for one, other in pairwise(points)]
    return points[0]


class _Way(NamedTuple):
    """The way of a follower's tip through points of the frame: how far aside of it they are, m, and at which S."""

    aside: Floats
    level: Floats


def rolled(
    pieces: tuple[Piece, ...], cam: Cam, sizes: Sizes, roller: float, turned: Floats, outer: bool = False
) -> Floats:
    """Give S of the follower at turns of the cam, (N,): m, or rad of one that rocks; `outer` is a groove's other flank.

    Where nothing of the profile is in the follower's way it is minus infinity.
    """
    track = _Track(_continued(pieces) if cam.translates else pieces, not cam.translates)

    def framed(along: Floats) -> Points:
        return _in_the_frame(track.at(along), cam, turned[:, None])

    if cam.follower.end == POINTED:
        return _met(track, lambda along: _way(framed(along), cam, sizes), len(turned))
    sign = -1 if outer else 1
    found = _highest(track, lambda along: _lift(framed(along), cam, sizes, roller, sign))
    return sign * np.where(found > AWAY / 2, found, NOWHERE)


def apart(pieces: tuple[Piece, ...], closed: bool, spots: Points) -> Floats:
    """Give how far points, (N,) m, are from the nearest place of a profile."""
    track = _Track(pieces, closed)
    parts = np.array_split(spots, math.ceil(len(spots) / AT_ONCE))
    return np.concatenate([_apart(track, part) for part in parts])


def _apart(track: _Track, spots: Points) -> Floats:
    """Look closer about the nearest chords: where a profile turns back, a place is nearest on one strand of several."""
    ends = np.append(track.looked, track.count) if track.closed else track.looked
    start, run = track.at(ends)[:-1], np.diff(track.at(ends))
    way = spots[:, None] - start
    share = np.clip((way * run.conj()).real / np.maximum(np.abs(run) ** 2, np.finfo(float).tiny), 0.0, 1.0)
    nearest = np.argpartition(np.abs(way - share * run), TOPS, axis=1)[:, :TOPS]
    half = 0.5 / LOOKED
    return -_closer(lambda along: -np.abs(track.at(along) - spots[:, None]), ends[nearest] + half, half)


def _in_the_frame(spot: Points, cam: Cam, turned: Floats) -> Points:
    if cam.translates:
        return np.asarray(spot - cam.sense * turned)
    return np.asarray(spot * np.exp(1j * cam.sense * turned))


def _way(spot: Points, cam: Cam, sizes: Sizes) -> _Way:
    if cam.rocks:
        # Angles are counted from the way to O, so that what is beyond the cam is below, not a turn above.
        arm, towards = spot - sizes.pivot, complex(cam.rising) if cam.translates else -sizes.pivot
        if cam.translates:  # a rocker never turns back behind its pivot: what is there counts as right over or under it
            arm = cam.rising * np.maximum(cam.rising * arm.real, 0.0) + 1j * arm.imag
        level = cam.rising * (np.angle(arm / towards) + np.angle(cam.rising * towards)) + cam.lift / 2
        return _Way(np.abs(arm) - (cam.follower.length or 0.0), level)
    if cam.flat:  # its base is how far the face is from O, wherever its axis is
        return _Way(spot.real, spot.imag - sizes.base)
    axis = 0.0 if cam.translates else cam.sense * sizes.offset
    return _Way(spot.real - axis, spot.imag - math.sqrt(sizes.base**2 - sizes.offset**2))


def _lift(spot: Points, cam: Cam, sizes: Sizes, roller: float, sign: int) -> Floats:
    """Give S at which a follower touches points from above (sign +1), or from below, turned round (-1)."""
    way = _way(spot, cam, sizes)
    if cam.flat:
        with np.errstate(invalid="ignore"):  # what is nearer to the pivot than the face is never touched
            far = np.arcsin(cam.follower.face / np.abs(spot - sizes.pivot)) if cam.rocks else 0.0
        return np.asarray(np.where(np.isnan(far), NOWHERE, way.level - far))
    lift, off = _upon(way, cam, roller, sign)
    lift = np.where(np.isnan(lift), AWAY - off, lift)
    if sign < 0 and not cam.translates:  # of a groove the other flank is met below the cam too
        return np.where(way.level < _way(np.array(0j), cam, sizes).level, NOWHERE, lift)
    return lift


def _upon(way: _Way, cam: Cam, roller: float, sign: int) -> tuple[Floats, Floats]:
    """Give S of a roller upon points, NaN of those too far aside for it, and by how much they are; in its own unit."""
    with np.errstate(invalid="ignore"):
        if not cam.rocks:
            return sign * way.level + np.sqrt(roller**2 - way.aside**2), np.abs(way.aside) - roller
        length = cam.follower.length or 0.0
        apart = way.aside + length
        cosine = (length**2 + apart**2 - roller**2) / (2 * length * apart)
        return sign * way.level + np.arccos(cosine), np.abs(cosine) - 1


def _highest(track: _Track, lift: Callable[[Floats], Floats]) -> Floats:
    """Give the highest lift along a profile at each of N turns, (N,)."""
    return _closer(lift, track.looked[_tops(lift(track.looked[None, :]), track.closed)], 1 / LOOKED)


def _closer(lift: Callable[[Floats], Floats], best: Floats, reach: float) -> Floats:
    """Look closer about the best places, (N, TOPS), so far to both sides at first: give the highest lift, (N,)."""
    for _ in range(CLOSER):
        near = best[:, :, None] + reach * NEAR
        found = lift(near.reshape(len(best), -1)).reshape(near.shape)
        best = np.take_along_axis(near, found.argmax(axis=2)[:, :, None], axis=2)[:, :, 0]
        reach /= LOOKED
    return np.asarray(lift(best).max(axis=1))


def _tops(found: Floats, closed: bool) -> npt.NDArray[np.intp]:
    """Give the highest few of the places that are above their neighbours, (N, TOPS): near a cusp there are two."""
    ends = (found[:, -1:], found[:, :1]) if closed else (np.full((len(found), 1), NOWHERE),) * 2
    padded = np.concatenate([ends[0], found, ends[1]], axis=1)
    top = (found >= padded[:, :-2]) & (found >= padded[:, 2:])
    return np.argpartition(np.where(top, found, NOWHERE), -TOPS, axis=1)[:, -TOPS:]


def _met(track: _Track, way: Callable[[Floats], _Way], count: int) -> Floats:
    """Give the highest S at which a profile is met by the way of a tip, at each of so many turns, (N,)."""
    looked = np.append(track.looked, track.count) if track.closed else track.looked
    aside, level = way(looked[None, :])
    crossed = aside[:, :-1] * aside[:, 1:] <= 0
    start = looked[np.where(crossed, level[:, :-1], NOWHERE).argmax(axis=1)]
    reach = 1 / LOOKED
    for _ in range(CLOSER):
        near = start[:, None] + reach * np.arange(LOOKED + 1) / LOOKED
        aside = way(near).aside
        # Where it is met at the very end of a part, rounding may leave no change of sign: it is where it is nearest.
        off = np.where(aside[:, :-1] * aside[:, 1:] <= 0, -1.0, np.minimum(*np.abs([aside[:, :-1], aside[:, 1:]])))
        start = near[np.arange(count), off.argmin(axis=1)]
        reach /= LOOKED
    first, last = way(start[:, None]), way(start[:, None] + reach)
    run = last.aside - first.aside
    share = np.where(run == 0, 0.0, -first.aside / np.where(run == 0, 1.0, run))
    level = first.level + share * (last.level - first.level)
    return np.where(crossed.any(axis=1), level[:, 0], NOWHERE)
