"""A sheet as it would stand: where its units are, how large and how bare it is, and what becomes of it (лист)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from drawings.layout.arrangement import Arrangement
from drawings.layout.bareness import bareness
from drawings.layout.block import Notes, TextBlock
from drawings.layout.contents import Composition, TableSpot
from drawings.layout.picture import Picture, Rung, Spot
from drawings.layout.room import Shown, Stock, ends_of, room_of
from drawings.layout.slicing import Size, Tree, pieces
from drawings.layout.standing import Occupant, Standing
from drawings.layout.table import RuledTable
from drawings.page.page import Field, Page

BARE = 0.11  # share of a sheet that may be bare before it counts; the last sheet of a set may be barer
LAST = 0.22
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

    def _sizes(self, k: int) -> Sequence[Size]:
        """Give the sizes that lettering may be broken to where it stands, and tables set."""
        return () if isinstance(self.stock.shown[k], Picture) else self.stock.sizes(k, self.rungs)

    @property
    def most(self) -> float:
        """The share of it that may be bare before that counts."""
        return LAST if self.last else BARE

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
        boxes = sorted(self.arranged.items())
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
