"""The places of a form: a plan's with its pole and corners, wherever an editor has put their lines (места бланка)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.checks.hold import off
from drawings.grading.asked import Place
from drawings.grading.onlooker import JOINED
from drawings.lettering.lettering import bounds
from drawings.paper.strokes import Circle, Group, Leaf, Line, Stroke, Text
from drawings.paper.walk import flat, groups
from drawings.reading.pathdata import number, pair

KIND = "place"  # of the data of a group that is the place of a figure
BESIDE = 25.0  # mm: arrows that lie farther from a place are not of it
CORNERS = 8  # lines, two to a corner, with which such a group begins
FLAT = 0.1  # mm: how far lines of a corner may be off


class FormPlace(NamedTuple):
    """The place of a plan on a form: its pole, if it has one, and its corners, mm; its scale, true units a mm."""

    plan: Place
    pole: complex | None
    low: complex
    high: complex
    scale: float = 1.0
    value: complex = 0j  # the true coordinates of its pole

    def away(self, text: Text) -> float:
        """Give how far a text is from the middle of its upper edge, over which its heading stands; none within it."""
        left, low, right, high = box = bounds(text)
        within = self.holds([complex(left + right, low + high) / 2])
        return 0.0 if within else off(complex((self.low.real + self.high.real) / 2, self.high.imag), box)

    def off(self, spot: complex) -> float:
        """Give how far a spot is from the place, mm; none within it."""
        return off(spot, (self.low.real, self.low.imag, self.high.real, self.high.imag))

    def holds(self, spots: Sequence[complex]) -> bool:
        """Tell whether most of some spots lie within its corners."""
        return 2 * sum(self.off(spot) == 0 for spot in spots) > len(spots)


def form_places(leaf: Leaf) -> tuple[FormPlace, ...]:
    """Give the places of a form; none of a sheet that is none."""
    return tuple(_places(leaf))


def place_of(spots: Sequence[complex], places: Sequence[FormPlace]) -> FormPlace | None:
    """Give the place in which arrows were drawn: at whose pole one ends, else within whose corners, or hard by them."""
    begun = [(min(abs(spot - place.pole) for spot in spots), place) for place in places if place.pole is not None]
    away, nearest = min(begun, key=lambda row: row[0], default=(JOINED + 1.0, None))
    if away <= JOINED:
        return nearest
    middle = sum(spots) / len(spots)
    beside = min(places, key=lambda place: (not place.holds(spots), place.off(middle)), default=None)
    return beside if beside is not None and (beside.holds(spots) or beside.off(middle) <= BESIDE) else None


def _places(leaf: Leaf) -> Iterator[FormPlace]:
    poles = {_of(group.data): group for group in groups(leaf.groups) if group.data.get("kind") == "pole"}
    found = [group for group in groups(leaf.groups) if group.data.get("kind") == KIND]
    boxes = [straight_lines(group.strokes)[:CORNERS] for group in found]
    loose = list(_loose(straight_lines(flat(leaf.groups)))) if not all(boxes) else []
    again = iter(loose if len(loose) == boxes.count([]) else ())  # an editor has taken them out, and kept their order
    for group, own in zip(found, boxes, strict=True):
        inner = (mark for mark in groups(group.strokes) if mark.data.get("kind") == "pole")
        mark = next(inner, poles.get(_of(group.data)))
        circles = (stroke.centre for stroke in (mark.strokes if mark else ()) if isinstance(stroke, Circle))
        lines = own or next(again, [])
        if lines:
            left, low, right, high = bounds(Group(tuple(lines)))
            scale, value = number(group.data.get("scale", "1")), pair((mark or group).data.get("value", "0 0"))
            corners = complex(left, low), complex(right, high)
            yield FormPlace(_of((mark or group).data), next(circles, None), *corners, scale, value)


def straight_lines(strokes: Iterable[Stroke]) -> list[Line]:
    """Give the straight lines among strokes."""
    return [stroke for stroke in strokes if isinstance(stroke, Line)]


def _loose(lines: Sequence[Line]) -> Iterator[list[Line]]:
    """Give the lines that mark the corners of a place: two of one length from each, one after another."""
    k = 0
    while k + CORNERS <= len(lines):
        eight = list(lines[k : k + CORNERS])
        long = [abs(line.end - line.start) for line in eight]
        paired = all(abs(one.start - other.start) <= FLAT for one, other in zip(eight[::2], eight[1::2], strict=True))
        marked = paired and max(long) - min(long) <= FLAT and len({line.start for line in eight[::2]}) > 1
        k += CORNERS if marked else 1
        if marked:
            yield eight


def _of(data: Mapping[str, str]) -> Place:
    text = data.get("position", "")
    return data.get("plan", ""), int(text) if text.isascii() and text.removeprefix("-").isdigit() else None
