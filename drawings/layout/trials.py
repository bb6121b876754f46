"""Trials of a composition: the ways to stand the figures of one sheet, and the best of them (варианты компоновки)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import product
from typing import NamedTuple

from drawings.layout.footing import PAD, Foot, Notes, feet
from drawings.layout.grid import Grid, Rows, arrangements, grid
from drawings.layout.picture import Picture, Spot
from drawings.layout.value_table import Setting, Table
from drawings.page.page import Field, Page

FOREMOST = 1.5  # the plan of positions is doubled though all the others are halved
HALF = 0.45  # of the sheet's width or height that the plan of positions takes at least: about half, by custom


@dataclass(frozen=True)
class Content:
    """What a sheet must show: the plan of positions, the plans of some positions, the table, the notes."""

    main: Picture | None
    velocities: tuple[Picture, ...]
    accelerations: tuple[Picture, ...]
    table: Table | None
    notes: Notes | None

    def part(self, positions: slice, rows: slice | None) -> Content:
        """Give what a following sheet shows: the plans of some positions and their values."""
        table = self.table.of(positions).part(rows) if self.table is not None and rows is not None else None
        return Content(None, self.velocities[positions], self.accelerations[positions], table, None)


class Trial(NamedTuple):
    """A way to compose one sheet: the rooms of the plan of positions and of the others, and what fills them."""

    room: Field
    spot: Spot | None
    plans: Field | None
    grid: Grid | None
    table: complex | None
    setting: Setting | None
    notes: Field | None
    halves: Halves | None = None

    @property
    def score(self) -> float:
        """How good it is: large figures, the plan of positions counting more than all others together."""
        return _merit(self.spot, self.grid)


def _merit(spot: Spot | None, plans: Grid | None) -> float:
    sizes = plans.drawn if plans is not None else []
    others = sum(map(math.log, sizes)) / len(sizes) if sizes else 0.0
    return others + (FOREMOST * math.log(max(spot.box.width, spot.box.height)) if spot is not None else 0.0)


def room_of(page: Page) -> Field:
    """Give the field that figures may fill: inside the frame, beside or under what else the standard has there."""
    room = page.field
    for place in page.taken:
        if place != page.block and place.width >= place.height:
            room = room._replace(top=min(room.top, place.bottom))
        elif place != page.block:
            room = room._replace(right=min(room.right, place.left))
    return room.inset(PAD)


@dataclass(frozen=True)
class Sheet:
    """A sheet to be composed: what it shows, on which paper."""

    content: Content
    page: Page
    tried: dict[tuple[int, int, int], Grid | None] = field(default_factory=dict)  # grids, by way and tenths of mm

    @property
    def field(self) -> Field:
        """The field that figures may fill: inside the frame, beside or under what else the standard has there."""
        return room_of(self.page)

    def best(self, legible: bool = True) -> Trial | None:
        """Find the best composition, whose plans are all drawn large enough for their letters if that is asked."""
        content, room = self.content, self.field
        settings = content.table.settings() if content.table is not None else [None]
        ladders = [
            [one.ladder(room.width, room.height, self.page.standard) for one in plans]
            for plans in (content.velocities, content.accelerations)
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
        return best if best is None or best.halves is None else best.halves.evened(best)

    def _spots(self) -> list[Spot | None]:
        """Give the plan of positions at the largest scale that fits, and smaller ones that still fill half a sheet."""
        if self.content.main is None:
            return [None]
        room = self.field
        rungs = self.content.main.ladder(room.width, room.height, self.page.standard).rungs
        large = [rung for rung in rungs if max(rung.wide / room.width, rung.high / room.height) >= HALF]
        return [Spot(Field(0.0, 0.0, rung.wide, rung.high), rung.scale) for rung in large or rungs[:1]]

    def _bound(self, spot: Spot | None, way: Rows | None) -> float:
        """Give what no trial can exceed: the plans in all the room that the plan of positions leaves."""
        if spot is None or way is None:
            return math.inf
        beside = self.grid(way, self.field.width - spot.box.width, self.field.height)
        above = self.grid(way, self.field.width, self.field.height - spot.box.height)
        return max((_merit(spot, found) for found in (beside, above) if found is not None), default=-math.inf)

    def grid(self, way: Rows, width: float, height: float) -> Grid | None:
        """Fit rows of plans into a room, each way and room once."""
        key = id(way), int(10 * width), int(10 * height)
        if key not in self.tried:  # in whole tenths, so that what is found fits all rooms of the key
            self.tried[key] = grid(way, key[1] / 10, key[2] / 10) if width > 0 and height > 0 else None
        return self.tried[key]

    def _trials(self, spot: Spot | None, setting: Setting | None, way: Rows | None) -> Iterator[Trial]:
        if spot is not None and way is not None:
            sides = (True, False) if self.content.table is not None else (True,)
            for table_left, notes_left in product(sides, (True, False)):
                yield from Halves(self, spot, setting, way, table_left, notes_left).trials(spot.box.width)
        if spot is not None and way is None:
            yield from self._aside(spot, setting)
        yield from self._stacked(spot, setting, way)

    def _aside(self, spot: Spot, setting: Setting | None) -> Iterator[Trial]:
        """Stand the plan of positions alone on the left at full height, all else over the title block."""
        room, block, content = self.field, self.page.block, self.content
        left = Field(room.left, room.bottom, block.left - PAD, room.top)
        right = Field(block.left, room.bottom, block.right, room.top)
        if spot.box.width > left.width or spot.box.height > left.height:
            return
        for foot in feet(right, block, content.table, setting, content.notes):
            if foot.top <= room.top:
                yield Trial(left, spot, None, None, foot.table, setting, foot.notes)

    def _stacked(self, spot: Spot | None, setting: Setting | None, way: Rows | None) -> Iterator[Trial]:
        """Stand the plan of positions above the others, table and notes at the foot of the sheet."""
        room, block, content = self.field, self.page.block, self.content
        column = Field(room.left, room.bottom, block.right, room.top)
        high = spot.box.height if spot is not None else 0.0
        for foot in feet(column, block, content.table, setting, content.notes):
            free = room.top - foot.top - high - PAD
            found = self.grid(way, room.width, free) if way is not None else None
            if free < 0 or (way is not None and found is None):
                continue
            spare = (free - found.size[1]) / 2 if found is not None else free
            middle = room.top - high - spare
            plans = Field(room.left, foot.top + PAD, room.right, middle)
            main = Field(room.left, middle, room.right, room.top)
            yield Trial(main, spot, plans, found, foot.table, setting, foot.notes)


class Halves(NamedTuple):
    """The plan of positions on the left and the others on the right, table and notes at the foot of either."""

    sheet: Sheet
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
            found = self.sheet.grid(self.way, plans.width, plans.height)
            if found is not None:
                room = Field(left.left, low.top, left.right, field.top)
                corner = (low if self.table_left else foot).table
                said = (low if self.notes_left else foot).notes
                yield Trial(room, self.spot, plans, found, corner, self.setting, said, self)

    def _feet(self, column: Field, block: Field | None, on_left: bool) -> Iterator[Foot]:
        table = self.sheet.content.table if self.table_left == on_left else None
        said = self.sheet.content.notes if self.notes_left == on_left else None
        return feet(column, block, table, self.setting if table is not None else None, said)

    def evened(self, found: Trial) -> Trial:
        """Share out what the right half has too much of, if the composition stays as good."""
        assert found.grid is not None and found.plans is not None  # halves have both
        own, others = self.spot.box.width, found.grid.size[0]
        wide = own + (found.plans.width - others) * own / (own + others)
        even = max(self.trials(wide), key=lambda trial: trial.score, default=found)
        return even if even.score >= found.score else found
