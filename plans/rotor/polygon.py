"""A polygon of vectors: laid off one after another from a pole, and closed (векторный многоугольник)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from geometry.board import Board, Mark
from plans.model.rotor import EPS, ROUNDING, Resultant
from plans.words.words import Message, because

CLOSES = because("closes_polygon")
RUN = 8  # vectors laid off in one row: a row of a thousand like ones would lose digits with each


class Side(NamedTuple):
    """A side of a polygon: its vector, and the corners between which it lies."""

    vector: Mark
    start: Mark
    end: Mark


class Polygon(NamedTuple):
    """A polygon of vectors: its sides in order, what closes it, and how far rounding can have moved that."""

    board: Board
    sides: tuple[Side, ...]
    closing: Mark
    slack: float

    @property
    def resultant(self) -> Resultant:
        """What closes the polygon."""
        return Resultant(complex(self.closing.point), self.slack)

    @property
    def closed(self) -> bool:
        """Whether the vectors close by themselves."""
        return self.resultant.vanishes


def polygon(
    board: Board, pole: Mark, name: str, vectors: Sequence[Mark], carried: float = 0.0, why: Message = CLOSES
) -> Polygon:
    """Lay vectors off one after another from a pole and close them; a vector of no length has no side.

    `carried` is how far rounding can have moved the vectors themselves.
    """
    laid = [one for one in vectors if one.point]
    sides = _row(board, pole, name, laid)
    closing = close(board, pole, name, laid, why) if len(laid) > RUN else board.join(name, _end(pole, sides), pole, why)
    return Polygon(board, sides, closing, rounding(laid) + carried)


def close(board: Board, pole: Mark, name: str, vectors: Sequence[Mark], why: Message) -> Mark:
    """Close any number of vectors: laid off in runs, and the ends of the runs likewise."""
    level = 0
    while len(vectors) > RUN:
        runs = [vectors[k : k + RUN] for k in range(0, len(vectors), RUN)]
        level += 1
        vectors = [_end(pole, _row(board, pole, f"{name}/{level}.{k}", run)) for k, run in enumerate(runs, 1)]
    return board.close(name, *vectors, why=why)


def rounding(vectors: Sequence[Mark]) -> float:
    """Give how far rounding can have moved the sum of some vectors."""
    return ROUNDING * EPS * sum(abs(complex(one.point)) for one in vectors)


def _row(board: Board, pole: Mark, name: str, vectors: Sequence[Mark]) -> tuple[Side, ...]:
    sides: list[Side] = []
    for number, vector in enumerate(vectors, 1):
        start = _end(pole, sides)
        sides.append(Side(vector, start, board.lay_off(f"{name}:{number}", start, vector, because("end_to_end"))))
    return tuple(sides)


def _end(pole: Mark, sides: Sequence[Side]) -> Mark:
    return sides[-1].end if sides else pole
