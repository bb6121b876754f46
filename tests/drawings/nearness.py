"""How far places are from the nearest place of a profile, as it was read from a sheet (профиль)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from geometry.curve import CubicPiece, Piece, RoundPiece
from plans.model.cam import TURN
from plans.model.cam_motion import Points
from plans.model.motion import Floats

FACET = 1 / 72  # of a turn of an arc, or of the length of a profile: what is longer is looked through in parts
LOOKED = 8  # places on a piece that are looked at first
CLOSER = 8  # rounds of looking closer, each at so many places to either side of the best, up to its neighbours
NEAR = np.linspace(-1.0, 1.0, 2 * LOOKED + 1)
TOPS = 3  # places that are looked at closer
AT_ONCE = 256  # points that are held against all of a profile together


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


def _closer(lift: Callable[[Floats], Floats], best: Floats, reach: float) -> Floats:
    """Look closer about the best places, (N, TOPS), so far to both sides at first: give the highest lift, (N,)."""
    for _ in range(CLOSER):
        near = best[:, :, None] + reach * NEAR
        found = lift(near.reshape(len(best), -1)).reshape(near.shape)
        best = np.take_along_axis(near, found.argmax(axis=2)[:, :, None], axis=2)[:, :, 0]
        reach /= LOOKED
    return np.asarray(lift(best).max(axis=1))
