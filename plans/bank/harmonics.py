"""Harmonics of the shaking force of one mechanism by polygons of its ordinates (гармонический анализ).

A turn is divided evenly; each ordinate over their number, turned back by n times its crank angle, is laid off end to
end: the end is the vector of the harmonic of order n at the crank angle 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from geometry.board import Board, Mark
from geometry.errors import ConstructionError
from plans.bank.letters import SINGLE, letters
from plans.bank.shaking import Shaking, Source
from plans.linkage.crank_positions import directions
from plans.model.balance.bank import EPS, HARMONIC, Harmonic
from plans.model.motion import Complexes
from plans.rotor.polygon import RUN
from plans.words.words import Message, because, message

HARMONICS = "harmonics"  # the board: forces, N
FEWEST, MOST = 16, 2**14  # ordinates of a turn: begun with, and at the most
END_TO_END = because("end_to_end")


class NotSettled(ConstructionError):  # noqa: N818  (the exception tree's own word)
    """The acceleration all but jumps within the turn, and no number of ordinates gives its harmonics."""


class Harmonics(NamedTuple):
    """The polygons of ordinates: the vector of every signed order, and how far rounding can have moved each, N."""

    board: Board
    pole: Mark
    vectors: Mapping[int, Mark]
    slack: float  # what is less is none
    bound: float  # how far a vector can be out, by the conditions of the plans that the ordinates are taken from
    ordinates: Complexes  # of the turn, N

    def harmonic(self, order: int) -> Harmonic:
        """Read the harmonic of an order."""
        ahead, back = (complex(self.vectors[signed].point) for signed in (order, -order))
        return Harmonic(order, ahead, back, self.slack)

    def beyond(self, count: int, order: int) -> float:
        """Give by how much higher orders can falsify one that is found from so few ordinates, N."""
        row = np.fft.fftshift(np.abs(np.fft.fft(self.ordinates))) / len(self.ordinates)
        orders = np.arange(len(row)) - len(row) // 2
        false = [(orders % count == signed % count) & (orders != signed) for signed in (order, -order)]
        return float(max(row[one].sum() for one in false))


def harmonics(source: Source, orders: Sequence[int]) -> Harmonics:
    """Divide the turn until the harmonics settle, and draw their polygons."""
    return of_ordinates(source, _settled(source, orders), orders)


def of_ordinates(source: Source, shaking: Shaking, orders: Sequence[int]) -> Harmonics:
    """Draw the polygons of some ordinates."""
    count, board = len(shaking.force), Board(HARMONICS)
    pole = board.given("0", 0j, because("forces_start"))
    ordinates = [
        board.given(f"Φ({k})", complex(force), because("ordinate", angle=f"{360 * k / count:.10g}"))
        for k, force in enumerate(shaking.force)
    ]
    vectors = {signed: _polygon(board, pole, ordinates, signed) for signed in _signed(orders)}
    own = _rounding(source, shaking)
    return Harmonics(board, pole, vectors, own, float(np.mean(shaking.slack)) + own, shaking.force)


def _rounding(source: Source, shaking: Shaking) -> float:
    """Give what a harmonic can be of rounding alone: more where the conditions of the plans are bad."""
    return max(HARMONIC * EPS * source.scale, float(np.mean(shaking.slack)))


def _settled(source: Source, orders: Sequence[int]) -> Shaking:
    """Draw the mechanism at twice as many angles until the harmonics stay where they are."""
    count = FEWEST
    while count <= 2 * max(orders):  # of fewer ordinates an order cannot be told from a lower one
        count *= 2
    while count <= MOST:
        shaking = source.shaking(Fraction(0), count)
        limit = _rounding(source, shaking)
        moved = max(abs(a - b) for a, b in _both(shaking.force, orders))
        if moved <= limit:
            return shaking
        count *= 2
    raise NotSettled(message("bank.not_settled", most=MOST))


def _both(force: Complexes, orders: Sequence[int]) -> Iterable[tuple[complex, complex]]:
    """Give every vector by all ordinates, and by every other one."""
    signed = _signed(orders)
    fine, coarse = (np.fft.fft(one) / len(one) for one in (force, force[::2]))
    return ((complex(fine[n % len(fine)]), complex(coarse[n % len(coarse)])) for n in signed)


def _signed(orders: Sequence[int]) -> list[int]:
    return [sign * order for order in orders for sign in (1, -1)]


def _polygon(board: Board, pole: Mark, ordinates: Sequence[Mark], signed: int) -> Mark:
    """Turn the ordinates back by their angles times the order, and lay them off end to end."""
    count, name, why = len(ordinates), letters(SINGLE, signed), because("turned_back", order=signed)
    backs = (directions(-360 * signed * np.arange(count), count) / count).tolist()
    turned = [board.turn(f"{name}({k})", one, backs[k], why) for k, one in enumerate(ordinates) if one.point]
    return end_of(board, pole, name, turned, because("harmonic_end"))


def end_of(board: Board, pole: Mark, name: str, vectors: Sequence[Mark], why: Message) -> Mark:
    """Lay vectors off end to end from a pole, many of them in runs; the end is their sum."""
    level = 0
    while len(vectors) > RUN:
        runs = [vectors[k : k + RUN] for k in range(0, len(vectors), RUN)]
        level += 1
        vectors = [_row(board, pole, (f"{name}/{level}.{k}", ""), run, END_TO_END) for k, run in enumerate(runs, 1)]
    return _row(board, pole, (f"{name}/", name), vectors, why)


def _row(board: Board, pole: Mark, names: tuple[str, str], vectors: Sequence[Mark], why: Message) -> Mark:
    stem, name = names
    end = pole
    for number, vector in enumerate(vectors, 1):
        last = number == len(vectors) and name
        end = board.lay_off(name if last else f"{stem}:{number}", end, vector, why if last else END_TO_END)
    return end
