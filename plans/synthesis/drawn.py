"""A construction of synthesis and the mechanisms that it gives: what is shown of it, what each size is read from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from geometry.board import Board
from plans.model.motion import Complexes
from plans.model.synthesis.design import Design
from plans.quantity import Shown


@dataclass(frozen=True)
class Figure:
    """What a sheet shows of a construction, by the letters of the design's places.

    The mechanism stands in its first position in full lines, in others by dashes; a block slides along a direction.
    """

    first: tuple[str, ...] = ()
    others: tuple[tuple[str, ...], ...] = ()
    lines: tuple[tuple[str, str], ...] = ()  # of the construction, thin
    axes: tuple[tuple[str, str], ...] = ()
    hinges: frozenset[str] = frozenset()
    fixed: frozenset[str] = frozenset()  # pivots in the frame
    blocks: Mapping[str, complex] = field(default_factory=dict)
    curves: Mapping[str, Complexes] = field(default_factory=dict)  # that are no circles: a coupler's curve


class Drawn(NamedTuple):
    """A mechanism drawn: as read off the board, from which marks, and over which arm m a length moves an angle."""

    design: Design
    shown: Mapping[str, Shown]
    arms: Mapping[str, float]
    figure: Figure


class DrawnReading(NamedTuple):
    """One reading of a task, or one of its circles, drawn: the board and every mechanism found on it."""

    kept: tuple[str, ...]
    board: Board
    found: tuple[Drawn, ...]
