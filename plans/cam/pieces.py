"""A law of motion put together of pieces whose acceleration is integrated twice, exactly (закон движения по участкам).

A piece of acceleration is a polynomial, or one harmonic beside it; two integrations make slope and displacement, each
going on where the last piece ended. All is in shares: of the phase across, of the lift up.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from plans.model.motion import Floats


class Push(NamedTuple):
    """Acceleration over a share `length` of the phase: a polynomial in the share gone, size*sin(rate*share + phase)."""

    length: float
    powers: tuple[float, ...] = ()
    size: float = 0.0
    rate: float = 1.0
    phase: float = 0.0


class Piece(NamedTuple):
    """A piece of a law: where it begins, and S as a polynomial in the share gone with a harmonic beside it."""

    start: float
    powers: tuple[float, ...]
    size: float
    rate: float
    phase: float

    def at(self, gone: Floats, order: int) -> Floats:
        """Give S or a derivative of it after a share of the phase from the start of the piece."""
        powers = np.polynomial.polynomial.polyder(self.powers, order) if order else np.asarray(self.powers)
        wave = self.size * self.rate**order * np.sin(self.rate * gone + self.phase + order * np.pi / 2)
        return np.asarray(np.polynomial.polynomial.polyval(gone, powers) + wave)


@dataclass(frozen=True)
class Shares:
    """A law in shares of phase and lift, from 0 to 1 over the whole phase."""

    pieces: tuple[Piece, ...]

    @property
    def starts(self) -> tuple[float, ...]:
        """Where its pieces begin."""
        return tuple(piece.start for piece in self.pieces)

    def at(self, share: Floats, order: int, before: bool = False) -> Floats:
        """Give s, s' or s'' (order 0 to 2, (N,)); where pieces join that of the later one, or of the one before.

        >>> law = shares([Push(0.5, (1.0,)), Push(0.5, (-1.0,))])
        >>> law.at(np.array([0.25, 0.5]), 0).tolist(), law.at(np.array([0.5]), 2, before=True).tolist()
        ([0.125, 0.5], [4.0])
        """
        k = np.asarray(share, dtype=float)
        own = np.clip(
            np.searchsorted(np.array(self.starts), k, side="left" if before else "right") - 1, 0, len(self.pieces) - 1
        )
        found = np.empty_like(k)
        for number, piece in enumerate(self.pieces):
            found[own == number] = piece.at(k[own == number] - piece.start, order)
        return found


def shares(pushes: Iterable[Push], slope: float = 0.0) -> Shares:
    """Integrate pieces of acceleration twice from rest, or from a slope, and scale them to a lift of 1.

    >>> shares([Push(1.0)], slope=2.0).at(np.array([0.5]), 1).tolist()
    [1.0]
    """
    pieces: list[Piece] = []
    start, level = 0.0, 0.0
    for push in pushes:
        piece = _integrated(push, start, slope, level)
        pieces.append(piece)
        end = np.array([push.length])
        level, slope = float(piece.at(end, 0)[0]), float(piece.at(end, 1)[0])
        start += push.length
    return Shares(tuple(_scaled(pieces, 1 / level)))


def _integrated(push: Push, start: float, slope: float, level: float) -> Piece:
    """Integrate one piece twice, so that it begins with a slope and a level."""
    size = -push.size / push.rate**2
    own = Piece(start, (0.0,), size, push.rate, push.phase)
    zero = np.zeros(1)
    constants = (slope - float(own.at(zero, 1)[0]), level - float(own.at(zero, 0)[0]))
    powers = np.polynomial.polynomial.polyint(push.powers or (0.0,), 2, list(constants))
    return own._replace(powers=tuple(powers.tolist()))


def _scaled(pieces: Sequence[Piece], by: float) -> Iterable[Piece]:
    return (one._replace(powers=tuple(by * c for c in one.powers), size=by * one.size) for one in pieces)
