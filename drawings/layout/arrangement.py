"""Arrangement: what stands on a sheet is moved a little where paper would stay bare, lettering broken anew (сдвиг).

Cells share their spare paper evenly, which leaves a strip all along narrow figures that stand one above another.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, reduce
from itertools import combinations, product
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from drawings.layout.slicing import GAP, SAME, Size
from drawings.layout.standing import Area, Grid
from drawings.page.page import Field, Page
from drawings.paper.ties import PLACES
from plans.model.motion import Floats

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
        return (Area(*own) for own in self.inked[n].tolist())

    def reach(self, area: Area) -> Truths:
        """Tell in which of them it inks some of an area."""
        left, bottom, right, top = np.moveaxis(self.inked, -1, 0)
        met = (left < area.right) & (area.left < right) & (bottom < area.top) & (area.bottom < top)
        return np.asarray(met.any(-1))


@dataclass(frozen=True)
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

    @cached_property
    def _block(self) -> Field:
        return self.page.block

    def _share(self, boxes: Boxes) -> float:
        return self._grid.share(self._grid.barest(self._areas(boxes)))

    def _areas(self, boxes: Boxes) -> list[Area]:
        inked = [one for k, box in boxes.items() for one in self.inked(k, box)]
        return [self._grid.area(one) for one in (*self._taken, *inked)]

    def _moved(self, some: tuple[int, ...], boxes: Boxes) -> Boxes:
        """Move some things, if that is worth the way: that way is weighed next which may be the best one."""
        others = {k: box for k, box in boxes.items() if k not in some}
        still, least = self._areas(others), max(self._share(boxes), self.most)
        stands = [self._stands(k, boxes[k], [*others.values()], FEW * (len(some) - 1)) for k in some]
        far = reduce(np.add.outer, [one.far for one in stands])
        bound, best = np.where(_meeting(stands), math.inf, self.most + far), {**boxes}
        for bare in self._bare:
            if not any(map(bare.meets, still)):
                self._raise(bound, far, bare, stands)
        while bound.size and bound.min() < least:
            way = np.unravel_index(bound.argmin(), bound.shape)
            pairs = list(zip(stands, way, strict=True))
            bare = self._grid.barest([*still, *(area for one, n in pairs for area in one.areas(int(n)))])
            self._bare[:] = [bare, *self._bare[: KNOWN - 1]]
            self._raise(bound, far, bare, stands)
            if bound[way] < least:
                moved = {k: one.box(int(n)) for k, (one, n) in zip(some, pairs, strict=True)}
                best, least = {**boxes, **moved}, float(bound[way])
            bound[way] = math.inf
        return best

    def _raise(self, bound: Floats, far: Floats, bare: Area, stands: Sequence[_Stands]) -> None:
        """Raise what all ways cost at least that leave a rectangle bare."""
        met = reduce(np.logical_or.outer, [one.reach(bare) for one in stands])
        np.maximum(bound, self._grid.share(bare) + far, out=bound, where=~met)

    def _stands(self, k: int, own: Field, others: Sequence[Field], few: int) -> _Stands:
        """Give the boxes that a thing may have beside all others, in its size or in others; in few of these, if any."""
        sizes = self.sizes(k)
        anew = sizes[:: math.ceil(len(sizes) / few) or 1] if few else sizes
        ways = [((own.width, own.height), SHIFTS), *((size, COARSE if few else SHIFTS) for size in anew)]
        found = [self._sized(k, own, size, shifts, others) for size, shifts in ways]
        return _Stands(*map(np.concatenate, zip(*found, strict=True)))

    def _sized(self, k: int, own: Field, size: Size, shifts: Cells, others: Sequence[Field]) -> _Stands:
        """Give the boxes of one size; what stands in the corners is kept clear of by ink, a heading in the middle."""
        wide, high = size
        corners: Floats = np.tile((own.left, own.top), 2) + np.tile(shifts, 2) * self._step
        box = Field(0.0, -high, wide, 0.0)
        boxes: Floats = corners + np.array(box)
        areas: Floats = np.array([*self.inked(k, box)], dtype=float).reshape(-1, 4)  # none of notes without lines
        inked: Floats = corners[:, None] + areas
        free = _within(boxes, self.room)
        for other in (*others, self._block):
            free &= ~_meet(boxes, other)
        for place in self._taken:
            free &= ~_meet(inked, place).any(-1)
        return _Stands(boxes[free], self._grid.cells(inked[free]), (FAR * np.hypot(*shifts[free].T)).round(PLACES))


def _meeting(stands: Sequence[_Stands]) -> Truths | bool:
    """Tell which ways of two things to stand are too near each other."""
    if len(stands) == 1:
        return False
    one, other = stands
    return _meet(one.boxes[:, None], np.moveaxis(other.boxes, -1, 0))


def _within(boxes: Floats, room: Field) -> Truths:
    left, bottom, right, top = np.moveaxis(boxes, -1, 0)
    across = (left >= room.left - SAME) & (right <= room.right + SAME)
    return np.asarray(across & (bottom >= room.bottom - SAME) & (top <= room.top + SAME))


def _meet(boxes: Floats, other: Field | Floats) -> Truths:
    """Tell which boxes stand nearer to others than things on a sheet do."""
    (left, bottom, right, top), near = np.moveaxis(boxes, -1, 0), GAP - SAME
    across = (left < other[2] + near) & (other[0] < right + near)
    return np.asarray(across & (bottom < other[3] + near) & (other[1] < top + near))
