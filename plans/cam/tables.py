"""A law by a table of S over φ: joined by lines, or by a ruler that bends (закон движения по таблице, гибкая линейка).

The ruler is the cubic spline with no slope at both ends. Its moments, the accelerations at the points, are what is
solved for; between two points they go straight. Of springs in place of the points it departs a little and bends less.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from plans.model.cam import LINES, SOFTNESSES, Law
from plans.model.motion import Floats

CORNER = 1e-9  # of the largest value of a derivative: what is less is the rounding of a law's coefficients
Pieces = npt.NDArray[np.int_]  # numbers of pieces, (N,)


class AccelerationPiece(NamedTuple):
    """Acceleration over a share `length` of the phase: a polynomial in the share gone, size*sin(rate*share + phase)."""

    length: float
    powers: tuple[float, ...] = ()
    size: float = 0.0
    rate: float = 1.0
    phase: float = 0.0


class LawPiece(NamedTuple):
    """A piece of a law: where it begins, and S as a polynomial in the share gone with a harmonic beside it."""

    start: float
    powers: tuple[float, ...]
    size: float = 0.0
    rate: float = 1.0
    phase: float = 0.0

    def at(self, gone: float, order: int) -> float:
        """Give S or a derivative of it after a share of the phase from the start of the piece."""
        return float(LawShares((self,)).of(np.zeros(1, dtype=int), np.array([gone]), order)[0])


@dataclass(frozen=True)
class LawShares:
    """A law in shares of phase and lift, from 0 to 1 over the whole phase."""

    pieces: tuple[LawPiece, ...]

    @cached_property
    def starts(self) -> tuple[float, ...]:
        """Where its pieces begin."""
        return tuple(piece.start for piece in self.pieces)

    def at(self, share: Floats, order: int, before: bool = False) -> Floats:
        """Give s, s' or s'' (order 0 to 2, (N,)); where pieces join that of the later one, or of the one before.

        >>> law = shares([AccelerationPiece(0.5, (1.0,)), AccelerationPiece(0.5, (-1.0,))])
        >>> law.at(np.array([0.25, 0.5]), 0).tolist(), law.at(np.array([0.5]), 2, before=True).tolist()
        ([0.125, 0.5], [4.0])
        """
        k = np.asarray(share, dtype=float)
        starts = np.array(self.starts)
        piece = np.clip(np.searchsorted(starts, k, side="left" if before else "right") - 1, 0, len(starts) - 1)
        return self.of(piece, k - starts[piece], order)

    def of(self, pieces: Pieces, gone: Floats, order: int) -> Floats:
        """Give s or a derivative, the third at most, of pieces by numbers, after shares from their starts, (N,)."""
        size, rate, phase = (column[pieces] for column in self._waves)
        wave = size * rate**order * np.sin(rate * gone + phase + order * np.pi / 2)
        return np.asarray(_horner(self._powers[order][:, pieces], gone) + wave)

    def gross(self, order: int) -> float:
        """Give what the terms of s or a derivative add up to at the most, whatever their signs: rounding is a share."""
        widths = np.diff([*self.starts, 1.0])
        size, rate, _ = self._waves
        return float(np.max(_horner(np.abs(self._powers[order]), widths) + np.abs(size) * rate**order))

    @cached_property
    def _waves(self) -> Floats:
        return np.array([(piece.size, piece.rate, piece.phase) for piece in self.pieces]).T

    @cached_property
    def _powers(self) -> tuple[Floats, ...]:
        """The coefficients of s and its derivatives by the power of the share gone, each (powers, pieces)."""
        most = max(3, *(len(piece.powers) for piece in self.pieces))
        rows = np.array([(*piece.powers, *(0.0,) * (most - len(piece.powers))) for piece in self.pieces]).T
        return tuple(np.polynomial.polynomial.polyder(rows, order) if order else rows for order in range(4))


def _horner(powers: Floats, x: Floats) -> Floats:
    """Sum powers of x, each with coefficients of its own, (powers, N)."""
    total = np.zeros_like(x)
    for row in powers[::-1]:
        total = total * x + row
    return total


def shares(pushes: Iterable[AccelerationPiece], slope: float = 0.0) -> LawShares:
    """Integrate pieces of acceleration twice from rest, or from a slope, and scale them to a lift of 1.

    >>> shares([AccelerationPiece(1.0)], slope=2.0).at(np.array([0.5]), 1).tolist()
    [1.0]
    """
    pieces: list[LawPiece] = []
    start, level = 0.0, 0.0
    for push in pushes:
        piece = _integrated(push, start, slope, level)
        pieces.append(piece)
        level, slope = piece.at(push.length, 0), piece.at(push.length, 1)
        start += push.length
    by = 1 / level
    scaled = (piece._replace(powers=tuple(by * c for c in piece.powers), size=by * piece.size) for piece in pieces)
    return LawShares(tuple(scaled))


def _integrated(push: AccelerationPiece, start: float, slope: float, level: float) -> LawPiece:
    """Integrate one piece twice, so that it begins with a slope and a level."""
    size = -push.size / push.rate**2
    integrated = LawPiece(start, (0.0,), size, push.rate, push.phase)
    constants = (slope - integrated.at(0.0, 1), level - integrated.at(0.0, 0))
    powers = np.polynomial.polynomial.polyint(push.powers or (0.0,), 2, list(constants))
    return integrated._replace(powers=tuple(powers.tolist()))


def bends(law: LawShares) -> Iterator[float]:
    """Give where pieces of a law join with a jump of s' or s'', or a corner of s''.

    >>> quarter = AccelerationPiece(0.25, (1.0,))
    >>> list(bends(shares([quarter, quarter, AccelerationPiece(0.5, (-1.0,))])))
    [0.5]
    """
    joins = np.array(law.starts[1:])
    numbers = np.arange(len(joins))
    after, before = (
        np.array([law.of(pieces, gone, order) for order in (1, 2, 3)])
        for pieces, gone in ((numbers + 1, 0 * joins), (numbers, joins - np.array(law.starts[:-1])))
    )
    largest = np.maximum(np.abs(after), np.abs(before)).max(axis=1, initial=1.0, keepdims=True)
    apart = np.abs(after - before) > CORNER * largest
    yield from joins[apart.any(axis=0)].tolist()


class Ruler(NamedTuple):
    """A bent ruler: where its points are, in shares of the phase, s there, and the accelerations there, (N,)."""

    share: Floats
    s: Floats
    moments: Floats

    def departure(self, law: Law) -> tuple[float, float]:
        """Give how far it is from a table's points at most, in shares of the lift, and at which share of the phase."""
        off = np.abs(self.s - np.array(law.points)[:, 1])
        worst = int(np.argmax(off.round(9)))  # of a table and its mirror image the first
        return float(off[worst]), float(self.share[worst])


def table(law: Law) -> LawShares:
    """Give the law of a table in pieces.

    >>> table(Law("table", points=((0, 0), (0.5, 0.4), (1, 1)), through="lines")).at(np.array([0.75]), 1).tolist()
    [1.2]
    """
    return _lines(law) if law.through == LINES else _cubics(ruler(law))


def smoothing(law: Law) -> tuple[float, float]:
    """Tell how far a table's curve is from its points at most, in shares of the lift, and where: never unsaid.

    >>> smoothing(Law("table", points=((0, 0), (0.5, 0.4), (1, 1))))
    (0.0, 0.0)
    """
    return (0.0, 0.0) if law.through == LINES else ruler(law).departure(law)


@lru_cache(maxsize=64)
def ruler(law: Law) -> Ruler:
    """Bend a ruler through a table's points, or as near to them as its tolerance allows with the least bending."""
    k, y = np.array(law.points, dtype=float).T
    equations = _equations(np.diff(k))
    best, low, high = y, -1, len(SOFTNESSES) if law.tolerance > 0 else 0
    while high - low > 1:
        middle = (low + high) // 2
        found = _sprung(equations, y, SOFTNESSES[middle])
        if np.abs(found - y).max() <= law.tolerance:
            best, low = found, middle
        else:
            high = middle
    return Ruler(k, best, np.linalg.solve(equations.bends, equations.kinks @ best))


class RulerEquations(NamedTuple):
    """The equations of three moments: `bends` by the moments are the `kinks` by the ordinates, (N, N) each.

    `given` are the kinks of what springs under all points but the first and the last give: their forces are kinks too.
    """

    bends: Floats
    kinks: Floats
    given: Floats


def _equations(h: Floats) -> RulerEquations:
    """Set the equations up for points at some distances, shares of the phase."""
    kinks = np.diag(-np.append(1 / h, 0.0) - np.append(0.0, 1 / h)) + np.diag(1 / h, 1) + np.diag(1 / h, -1)
    bends = np.diag(np.append(h, 0.0) + np.append(0.0, h)) / 3 + np.diag(h, 1) / 6 + np.diag(h, -1) / 6
    return RulerEquations(bends, kinks, kinks[:, 1:-1] @ kinks[1:-1])


def _sprung(equations: RulerEquations, y: Floats, softness: float) -> Floats:
    """Give the ordinates of a ruler on springs of some softness, (N,)."""
    moments = np.linalg.solve(equations.bends + softness * equations.given, equations.kinks @ y)
    forces = equations.kinks @ moments
    return np.asarray(y - softness * np.array([0.0, *forces[1:-1], 0.0]))


def _cubics(bent: Ruler) -> LawShares:
    h, (first, last) = np.diff(bent.share), (bent.moments[:-1], bent.moments[1:])
    slopes = np.diff(bent.s) / h - h * (2 * first + last) / 6
    rows = np.column_stack([bent.s[:-1], slopes, first / 2, (last - first) / (6 * h)])
    pairs = zip(bent.share.tolist(), rows.tolist(), strict=False)
    return LawShares(tuple(LawPiece(start, tuple(row)) for start, row in pairs))


def _lines(law: Law) -> LawShares:
    return LawShares(tuple(LawPiece(k, (s, (b - s) / (a - k))) for (k, s), (a, b) in pairwise(law.points)))
