"""What must stand on a sheet: a statement, the value that the analysis gives it, how far off it may be (ожидаемое)."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple, TypeAlias

import numpy as np

from drawings.paper.statement import Key, Kind
from drawings.paper.strokes import Leaf
from plans.model.motion import Complexes, Floats

# A value of a vector, a number, a direction; a text; a graph as a function of its argument; a path by dense points.
Value: TypeAlias = complex | float | str | Callable[[Floats], Floats] | Complexes


KNOWN = 1e-9  # share of a number that both roads may differ by: they agree far better
NOTES, NOTHING = "notes", "—"  # the figure that notes stand on; what a cell without a value says


class Expected(NamedTuple):
    """A row of the table of what must stand on the sheets of a kind, by the analysis alone.

    One that `may_lack` is too short to be drawn, or doubtful by rounding; one that rounding alone decides is `allowed`
    any difference, math.inf. `letter` is what its mark must be lettered;
    `ends` are where a graph begins and ends, in units of its argument.
    """

    kind: Kind
    figure: str
    name: str
    value: Value
    allowed: float = 0.0
    position: int | None = None
    may_lack: bool = False
    letter: str = ""
    ends: tuple[float, float] = (math.nan, math.nan)
    digits: int = 0  # of a number: so many may be written, its end may be left off that is zero
    period: float = 0.0  # of an angle: a full turn more or less is the same

    @property
    def key(self) -> Key:
        """What is stated of whom."""
        return self.kind, self.figure, self.name, self.position


def subject(leaf: Leaf) -> str:
    """Tell what a sheet is of among those of its kind; what must stand on sheets is asked of each subject apart."""
    return str(leaf.metadata.get("cam", ""))


def course(x: Floats, y: Floats) -> Callable[[Floats], Floats]:
    """Give the function that goes straight from point to point.

    >>> float(course(np.array([0.0, 2.0]), np.array([1.0, 5.0]))(np.array([0.5]))[0])
    2.0
    """
    return lambda at: np.asarray(np.interp(at, x, y))


def by_hand(table: str, name: str, error: float, most: float, position: int | None = None) -> Expected:
    """Give the cell of what a hand may be out: two digits of it, or nothing at a dead centre."""
    if not error <= most:
        return Expected(Kind.NUMBER, table, name, NOTHING, position=position)
    return Expected(Kind.NUMBER, table, name, error, 0.05 * error, position=position)
