"""Arrangement: what stands on a sheet is moved a little where paper would stay bare, lettering broken anew (сдвиг).

Cells share their spare paper evenly, which leaves a strip all along narrow figures that stand one above another.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from typing import TypeAlias

from drawings.layout.bareness import bareness
from drawings.layout.slicing import GAP, SAME, Size
from drawings.page.page import Field, Page

REACH = 60  # mm that a thing is moved at most at once
STEP = 10  # mm
ROUNDS = 3
FAR = 3e-4  # share of the sheet that must become less bare for a move by a millimetre
SHIFTS = tuple(product(range(-REACH, REACH + 1, STEP), repeat=2))

Boxes: TypeAlias = Mapping[int, Field]


@dataclass(frozen=True)
class Arrangement:
    """How things may be moved in the room of a page, and how bare it may be.

    `inked` gives what of the box of a thing bears ink, `sizes` what other sizes it may have, mm.
    """

    page: Page
    room: Field
    most: float
    inked: Callable[[int, Field], Iterable[Field]]
    sizes: Callable[[int], Iterable[Size]]

    def arranged(self, boxes: Boxes) -> Boxes:
        """Move one thing after another to where it leaves the least paper bare, until it is little enough."""
        for _ in range(ROUNDS):
            before = boxes
            for k in boxes:
                boxes = self._moved(k, boxes)
            if boxes == before:
                break
        return boxes

    def _moved(self, k: int, boxes: Boxes) -> Boxes:
        """Move a thing, if that is worth the way."""
        ink = [field for other, box in boxes.items() if other != k for field in self.inked(other, box)]

        def cost(box: Field) -> float:
            bare = bareness([*ink, *self.inked(k, box), *self.page.taken], self.page.field)
            return max(bare, self.most) + FAR * abs(_corner(box) - _corner(boxes[k]))

        here = cost(boxes[k])
        if here <= self.most:
            return boxes
        best = min(self._places(k, boxes), key=cost, default=boxes[k])
        return {**boxes, k: best} if cost(best) < here else boxes

    def _places(self, k: int, boxes: Boxes) -> Iterator[Field]:
        """Give the boxes that a thing may have beside all others."""
        own = boxes[k]
        others = [*(box for other, box in boxes.items() if other != k), self.page.block]
        for (wide, high), (right, up) in product([(own.width, own.height), *self.sizes(k)], SHIFTS):
            left, top = own.left + right, own.top + up
            box = Field(left, top - high, left + wide, top)
            free = _within(box, self.room) and not any(_meet(box, other) for other in others)
            if free and self._clear(k, box):
                yield box

    def _clear(self, k: int, box: Field) -> bool:
        """Tell whether a thing keeps clear of what stands in the corners: a heading in the middle of its box may."""
        return not any(_meet(ink, place) for ink in self.inked(k, box) for place in self.page.taken)


def _corner(box: Field) -> complex:
    return complex(box.left, box.top)


def _within(box: Field, room: Field) -> bool:
    return (
        box.left >= room.left - SAME
        and box.right <= room.right + SAME
        and box.bottom >= room.bottom - SAME
        and box.top <= room.top + SAME
    )


def _meet(box: Field, other: Field) -> bool:
    """Tell whether two boxes stand nearer than things on a sheet do."""
    near = GAP - SAME
    across = box.left < other.right + near and other.left < box.right + near
    return across and box.bottom < other.top + near and other.bottom < box.top + near
