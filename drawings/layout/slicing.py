"""Slicing of a sheet: units in their order, beside or above each other, in all sizes that they can take (разбивка).

A run of units is one unit, or two runs side by side, or one above the other. Of every run those sizes are kept that no
other beats both ways (Stockmeyer's shape functions). A run that closes a sheet ends with its corner, the title block.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from drawings.paper.ties import PLACES
from plans.model.motion import Floats

GAP = 5.0  # mm between two units; the margins of figures keep letters apart already
KEPT = 12  # sizes kept of a run
SAME = 1e-9  # mm: sizes are sums of the same units in another order

Size: TypeAlias = tuple[float, float]
Ways: TypeAlias = npt.NDArray[np.intp]  # (n, 4), or (n,)


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
    """The sizes (n, 2) mm that a run may have, and of each where the run is cut, which way, and both parts' sizes.

    `parts` are the shapes of both parts, by how many units stand before the cut; a single unit has none.
    """

    sizes: Floats
    ways: Ways
    parts: Mapping[int, tuple[Shapes, Shapes]]

    def tree(self, choice: int, units: Sequence[int]) -> Tree:
        """Give how a run of some units is cut where it has one of its sizes."""
        at, beside, first, second = map(int, self.ways[choice])
        if not self.parts:
            return Piece(units[0], first)
        parts = self.parts[at]
        return Cut(bool(beside), parts[0].tree(first, units[:at]), parts[1].tree(second, units[at:]))


NONE = Shapes(np.empty((0, 2)), np.empty((0, 4), int), {})


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
        own = tuple(sizes)
        if own not in self._numbers:
            k = self._numbers[own] = len(self._numbers)
            self._least.append(min(((wide + GAP) * (high + GAP) for wide, high in own), default=math.inf))
            self._runs[k,] = self._own(own)
        return self._numbers[own]

    def run(self, units: tuple[int, ...]) -> Shapes:
        """Give the sizes of a run of units, by their numbers."""
        if units not in self._runs:
            self._runs[units] = self._join(units)
        return self._runs[units]

    def _own(self, own: Sequence[Size]) -> Shapes:
        sizes = np.array(own, float).reshape(-1, 2)
        kept = self._chosen(sizes)
        ways = np.zeros((len(kept), 4), int)
        ways[:, 2] = kept
        return Shapes(sizes[kept], ways, {})

    def _join(self, units: tuple[int, ...]) -> Shapes:
        """Join the sizes of both parts of a run, wherever it can be cut, both ways."""
        if sum(self._least[k] for k in units) > self._most:
            return NONE
        cuts = {at: (self.run(units[:at]), self.run(units[at:])) for at in range(1, len(units))}
        parts = {at: pair for at, pair in cuts.items() if all(len(part.sizes) for part in pair)}
        if not parts:
            return NONE
        first, second = (_alike([pair[k].sizes for pair in parts.values()]) for k in (0, 1))
        sizes = _joined(first[:, :, None], second[:, None])
        kept = self._chosen(sizes.reshape(-1, 2))
        if not kept.size:
            return NONE
        at, *rest = np.unravel_index(kept, sizes.shape[:-1])
        ways = np.stack([np.array(list(parts))[at], *rest], axis=-1)
        return Shapes(sizes.reshape(-1, 2)[kept], ways, parts)

    def _chosen(self, sizes: Floats) -> Ways:
        """Choose among sizes (n, 2) those of a run: of what fits into the room."""
        fits = np.flatnonzero((sizes[:, 0] <= self._wide) & (sizes[:, 1] <= self._high))
        return fits[_kept(sizes[fits])] if fits.size > 1 else fits


def _alike(sizes: Sequence[Floats]) -> Floats:
    """Put the sizes (n, 2) of several runs into one table (run, most n, 2); what is missing fits nowhere."""
    table = np.full((len(sizes), max(map(len, sizes)), 2), math.inf)
    for row, own in zip(table, sizes, strict=True):
        row[: len(own)] = own
    return table


def _joined(first: Floats, second: Floats) -> Floats:
    """Join sizes (cut, n, 1, 2) and (cut, 1, m, 2), one above the other and beside: (cut, 2, n, m, 2)."""
    over, most = first + second + GAP, np.maximum(first, second)
    sizes = np.empty((len(over), 2, *over.shape[1:]))
    sizes[:, 0, ..., 0], sizes[:, 0, ..., 1] = most[..., 0], over[..., 1]
    sizes[:, 1, ..., 0], sizes[:, 1, ..., 1] = over[..., 0], most[..., 1]
    return sizes


def _kept(sizes: Floats) -> Ways:
    """Choose the sizes that no other beats both ways; of too many those that lie evenly among them."""
    sizes = sizes.round(PLACES)
    order = np.lexsort((sizes[:, 1], sizes[:, 0]))
    high = sizes[order, 1]
    lower = np.ones(len(high), bool)
    lower[1:] = high[1:] < np.minimum.accumulate(high)[:-1]
    order = order[lower]
    return order[np.linspace(0, len(order) - 1, KEPT).round().astype(int)] if len(order) > KEPT else order


class Run(NamedTuple):
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
    """The sizes of all runs of units that fit into a room, and of those that make a sheet.

    A sheet is closed by its corner, and a unit that opens it may have other sizes than amid the others.
    """

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

    def run(self, i: int, j: int) -> Run:
        """Give the sizes of the run from one unit to another."""
        return Run(self._cuts.run(self._units[i : j + 1]), range(i, j + 1))

    def sheet(self, i: int, j: int) -> Run:
        """Give the sizes of the sheet of the run from one unit to another; its corner is numbered behind all units."""
        shown = (self._opening[i], *self._units[i + 1 : j + 1], self._corner)
        return Run(self._cuts.run(shown), (*range(i, j + 1), len(self._units)))
