"""Slicing of a sheet: units in their order, beside or above each other, in all sizes that they can take (разбивка).

A run of units is one unit, or two runs side by side, or one above the other. Of every run those sizes are kept that no
other beats both ways (Stockmeyer's shape functions). A run that closes a sheet ends with its corner, the title block.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from plans.model.motion import Floats

GAP = 5.0  # mm between two units; the margins of figures keep letters apart already
KEPT = 12  # sizes kept of a run
SAME = 1e-9  # mm: sizes are sums of the same units in another order

Size: TypeAlias = tuple[float, float]
Ways: TypeAlias = npt.NDArray[np.intp]  # (n, 4)


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

    `parts` are the shapes of both parts, by where the run is cut; a single unit has none.
    """

    sizes: Floats
    ways: Ways
    parts: Mapping[int, tuple[Shapes, Shapes]]

    def tree(self, choice: int) -> Tree:
        """Give how the run is cut where it has one of its sizes."""
        at, beside, first, second = map(int, self.ways[choice])
        if not self.parts:
            return Piece(at, first)
        parts = self.parts[at]
        return Cut(bool(beside), parts[0].tree(first), parts[1].tree(second))


class Slicing:
    """The sizes of all runs of units that fit into a room, and of those that make a sheet.

    A sheet is closed by its corner, and a unit that opens it may have other sizes than amid the others.
    """

    def __init__(
        self,
        units: Sequence[Sequence[Size]],
        room: Size,
        corner: Size = (0.0, 0.0),
        opening: Sequence[Sequence[Size]] | None = None,
    ) -> None:
        self.room = np.add(room, SAME)
        last = self._own(len(units), [corner])
        self._runs = {(k, k): self._own(k, own) for k, own in enumerate(units)}
        self._opened = {(k, k): self._own(k, own) for k, own in enumerate(opening or units)}
        self._closed = {(k + 1, k): last for k in range(len(units))}
        self._sheets = dict[tuple[int, int], Shapes]()

    def run(self, i: int, j: int) -> Shapes:
        """Give the sizes of the run from one unit to another."""
        if (i, j) not in self._runs:
            self._runs[i, j] = self._join([(self.run(i, k), self.run(k + 1, j), k) for k in range(i, j)])
        return self._runs[i, j]

    def opened(self, i: int, j: int) -> Shapes:
        """Give the sizes of a run that begins a sheet."""
        if (i, j) not in self._opened:
            self._opened[i, j] = self._join([(self.opened(i, k), self.run(k + 1, j), k) for k in range(i, j)])
        return self._opened[i, j]

    def closed(self, i: int, j: int) -> Shapes:
        """Give the sizes of a run that ends a sheet, the corner behind it; of no unit at all it is the corner."""
        if (i, j) not in self._closed:
            self._closed[i, j] = self._join([(self.run(i, k), self.closed(k + 1, j), k) for k in range(i, j + 1)])
        return self._closed[i, j]

    def sheet(self, i: int, j: int) -> Shapes:
        """Give the sizes of the sheet of the run from one unit to another."""
        if (i, j) not in self._sheets:
            self._sheets[i, j] = self._join([(self.opened(i, k), self.closed(k + 1, j), k) for k in range(i, j + 1)])
        return self._sheets[i, j]

    def _own(self, k: int, sizes: Sequence[Size]) -> Shapes:
        ways = np.array([(k, 0, choice, 0) for choice in range(len(sizes))], int).reshape(-1, 4)
        return self._kept(np.array(sizes, float).reshape(-1, 2), ways, {})

    def _join(self, cuts: Sequence[tuple[Shapes, Shapes, int]]) -> Shapes:
        """Join the sizes of both parts of a run, wherever it can be cut, both ways."""
        parts = {at: (first, second) for first, second, at in cuts if len(first.sizes) and len(second.sizes)}
        joined = [self._pairs(*pair, at) for at, pair in parts.items()]
        if not joined:
            return Shapes(np.empty((0, 2)), np.empty((0, 4), int), {})
        sizes, ways = zip(*joined, strict=True)
        return self._kept(np.concatenate(sizes), np.concatenate(ways), parts)

    def _pairs(self, first: Shapes, second: Shapes, at: int) -> tuple[Floats, Ways]:
        own, other = first.sizes[:, None], second.sizes[None, :]
        over, most = own + other + GAP, np.maximum(own, other)
        every = np.empty((2, *over.shape))  # stacked, beside
        every[0, ..., 0], every[0, ..., 1] = most[..., 0], over[..., 1]
        every[1, ..., 0], every[1, ..., 1] = over[..., 0], most[..., 1]
        fits = np.argwhere((every <= self.room).all(-1))
        ways = np.column_stack([np.full(len(fits), at), fits])
        return every[fits[:, 0], fits[:, 1], fits[:, 2]], ways

    def _kept(self, sizes: Floats, ways: Ways, parts: Mapping[int, tuple[Shapes, Shapes]]) -> Shapes:
        """Keep the sizes that no other beats both ways; of too many those that lie evenly among them."""
        fits = (sizes <= self.room).all(-1)
        sizes, ways = sizes[fits], ways[fits]
        order = np.lexsort((sizes[:, 1], sizes[:, 0]))
        high = sizes[order, 1]
        lower = np.ones(len(high), bool)
        lower[1:] = high[1:] < np.minimum.accumulate(high)[:-1] - SAME
        order = order[lower]
        if len(order) > KEPT:
            order = order[np.linspace(0, len(order) - 1, KEPT).round().astype(int)]
        return Shapes(sizes[order], ways[order], parts)
