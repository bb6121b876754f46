"""Columns of pictures and lettering side by side, each picture at the largest standard scale that fits (столбцы)."""

from __future__ import annotations

import heapq
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

from drawings.layout.block import TextBlock
from drawings.layout.grid import GAP
from drawings.layout.picture import Ladder, Rung, Spot
from drawings.page.page import Field

UNDER = 8.0  # mm from a picture to the lettering that belongs to it

FOOT = 0.6  # share of the gap between two pictures that is left below the last one


Part: TypeAlias = Ladder | TextBlock
Column: TypeAlias = tuple[Part, ...]


class Zone(NamedTuple):
    """Columns over one foot of a sheet: the least width of the zone, and the height of its columns, mm."""

    columns: tuple[Column, ...]
    least: float
    height: float


@dataclass(frozen=True)
class Filled:
    """Zones beside each other, with a rung for each picture (None for lettering)."""

    zones: tuple[Zone, ...]
    rungs: tuple[tuple[tuple[Rung | None, ...], ...], ...]

    @property
    def score(self) -> float:
        """How good it is: the harmonic mean of the sizes of its pictures, mm, to which the small ones matter most."""
        every = (pair for zone, own in zip(self.zones, self.rungs, strict=True) for pair in _pairs(zone, own))
        sizes = [rung.extent / one.weight for one, rung in every if rung.extent > 0]
        return len(sizes) / sum(1 / size for size in sizes) if sizes else 0.0

    def stand(self, room: Field, floors: Sequence[float]) -> tuple[dict[str, Spot], dict[str, Field]]:
        """Stand the columns in a room, each zone on its floor: spare paper is shared, first headings are level."""
        spots: dict[str, Spot] = {}
        blocks: dict[str, Field] = {}
        places = [(one, floor) for one, floor in zip(self._fields(room), floors, strict=True)]
        racks = [
            _Rack(column, rungs, x, width, floor)
            for (zone, rungs_of), (field, floor) in zip(zip(self.zones, self.rungs, strict=True), places, strict=True)
            for column, rungs, (x, width) in zip(zone.columns, rungs_of, _across(zone, rungs_of, field), strict=True)
        ]
        level = min((rack.spare(room.top) / (len(rack.parts) + 1) for rack in racks), default=0.0)
        for rack in racks:
            for one, rung, box in rack.stand(room.top, level):
                if rung is None:
                    blocks[one.name] = box
                else:
                    spots[one.name] = Spot(box, rung.scale)
        return spots, blocks

    def _fields(self, room: Field) -> list[Field]:
        """Give each zone its width: what it needs, and its share of what is left over."""
        needs = [_needed(zone, rungs) for zone, rungs in zip(self.zones, self.rungs, strict=True)]
        spare = room.width - sum(needs) - _gaps(needs)
        counts = [len(zone.columns) for zone in self.zones]
        fields, left = [], room.left
        for need, count in zip(needs, counts, strict=True):
            right = left + need + (spare * count / sum(counts) if sum(counts) else 0.0)
            fields.append(Field(left, room.bottom, right, room.top))
            left = right + GAP
        return fields


class _Rack(NamedTuple):
    """A column at its scales: its middle and its width on the sheet, and the floor that it stands on."""

    parts: Column
    rungs: tuple[Rung | None, ...]
    middle: float
    width: float
    floor: float

    @property
    def sizes(self) -> list[tuple[float, float]]:
        return [_size(part, rung, self.width) for part, rung in zip(self.parts, self.rungs, strict=True)]

    def spare(self, top: float) -> float:
        """Give the height that is left over, mm."""
        return top - self.floor - sum(high for _, high in self.sizes)

    def stand(self, top: float, level: float) -> Iterator[tuple[Part, Rung | None, Field]]:
        """Give each part its box, the first one some millimetres under the top, lettering close under its picture."""
        under = [isinstance(part, TextBlock) and k > 0 for k, part in enumerate(self.parts)]
        spare = self.spare(top) - level
        close = min(UNDER, spare / len(self.parts))
        up = (spare - close * sum(under)) / (len(self.parts) - sum(under) - 1 + FOOT)
        top -= level
        for k, (part, rung, (wide, high)) in enumerate(zip(self.parts, self.rungs, self.sizes, strict=True)):
            top -= close if under[k] else up if k > 0 else 0.0
            yield part, rung, Field(self.middle - wide / 2, top - high, self.middle + wide / 2, top)
            top -= high


def fill(zones: tuple[Zone, ...], width: float, legible: bool = True) -> Filled | None:
    """Fit zones of columns into a width: from the least legible scales on, the smallest picture is enlarged first."""
    growth = _start(zones, legible)
    if growth is None or not growth.fits(width):
        return None
    places = [(c, i) for c, column in enumerate(growth.columns) for i, part in enumerate(column) if _ladder(part)]
    growing = [(growth.extent(c, i), c, i) for c, i in places]
    heapq.heapify(growing)
    while growing:
        _, c, i = growing[0]
        if growth.enlarge(c, i, width):
            heapq.heapreplace(growing, (growth.extent(c, i), c, i))
        else:
            heapq.heappop(growing)
    return growth.fill()


@dataclass
class _Growth:
    """The scales of all pictures while they grow, with the sizes of the columns and the widths of the zones."""

    zones: tuple[Zone, ...]
    columns: list[Column]
    zone_of: list[int]
    steps: list[list[int]]
    sizes: list[tuple[float, float]]
    wide: list[float]

    def extent(self, c: int, i: int) -> float:
        part = self.columns[c][i]
        assert isinstance(part, Ladder)
        return part.rungs[self.steps[c][i]].extent / part.weight

    def fits(self, width: float) -> bool:
        """Tell whether all columns fit their zones, and the zones the width."""
        if any(size[1] > self.zones[z].height for size, z in zip(self.sizes, self.zone_of, strict=True)):
            return False
        return self._across() <= width

    def _across(self) -> float:
        return sum([max(own, zone.least) for own, zone in zip(self.wide, self.zones, strict=True)], _gaps(self.zones))

    def enlarge(self, c: int, i: int, width: float) -> bool:
        """Draw a picture at the next larger scale if all still fits."""
        if self.steps[c][i] == 0:
            return False
        kept, z = self.sizes[c], self.zone_of[c]
        self.steps[c][i] -= 1
        size = _measured(self.columns[c], self.steps[c])
        if size[1] <= self.zones[z].height:
            self.wide[z] += size[0] - kept[0]
            if self._across() <= width:
                self.sizes[c] = size
                return True
            self.wide[z] += kept[0] - size[0]
        self.steps[c][i] += 1
        return False

    def fill(self) -> Filled:
        rungs: list[list[tuple[Rung | None, ...]]] = [[] for _ in self.zones]
        for column, steps, z in zip(self.columns, self.steps, self.zone_of, strict=True):
            rungs[z].append(_rungs(column, steps))
        return Filled(self.zones, tuple(tuple(zone) for zone in rungs))


def _start(zones: tuple[Zone, ...], legible: bool) -> _Growth | None:
    """Begin with the smallest scales at which the pictures can be read, or with the smallest of all."""
    columns = [column for zone in zones for column in zone.columns]
    steps = [[_least(part, legible) for part in column] for column in columns]
    if any(step < 0 for own in steps for step in own):
        return None
    zone_of = [z for z, zone in enumerate(zones) for _ in zone.columns]
    sizes = [_measured(*one) for one in zip(columns, steps, strict=True)]
    wide = [_gaps(zone.columns) for zone in zones]
    for (own, _), z in zip(sizes, zone_of, strict=True):
        wide[z] += own
    return _Growth(zones, columns, zone_of, steps, sizes, wide)


def _least(part: Part, legible: bool) -> int:
    """Give the place of the smallest allowed scale in a ladder; -1 where it has none."""
    if isinstance(part, TextBlock):
        return 0
    allowed = [k for k, rung in enumerate(part.rungs) if not legible or rung.extent >= part.least or rung.extent == 0]
    return allowed[-1] if allowed else -1


def _gaps(beside: Sequence[object]) -> float:
    return GAP * max(len(beside) - 1, 0)


def _ladder(part: Part) -> bool:
    return isinstance(part, Ladder)


def _rungs(column: Column, steps: Sequence[int]) -> tuple[Rung | None, ...]:
    return tuple(
        part.rungs[step] if isinstance(part, Ladder) else None for part, step in zip(column, steps, strict=True)
    )


def _measured(column: Column, steps: Sequence[int]) -> tuple[float, float]:
    """Give width and height of a column; lettering is broken at the width that its pictures need."""
    wide, high, blocks = 0.0, -GAP, []
    for part, step in zip(column, steps, strict=True):
        if isinstance(part, Ladder):
            rung = part.rungs[step]
            wide, high = max(wide, rung.wide), high + rung.high + GAP
        else:
            wide, high = max(wide, part.sizes[0][0]), high + GAP
            blocks.append(part)
    return wide, high + sum(block.size(wide)[1] for block in blocks)


def _size(part: Part, rung: Rung | None, width: float) -> tuple[float, float]:
    if isinstance(part, TextBlock):
        return part.size(width)
    assert rung is not None  # every picture has a scale
    return rung.wide, rung.high


def _pairs(zone: Zone, rungs: Sequence[Sequence[Rung | None]]) -> Iterator[tuple[Ladder, Rung]]:
    """Give the pictures of a zone with their scales."""
    for column, own in zip(zone.columns, rungs, strict=True):
        for part, rung in zip(column, own, strict=True):
            if isinstance(part, Ladder) and rung is not None:
                yield part, rung


def _widths(zone: Zone, rungs: Sequence[Sequence[Rung | None]]) -> list[float]:
    return [
        max(part.sizes[0][0] if isinstance(part, TextBlock) else rung.wide if rung else 0.0 for part, rung in pairs)
        for pairs in (list(zip(column, own, strict=True)) for column, own in zip(zone.columns, rungs, strict=True))
    ]


def _needed(zone: Zone, rungs: Sequence[Sequence[Rung | None]]) -> float:
    widths = _widths(zone, rungs)
    return max(sum(widths) + _gaps(widths), zone.least)


def _across(zone: Zone, rungs: Sequence[Sequence[Rung | None]], field: Field) -> list[tuple[float, float]]:
    """Give middle and width of each column of a zone: columns share what is left over."""
    widths = _widths(zone, rungs)
    across = (field.width - sum(widths)) / (len(widths) + 1)
    places, left = [], field.left + across
    for width in widths:
        places.append((left + width / 2, width))
        left += width + across
    return places
