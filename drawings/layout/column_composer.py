"""The composition of sheets from columns of figures and lettering, loose figures, a table and notes (компоновка)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise, product, takewhile
from typing import NamedTuple

from drawings.layout.block import TextBlock
from drawings.layout.columns import Column, Filled, Part, Zone, fill
from drawings.layout.contents import Composition, Contents, at_foot
from drawings.layout.footing import PAD, Foot, Notes, feet
from drawings.layout.picture import Ladder, Picture
from drawings.layout.stacking import even, stacks
from drawings.layout.table import RuledTable, Setting
from drawings.layout.trials import room_of
from drawings.page.page import Field, Page
from drawings.paper.strokes import SheetError
from plans.words.words import message


def compose(contents: Contents, page: Page) -> tuple[Composition, ...]:
    """Compose the sheets: all on one if every figure stays readable there, or else as many a sheet as do."""
    room = room_of(page)
    ladders = {
        panel.item.name: panel.item.ladder(room.width, room.height, page.standard, panel.weight)
        for panel in contents.panels
        if isinstance(panel.item, Picture)
    }
    sheet = _Sheet(contents, page, ladders)
    whole = sheet.best()
    return (whole,) if whole is not None else tuple(_series(sheet))


def _series(whole: _Sheet) -> Iterator[Composition]:
    """Compose several sheets: the notes on the first, the table on the last or on sheets of its own."""
    count, runs = len(whole.contents.groups), list(_runs(whole))
    composed = [one for _, one in runs]
    if len(runs) > 1:  # the same number of sheets, but filled alike
        cuts = [round(count * k / len(runs)) for k in range(len(runs) + 1)]
        parts = [whole.part(slice(*cut)) for cut in pairwise(cuts)]
        alike = [part.best() for part in parts]
        if None not in alike:
            runs = [(part, one) for part, one in zip(parts, alike, strict=True) if one is not None]
            composed = [one for _, one in runs]
    yield from composed[:-1]
    last, table = runs[-1][0], whole.contents.table
    full = replace(last, contents=replace(last.contents, tables=whole.contents.tables)).best()
    yield full or composed[-1]
    if full is None and table is not None:
        yield from _tables(table, whole.page)


def _runs(whole: _Sheet) -> Iterator[tuple[_Sheet, Composition]]:
    """Take as many columns on each sheet as stay readable; a single one may be as small as it must."""
    start, count, page = 0, len(whole.contents.groups), whole.page
    while start < count:
        for end in range(count, start, -1):
            sheet = whole.part(slice(start, end))
            composition = sheet.best() or (sheet.best(legible=False) if end == start + 1 else None)
            if composition is not None:
                break
        else:
            raise SheetError(message("refused.column", format=page.name))
        yield sheet, composition
        start = end


def _tables(table: RuledTable, page: Page) -> Iterator[Composition]:
    """Set a table on sheets of its own, as many rows on each as fit."""
    start = 0
    while start < len(table.lines):
        for end in range(len(table.lines), start, -1):
            composition = _Sheet(Contents((), (table.part(slice(start, end)),)), page, {}).best()
            if composition is not None:
                break
        else:
            raise SheetError(message("refused.table", format=page.name))
        yield composition
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

    contents: Contents
    page: Page
    ladders: Mapping[str, Ladder]  # of all pictures of the set, by their names

    def part(self, groups: slice) -> _Sheet:
        """Give the sheet of a run of the groups; the notes go with the first."""
        panels = tuple(panel for group in self.contents.groups[groups] for panel in group)
        return replace(self, contents=Contents(panels, (), self.contents.notes if groups.start == 0 else None))

    @cached_property
    def columns(self) -> tuple[Column, ...]:
        """The groups as columns, each picture by its scales."""
        return tuple(
            tuple(self.ladders[panel.item.name] if isinstance(panel.item, Picture) else panel.item for panel in group)
            for group in self.contents.groups
        )

    @property
    def loose(self) -> int:
        """How many columns of one part stand last: these may stand on one another."""
        return sum(1 for _ in takewhile(lambda column: len(column) == 1, reversed(self.columns)))

    def best(self, legible: bool = True) -> Composition | None:
        """Find the composition with the largest figures."""
        room, best = room_of(self.page), None
        if sum(_area(column, legible) for column in self.columns) > room.width * room.height:
            return None
        bases = _best_of(self._feet(room))
        for aside in (False, True):  # all columns beside the title block only where they cannot stand otherwise
            for columns in self._ways(room):
                if sum(_least(column, legible) for column in columns) > room.width:
                    continue
                splits = [len(columns)] if aside else range(max(len(columns), 1))
                for base, split in product(bases, splits):
                    trial = self._filled(columns, split, base, room, legible)
                    if trial is not None and (best is None or trial.score > best[0].score):
                        best = trial, base
            if best is not None:
                return self._composed(*best, room)
        return None

    def _ways(self, room: Field) -> Iterator[tuple[Column, ...]]:
        """List the ways to stand columns and loose pictures; on paper that stands upright columns stand on columns."""
        first = len(self.columns) - self.loose
        own, loose = self.columns[:first], [column[0] for column in self.columns[first:]]
        tall = [own] if room.width > room.height else [_joined(way) for way in even(own)]
        for columns, stacked in product(tall, stacks(loose)):
            yield (*columns, *stacked)

    def _filled(
        self, columns: tuple[Column, ...], split: int, base: _Base, room: Field, legible: bool
    ) -> Filled | None:
        if not split and base.widths[0]:
            return None  # nothing stands under columns that are not there
        heights = [room.top - floor for floor in base.floors]
        zones = [Zone(columns[:split], base.widths[0], heights[0])] if split else []
        zones.append(Zone(columns[split:], base.widths[1], heights[1]))
        return fill(tuple(zones), room.width, legible)

    def _feet(self, room: Field) -> Iterator[_Base]:
        table, notes, block = self.contents.table, self.contents.notes, self.page.block
        for setting in table.settings() if table is not None else [None]:
            wide = table.size(setting)[0] if table is not None and setting is not None else 0.0
            for table_left, notes_left in product({False, table is not None}, {False, notes is not None}):
                own = (table if table_left else None, setting, notes if notes_left else None)
                other = (None if table_left else table, setting, None if notes_left else notes)
                lefts = _standing(room, None, wide if table_left else 0.0, *own)
                rights = _standing(room, block, 0.0 if table_left else wide, *other)
                for (one, low), (two, high) in product(list(lefts), list(rights)):
                    floors = low.top + PAD if low.top > room.bottom else room.bottom, high.top + PAD
                    words = low.notes if notes_left else high.notes
                    corner = (low.table if table_left else high.table) if table is not None else None
                    yield _Base((one, two), floors, corner, setting, words)

    def _composed(self, trial: Filled, base: _Base, room: Field) -> Composition:
        floors = base.floors if len(trial.zones) > 1 else base.floors[1:]
        feet = at_foot(self.contents.table, base.table, base.setting)
        return Composition(*trial.stand(room, floors), feet, base.notes)


def _standing(
    room: Field,
    block: Field | None,
    wide: float,
    table: RuledTable | None,
    setting: Setting | None,
    notes: Notes | None,
) -> Iterator[tuple[float, Foot]]:
    """List widths of a zone with the ways to stand its foot in it."""
    needed = PAD if wide and notes else 0.0
    if block is None:
        widths = {wide + needed + notes.least * k for k in (1, 2)} if notes else {wide}
    else:
        widths = {block.width, max(wide, block.width), wide + PAD + block.width, room.width}
        widths |= {wide + needed + notes.least * k + PAD + block.width for k in (1, 2)} if notes else set()
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
    if isinstance(part, TextBlock):
        return part.sizes[0][0], part.sizes[-1][1]
    sizes = [(rung.wide, rung.high) for rung in part.rungs if not legible or rung.extent >= part.least]
    return min(sizes, default=(0.0, 0.0))


def _least(column: Column, legible: bool) -> float:
    return max(_smallest(part, legible)[0] for part in column)


def _area(column: Column, legible: bool) -> float:
    return sum(wide * high for wide, high in (_smallest(part, legible) for part in column))


def _joined(way: Iterable[Iterable[Column]]) -> tuple[Column, ...]:
    return tuple(tuple(part for column in stack for part in column) for stack in way)
