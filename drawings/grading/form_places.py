"""Places of a form: which plan was to be drawn where, by the data of its poles and corners (места на бланке)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.checks.letters import off
from drawings.grading.asked import Place
from drawings.grading.segments import JOINED
from drawings.lettering.extent import bounds
from drawings.paper.strokes import Circle, Group, Leaf, Line, Text
from drawings.paper.walk import groups

KIND = "place"  # of the data of a group that is the place of a figure
CORNERS = 8  # lines, two to a corner, with which such a group begins


class FormPlace(NamedTuple):
    """The place of a plan on a form: its pole, if it has one, and its corners, mm."""

    plan: Place
    pole: complex | None
    low: complex
    high: complex

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
        within = [
            self.low.real <= one.real <= self.high.real and self.low.imag <= one.imag <= self.high.imag for one in spots
        ]
        return 2 * sum(within) > len(spots)


def form_places(leaf: Leaf) -> tuple[FormPlace, ...]:
    """Give the places of a form; none of a sheet that is none."""
    return tuple(_places(leaf))


def place_of(spots: Sequence[complex], places: Sequence[FormPlace]) -> FormPlace | None:
    """Give the place in which arrows were drawn: at whose pole one of their ends lies, else within whose corners."""
    begun = [(min(abs(one - place.pole) for one in spots), place) for place in places if place.pole is not None]
    away, nearest = min(begun, key=lambda one: one[0], default=(JOINED + 1.0, None))
    if away <= JOINED:
        return nearest
    return next((place for place in places if place.holds(spots)), None)


def nearest(spot: complex, places: Sequence[FormPlace]) -> FormPlace | None:
    """Give the place that a spot lies in, or else that which is nearest to it."""
    return min(places, key=lambda one: one.off(spot), default=None)


def _places(leaf: Leaf) -> Iterator[FormPlace]:
    for group in groups(leaf.groups):
        lines = tuple(one for one in group.strokes if isinstance(one, Line))[:CORNERS]
        if group.data.get("kind") != KIND or not lines:
            continue
        left, low, right, high = bounds(Group(lines))
        poles = [one for one in groups(group.strokes) if one.data.get("kind") == "pole"]
        own = (poles[0] if poles else group).data
        plan = own.get("plan", ""), _position(own.get("position", ""))
        pole = next((one.centre for one in (poles[0].strokes if poles else ()) if isinstance(one, Circle)), None)
        yield FormPlace(plan, pole, complex(left, low), complex(right, high))


def _position(text: str) -> int | None:
    return int(text) if text.isascii() and text.removeprefix("-").isdigit() else None
