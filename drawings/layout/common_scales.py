"""The scales that figures may have; figures of one key share one, grow while all still fits (общие масштабы)."""

from __future__ import annotations

import heapq
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

from drawings.layout.contents import Panel
from drawings.layout.picture import SMALLER, Picture, Rung
from drawings.layout.room import Stock
from drawings.layout.slicing import SAME, Piece, Size, Tree, pieces
from drawings.layout.standing import natural
from drawings.page.scale import Scale
from drawings.paper.ties import tied

State: TypeAlias = tuple[int, ...]  # the step of each group of figures that share a scale

READ = 0.5  # share of the figures of one key that can be read at any scale that they share


class Steps(NamedTuple):
    """What figures of one scale may be enlarged to, from the smallest on: a rung of each figure, by its name.

    `sizes` tells how large they are at each step: the larger sides of their lines over their weight, mm.
    """

    rungs: tuple[Mapping[str, Rung], ...]
    sizes: tuple[float, ...]

    def at(self, level: float) -> int:
        """Give the last step that is no larger than a level, mm, or else the first."""
        return max(sum(size <= level for size in self.sizes) - 1, 0)


class _Figure(NamedTuple):
    """A picture with its scales, the smallest picture first."""

    picture: Picture
    weight: float
    rungs: tuple[Rung, ...]

    @property
    def read(self) -> tuple[Rung, ...]:
        """The scales at which it can be read."""
        return tuple(rung for rung in self.rungs if can_be_read(self.picture, rung))

    def at(self, scale: Scale) -> Rung:
        """Give its rung at a scale."""
        return Rung(scale, *self.picture.size(scale), self.picture.extent(scale))

    def legible(self, scale: Scale) -> Rung:
        """Give its rung at a scale; where it cannot be read there, at the next scale at which it can."""
        own = self.at(scale)
        if can_be_read(self.picture, own) or not self.rungs:
            return own
        return next(iter(self.read), self.rungs[-1])


def can_be_read(picture: Picture, rung: Rung) -> bool:
    """Tell whether a picture is large enough for its letters; a point needs no size."""
    return rung.extent == 0 or rung.extent >= picture.least * SMALLER


def steps_of(panels: Sequence[Panel], room: tuple[float, float], standard: str, legible: bool) -> tuple[Steps, ...]:
    """Give the steps of all figures that fit a room, the legible ones alone or all: those of one key together."""
    keyed: dict[tuple[str, int], list[_Figure]] = {}
    for k, panel in enumerate(panels):
        if isinstance(panel.item, Picture):
            rungs = panel.item.ladder(*room, standard).rungs[::-1]
            key = (panel.scale, 0 if panel.scale else k)
            keyed.setdefault(key, []).append(_Figure(panel.item, panel.weight, rungs))
    return tuple(_steps(own, legible) for own in keyed.values())


def _steps(figures: Sequence[_Figure], legible: bool) -> Steps:
    """Enlarge figures together, as far as the one that needs most paper fits."""
    sized = [one for one in figures if max(one.picture.wide, one.picture.high)] or figures  # a point has any scale
    largest = max(sized, key=lambda one: one.rungs[-1].scale.mu if one.rungs else math.inf)
    scales = [rung.scale for rung in largest.rungs]
    every = [
        {one.picture.name: one.legible(scale) if legible else one.at(scale) for one in figures} for scale in scales
    ]
    shares = [_mean([can_be_read(one.picture, one.at(scale)) for one in figures]) for scale in scales]
    least = min(READ, max(shares, default=READ)) or READ if legible else 0.0  # of one that is never legible no step
    kept = [step for step, share in zip(every, shares, strict=True) if share >= least]
    return Steps(tuple(kept), tuple(tied(_mean([*_sizes(figures, step)])) for step in kept))


def _mean(values: Sequence[float]) -> float:
    return math.fsum(values) / len(values)


def _sizes(figures: Sequence[_Figure], step: Mapping[str, Rung]) -> Iterator[float]:
    """Give the sizes of figures over their weights; a point is as large as it can be."""
    for one in figures:
        extent = step[one.picture.name].extent
        yield extent / one.weight if extent else math.inf


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
