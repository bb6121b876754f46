"""Slicing of a sheet: units in their order, beside or above each other, in all sizes that they can take (разбивка).

A run of units is one unit, or two runs side by side, or one above the other. Of every run those sizes are kept that no
other beats both ways (Stockmeyer's shape functions). A run that closes a sheet ends with its corner, the title block.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from drawings.paper.walk import PLACES
from plans.model.motion import Floats

GAP = 5.0  # mm between two units; the margins of figures keep letters apart already
KEPT = 12  # sizes kept of a run
SAME = 1e-9  # mm: sizes are sums of the same units in another order

Size: TypeAlias = tuple[float, float]
Ways: TypeAlias = npt.NDArray[np.intp]


class Piece(NamedTuple):
    """A unit, by its number, at one of its sizes."""

    unit: int
    choice: int


class Cut(NamedTuple):
    """Two runs of units, side by side (beside) or one above the other; tied ones stand close."""

    beside: bool
    first: Tree
    second: Tree
    tied: bool = False


Tree: TypeAlias = Piece | Cut


def pieces(tree: Tree) -> Iterator[Piece]:
    """Give the units of a run in their order."""
    if isinstance(tree, Piece):
        yield tree
    else:
        yield from pieces(tree.first)
        yield from pieces(tree.second)


class Shapes(NamedTuple):
    """The sizes mm that a run may have, the ways in which it is cut to them, and both parts' shapes at every cut.

    Where it is cut, which way, and both parts' sizes are one number, by a `grid` of these sizes. `parts` go by how many
    units stand before the cut; a single unit has none, and its ways are its choices.
    """

    number: int
    table: Floats  # (2, most that are kept): widths and heights, infinite behind the last one
    ways: Ways
    grid: tuple[int, int]
    parts: Mapping[int, tuple[Shapes, Shapes]]

    @property
    def sizes(self) -> Floats:
        """The sizes (n, 2) mm."""
        return self.table[:, : self.number].T

    def tree(self, choice: int, units: Sequence[int]) -> Tree:
        """Give how a run of some units is cut where it has one of its sizes."""
        way = int(self.ways[choice])
        if not self.parts:
            return Piece(units[0], way)
        way, second = divmod(way, self.grid[1])
        way, first = divmod(way, self.grid[0])
        at = list(self.parts)[way // 2]
        parts = self.parts[at]
        return Cut(bool(way % 2), parts[0].tree(first, units[:at]), parts[1].tree(second, units[at:]))


BEYOND: Floats = np.full((2, KEPT), math.inf)
NONE = Shapes(0, BEYOND, np.empty(0, int), (0, 0), {})


class Cuts:
    """The sizes of all runs that fit into a room, by the sizes of their units: all orders and scales share them."""

    def __init__(self, room: Size) -> None:
        self._wide, self._high = (side + SAME for side in room)
        self._most = (self._wide + GAP) * (self._high + GAP)
        self._numbers = dict[tuple[Size, ...], int]()
        self._least: list[float] = []  # mm2 that each unit takes at least, with the gap beside and above it
        self._runs = dict[tuple[int, ...], Shapes]()

    def number(self, sizes: Sequence[Size]) -> int:
        """Give the number by which units of these sizes are known."""
        key = tuple(sizes)
        if key not in self._numbers:
            k = self._numbers[key] = len(self._numbers)
            self._least.append(min(((wide + GAP) * (high + GAP) for wide, high in key), default=math.inf))
            self._runs[k,] = self._shapes(key)
        return self._numbers[key]

    def run(self, units: tuple[int, ...]) -> Shapes:
        """Give the sizes of a run of units, by their numbers."""
        if units not in self._runs:
            self._runs[units] = self._join(units)
        return self._runs[units]

    def _shapes(self, sizes: Sequence[Size]) -> Shapes:
        return self._kept(np.array(sizes, float).reshape(-1, 2).T, (0, 0), {})

    def _join(self, units: tuple[int, ...]) -> Shapes:
        """Join the sizes of both parts of a run, wherever it can be cut, both ways."""
        if sum(self._least[k] for k in units) > self._most:
            return NONE
        cuts = {at: (self.run(units[:at]), self.run(units[at:])) for at in range(1, len(units))}
        parts = {at: pair for at, pair in cuts.items() if pair[0].number and pair[1].number}
        if not parts:
            return NONE
        pairs = parts.values()
        grid = max([pair[0].number for pair in pairs]), max([pair[1].number for pair in pairs])
        first = np.array([pair[0].table for pair in pairs])[:, :, : grid[0], None]
        second = np.array([pair[1].table for pair in pairs])[:, :, None, : grid[1]]
        sides = np.empty((2, len(parts), 2, *grid))  # widths and heights: one above the other, side by side
        np.maximum(first[:, 0], second[:, 0], out=sides[0, :, 0])
        np.maximum(first[:, 1], second[:, 1], out=sides[1, :, 1])
        sides[0, :, 1] = first[:, 0] + second[:, 0] + GAP
        sides[1, :, 0] = first[:, 1] + second[:, 1] + GAP
        return self._kept(sides.reshape(2, -1), grid, parts)

    def _kept(self, sides: Floats, grid: tuple[int, int], parts: Mapping[int, tuple[Shapes, Shapes]]) -> Shapes:
        """Keep of the sizes of a run, widths and heights, those that fit into the room."""
        (fits,) = ((sides[0] <= self._wide) & (sides[1] <= self._high)).nonzero()
        if not fits.size:
            return NONE
        kept = fits[_unbeaten(sides[:, fits].round(PLACES))]
        table = BEYOND.copy()
        table[:, : len(kept)] = sides[:, kept]
        return Shapes(len(kept), table, kept, grid, parts)


def _unbeaten(sides: Floats) -> Ways:
    """Choose the sizes that no other beats both ways; of too many those that lie evenly among them."""
    order = np.lexsort(sides[::-1])
    high = sides[1, order]
    lower = np.ones(len(high), bool)
    lower[1:] = high[1:] < np.minimum.accumulate(high)[:-1]
    order = order[lower]
    return order[_evenly(len(order))] if len(order) > KEPT else order


@cache
def _evenly(count: int) -> Ways:
    return np.linspace(0, count - 1, KEPT).round().astype(int)


class Slices(NamedTuple):
    """The shapes of a run, and the numbers of its units."""

    shapes: Shapes
    units: Sequence[int]

    @property
    def sizes(self) -> Floats:
        """The sizes (n, 2) mm that it may have."""
        return self.shapes.sizes

    def tree(self, choice: int) -> Tree:
        """Give how the run is cut where it has one of its sizes."""
        return self.shapes.tree(choice, self.units)


class Slicing:
    """The sizes of all runs of units that fit into a room, and of those that make a sheet, with its corner."""

    def __init__(
        self,
        units: Sequence[Sequence[Size]],
        cuts: Cuts,
        corner: Size = (0.0, 0.0),
        opening: Sequence[Sequence[Size]] | None = None,
    ) -> None:
        self._cuts, self._corner = cuts, cuts.number([corner])
        self._units = tuple(map(cuts.number, units))
        self._opening = self._units if opening is None else tuple(map(cuts.number, opening))

    def run(self, i: int, j: int) -> Slices:
        """Give the sizes of the run from one unit to another."""
        return Slices(self._cuts.run(self._units[i : j + 1]), range(i, j + 1))

    def sheet(self, i: int, j: int) -> Slices:
        """Give the sizes of the sheet of the run from one unit to another; its corner is numbered behind all units."""
        shown = (self._opening[i], *self._units[i + 1 : j + 1], self._corner)
        return Slices(self._cuts.run(shown), (*range(i, j + 1), len(self._units)))
