"""The room of a sheet: what is left inside the frame for figures, tables and notes (рабочее поле)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property
from typing import NamedTuple, TypeAlias

from drawings.layout.contents import Contents, Panel
from drawings.layout.picture import Notes, Picture, Rung, TextBlock
from drawings.layout.slicing import GAP, Cut, Cuts, Piece, Size, Slicing, Tree, pieces
from drawings.layout.table import RuledTable
from drawings.page.page import Field, Page

Shown: TypeAlias = Picture | TextBlock | RuledTable | Notes
CORNER, HEAD = -1, -2  # the numbers of the title block, and of what stands in the upper left corner
CLEAR = 3.0  # mm from that to a heading
Unit: TypeAlias = int | tuple["Unit", ...]
Order: TypeAlias = tuple[Unit, ...]


class Shape(NamedTuple):
    """A size mm that a unit can take, and how it stands then."""

    size: Size
    tree: Tree


@dataclass(frozen=True, eq=False, repr=False)
class Stock:
    """All that a set of sheets shows, by its numbers, and the room mm of a sheet."""

    shown: tuple[Shown, ...]
    room: Size
    cuts: Cuts = field(compare=False, repr=False)
    whole: bool = False  # whether tables stand in as few pieces as a sheet has room for

    def shapes(self, unit: Unit, rungs: Mapping[str, Rung]) -> list[Shape]:
        """Give what sizes a unit can take where pictures have some scales."""
        if isinstance(unit, int):
            return [Shape(size, Piece(unit, k)) for k, size in enumerate(self.sizes(unit, rungs))]
        inner = [self.shapes(part, rungs) for part in unit]
        slicing = Slicing([[shape.size for shape in group] for group in inner], self.cuts)
        last = len(unit) - 1
        return [
            Shape((float(wide), float(high)), nested(slicing.run(0, last).tree(k), inner, tied=self.close(unit)))
            for k, (wide, high) in enumerate(slicing.run(0, last).sizes)
        ]

    def opening(self, shapes: Sequence[Shape], head: Size | None) -> list[Shape]:
        """Give what sizes a unit takes that begins a sheet: under the corner, unless it is a figure that leaves it."""
        return [shape if head is None or self._leaves(shape, head) else under(shape, head) for shape in shapes]

    def _leaves(self, shape: Shape, head: Size) -> bool:
        """Tell whether a figure's heading is clear of the upper left corner."""
        item = self.shown[next(pieces(shape.tree)).unit]
        alone = isinstance(shape.tree, Piece) or shape.tree.tied
        return (
            alone and isinstance(item, Picture) and item.open and (shape.size[0] - item.heading) / 2 >= head[0] + CLEAR
        )

    def sizes(self, k: int, rungs: Mapping[str, Rung]) -> Sequence[Size]:
        """Give the sizes that one thing can have."""
        item = self.shown[k]
        return [(rungs[item.name].wide, rungs[item.name].high)] if isinstance(item, Picture) else self._lettered[k]

    @cached_property
    def _lettered(self) -> Mapping[int, Sequence[Size]]:
        """The sizes of all lettering, by its numbers."""
        written = {k: self._written(item) for k, item in enumerate(self.shown) if not isinstance(item, Picture)}
        return {k: [sizes[n] for n in self._kept(k, sizes)] for k, sizes in written.items()}

    def _kept(self, k: int, sizes: Sequence[Size]) -> Sequence[int]:
        """Choose of its sizes all, or those of a table in the fewest pieces that a sheet has room for."""
        torn = self._torn(self.shown[k])
        inside = [n for n in range(len(torn)) if sizes[n][0] <= self.room[0] and sizes[n][1] <= self.room[1]]
        if not (self.whole and inside):
            return range(len(sizes))
        return [n for n in inside if torn[n] == min(torn[i] for i in inside)]

    def _written(self, item: TextBlock | RuledTable | Notes) -> Sequence[Size]:
        if isinstance(item, TextBlock):
            return item.sizes
        if isinstance(item, RuledTable):
            return [item.size(setting) for setting in item.settings()]
        return item.sizes(self.room[0])

    def _torn(self, item: Shown) -> Sequence[int]:
        if isinstance(item, RuledTable):
            return [item.pieces(setting) for setting in item.settings()]
        return item.pieces if isinstance(item, TextBlock) else ()

    def pieces(self, k: int) -> Sequence[int]:
        """Give into how many pieces a table is torn at each of its sizes, nothing for what is no table."""
        item = self.shown[k]
        torn = self._torn(item)
        return [torn[n] for n in self._kept(k, self._written(item))] if torn and not isinstance(item, Picture) else ()

    def close(self, unit: tuple[Unit, ...]) -> bool:
        """Tell whether all lettering of a unit belongs to its picture."""
        return all(isinstance(part, int) and isinstance(self.shown[part], TextBlock) for part in unit[1:])


def under(shape: Shape, head: Size) -> Shape:
    """Stand a unit under the upper left corner."""
    wide, high = shape.size
    return Shape((max(wide, head[0]), high + GAP + head[1]), Cut(False, Piece(HEAD, 0), shape.tree))


def nested(
    tree: Tree, inner: Sequence[Sequence[Shape]], opening: Sequence[Sequence[Shape]] | None = None, tied: bool = False
) -> Tree:
    """Put the trees of units in the tree that they are the pieces of: one opens a sheet, behind them is the corner."""
    if isinstance(tree, Piece):
        choices = inner if opening is None else opening
        return choices[tree.unit][tree.choice].tree if tree.unit < len(inner) else Piece(CORNER, 0)
    first, second = nested(tree.first, inner, opening, tied), nested(tree.second, inner, None, tied)
    return Cut(tree.beside, first, second, tied and not tree.beside)


def groups(contents: Contents) -> list[Unit]:
    """Give the units of the panels."""
    numbers = {id(panel): k for k, panel in enumerate(contents.panels)}
    return [_unit([(numbers[id(panel)], panel) for panel in group]) for group in contents.groups]


def _unit(group: Sequence[tuple[int, Panel]]) -> Unit:
    """Put lettering close to the picture before it."""
    piles: list[list[int]] = []
    for k, panel in group:
        if piles and isinstance(panel.item, TextBlock):
            piles[-1].append(k)
        else:
            piles.append([k])
    units: list[Unit] = [pile[0] if len(pile) == 1 else tuple(pile) for pile in piles]
    return units[0] if len(units) == 1 else tuple(units)


def orders(figures: Sequence[Unit], tables: Sequence[Unit], notes: Sequence[Unit]) -> list[Order]:
    """List the orders to read units in: tables and notes behind all figures or behind the first.

    >>> orders([0, 1], [2], [])
    [(0, 1, 2), (0, 2, 1)]
    """
    first, rest = figures[:1], figures[1:]
    ways = [
        [*figures, *tables, *notes],
        [*figures, *notes, *tables],
        [*first, *notes, *rest, *tables],
        [*first, *tables, *rest, *notes],
        [*first, *tables, *notes, *rest],
        [*first, *notes, *tables, *rest],
    ]
    return list(dict.fromkeys(map(tuple, ways)))


def further(figures: Sequence[Unit], tables: Sequence[Unit], notes: Sequence[Unit]) -> list[Order]:
    """List more orders, for sets of some sheets: tables and notes behind any of the figures.

    >>> further([0, 1, 2], [], [3])
    [(0, 1, 3, 2)]
    """
    ways = [
        way
        for k in range(1, len(figures))
        for way in (
            (*_behind(figures, k, notes), *tables),
            (*_behind(figures, k, tables), *notes),
            _behind(figures, k, (*tables, *notes)),
        )
    ]
    known = orders(figures, tables, notes)
    return [way for way in dict.fromkeys(ways) if way not in known]


def _behind(units: Sequence[Unit], k: int, some: Sequence[Unit]) -> Order:
    return *units[:k], *some, *units[k:]


PAD = 6.0  # mm between the frame and what stands inside it


@cache
def room_of(page: Page) -> Field:
    """Give the field that figures may fill: inside the frame, beside what stands in its upper right corner."""
    room = page.field
    for place in page.taken:
        if place != page.block and place.left > room.left:
            room = room._replace(right=min(room.right, place.left))
    return room.inset(PAD)


def size_of_room(page: Page) -> Size:
    """Give how wide and high that field is, mm."""
    room = room_of(page)
    return room.width, room.height


@cache
def corner_of(page: Page) -> Size:
    """Give what the title block takes of the room, mm: it stands at the frame itself."""
    room, block = room_of(page), page.block
    return min(room.right - block.left, room.width), block.top - room.bottom


@cache
def head_of(page: Page) -> Size | None:
    """Give what the standard has in the upper left corner of the room, mm, if anything."""
    room = room_of(page)
    for place in page.taken:
        if place != page.block and place.left <= room.left:
            return place.right - room.left, room.top - place.bottom
    return None


@cache
def ends_of(page: Page) -> Mapping[int, Size]:
    """Give the sizes of what stands in the corners of the room, by their numbers."""
    head = head_of(page)
    return {CORNER: corner_of(page)} | ({} if head is None else {HEAD: head})
