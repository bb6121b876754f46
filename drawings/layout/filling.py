"""Filling: workings are written beside their figures where paper would stay bare (заполнение листа выкладками).

What is bare of the lines of all figures takes a column of them.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from typing import NamedTuple

import numpy as np

from drawings.layout.arrangement import Arrangement, clear
from drawings.layout.contents import Composition, TableSpot
from drawings.layout.ink import Ink
from drawings.layout.picture import Notes, Picture, Rung, Spot, TextBlock
from drawings.layout.room import Shown, Stock, ends_of, room_of
from drawings.layout.slicing import GAP, SAME, Size, Tree, pieces
from drawings.layout.standing import Occupant, Standing, bareness
from drawings.layout.table import RuledTable
from drawings.page.page import Field, Page
from drawings.paper.strokes import Group
from drawings.paper.walk import tied

STOOD_BARE = 0.11  # share of a sheet that may be bare before it counts; the last sheet of a set may be barer
STOOD_LAST = 0.15
COSTS = 6.0  # what a share more counts, against the logarithm of the figures' sizes
TORN = 0.03  # what each piece of a table beyond the first counts, likewise
HEAD = 16.0  # mm of a heading and the scale under it
WIDER = 1.5  # times its width that a table may be set: wider cells are hard to read along
LETTERED = 0.25  # share of the margins of a figure that its letters and symbols fill


@dataclass(frozen=True, eq=False, repr=False)
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
                item = self.stock.shown[piece.unit]
                size = self.stock.sizes(piece.unit, self.rungs)[piece.choice]
                units[piece.unit] = Occupant(size, isinstance(item, Picture), *self._more(item, size))
        boxes = Standing(units, room_of(self.page)).boxes(self.tree)
        return {k: box for k, box in boxes.items() if k not in ends}

    def _more(self, item: Shown, size: Size) -> Size:
        """Tell how much wider and higher than its size a thing may stand, mm."""
        if isinstance(item, Picture):
            return 0.0, (item.taller - 1) * item.high / self.rungs[item.name].scale.mu
        if isinstance(item, RuledTable):
            return (WIDER - 1) * size[0], 0.0
        return (math.inf if isinstance(item, Notes) else 0.0), 0.0

    @cached_property
    def bare(self) -> float:
        """The share of the sheet that the largest empty rectangle takes, as far as boxes tell."""
        return bareness(self.ink(self.boxes), self.page.field)

    def ink(self, boxes: Mapping[int, Field]) -> list[Field]:
        """Give what bears ink where all stands in some boxes, and what the page itself takes."""
        return [*(part for k, box in boxes.items() for part in self._inked(k, box)), *self.page.taken]

    @cached_property
    def arranged(self) -> Mapping[int, Field]:
        """The boxes, moved where too much of the sheet would stay bare."""
        most = self.most
        if self.bare <= most:
            return self.boxes
        return Arrangement(self.page, room_of(self.page), most, self._inked, self._sizes).arranged(self.boxes)

    @cached_property
    def stands(self) -> Mapping[int, Field]:
        """The boxes at last: where paper is free, lettering is wider and tables whole; the sheet is no barer for it."""
        boxes = dict(self.arranged)
        most = max(bareness(self.ink(boxes), self.page.field), self.most)
        for k in (k for k in boxes if not isinstance(self.stock.shown[k], Picture)):
            others = [*(box for n, box in boxes.items() if n != k), *self.page.taken]
            if self.stock.pieces(k):
                boxes[k] = self._whole(k, boxes, others)
                continue
            wider = np.array([*self._wider(k, boxes[k])]).reshape(-1, 4)
            free = map(Field._make, wider[clear(wider, others, room_of(self.page))].tolist())
            fair = (box for box in free if bareness(self.ink({**boxes, k: box}), self.page.field) <= most)
            boxes[k] = next(fair, boxes[k])
        return boxes

    def _wider(self, k: int, box: Field) -> Iterator[Field]:
        """Give the wider boxes that lettering may have under the top of its own, the widest first."""
        for wide, high in (size for size in self._sizes(k)[::-1] if size[0] > box.width + SAME):
            low = box._replace(bottom=box.top - high)
            yield from (low._replace(right=box.left + wide), low._replace(left=box.right - wide))

    def _whole(self, k: int, boxes: Mapping[int, Field], others: Sequence[Field]) -> Field:
        """Give the box of a table in the fewest pieces that find a place: where the sheet is least bare, nearest."""
        box, room = boxes[k], room_of(self.page)
        ways, now = zip(self.stock.pieces(k), self._sizes(k), strict=True), self._now(k, box)
        beside = [other.inset(-GAP) for other in others] if isinstance(self.stock.shown[k], RuledTable) else []

        def loss(way: Field) -> tuple[float, float]:
            bare = bareness(self.ink({**boxes, k: way}), self.page.field)
            return max(bare, self.most), tied(abs(way.centre - box.centre))

        for _, (wide, high) in sorted(way for way in ways if way[0] < now):
            lefts = {box.left, box.right - wide, *(x for edge in beside for x in (edge.right, edge.left - wide))}
            lows = {box.bottom, box.top - high, *(y for edge in beside for y in (edge.top, edge.bottom - high))}
            corners = np.array([*product(sorted(lefts), sorted(lows))])
            stands = np.hstack([corners, corners + np.array([wide, high])])
            if free := stands[clear(stands, others, room)].tolist():
                return min(map(Field._make, free), key=loss)
        return box

    def _now(self, k: int, box: Field) -> int:
        """Count the pieces of a table that is as high as its box."""
        ways = zip(self.stock.pieces(k), self._sizes(k), strict=True)
        return min(ways, key=lambda way: tied(abs(way[1][1] - box.height)))[0]

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
    def full(self) -> float:
        """The share of the room that all boxes take."""
        sizes = (
            self.stock.sizes(piece.unit, self.rungs)[piece.choice] for piece in pieces(self.tree) if piece.unit >= 0
        )
        return math.fsum(wide * high for wide, high in sizes) / math.prod(self.stock.room)

    @property
    def torn(self) -> float:
        """What its tables count that stand in pieces."""
        tables = ((self.stock.pieces(piece.unit), piece.choice) for piece in pieces(self.tree) if piece.unit >= 0)
        return TORN * sum(torn[choice] - 1 for torn, choice in tables if torn)

    @property
    def parted(self) -> bool:
        """Whether a table is torn where it stands at last that could be whole."""
        least = {k: replace(self.stock, whole=True).pieces(k)[:1] for k in self.stands}
        return any(self._now(k, self.stands[k]) > fewest for k, some in least.items() for fewest in some)

    @property
    def notes(self) -> bool:
        """Whether it bears the notes."""
        return any(isinstance(self.stock.shown[k], Notes) for k in self.boxes)

    def _inked(self, k: int, box: Field) -> Iterator[Field]:
        """Give what of a box is inked: lines and letters of a figure, and its heading."""
        item = self.stock.shown[k]
        if isinstance(item, Notes):
            yield from _written(item, box)
            return
        if not isinstance(item, Picture):
            yield box
            return
        scale, around = self.rungs[item.name].scale, item.margins
        item = item.filling(Spot(box, scale))
        middle, wide, high = box.centre.real, item.wide / scale.mu, item.high / scale.mu
        left, low = middle - wide / 2, box.bottom + around.below
        side, below, above = LETTERED * around.side, LETTERED * around.below, box.top - HEAD - low - high
        for band in item.bands:
            yield Field(
                left + band.left * wide - side,
                low + band.low * high - below,
                left + band.right * wide + side,
                low + band.high * high + above,
            )
        yield Field(middle - item.heading / 2, box.top - HEAD, middle + item.heading / 2, box.top)

    def composition(self) -> Composition:
        """Give where everything stands, in the order of the contents."""
        boxes = sorted(self.stands.items())
        shown = [(self.stock.shown[k], box) for k, box in boxes]
        tables = []
        for item, box in shown:
            if isinstance(item, RuledTable):
                setting = item.as_high(box)
                tables.append(TableSpot(item.widened(setting, box.width), complex(box.left, box.top), setting))
        return Composition(
            {item.name: Spot(box, self.rungs[item.name].scale) for item, box in shown if isinstance(item, Picture)},
            {item.name: box for item, box in shown if isinstance(item, TextBlock)},
            tuple(tables),
            next((box for item, box in shown if isinstance(item, Notes)), None),
        )


def _written(notes: Notes, box: Field) -> Iterator[Field]:
    """Give the boxes of the paragraphs of notes, from the top of their own downwards."""
    top = box.top
    for wide, high in notes.lines(box.width):
        yield Field(box.left, max(top - high, box.bottom), box.left + wide, top)
        top = max(top - high, box.bottom)


def size_of(extents: list[float]) -> float:
    """Give the mean of the sizes of figures, mm, by their inverse squares: the small ones matter most."""
    sizes = [extent for extent in extents if 0 < extent < math.inf]
    return math.sqrt(len(sizes) / sum(size**-2 for size in sizes)) if sizes else 1.0


BARE, LAST = 0.13, 0.17  # shares of a sheet that may stay bare, of the last one of a set more
APART = 2.0  # mm between workings in a column: they read on


class Loose(NamedTuple):
    """A working that has no place yet: the sizes that it may have, and how it is written in its box."""

    block: TextBlock
    write: Callable[[Field], Group]


def fill(ink: Ink, page: Page, last: bool, loose: Sequence[Loose]) -> Iterator[Group]:
    """Write workings where most is bare, until no more is than may be or none of them fits; the ink knows of them."""
    left, room = {entry.block.name: entry for entry in loose}, room_of(page)
    most = page.field.width * page.field.height * (LAST if last else BARE)  # mm2, of one rectangle
    while left:
        bare = ink.bare(page.field)
        if bare.width * bare.height <= most:
            return
        found = _least([entry.block for entry in left.values()], bare, room, most)
        if not found:
            return
        for name, box in found.items():
            group = left.pop(name).write(box)
            ink.draw([group])
            yield group


def _least(blocks: Sequence[TextBlock], bare: Field, room: Field, most: float) -> dict[str, Field]:
    """Take the fewest workings that leave no more bare there than may be, mm2, or else as many as there is room for."""
    clear, share = bare.inset(GAP), most / (bare.width * bare.height)
    inner = Field(*map(max, clear[:2], room[:2]), *map(min, clear[2:], room[2:]))
    some = (*([block] for block in blocks), *(blocks[:k] for k in range(2, len(blocks))))
    ways = (column(chosen, inner) for chosen in some)
    enough = (way for way in ways if way and bareness(way.values(), bare) <= share)
    return next(enough, None) or column(blocks, inner)


def column(blocks: Sequence[TextBlock], bare: Field) -> dict[str, Field]:
    """Stand lettering one below another amid what is bare, what there is room for: the box of each by its name.

    >>> column([TextBlock("a", ((20.0, 10.0),)), TextBlock("b", ((20.0, 30.0),))], Field(0.0, 0.0, 40.0, 30.0))
    {'a': Field(left=10.0, bottom=10.0, right=30.0, top=20.0)}
    """
    widths = {wide for block in blocks for wide, _ in block.sizes if wide <= bare.width}
    columns = [_sized(blocks, wide, bare.height) for wide in sorted(widths)]
    ways = [dict(_spread(sizes, bare, apart)) for sizes in columns for apart in (APART, math.inf)]
    return min(ways, key=lambda way: bareness(way.values(), bare), default={})


def _sized(blocks: Sequence[TextBlock], width: float, height: float) -> dict[str, Size]:
    """Give the lowest sizes in a width of what has room in a height."""
    sizes, high = dict[str, Size](), -APART
    for block in blocks:
        size = min((shape for shape in block.sizes if shape[0] <= width), key=lambda shape: shape[1], default=None)
        if size is not None and high + APART + size[1] <= height:
            sizes[block.name] = size
            high += APART + size[1]
    return sizes


def _spread(sizes: dict[str, Size], bare: Field, most: float) -> Iterator[tuple[str, Field]]:
    """Stand sizes in the middle of what is bare, the spare height between them, no more than that apart."""
    wide, high = max((size[0] for size in sizes.values()), default=0.0), sum(size[1] for size in sizes.values())
    apart = min((bare.height - high) / (len(sizes) + 1), most)
    left, top = bare.centre.real - wide / 2, bare.centre.imag + (high + apart * (len(sizes) - 1)) / 2
    for name, (width, tall) in sizes.items():
        yield name, Field(left, top - tall, left + width, top)
        top -= tall + apart
