"""Filling: workings are written beside their figures where paper would stay bare (заполнение листа выкладками).

What is bare of the lines of all figures takes a column of them; or a cell is cut off for one before anything is drawn.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

from drawings.layout.arrangement import Arrangement, sizes_of
from drawings.layout.contents import Composition, TableSpot
from drawings.layout.ink import Ink
from drawings.layout.picture import Notes, Picture, Rung, Spot, TextBlock
from drawings.layout.room import Shown, Stock, ends_of, room_of
from drawings.layout.slicing import GAP, SAME, Cut, Piece, Size, Tree, pieces
from drawings.layout.standing import Occupant, Standing, bareness, natural
from drawings.layout.table import RuledTable
from drawings.page.page import Field, Page
from drawings.paper.strokes import Group

STOOD_BARE = 0.11  # share of a sheet that may be bare before it counts; the last sheet of a set may be barer
STOOD_LAST = 0.22
COSTS = 6.0  # what a share more counts, against the logarithm of the figures' sizes
HEAD = 16.0  # mm of a heading and the scale under it
WIDER = 1.5  # times its width that a table may be set: wider cells are hard to read along
LETTERED = 0.25  # share of the margins of a figure that its letters and symbols fill


@dataclass(frozen=True)
class Stood:
    """A sheet: what is shown, how it is cut, the scales of its pictures, whether it ends its set."""

    stock: Stock
    page: Page
    tree: Tree
    rungs: Mapping[str, Rung]
    last: bool

    @cached_property
    def boxes(self) -> dict[int, Field]:
        """The box of everything on it, by its number."""
        ends = ends_of(self.page)
        units = {k: Occupant(size, False) for k, size in ends.items()}
        for piece in pieces(self.tree):
            if piece.unit not in ends:
                one = self.stock.shown[piece.unit]
                size = self.stock.sizes(piece.unit, self.rungs)[piece.choice]
                units[piece.unit] = Occupant(size, isinstance(one, Picture), *self._more(one, size))
        boxes = Standing(units, room_of(self.page)).boxes(self.tree)
        return {k: box for k, box in boxes.items() if k not in ends}

    def _more(self, one: Shown, size: Size) -> Size:
        """Tell how much wider and higher than its size a thing may stand, mm."""
        if isinstance(one, Picture):
            return 0.0, (one.taller - 1) * one.high / self.rungs[one.name].scale.mu
        if isinstance(one, RuledTable):
            return (WIDER - 1) * size[0], 0.0
        return (math.inf if isinstance(one, Notes) else 0.0), 0.0

    @cached_property
    def bare(self) -> float:
        """The share of the sheet that the largest empty rectangle takes, as far as boxes tell."""
        return bareness(self.ink(self.boxes), self.page.field)

    def ink(self, boxes: Mapping[int, Field]) -> list[Field]:
        """Give what bears ink where all stands in some boxes, and what the page itself takes."""
        return [*(part for k, own in boxes.items() for part in self._inked(k, own)), *self.page.taken]

    @cached_property
    def arranged(self) -> Mapping[int, Field]:
        """The boxes, moved where too much of the sheet would stay bare."""
        most = self.most
        if self.bare <= most:
            return self.boxes
        return Arrangement(self.page, room_of(self.page), most, self._inked, self._sizes).arranged(self.boxes)

    @cached_property
    def stands(self) -> Mapping[int, Field]:
        """The boxes at last: lettering is set wider where paper beside it is free, and the sheet is no barer for it."""
        boxes = dict(self.arranged)
        most = max(bareness(self.ink(boxes), self.page.field), self.most)
        for k in (k for k in boxes if isinstance(self.stock.shown[k], TextBlock | Notes)):
            taken = [*(own for n, own in boxes.items() if n != k), *self.page.taken]
            free = (own for own in self._wider(k, boxes[k]) if _free(own, taken, room_of(self.page)))
            fair = (own for own in free if bareness(self.ink({**boxes, k: own}), self.page.field) <= most)
            boxes[k] = next(fair, boxes[k])
        return boxes

    def _wider(self, k: int, box: Field) -> Iterator[Field]:
        """Give the wider boxes that lettering may have under the top of its own, the widest first."""
        for wide, high in (size for size in self._sizes(k)[::-1] if size[0] > box.width + SAME):
            low = box._replace(bottom=box.top - high)
            yield from (low._replace(right=box.left + wide), low._replace(left=box.right - wide))

    def _sizes(self, k: int) -> Sequence[Size]:
        """Give the sizes that lettering may be broken to where it stands, and tables set."""
        return () if isinstance(self.stock.shown[k], Picture) else self.stock.sizes(k, self.rungs)

    @property
    def most(self) -> float:
        """The share of it that may be bare before that counts."""
        return STOOD_LAST if self.last else STOOD_BARE

    @property
    def fault(self) -> float:
        """What its bareness counts."""
        return COSTS * max(self.bare - self.most, 0.0)

    @property
    def left(self) -> float:
        """What its bareness counts that is left when all is moved."""
        return COSTS * max(bareness(self.ink(self.arranged), self.page.field) - self.most, 0.0)

    @property
    def notes(self) -> bool:
        """Whether it bears the notes."""
        return any(isinstance(self.stock.shown[k], Notes) for k in self.boxes)

    def _inked(self, k: int, box: Field) -> Iterator[Field]:
        """Give what of a box is inked: lines and letters of a figure, and its heading."""
        one = self.stock.shown[k]
        if isinstance(one, Notes):
            yield from _written(one, box)
            return
        if not isinstance(one, Picture):
            yield box
            return
        scale, around = self.rungs[one.name].scale, one.margins
        one = one.filling(Spot(box, scale))
        middle, wide, high = box.centre.real, one.wide / scale.mu, one.high / scale.mu
        left, low = middle - wide / 2, box.bottom + around.below
        side, below, above = LETTERED * around.side, LETTERED * around.below, box.top - HEAD - low - high
        for band in one.bands:
            yield Field(
                left + band.left * wide - side,
                low + band.low * high - below,
                left + band.right * wide + side,
                low + band.high * high + above,
            )
        yield Field(middle - one.heading / 2, box.top - HEAD, middle + one.heading / 2, box.top)

    def composition(self) -> Composition:
        """Give where everything stands, in the order of the contents."""
        boxes = sorted(self.stands.items())
        shown = [(self.stock.shown[k], box) for k, box in boxes]
        tables = []
        for one, box in shown:
            if isinstance(one, RuledTable):
                setting = one.as_high(box)
                tables.append(TableSpot(one.widened(setting, box.width), complex(box.left, box.top), setting))
        return Composition(
            {one.name: Spot(box, self.rungs[one.name].scale) for one, box in shown if isinstance(one, Picture)},
            {one.name: box for one, box in shown if isinstance(one, TextBlock)},
            tuple(tables),
            next((box for one, box in shown if isinstance(one, Notes)), None),
        )


def _free(box: Field, others: Sequence[Field], room: Field) -> bool:
    """Tell whether a box is in a room and as far from all others as things on a sheet are."""
    if box.left < room.left - SAME or box.right > room.right + SAME or box.bottom < room.bottom - SAME:
        return False
    left, bottom, right, top = box.inset(SAME - GAP)
    return not any(one.left < right and left < one.right and one.bottom < top and bottom < one.top for one in others)


def _written(notes: Notes, box: Field) -> Iterator[Field]:
    """Give the boxes of the paragraphs of notes, from the top of their own downwards."""
    top = box.top
    for wide, high in notes.lines(box.width):
        yield Field(box.left, max(top - high, box.bottom), box.left + wide, top)
        top = max(top - high, box.bottom)


def size_of(extents: list[float]) -> float:
    """Give the harmonic mean of the sizes of figures, mm, to which the small ones matter most."""
    sizes = [one for one in extents if 0 < one < math.inf]
    return len(sizes) / sum(1 / one for one in sizes) if sizes else 1.0


BARE, LAST = 0.13, 0.22  # shares of a sheet that may stay bare, of the last one of a set more
APART = 2.0  # mm between workings in a column: they read on


class Loose(NamedTuple):
    """A working that has no place yet: the sizes that it may have, and how it is written in its box."""

    block: TextBlock
    write: Callable[[Field], Group]


def most_bare(page: Page, last: bool) -> float:
    """Give how much of a sheet may stay bare in one rectangle, mm2."""
    return page.field.width * page.field.height * (LAST if last else BARE)


def fill(ink: Ink, page: Page, last: bool, loose: Sequence[Loose]) -> Iterator[Group]:
    """Write workings where most is bare, until no more is than may be or none of them fits; the ink knows of them."""
    left, room = {one.block.name: one for one in loose}, room_of(page)
    most = most_bare(page, last)
    while left:
        bare = ink.bare(page.field)
        if bare.width * bare.height <= most:
            return
        found = _least([one.block for one in left.values()], bare, room, most)
        if not found:
            return
        for name, box in found.items():
            group = left.pop(name).write(box)
            ink.draw([group])
            yield group


def _least(blocks: Sequence[TextBlock], bare: Field, room: Field, most: float) -> dict[str, Field]:
    """Take the fewest workings that leave no more bare there than may be, mm2, or else as many as there is room for."""
    inner, share = _common(bare.inset(GAP), room), most / (bare.width * bare.height)
    some = (*([one] for one in blocks), *(blocks[:k] for k in range(2, len(blocks))))
    ways = (column(own, inner) for own in some)
    enough = (way for way in ways if way and bareness(way.values(), bare) <= share)
    return next(enough, None) or column(blocks, inner)


def column(blocks: Sequence[TextBlock], bare: Field) -> dict[str, Field]:
    """Stand lettering one below another amid what is bare, what there is room for: the box of each by its name.

    >>> column([TextBlock("a", ((20.0, 10.0),)), TextBlock("b", ((20.0, 30.0),))], Field(0.0, 0.0, 40.0, 30.0))
    {'a': Field(left=10.0, bottom=10.0, right=30.0, top=20.0)}
    """
    widths = {wide for one in blocks for wide, _ in one.sizes if wide <= bare.width}
    columns = [_sized(blocks, wide, bare.height) for wide in sorted(widths)]
    ways = [dict(_spread(sizes, bare, apart)) for sizes in columns for apart in (APART, math.inf)]
    return min(ways, key=lambda way: bareness(way.values(), bare), default={})


def _sized(blocks: Sequence[TextBlock], width: float, height: float) -> dict[str, Size]:
    """Give the lowest sizes in a width of what has room in a height."""
    sizes, high = dict[str, Size](), -APART
    for one in blocks:
        size = min((own for own in one.sizes if own[0] <= width), key=lambda own: own[1], default=None)
        if size is not None and high + APART + size[1] <= height:
            sizes[one.name] = size
            high += APART + size[1]
    return sizes


def _spread(sizes: dict[str, Size], bare: Field, most: float) -> Iterator[tuple[str, Field]]:
    """Stand sizes in the middle of what is bare, the spare height between them, no more than that apart."""
    wide, high = max((own[0] for own in sizes.values()), default=0.0), sum(own[1] for own in sizes.values())
    apart = min((bare.height - high) / (len(sizes) + 1), most)
    left, top = bare.centre.real - wide / 2, bare.centre.imag + (high + apart * (len(sizes) - 1)) / 2
    for name, (own, tall) in sizes.items():
        yield name, Field(left, top - tall, left + own, top)
        top -= tall + apart


def _common(one: Field, other: Field) -> Field:
    return Field(*map(max, one[:2], other[:2]), *map(min, one[2:], other[2:]))


def filled(sheet: Stood) -> Stood:
    """Write workings beside their figures until no more of a sheet is bare than may be, or none is left that helps."""
    for k in _workings(sheet):
        if not sheet.left:
            break
        sheet = min((sheet, *_beside(sheet, k)), key=lambda one: one.left)
    return sheet


def _workings(sheet: Stood) -> list[int]:
    """Give the workings of the figures on a sheet, by their numbers."""
    figures = (sheet.stock.shown[k] for k in sheet.boxes)
    return [k for one in figures if isinstance(one, Picture) for k in sheet.stock.workings.get(one.name, ())]


def _beside(sheet: Stood, k: int) -> Iterator[Stood]:
    """Cut a cell off for a working, where that leaves the least bare."""
    ends, room = ends_of(sheet.page), sheet.stock.room
    ways = []
    for choice in range(len(sheet.stock.sizes(k, sheet.rungs))):
        for tree in _cut_off(sheet, sheet.tree, Piece(k, choice), ends):
            wide, high = natural(tree, sizes_of(sheet.stock, tree, sheet.rungs, ends))
            if wide <= room[0] + SAME and high <= room[1] + SAME:
                ways.append(replace(sheet, tree=tree))
    yield from (min(ways, key=lambda way: way.bare),) if ways else ()


def _cut_off(sheet: Stood, tree: Tree, own: Piece, ends: Mapping[int, Size]) -> Iterator[Tree]:
    """Give the trees in which a working is cut off from a part of a tree that shows its figure."""
    numbers = [piece.unit for piece in pieces(tree)]
    shown = [sheet.stock.shown[k] for k in numbers if k not in ends]
    if not any(isinstance(one, Picture) and own.unit in sheet.stock.workings.get(one.name, ()) for one in shown):
        return
    if len(shown) == len(numbers):
        yield from (Cut(True, tree, own), Cut(True, own, tree), Cut(False, tree, own))
    if isinstance(tree, Cut) and not tree.tied:
        yield from (tree._replace(first=one) for one in _cut_off(sheet, tree.first, own, ends))
        yield from (tree._replace(second=one) for one in _cut_off(sheet, tree.second, own, ends))
