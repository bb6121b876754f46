"""Arrangement: what stands on a sheet is moved a little where paper would stay bare, lettering broken anew (сдвиг).

Cells share their spare paper evenly, which leaves a strip all along narrow figures that stand one above another.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, product
from typing import TypeAlias

from drawings.layout.bareness import bareness
from drawings.layout.slicing import GAP, SAME, Size
from drawings.page.page import Field, Page

REACH = 60  # mm that a thing is moved at most at once
STEP = 10  # mm
ROUNDS = 3
FAR = 3e-4  # share of the sheet that must become less bare for a move by a millimetre
Boxes: TypeAlias = Mapping[int, Field]
Shifts: TypeAlias = Sequence[tuple[int, int]]
_STEPS = range(-REACH, REACH + 1, STEP)
SHIFTS: Shifts = tuple((right, up) for right in _STEPS for up in _STEPS)
SIDEWAYS: Shifts = tuple((right, up) for right, up in SHIFTS if not up)


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
        """Move one thing after another, then two at once, to where they leave the least paper bare."""
        for _ in range(ROUNDS):
            before = boxes
            for some in (*((k,) for k in boxes), *combinations(boxes, 2)):
                if self._bare(boxes) <= self.most:
                    return boxes
                boxes = self._moved(some, boxes)
            if boxes == before:
                break
        return boxes

    def _moved(self, some: tuple[int, ...], boxes: Boxes) -> Boxes:
        """Move some things, if that is worth the way: one anywhere, two to their sides."""
        others = [box for k, box in boxes.items() if k not in some]
        shifts, anew = (SHIFTS, True) if len(some) == 1 else (SIDEWAYS, False)
        places = [list(self._places(k, boxes[k], others, shifts, anew)) for k in some]
        ways = [{**boxes, **dict(zip(some, way, strict=True))} for way in product(*places) if not _meeting(way)]
        best = min(ways, key=lambda way: self._cost(way, boxes), default=boxes)
        return best if self._cost(best, boxes) < self._cost(boxes, boxes) else boxes

    def _cost(self, way: Boxes, before: Boxes) -> float:
        """Weigh how bare a sheet is, and how far things are moved for it."""
        far = sum(abs(_corner(box) - _corner(before[k])) for k, box in way.items())
        return max(self._bare(way), self.most) + FAR * far

    def _bare(self, boxes: Boxes) -> float:
        ink = [field for k, box in boxes.items() for field in self.inked(k, box)]
        return bareness([*ink, *self.page.taken], self.page.field)

    def _places(self, k: int, own: Field, others: Sequence[Field], shifts: Shifts, anew: bool) -> Iterator[Field]:
        """Give the boxes that a thing may have beside all others, in its size or broken anew."""
        sizes = [(own.width, own.height), *(self.sizes(k) if anew else ())]
        for (wide, high), (right, up) in product(sizes, shifts):
            left, top = own.left + right, own.top + up
            box = Field(left, top - high, left + wide, top)
            free = _within(box, self.room) and not any(_meet(box, other) for other in (*others, self.page.block))
            if free and self._clear(k, box):
                yield box

    def _clear(self, k: int, box: Field) -> bool:
        """Tell whether a thing keeps clear of what stands in the corners: a heading in the middle of its box may."""
        return not any(_meet(ink, place) for ink in self.inked(k, box) for place in self.page.taken)


def _meeting(way: Sequence[Field]) -> bool:
    return any(_meet(*pair) for pair in combinations(way, 2))


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
