"""Trials of a composition: the ways to stand the figures of one sheet, and the best of them (варианты компоновки)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import product
from typing import NamedTuple

from drawings.layout.contents import Contents
from drawings.layout.footing import PAD, Foot, feet
from drawings.layout.grid import Grid, Rows, arrangements, grid
from drawings.layout.picture import Picture, Spot
from drawings.layout.table import Setting
from drawings.page.page import Field, Page

HALF = 0.45  # of the sheet's width or height that the foremost figure takes at least: about half, by custom


class Trial(NamedTuple):
    """A way to compose one sheet: the rooms of the foremost figure and of the others, and what fills them."""

    room: Field
    spot: Spot | None
    plans: Field | None
    grid: Grid | None
    table: complex | None
    setting: Setting | None
    notes: Field | None
    score: float  # how good it is: large figures, the foremost counting by its weight against all others together
    halves: Halves | None = None


def merit(spot: Spot | None, weight: float, plans: Grid | None) -> float:
    """Rate a composition: the sizes of its figures by their logarithms, twice as large counting alike for all."""
    sizes = plans.extent if plans is not None else []
    others = sum(map(math.log, sizes)) / len(sizes) if sizes else 0.0
    return others + (weight * math.log(max(spot.box.width, spot.box.height)) if spot is not None else 0.0)


def room_of(page: Page) -> Field:
    """Give the field that figures may fill: inside the frame, beside or under what else the standard has there."""
    room = page.field
    for place in page.taken:
        if place != page.block and place.width >= place.height:
            room = room._replace(top=min(room.top, place.bottom))
        elif place != page.block:
            room = room._replace(right=min(room.right, place.left))
    return room.inset(PAD)


def rows_of(contents: Contents) -> tuple[tuple[Picture, ...], ...]:
    """Give the figures beside the foremost one by their places in their groups: all first ones, all second ones."""
    figures = ([panel.item for panel in group if isinstance(panel.item, Picture)] for group in contents.others)
    return tuple(zip(*figures, strict=True))


@dataclass(frozen=True)
class SheetTrials:
    """A sheet to be composed: what it shows, on which paper."""

    contents: Contents
    page: Page
    tried: dict[tuple[int, int, int], Grid | None] = field(default_factory=dict)  # grids, by way and tenths of mm

    @property
    def field(self) -> Field:
        """The field that figures may fill: inside the frame, beside or under what else the standard has there."""
        return room_of(self.page)

    @property
    def main(self) -> Picture | None:
        """The foremost figure."""
        foremost = self.contents.foremost
        return foremost.item if foremost is not None and isinstance(foremost.item, Picture) else None

    def merit(self, spot: Spot | None, plans: Grid | None) -> float:
        """Rate a composition of this sheet."""
        return merit(spot, self.contents.foremost.weight if self.contents.foremost is not None else 0.0, plans)

    def best(self, legible: bool = True) -> Trial | None:
        """Find the best composition; where it is asked, the other figures are large enough for their letters."""
        table, room = self.contents.table, self.field
        settings = table.settings() if table is not None else [None]
        ladders = [
            [one.ladder(room.width, room.height, self.page.standard) for one in row] for row in rows_of(self.contents)
        ]
        ways: list[Rows | None] = list(arrangements(*ladders)) or [None]
        best: Trial | None = None
        for spot, way in product(self._spots(), ways):
            if best is not None and self._bound(spot, way) <= best.score:
                continue
            for trial in (one for setting in settings for one in self._trials(spot, setting, way)):
                large = not legible or trial.grid is None or trial.grid.legible
                if large and (best is None or trial.score > best.score):
                    best = trial
        return best if best is None or best.halves is None else best.halves.even_out(best)

    def _spots(self) -> list[Spot | None]:
        """Give the foremost figure at the largest scale that fits, and smaller ones that still fill half a sheet."""
        if self.main is None:
            return [None]
        room = self.field
        rungs = self.main.ladder(room.width, room.height, self.page.standard).rungs
        large = [rung for rung in rungs if max(rung.wide / room.width, rung.high / room.height) >= HALF]
        return [Spot(Field(0.0, 0.0, rung.wide, rung.high), rung.scale) for rung in large or rungs[:1]]

    def _bound(self, spot: Spot | None, way: Rows | None) -> float:
        """Give what no trial can exceed: the plans in all the room that the foremost figure leaves."""
        if spot is None or way is None:
            return math.inf
        beside = self.grid(way, self.field.width - spot.box.width, self.field.height)
        above = self.grid(way, self.field.width, self.field.height - spot.box.height)
        return max((self.merit(spot, plans) for plans in (beside, above) if plans is not None), default=-math.inf)

    def grid(self, way: Rows, width: float, height: float) -> Grid | None:
        """Fit rows of plans into a room, each way and room once."""
        key = id(way), int(10 * width), int(10 * height)
        if key not in self.tried:  # in whole tenths, so that what is found fits all rooms of the key
            self.tried[key] = grid(way, key[1] / 10, key[2] / 10) if width > 0 and height > 0 else None
        return self.tried[key]

    def _trials(self, spot: Spot | None, setting: Setting | None, way: Rows | None) -> Iterator[Trial]:
        if spot is not None and way is not None:
            sides = (True, False) if self.contents.table is not None else (True,)
            for table_left, notes_left in product(sides, (True, False)):
                yield from Halves(self, spot, setting, way, table_left, notes_left).trials(spot.box.width)
        if spot is not None and way is None:
            yield from self._aside(spot, setting)
        yield from self._stacked(spot, setting, way)

    def _aside(self, spot: Spot, setting: Setting | None) -> Iterator[Trial]:
        """Stand the foremost figure alone on the left at full height, all else over the title block."""
        room, block, content = self.field, self.page.block, self.contents
        left = Field(room.left, room.bottom, block.left - PAD, room.top)
        right = Field(block.left, room.bottom, block.right, room.top)
        if spot.box.width > left.width or spot.box.height > left.height:
            return
        for foot in feet(right, block, content.table, setting, content.notes):
            if foot.top <= room.top:
                yield Trial(left, spot, None, None, foot.table, setting, foot.notes, self.merit(spot, None))

    def _stacked(self, spot: Spot | None, setting: Setting | None, way: Rows | None) -> Iterator[Trial]:
        """Stand the foremost figure above the others, table and notes at the foot of the sheet."""
        room, block, content = self.field, self.page.block, self.contents
        column = Field(room.left, room.bottom, block.right, room.top)
        high = spot.box.height if spot is not None else 0.0
        for foot in feet(column, block, content.table, setting, content.notes):
            free = room.top - foot.top - high - PAD
            rows = self.grid(way, room.width, free) if way is not None else None
            if free < 0 or (way is not None and rows is None):
                continue
            spare = (free - rows.size[1]) / 2 if rows is not None else free
            middle = room.top - high - spare
            plans = Field(room.left, foot.top + PAD, room.right, middle)
            main = Field(room.left, middle, room.right, room.top)
            yield Trial(main, spot, plans, rows, foot.table, setting, foot.notes, self.merit(spot, rows))


class Halves(NamedTuple):
    """The foremost figure on the left and the others on the right, table and notes at the foot of either."""

    sheet: SheetTrials
    spot: Spot
    setting: Setting | None
    way: Rows
    table_left: bool
    notes_left: bool

    def trials(self, wide: float) -> Iterator[Trial]:
        """Try the ways to stand the feet where the left half has a width, mm."""
        field, block = self.sheet.field, self.sheet.page.block
        left = Field(field.left, field.bottom, field.left + wide, field.top)
        right = Field(left.right + PAD, field.bottom, block.right, field.top)
        if right.width < block.width:
            return
        lows = [low for low in self._feet(left, None, True) if low.top + self.spot.box.height <= field.top]
        for low, foot in product(lows, list(self._feet(right, block, False)) if lows else ()):
            plans = Field(right.left, foot.top + PAD, field.right, field.top)
            rows = self.sheet.grid(self.way, plans.width, plans.height)
            if rows is not None:
                room = Field(left.left, low.top, left.right, field.top)
                corner = (low if self.table_left else foot).table
                words = (low if self.notes_left else foot).notes
                score = self.sheet.merit(self.spot, rows)
                yield Trial(room, self.spot, plans, rows, corner, self.setting, words, score, self)

    def _feet(self, column: Field, block: Field | None, on_left: bool) -> Iterator[Foot]:
        table = self.sheet.contents.table if self.table_left == on_left else None
        words = self.sheet.contents.notes if self.notes_left == on_left else None
        return feet(column, block, table, self.setting if table is not None else None, words)

    def even_out(self, found: Trial) -> Trial:
        """Share out what the right half has too much of, if the composition stays as good."""
        assert found.grid is not None and found.plans is not None  # halves have both
        own, others = self.spot.box.width, found.grid.size[0]
        wide = own + (found.plans.width - others) * own / (own + others)
        even = max(self.trials(wide), key=lambda trial: trial.score, default=found)
        return even if even.score >= found.score else found
