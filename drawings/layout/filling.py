"""Filling: workings are written beside their figures where paper would stay bare (заполнение листа выкладками).

What is bare of the lines of all figures takes a column of them; or a cell is cut off for one before anything is drawn.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from drawings.layout.bareness import bareness
from drawings.layout.block import TextBlock
from drawings.layout.common_scales import sizes_of
from drawings.layout.ink import Ink
from drawings.layout.picture import Picture
from drawings.layout.room import ends_of, room_of
from drawings.layout.slicing import GAP, SAME, Cut, Piece, Size, Tree, pieces
from drawings.layout.standing import natural
from drawings.layout.stood import Stood
from drawings.page.page import Field, Page
from drawings.paper.strokes import Group

BARE, LAST = 0.13, 0.26  # shares of a sheet that may stay bare, of the last one of a set more
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
