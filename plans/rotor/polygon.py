"""A polygon of vectors: laid off one after another from a pole, and closed (векторный многоугольник)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from geometry.board import Board, Mark
from plans.model.rotor import EPS, ROUNDING, Resultant


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
    board: Board, pole: Mark, name: str, vectors: Sequence[Mark], carried: float = 0.0, why: str = "closes the polygon"
) -> Polygon:
    """Lay vectors off one after another from a pole and close them; a vector of no length has no side.

    `carried` is how far rounding can have moved the vectors themselves.
    """
    sides: list[Side] = []
    corner = pole
    for vector in (one for one in vectors if one.point):
        end = board.lay_off(f"{name}:{len(sides) + 1}", corner, vector, "end to end")
        sides.append(Side(vector, corner, end))
        corner = end
    closing = board.join(name, corner, pole, why)
    sizes = sum(abs(complex(side.vector.point)) for side in sides)
    return Polygon(board, tuple(sides), closing, ROUNDING * EPS * sizes + carried)
