"""Slicing of a sheet: units in their order, beside or above each other, in all sizes that they can take (разбивка).

A run of units is one unit, or two runs side by side, or one above the other. Of every run those sizes are kept that no
other beats both ways (Stockmeyer's shape functions). A run that closes a sheet ends with its corner, the title block.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from plans.model.motion import Floats

GAP = 5.0  # mm between two units; the margins of figures keep letters apart already
KEPT = 12  # sizes kept of a run
SAME = 1e-9  # mm: sizes are sums of the same units in another order

Size: TypeAlias = tuple[float, float]


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
    """The sizes (n, 2) mm that a run may have, and of each where the run is cut, which way, and both parts' sizes."""

    sizes: Floats
    ways: npt.NDArray[np.intp]  # (n, 4)


class Slicing:
    """The sizes of all runs of units that fit into a room, alone or closed by the corner of the sheet."""

    def __init__(self, units: Sequence[Sequence[Size]], room: Size, corner: Size | None = None) -> None:
        self.count, self.room = len(units), np.add(room, SAME)
        self._runs = {(k, k): self._own(k, own) for k, own in enumerate(units)}
        self._closed = dict[tuple[int, int], Shapes]()
        if corner is not None:
            own = self._own(self.count, [corner])
            self._closed = {(k + 1, k): own for k in range(-1, self.count)}

    def run(self, i: int, j: int) -> Shapes:
        """Give the sizes of the run from one unit to another."""
        if (i, j) not in self._runs:
            self._runs[i, j] = self._join([(self.run(i, k), self.run(k + 1, j), k) for k in range(i, j)])
        return self._runs[i, j]

    def closed(self, i: int, j: int) -> Shapes:
        """Give the sizes of the run from one unit to another and the corner behind it."""
        if (i, j) not in self._closed:
            self._closed[i, j] = self._join([(self.run(i, k), self.closed(k + 1, j), k) for k in range(i, j + 1)])
        return self._closed[i, j]

    def tree(self, i: int, j: int, choice: int, closed: bool = False) -> Tree:
        """Give how a run is cut where it has one of its sizes."""
        if i > j:
            return Piece(self.count, 0)
        at, beside, first, second = map(int, (self.closed if closed else self.run)(i, j).ways[choice])
        if not closed and i == j:
            return Piece(i, first)
        return Cut(bool(beside), self.tree(i, at, first), self.tree(at + 1, j, second, closed))

    def _own(self, k: int, sizes: Sequence[Size]) -> Shapes:
        ways = np.array([(k, 0, choice, 0) for choice in range(len(sizes))], int).reshape(-1, 4)
        return self._kept(np.array(sizes, float).reshape(-1, 2), ways)

    def _join(self, parts: Sequence[tuple[Shapes, Shapes, int]]) -> Shapes:
        """Join the sizes of both parts of a run, wherever it can be cut, both ways."""
        joined = [self._pairs(*part) for part in parts if len(part[0].sizes) and len(part[1].sizes)]
        if not joined:
            return Shapes(np.empty((0, 2)), np.empty((0, 4), int))
        sizes, ways = zip(*joined, strict=True)
        return self._kept(np.concatenate(sizes), np.concatenate(ways))

    def _pairs(self, first: Shapes, second: Shapes, at: int) -> tuple[Floats, npt.NDArray[np.intp]]:
        own, other = first.sizes[:, None], second.sizes[None, :]
        over, most = own + other + GAP, np.maximum(own, other)
        every = np.empty((2, *over.shape))  # stacked, beside
        every[0, ..., 0], every[0, ..., 1] = most[..., 0], over[..., 1]
        every[1, ..., 0], every[1, ..., 1] = over[..., 0], most[..., 1]
        fits = np.argwhere((every <= self.room).all(-1))
        ways = np.column_stack([np.full(len(fits), at), fits])
        return every[fits[:, 0], fits[:, 1], fits[:, 2]], ways

    def _kept(self, sizes: Floats, ways: npt.NDArray[np.intp]) -> Shapes:
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
        return Shapes(sizes[order], ways[order])
