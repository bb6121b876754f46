"""A construction of synthesis and the mechanisms that it gives: what is shown of it, what each size is read from."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from geometry.board import Board, Mark, Reading
from plans.model.synthesis.design import Design
from plans.quantity import Shown


class SynthesisFigure(NamedTuple):
    """What a sheet shows of a construction, by the letters of the design's places and sizes.

    The mechanism stands in its first position in full lines, in others by dashes; a block slides along a direction.
    Sizes are dimensioned between two places, angles at one from the second to the third.
    """

    first: tuple[str, ...] = ()
    others: tuple[tuple[str, ...], ...] = ()
    lines: tuple[tuple[str, str], ...] = ()  # of the construction, thin
    axes: tuple[tuple[str, str], ...] = ()
    hinges: frozenset[str] = frozenset()
    fixed: frozenset[str] = frozenset()  # pivots in the frame
    blocks: Mapping[str, complex] = MappingProxyType({})
    lengths: tuple[tuple[str, str, str], ...] = ()
    angles: tuple[tuple[str, str, str, str], ...] = ()


class DrawnDesign(NamedTuple):
    """A mechanism drawn: as read off the board, from which marks, and over which arm m a length moves an angle.

    A size that hangs on what is found by trial may be off `within` something more.
    """

    design: Design
    shown: Mapping[str, Shown]
    arms: Mapping[str, float]
    figure: SynthesisFigure
    within: Mapping[str, float] = MappingProxyType({})


class DrawnReading(NamedTuple):
    """One reading of a task, or one of its circles, drawn: the board and every mechanism found on it."""

    kept: tuple[str, ...]
    board: Board
    found: tuple[DrawnDesign, ...]


def angle(board: Board, name: str, first: Mark, second: Mark) -> Reading:
    """Measure an angle between two ways: the first is turned into the second."""
    unit = board.turn(f"{name}:w", second, 1 / abs(complex(second.point)))
    return Reading(board.turn(name, first, unit.point / first.point), unit)
