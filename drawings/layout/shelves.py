"""The composition of sheets from columns of pictures, loose pictures, a table and notes (компоновка листов)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, product
from typing import NamedTuple, TypeAlias, TypeVar

from drawings.layout.columns import Block, Column, Filled, Part, Zone, filled
from drawings.layout.footing import NARROW, PAD, Foot, Notes, feet
from drawings.layout.picture import Ladder, Picture, Spot
from drawings.layout.trials import room_of
from drawings.layout.value_table import Setting, Table
from drawings.page.page import Field, Page
from drawings.paper.strokes import SheetError
from plans.words.words import message

FEW = 4  # loose pictures that are stacked in every way; more of them only in columns of about equal numbers

T = TypeVar("T")

Item: TypeAlias = Picture | Block
Shelf: TypeAlias = tuple[Item, ...]


@dataclass(frozen=True)
class Content:
    """What a set of sheets must show: columns kept together from top to bottom, loose pictures, table and notes."""

    columns: tuple[Shelf, ...]
    loose: tuple[Picture, ...] = ()
    table: Table | None = None
    notes: Notes | None = None

    @property
    def count(self) -> int:
        """How many columns and loose pictures there are."""
        return len(self.columns) + len(self.loose)

    def part(self, units: slice, notes: Notes | None) -> Content:
        """Give what one of several sheets shows: a run of the columns and, after them, of the loose pictures."""
        first = len(self.columns)
        loose = slice(max(units.start - first, 0), max(units.stop - first, 0))
        return Content(self.columns[units], self.loose[loose], None, notes)


class Composed(NamedTuple):
    """One sheet: what it shows, and where."""

    content: Content
    pictures: dict[str, Spot]  # by their names
    blocks: dict[str, Field]  # of lettering, by their names
    table: complex | None  # upper left corner
    setting: Setting | None
    notes: Field | None


def compose(content: Content, page: Page) -> tuple[Composed, ...]:
    """Compose the sheets: all on one if every figure stays readable there, or else as many a sheet as do."""
    room = room_of(page)
    pictures = [item for column in content.columns for item in column if isinstance(item, Picture)]
    ladders = {one.name: one.ladder(room.width, room.height, page.standard) for one in (*pictures, *content.loose)}
    whole = _Sheet(content, page, ladders).best()
    return (whole,) if whole is not None else tuple(_series(_Sheet(content, page, ladders)))


def _series(whole: _Sheet) -> Iterator[Composed]:
    """Compose several sheets: the notes on the first, the table on the last or on sheets of its own."""
    content, composed = whole.content, _runs(whole)
    count = len(composed)
    if count > 1:  # the same number of sheets, but filled alike
        cuts = [round(content.count * k / count) for k in range(count + 1)]
        runs = [slice(*cut) for cut in pairwise(cuts)]
        alike = [whole.part(run).best() for run in runs]
        composed = [one for one in alike if one is not None] if None not in alike else composed
    yield from composed[:-1]
    last = composed[-1].content
    full = replace(whole, content=replace(last, table=content.table)).best()
    yield full or composed[-1]
    if full is None and content.table is not None:
        yield from _tables(content.table, whole.page)


def _runs(whole: _Sheet) -> list[Composed]:
    """Take as many columns on each sheet as stay readable; a single one may be as small as it must."""
    composed: list[Composed] = []
    start, count, page = 0, whole.content.count, whole.page
    while start < count:
        for end in range(count, start, -1):
            sheet = whole.part(slice(start, end))
            found = sheet.best() or (sheet.best(legible=False) if end == start + 1 else None)
            if found is not None:
                break
        else:
            raise SheetError(message("refused.column", format=page.name))
        composed.append(found)
        start = end
    return composed


def _tables(table: Table, page: Page) -> Iterator[Composed]:
    """Set a table on sheets of its own, as many rows on each as fit."""
    start = 0
    while start < len(table.lines):
        for end in range(len(table.lines), start, -1):
            found = _Sheet(Content((), (), table.part(slice(start, end))), page, {}).best()
            if found is not None:
                break
        else:
            raise SheetError(message("refused.table", format=page.name))
        yield found
        start = end


class _Base(NamedTuple):
    """What stands at the foot of a sheet: under its left columns, and under its right ones with the title block."""

    widths: tuple[float, float]
    floors: tuple[float, float]
    table: complex | None
    setting: Setting | None
    notes: Field | None

    @property
    def cost(self) -> tuple[float, ...]:
        return *self.widths, *self.floors


@dataclass(frozen=True)
class _Sheet:
    """A sheet to be composed."""

    content: Content
    page: Page
    ladders: Mapping[str, Ladder]  # of all pictures of the set, by their names

    def part(self, units: slice) -> _Sheet:
        """Give the sheet of a run of the columns and loose pictures; the notes go with the first."""
        return replace(self, content=self.content.part(units, self.content.notes if units.start == 0 else None))

    def best(self, legible: bool = True) -> Composed | None:
        """Find the composition with the largest figures."""
        room, found = room_of(self.page), None
        own = [self._measured(column) for column in (*self.content.columns, *((one,) for one in self.content.loose))]
        if sum(_area(column, legible) for column in own) > room.width * room.height:
            return None
        bases = _best_of(self._feet(room))
        for columns in self._ways(room):
            if sum(_least(column, legible) for column in columns) > room.width:
                continue
            for base, split in product(bases, range(max(len(columns), 1))):
                trial = self._filled(columns, split, base, room, legible)
                if trial is not None and (found is None or trial.score > found[0].score):
                    found = trial, base
        return None if found is None else self._composed(*found, room)

    def _ways(self, room: Field) -> Iterator[tuple[Column, ...]]:
        """List the ways to stand columns and loose pictures; on paper that stands upright columns stand on columns."""
        columns = self.content.columns
        tall = [columns] if room.width > room.height else [_joined(way) for way in even(columns)]
        for own, loose in product(tall, stacks(self.content.loose)):
            yield tuple(self._measured(column) for column in (*own, *loose))

    def _measured(self, column: Shelf) -> Column:
        return tuple(self.ladders[item.name] if isinstance(item, Picture) else item for item in column)

    def _filled(
        self, columns: tuple[Column, ...], split: int, base: _Base, room: Field, legible: bool
    ) -> Filled | None:
        if not split and base.widths[0]:
            return None  # nothing stands under columns that are not there
        heights = [room.top - floor for floor in base.floors]
        zones = [Zone(columns[:split], base.widths[0], heights[0])] if split else []
        zones.append(Zone(columns[split:], base.widths[1], heights[1]))
        return filled(tuple(zones), room.width, legible)

    def _feet(self, room: Field) -> Iterator[_Base]:
        table, notes, block = self.content.table, self.content.notes, self.page.block
        for setting in table.settings() if table is not None else [None]:
            wide = table.size(setting)[0] if table is not None and setting is not None else 0.0
            for table_left, notes_left in product({False, table is not None}, {False, notes is not None}):
                own = (table if table_left else None, setting, notes if notes_left else None)
                other = (None if table_left else table, setting, None if notes_left else notes)
                lefts = _standing(room, None, wide if table_left else 0.0, *own)
                rights = _standing(room, block, 0.0 if table_left else wide, *other)
                for (one, low), (two, high) in product(list(lefts), list(rights)):
                    floors = low.top + PAD if low.top > room.bottom else room.bottom, high.top + PAD
                    said = low.notes if notes_left else high.notes
                    corner = (low.table if table_left else high.table) if table is not None else None
                    yield _Base((one, two), floors, corner, setting, said)

    def _composed(self, trial: Filled, base: _Base, room: Field) -> Composed:
        floors = base.floors if len(trial.zones) > 1 else base.floors[1:]
        return Composed(self.content, *trial.stood(room, floors), base.table, base.setting, base.notes)


def _standing(
    room: Field, block: Field | None, wide: float, table: Table | None, setting: Setting | None, notes: Notes | None
) -> Iterator[tuple[float, Foot]]:
    """List widths of a zone with the ways to stand its foot in it."""
    needed = PAD if wide and notes else 0.0
    if block is None:
        widths = {wide + needed + NARROW * k for k in (1, 2)} if notes else {wide}
    else:
        widths = {block.width, max(wide, block.width), wide + PAD + block.width, room.width}
        widths |= {wide + needed + NARROW * k + PAD + block.width for k in (1, 2)} if notes else set()
    for width in sorted(one for one in widths if one <= room.width):
        left = room.left if block is None else block.right - width
        column = Field(left, room.bottom, left + width, room.top)
        if not width:
            yield 0.0, Foot(room.bottom, None, None)
            continue
        for foot in feet(column, block, table, setting if table is not None else None, notes):
            if foot.top <= room.top:
                yield width, foot


def _best_of(ways: Iterable[_Base]) -> list[_Base]:
    """Keep the ways to stand table and notes that no other beats, or all but beats, in every width and height."""
    kept: list[_Base] = []
    for way in sorted(ways, key=lambda way: sum(way.cost)):
        if not any(all(a <= b + PAD for a, b in zip(one.cost, way.cost, strict=True)) for one in kept):
            kept.append(way)
    return kept


def _smallest(part: Part, legible: bool) -> tuple[float, float]:
    """Give width and height that a part has at least, mm."""
    if isinstance(part, Block):
        return part.sizes[0][0], part.sizes[-1][1]
    sizes = [(rung.wide, rung.high) for rung in part.rungs if not legible or rung.drawn >= part.least]
    return min(sizes, default=(0.0, 0.0))


def _least(column: Column, legible: bool) -> float:
    return max(_smallest(part, legible)[0] for part in column)


def _area(column: Column, legible: bool) -> float:
    return sum(wide * high for wide, high in (_smallest(part, legible) for part in column))


def even(units: Sequence[T]) -> list[tuple[tuple[T, ...], ...]]:
    """List the ways to stack units in columns of about equal numbers, their order kept.

    >>> [[len(column) for column in way] for way in even("abcde")]
    [[1, 1, 1, 1, 1], [2, 2, 1], [3, 2], [5]]
    """
    count = len(units)
    highs = sorted({-(-count // columns) for columns in range(1, count + 1)})
    return [tuple(tuple(units[k : k + high]) for k in range(0, count, high)) for high in highs] or [()]


def _joined(way: Iterable[Iterable[Shelf]]) -> tuple[Shelf, ...]:
    return tuple(tuple(item for column in stack for item in column) for stack in way)


def stacks(loose: Sequence[T]) -> list[tuple[tuple[T, ...], ...]]:
    """List the ways to stack pictures in columns, their order kept.

    >>> [[len(column) for column in way] for way in stacks("abc")]
    [[3], [2, 1], [1, 2], [1, 1, 1]]
    """
    count = len(loose)
    if count > FEW:
        return even(loose)
    ways = []
    for broken in product((False, True), repeat=max(count - 1, 0)):
        cuts = [0, *(k + 1 for k, cut in enumerate(broken) if cut), count]
        ways.append(tuple(tuple(loose[a:b]) for a, b in pairwise(cuts) if b > a))
    return sorted(ways, key=len)
