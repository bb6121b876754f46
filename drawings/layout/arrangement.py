"""Arrangement: what stands on a sheet is moved a little where paper would stay bare, lettering broken anew (сдвиг).

Cells share their spare paper evenly, which leaves a strip all along narrow figures that stand one above another.
"""

import heapq
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, reduce
from itertools import combinations, product
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from drawings.layout.contents import Panel
from drawings.layout.picture import SMALLER, Picture, Rung
from drawings.layout.room import Stock
from drawings.layout.slicing import GAP, SAME, Size, Tree, pieces
from drawings.layout.standing import Area, Grid, natural
from drawings.page.page import Field, Page, Scale
from drawings.paper.walk import PLACES, tied
from plans.model.motion import Floats

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


class _Scaled(NamedTuple):
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
        rung = self.at(scale)
        if can_be_read(self.picture, rung) or not self.rungs:
            return rung
        return next(iter(self.read), self.rungs[-1])


def can_be_read(picture: Picture, rung: Rung) -> bool:
    """Tell whether a picture is large enough for its letters; a point needs no size."""
    return rung.extent == 0 or rung.extent >= picture.least * SMALLER


def steps_of(panels: Sequence[Panel], room: tuple[float, float], standard: str, legible: bool) -> tuple[Steps, ...]:
    """Give the steps of all figures that fit a room, the legible ones alone or all: those of one key together."""
    keyed: dict[tuple[str, int], list[_Scaled]] = {}
    for k, panel in enumerate(panels):
        if isinstance(panel.item, Picture):
            rungs = panel.item.rungs(*room, standard)[::-1]
            key = (panel.scale, 0 if panel.scale else k)
            keyed.setdefault(key, []).append(_Scaled(panel.item, panel.weight, rungs))
    return tuple(_steps(figures, legible) for figures in keyed.values())


def _steps(figures: Sequence[_Scaled], legible: bool) -> Steps:
    """Enlarge figures together, as far as the one that needs most paper fits."""
    sized = [item for item in figures if max(item.picture.wide, item.picture.high)] or figures  # a point has any scale
    largest = max(sized, key=lambda figure: figure.rungs[-1].scale.mu if figure.rungs else math.inf)
    scales = [rung.scale for rung in largest.rungs]
    every = [
        {item.picture.name: item.legible(scale) if legible else item.at(scale) for item in figures} for scale in scales
    ]
    shares = [_mean([can_be_read(figure.picture, figure.at(scale)) for figure in figures]) for scale in scales]
    least = min(READ, max(shares, default=READ)) or READ if legible else 0.0  # of one that is never legible no step
    kept = [step for step, share in zip(every, shares, strict=True) if share >= least]
    return Steps(tuple(kept), tuple(tied(_mean([*_sizes(figures, step)])) for step in kept))


def _mean(values: Sequence[float]) -> float:
    return math.fsum(values) / len(values)


def _sizes(figures: Sequence[_Scaled], step: Mapping[str, Rung]) -> Iterator[float]:
    """Give the sizes of figures over their weights; a point is as large as it can be."""
    for figure in figures:
        extent = step[figure.picture.name].extent
        yield extent / figure.weight if extent else math.inf


def rungs_of(steps: Sequence[Steps], state: State) -> dict[str, Rung]:
    """Give the scales of all pictures, by their names."""
    return {name: rung for step, k in zip(steps, state, strict=True) for name, rung in step.rungs[k].items()}


def sizes_of(stock: Stock, tree: Tree, rungs: Mapping[str, Rung], ends: Mapping[int, Size]) -> dict[int, Size]:
    """Give the sizes mm of all that stands on a sheet; those of what stands in its corners are known."""
    return {unit: ends[unit] if unit in ends else stock.sizes(unit, rungs)[way] for unit, way in pieces(tree)}


@dataclass(eq=False, repr=False)
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
            (step.sizes[now[v]], v)
            for v, step in enumerate(self.steps)
            if (step.rungs[0].keys() <= every if only else step.rungs[0].keys() & every)
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
                resized = {**sizes[k], **self._changed(sizes[k], rungs)}
                wide, high = natural(tree, resized)
                if wide > self.stock.room[0] + SAME or high > self.stock.room[1] + SAME:
                    return False
                changed[k] = resized
        for k, resized in changed.items():
            sizes[k] = resized
        now[v] += 1
        return True

    def _changed(self, sizes: Mapping[int, Size], rungs: Mapping[str, Rung]) -> dict[int, Size]:
        """Give the new sizes of the figures that are drawn at other scales."""
        found: dict[int, Size] = {}
        for k in sizes:
            shown = None if k in self.ends else self.stock.shown[k]
            if isinstance(shown, Picture) and shown.name in rungs:
                found[k] = rungs[shown.name].wide, rungs[shown.name].high
        return found

    def _names(self, tree: Tree) -> set[str]:
        shown = (self.stock.shown[piece.unit] for piece in pieces(tree) if piece.unit not in self.ends)
        return {item.name for item in shown if isinstance(item, Picture)}


REACH = 6  # steps that a thing is moved at most at once
STEP = 1 / 36  # of the longer side of the field: 8 to 23 mm
ROUNDS = 3
FEW = 4  # other sizes of lettering that are tried where two things are moved at once
FAR = 3e-3  # share of the sheet that must become less bare for a move by a step
KNOWN = 12  # bare rectangles that are kept in mind
Boxes: TypeAlias = Mapping[int, Field]
Truths: TypeAlias = npt.NDArray[np.bool_]
Cells: TypeAlias = npt.NDArray[np.intp]
SHIFTS = np.array([*product(range(-REACH, REACH + 1), repeat=2)])
COARSE = SHIFTS[(SHIFTS % 2 == 0).all(-1)]


class _Stands(NamedTuple):
    """The boxes (n, 4) mm that a thing may have, what cells (n, m, 4) it inks there, what it costs to move it (n,)."""

    boxes: Floats
    inked: Cells
    far: Floats

    def box(self, n: int) -> Field:
        """Give one of the boxes."""
        return Field(*self.boxes[n].tolist())

    def areas(self, n: int) -> Iterator[Area]:
        """Give what it inks in one of them."""
        return (Area(*edges) for edges in self.inked[n].tolist())

    def reach(self, area: Area) -> Truths:
        """Tell in which of them it inks some of an area."""
        left, bottom, right, top = np.moveaxis(self.inked, -1, 0)
        met = (left < area.right) & (area.left < right) & (bottom < area.top) & (area.bottom < top)
        return np.asarray(met.any(-1))


@dataclass(frozen=True, eq=False, repr=False)
class Arrangement:
    """How things may be moved in the room of a page, and how bare it may be.

    `inked` gives what of the box of a thing bears ink, `sizes` what other sizes it may have, mm.
    """

    page: Page
    room: Field
    most: float
    inked: Callable[[int, Field], Iterable[Field]]
    sizes: Callable[[int], Sequence[Size]]
    _bare: list[Area] = field(default_factory=list)  # rectangles that were the barest of some ways, the last one first

    def arranged(self, boxes: Boxes) -> Boxes:
        """Move one thing after another, then two at once, to where they leave the least paper bare."""
        for _ in range(ROUNDS):
            before = boxes
            for some in (*((k,) for k in boxes), *combinations(boxes, 2)):
                if self._share(boxes) <= self.most:
                    return boxes
                boxes = self._moved(some, boxes)
            if boxes == before:
                break
        return boxes

    @cached_property
    def _grid(self) -> Grid:
        return Grid(self.page.field)

    @cached_property
    def _step(self) -> float:
        return STEP * max(self.page.field.width, self.page.field.height)

    @cached_property
    def _taken(self) -> tuple[Field, ...]:
        return self.page.taken

    def _share(self, boxes: Boxes) -> float:
        return self._grid.share(self._grid.barest(self._areas(boxes)))

    def _areas(self, boxes: Boxes) -> list[Area]:
        inked = [ink for k, box in boxes.items() for ink in self.inked(k, box)]
        return [self._grid.area(field) for field in (*self._taken, *inked)]

    def _moved(self, some: tuple[int, ...], boxes: Boxes) -> Boxes:
        """Move some things, if that is worth the way: that way is weighed next which may be the best one."""
        others = {k: box for k, box in boxes.items() if k not in some}
        still, least = self._areas(others), max(self._share(boxes), self.most)
        stands = [self._stands(k, boxes[k], [*others.values()], FEW * (len(some) - 1)) for k in some]
        far = reduce(np.add.outer, [stand.far for stand in stands])
        bound, best = np.where(_meeting(stands), math.inf, self.most + far), {**boxes}
        for bare in self._bare:
            if not any(map(bare.meets, still)):
                self._raise(bound, far, bare, stands)
        while bound.size and bound.min() < least:
            way = np.unravel_index(bound.argmin(), bound.shape)
            pairs = list(zip(stands, way, strict=True))
            bare = self._grid.barest([*still, *(area for stand, n in pairs for area in stand.areas(int(n)))])
            self._bare[:] = [bare, *self._bare[: KNOWN - 1]]
            self._raise(bound, far, bare, stands)
            if bound[way] < least:
                moved = {k: stand.box(int(n)) for k, (stand, n) in zip(some, pairs, strict=True)}
                best, least = {**boxes, **moved}, float(bound[way])
            bound[way] = math.inf
        return best

    def _raise(self, bound: Floats, far: Floats, bare: Area, stands: Sequence[_Stands]) -> None:
        """Raise what all ways cost at least that leave a rectangle bare."""
        met = reduce(np.logical_or.outer, [stand.reach(bare) for stand in stands])
        np.maximum(bound, self._grid.share(bare) + far, out=bound, where=~met)

    def _stands(self, k: int, field: Field, others: Sequence[Field], few: int) -> _Stands:
        """Give the boxes that a thing may have beside all others, in its size or in others; in few of these, if any."""
        sizes = self.sizes(k)
        anew = sizes[:: math.ceil(len(sizes) / few) or 1] if few else sizes
        ways = [((field.width, field.height), SHIFTS), *((size, COARSE if few else SHIFTS) for size in anew)]
        found = [self._sized(k, field, size, shifts, others) for size, shifts in ways]
        return _Stands(*map(np.concatenate, zip(*found, strict=True)))

    def _sized(self, k: int, field: Field, size: Size, shifts: Cells, others: Sequence[Field]) -> _Stands:
        """Give the boxes of one size; what stands in the corners is kept clear of by ink, a heading in the middle."""
        wide, high = size
        corners: Floats = np.tile((field.left, field.top), 2) + np.tile(shifts, 2) * self._step
        box = Field(0.0, -high, wide, 0.0)
        boxes: Floats = corners + np.array(box)
        areas: Floats = np.array([*self.inked(k, box)], dtype=float).reshape(-1, 4)  # none of notes without lines
        inked: Floats = corners[:, None] + areas
        free = clear(boxes, (*others, self.page.block), self.room)
        for place in self._taken:
            free &= ~_meet(inked, place).any(-1)
        return _Stands(boxes[free], self._grid.cells(inked[free]), (FAR * np.hypot(*shifts[free].T)).round(PLACES))


def _meeting(stands: Sequence[_Stands]) -> Truths | bool:
    """Tell which ways of two things to stand are too near each other."""
    if len(stands) == 1:
        return False
    stand, other = stands
    return _meet(stand.boxes[:, None], np.moveaxis(other.boxes, -1, 0))


def clear(boxes: Floats, others: Iterable[Field], room: Field) -> Truths:
    """Tell which boxes are in a room and as far from all others as things on a sheet are."""
    left, bottom, right, top = np.moveaxis(boxes, -1, 0)
    free = (left >= room.left - SAME) & (right <= room.right + SAME)
    free &= (bottom >= room.bottom - SAME) & (top <= room.top + SAME)
    for other in others:
        free &= ~_meet(boxes, other)
    return np.asarray(free)


def _meet(boxes: Floats, other: Field | Floats) -> Truths:
    """Tell which boxes stand nearer to others than things on a sheet do."""
    (left, bottom, right, top), near = np.moveaxis(boxes, -1, 0), GAP - SAME
    across = (left < other[2] + near) & (other[0] < right + near)
    return np.asarray(across & (bottom < other[3] + near) & (other[1] < top + near))
