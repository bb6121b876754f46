"""Growth: in sheets that are cut already the smallest figures are enlarged while all still fits (увеличение фигур)."""

from __future__ import annotations

import heapq
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from drawings.layout.common_scales import Steps
from drawings.layout.picture import Picture, Rung
from drawings.layout.slicing import SAME, Piece, Size, Tree, pieces
from drawings.layout.standing import natural
from drawings.layout.units import Stock

State: TypeAlias = tuple[int, ...]  # the step of each group of figures that share a scale


def rungs_of(steps: Sequence[Steps], state: State) -> dict[str, Rung]:
    """Give the scales of all pictures, by their names."""
    return {name: rung for own, k in zip(steps, state, strict=True) for name, rung in own.rungs[k].items()}


def sizes_of(stock: Stock, tree: Tree, rungs: Mapping[str, Rung], ends: Mapping[int, Size]) -> dict[int, Size]:
    """Give the sizes mm of all that stands on a sheet; those of what stands in its corners are known."""
    return {piece.unit: _size(stock, piece, rungs, ends) for piece in pieces(tree)}


def _size(stock: Stock, piece: Piece, rungs: Mapping[str, Rung], ends: Mapping[int, Size]) -> Size:
    return ends[piece.unit] if piece.unit in ends else stock.sizes(piece.unit, rungs)[piece.choice]


@dataclass
class Growth:
    """The sheets of a set while their figures grow."""

    stock: Stock
    ends: Mapping[int, Size]
    steps: Sequence[Steps]
    trees: Sequence[Tree]

    def grown(self, state: State, only: bool = False) -> State:
        """Enlarge the smallest figures first; `only` those that stand on no other sheet."""
        rungs = rungs_of(self.steps, state)
        sizes = [sizes_of(self.stock, tree, rungs, self.ends) for tree in self.trees]
        names = [self._names(tree) for tree in self.trees]
        every = set[str]().union(*names)
        now = list(state)
        growing = [
            (own.sizes[now[v]], v)
            for v, own in enumerate(self.steps)
            if (own.rungs[0].keys() <= every if only else own.rungs[0].keys() & every)
        ]
        heapq.heapify(growing)
        while growing:
            _, v = growing[0]
            if self._enlarged(v, now, sizes, names):
                heapq.heapreplace(growing, (self.steps[v].sizes[now[v]], v))
            else:
                heapq.heappop(growing)
        return tuple(now)

    def _enlarged(self, v: int, now: list[int], sizes: list[dict[int, Size]], names: list[set[str]]) -> bool:
        """Draw the figures of one scale a step larger, if all still fits."""
        if now[v] + 1 == len(self.steps[v].rungs):
            return False
        rungs = self.steps[v].rungs[now[v] + 1]
        changed: dict[int, dict[int, Size]] = {}
        for k, tree in enumerate(self.trees):
            if names[k] & rungs.keys():
                own = {**sizes[k], **self._changed(sizes[k], rungs)}
                wide, high = natural(tree, own)
                if wide > self.stock.room[0] + SAME or high > self.stock.room[1] + SAME:
                    return False
                changed[k] = own
        for k, own in changed.items():
            sizes[k] = own
        now[v] += 1
        return True

    def _changed(self, sizes: Mapping[int, Size], rungs: Mapping[str, Rung]) -> dict[int, Size]:
        """Give the new sizes of the figures that are drawn at other scales."""
        found: dict[int, Size] = {}
        for k in sizes:
            one = None if k in self.ends else self.stock.shown[k]
            if isinstance(one, Picture) and one.name in rungs:
                found[k] = rungs[one.name].wide, rungs[one.name].high
        return found

    def _names(self, tree: Tree) -> set[str]:
        shown = (self.stock.shown[piece.unit] for piece in pieces(tree) if piece.unit not in self.ends)
        return {one.name for one in shown if isinstance(one, Picture)}
