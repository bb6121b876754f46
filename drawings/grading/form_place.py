"""The places of a form: a plan's with its pole and corners, wherever an editor has put their lines (места бланка)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.checks.hold import off
from drawings.grading.asked import Place
from drawings.grading.onlooker import JOINED
from drawings.lettering.lettering import bounds
from drawings.paper.strokes import Circle, Group, Leaf, Line, Text
from drawings.paper.walk import flat, groups
from drawings.reading.pathdata import number, pair

KIND = "place"  # of the data of a group that is the place of a figure
BESIDE = 25.0  # mm: arrows that lie farther from a place are not of it
CORNERS = 8  # lines, two to a corner, with which such a group begins
CORNER, FLAT = 8.0, 0.1  # mm: no line of a corner is longer, nor out of its way by more


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
    for group in groups(leaf.groups):
        if group.data.get("kind") != KIND:
            continue
        inner = (mark for mark in groups(group.strokes) if mark.data.get("kind") == "pole")
        mark = next(inner, poles.get(_of(group.data)))
        circles = (stroke.centre for stroke in (mark.strokes if mark else ()) if isinstance(stroke, Circle))
        pole = next(circles, None)
        lines = tuple(stroke for stroke in group.strokes if isinstance(stroke, Line))[:CORNERS]
        corners = _box(lines) if lines else None if pole is None else _about(pole, leaf)
        if corners is not None:
            scale, value = number(group.data.get("scale", "1")), pair((mark or group).data.get("value", "0 0"))
            yield FormPlace(_of((mark or group).data), pole, *corners, scale, value)


def _of(data: Mapping[str, str]) -> Place:
    return data.get("plan", ""), _position(data.get("position", ""))


def _box(lines: tuple[Line, ...]) -> tuple[complex, complex]:
    left, low, right, high = bounds(Group(lines))
    return complex(left, low), complex(right, high)


def _about(pole: complex, leaf: Leaf) -> tuple[complex, complex]:
    """Give the corners about a pole that an editor has taken out of their group: of each kind the nearest."""
    short = [line for line in flat(leaf.groups) if isinstance(line, Line) and abs(line.end - line.start) <= CORNER]
    ends = [(a, b) for line in short for a, b in ((line.start, line.end), (line.end, line.start))]
    spots = [
        spot
        for spot, other in ends if abs((other - spot).imag) < FLAT
        for at, up in ends if abs((up - at).real) < FLAT and abs(at - spot) < FLAT
    ]  # fmt: skip
    low = [spot for spot in spots if spot.real <= pole.real and spot.imag <= pole.imag]
    high = [spot for spot in spots if spot.real >= pole.real and spot.imag >= pole.imag]
    boxes = [(one, other) for one in low for other in high if _is_boxed(one, other, spots)]
    return min(boxes, key=lambda box: abs(box[1] - box[0]), default=(pole, pole))


def _is_boxed(low: complex, high: complex, spots: Sequence[complex]) -> bool:
    """Tell whether two corners have the other two of their box."""
    others = complex(low.real, high.imag), complex(high.real, low.imag)
    return low.real < high.real and all(any(abs(spot - other) < FLAT for spot in spots) for other in others)


def _position(text: str) -> int | None:
    return int(text) if text.isascii() and text.removeprefix("-").isdigit() else None
