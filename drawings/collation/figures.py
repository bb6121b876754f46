"""Figures: what the parts of a sheet are called, where they stand and at which scale (изображения листа)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

from drawings.collation.items import Item, is_heading, items
from drawings.collation.spots import middle, spots
from drawings.paper.strokes import Group, Leaf, Text
from drawings.paper.walk import groups
from plans.words.words import Message, message

STILL = ("frame", "corners", "title-block", "notes")  # what every sheet has, by the names of its groups


class Scale(NamedTuple):
    """How much a millimetre of a figure stands for, and of what."""

    size: float
    unit: str


class Box(NamedTuple):
    """The rectangle that a figure takes, mm."""

    left: float
    bottom: float
    right: float
    top: float

    def off(self, spot: complex) -> tuple[float, float]:
        """Give how far outside a place lies, and the area, by which the smaller one of two figures is chosen."""
        across = max(self.left - spot.real, 0.0, spot.real - self.right)
        up = max(self.bottom - spot.imag, 0.0, spot.imag - self.top)
        return math.hypot(across, up), (self.right - self.left) * (self.top - self.bottom)


class Figures:
    """The figures of a sheet as it must be: groups at the top that have a name."""

    def __init__(self, leaf: Leaf) -> None:
        self.leaf = leaf

    @cached_property
    def named(self) -> dict[str, Group]:
        """The groups with a name."""
        return {group.name: group for group in self.leaf.groups if group.name}

    @cached_property
    def boxes(self) -> dict[str, Box]:
        """The rectangles that figures take, without the frame, which is around all of them."""
        own: dict[str, list[complex]] = {}
        for item in items(self.leaf):
            if item.home.figure and item.home.figure != STILL[0] and item.home.figure != STILL[1]:
                own.setdefault(item.home.figure, []).extend(spots(item.stroke))
        return {name: _box(places) for name, places in own.items()}

    def of(self, item: Item) -> str:
        """Name the figure that an item is of: its own group, or else the one where it stands."""
        if item.home.figure or not self.boxes:
            return item.home.figure
        spot = middle(item.stroke)
        return min(self.boxes, key=lambda name: self.boxes[name].off(spot))

    def scale(self, item: Item) -> Scale | None:
        """Give the scale at which an item is drawn: its own mark's, or the first that is stated in its figure."""
        group = self.named.get(self.of(item))
        marks = [item.home.mark, *(one.data for one in groups((group,) if group is not None else ()))]
        return next(
            (found for data in marks if (found := _scale(data.get("scale"), data.get("unit"))) is not None), None
        )

    def called(self, name: str) -> Message:
        """Name a figure for a message: by its heading, or by what it is."""
        if name in STILL:
            return message(f"exhibit.{name}")
        if name.rpartition("-")[0] in self.leaf.metadata.get("rows", {}):
            return message("exhibit.table", name=name)
        heading = self._heading(name)
        return message("exhibit.headed", title=heading) if heading else message("exhibit.other", name=name)

    def _heading(self, name: str) -> str:
        """Read the heading of a figure: the first group in it, or a group without a name before it."""
        for place, group in enumerate(self.leaf.groups):
            if group.name == name:
                before = self.leaf.groups[place - 1] if place and is_heading(self.leaf.groups[place - 1]) else None
                return next(_headings(group), "") or next(_headings(before), "")
        return ""


def _headings(group: Group | None) -> Iterator[str]:
    if group is None:
        return
    first = group if is_heading(group) else next(iter(group.strokes), None)
    if isinstance(first, Group) and is_heading(first):
        yield from (text.plain for text in first.strokes if isinstance(text, Text))


def _box(places: list[complex]) -> Box:
    across, up = [spot.real for spot in places], [spot.imag for spot in places]
    return Box(min(across), min(up), max(across), max(up))


def _scale(size: str | None, unit: str | None) -> Scale | None:
    """Read a scale that a mark states; of a stranger's that is no number there is none."""
    try:
        found = Scale(float(size or ""), unit or "")
    except ValueError:
        return None
    return found if math.isfinite(found.size) and found.size > 0 else None
