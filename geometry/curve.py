"""Curves in pieces: cubics and arcs, each beginning where the last one ends (кривая из кубических кусков и дуг)."""

from __future__ import annotations

import cmath
import math
from itertools import pairwise
from typing import NamedTuple, TypeAlias

NEARER = 6  # steps of Newton's method to a foot
TINY = 1e-300  # keeps them from dividing by the speed at a cusp


class CubicPiece(NamedTuple):
    """A cubic from `start` to `end`, which leaves towards `first` and comes from `second` (кривая Безье)."""

    start: complex
    first: complex
    second: complex
    end: complex

    def at(self, share: float) -> complex:
        """Give the point at a share, from 0 to 1, of its parameter.

        >>> CubicPiece(0j, 1 + 0j, 2 + 0j, 3 + 0j).at(0.5)
        (1.5+0j)
        """
        left = 1 - share
        ends = left**3 * self.start + share**3 * self.end
        return ends + 3 * left * share * (left * self.first + share * self.second)

    def part(self, low: float, high: float) -> CubicPiece:
        """Give what of it lies between two shares of its parameter.

        >>> CubicPiece(0j, 1 + 0j, 2 + 0j, 3 + 0j).part(0.5, 1.0)
        CubicPiece(start=(1.5+0j), first=(2+0j), second=(2.5+0j), end=(3+0j))
        """
        third = (high - low) / 3
        start, end = self.at(low), self.at(high)
        return CubicPiece(start, start + third * self._rate(low), end - third * self._rate(high), end)

    def nearest(self, spot: complex, share: float) -> float:
        """Give the share at which it is nearest to a place, from one that is near; Newton's method on the foot.

        >>> CubicPiece(0j, 1 + 0j, 2 + 0j, 3 + 0j).nearest(0.75 + 1j, 0.2)
        0.25
        """
        for _ in range(NEARER):
            rate = self._rate(share)
            share += ((spot - self.at(share)) * rate.conjugate()).real / max(abs(rate) ** 2, TINY)
        return min(max(share, 0.0), 1.0)

    def _rate(self, share: float) -> complex:
        left = 1 - share
        ends = left**2 * (self.first - self.start) + share**2 * (self.end - self.second)
        return 3 * ends + 6 * left * share * (self.second - self.first)

    def placed(self, factor: complex, shift: complex) -> CubicPiece:
        """Give it turned and enlarged by a factor, then shifted."""
        return CubicPiece(*(factor * point + shift for point in self))


class RoundPiece(NamedTuple):
    """An arc from `start` about `centre` through the angle `sweep`, rad, above 0 counter-clockwise (дуга)."""

    start: complex
    centre: complex
    sweep: float

    def at(self, share: float) -> complex:
        """Give the point after a share, from 0 to 1, of its sweep."""
        return self.centre + (self.start - self.centre) * cmath.exp(1j * share * self.sweep)

    def nearest(self, spot: complex, share: float) -> float:
        """Give the share of its sweep towards a place: it is gone through evenly, and the share is known."""
        return share

    def part(self, low: float, high: float) -> RoundPiece:
        """Give what of it lies between two shares of its sweep."""
        return RoundPiece(self.at(low), self.centre, (high - low) * self.sweep)

    @property
    def end(self) -> complex:
        """Where it ends."""
        return self.at(1.0)

    @property
    def radius(self) -> float:
        """Its radius."""
        return abs(self.start - self.centre)

    def placed(self, factor: complex, shift: complex) -> RoundPiece:
        """Give it turned and enlarged by a factor, then shifted."""
        return RoundPiece(factor * self.start + shift, factor * self.centre + shift, self.sweep)


Piece: TypeAlias = CubicPiece | RoundPiece


def straight(start: complex, end: complex) -> CubicPiece:
    """Give a straight line as a cubic that is gone through evenly.

    >>> straight(0j, 3 + 0j).first
    (1+0j)
    """
    return CubicPiece(start, start + (end - start) / 3, end - (end - start) / 3, end)


def sampled(pieces: tuple[Piece, ...], sag: float) -> list[complex]:
    """Give points along pieces, the chain of which is nowhere farther from them than a sag."""
    points = [pieces[0].start]
    for piece in pieces:
        count = _facets(piece, sag)
        points += [piece.at(k / count) for k in range(1, count + 1)]
    return points


def _facets(piece: Piece, sag: float) -> int:
    if isinstance(piece, RoundPiece):
        flat = 2 * math.acos(max(1 - sag / piece.radius, 0.0)) if piece.radius > 0 else math.inf
        return max(math.ceil(abs(piece.sweep) / flat), 1)
    # A chord over 1/n of a cubic is off it by its second derivative over 8 n2 at the most.
    bend = max(abs(a - 2 * b + c) for a, b, c in (piece[:3], piece[1:]))
    return max(math.ceil(math.sqrt(6 * bend / (8 * sag))), 1)


def gaps(pieces: tuple[Piece, ...], closed: bool) -> float:
    """Give the widest gap between the end of a piece and the start of the next one."""
    following = (*pieces, pieces[0]) if closed else pieces
    return max((abs(after.start - before.end) for before, after in pairwise(following)), default=0.0)
