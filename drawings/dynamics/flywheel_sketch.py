"""The flywheel's sketch: the wheel cut along its shaft and seen from the side, its rim dimensioned (эскиз маховика).

The rim is to scale; shaft, hub and web are drawn in the proportions of usual wheels.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import partial
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.layout.picture import LetteredFigure, Margins, Picture, Place, Spot, picture
from drawings.lettering.lettering import text_width
from drawings.lettering.words import Slot, joined, telling
from drawings.page.page import Drafting, Scale
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Line, Polyline, Stroke, Text
from drawings.symbols.figure import Dimension, Subject, around, explained, heading
from drawings.symbols.symbols import fit, hatching
from plans.model.dynamics import Wheel

NAME = "flywheel_sketch"
MARGINS = Margins(2.0, 2.4, 3.4)  # paper around it for letters, in their sizes
LETTERS, MOST = 16.0, 32.0  # it is drawn at least so many letters large, and at most
BORE, HUB = 0.12, 0.24  # of the mean diameter: shaft, hub
WEB = 0.35  # of the rim's breadth: the web
WITHIN = 0.7  # of the rim's inner diameter: the hub at most
APART = 0.3  # of the mean diameter: between the two views
AXIS = 5.0  # mm that an axis goes past the wheel
OFF = 9.0  # mm from the wheel to a dimension line
ABOVE = 1.2  # mm from a dimension line to its letters
DIGITS = 4
SYMBOL, UNIT = "l", "m"


class Outlines(NamedTuple):
    """The outlines of a wheel, true: the cut has its middle at 0, the side view is beside it."""

    rim: Wheel

    @property
    def outer(self) -> float:
        """The outer radius, m."""
        return self.rim.outer / 2

    @property
    def inner(self) -> float:
        """The inner radius of the rim, m."""
        return self.rim.inner / 2

    @property
    def hub(self) -> float:
        """The radius of the hub, m."""
        return min(HUB * self.rim.diameter / 2, WITHIN * self.inner)

    @property
    def bore(self) -> float:
        """The radius of the shaft, m."""
        return self.hub * BORE / HUB

    @property
    def long(self) -> float:
        """Half the length of the hub, m."""
        return max(self.rim.breadth / 2, self.hub)

    @property
    def side(self) -> complex:
        """The middle of the side view, m."""
        return complex(max(self.long, self.rim.breadth / 2) + APART * self.rim.diameter + self.outer)

    @property
    def half(self) -> tuple[complex, ...]:
        """The outline of the upper half of the cut, m, from the bore up."""
        web, broad = WEB * self.rim.breadth / 2, self.rim.breadth / 2
        right = [(self.long, self.bore), (self.long, self.hub), (web, self.hub)]
        right += [(web, self.inner), (broad, self.inner), (broad, self.outer)]
        return tuple(complex(x, y) for x, y in [*right, *((-x, y) for x, y in reversed(right))])

    @property
    def corners(self) -> tuple[complex, complex]:
        """The lower left and the upper right corner of both views, m."""
        left = -max(self.long, self.rim.breadth / 2)
        return complex(left, -self.outer), self.side + complex(self.outer, self.outer)


def measure(rim: Wheel, drafting: Drafting) -> Picture:
    """Measure the room that the sketch needs: both views, the dimensions beside them."""
    hand = drafting.hand
    first, *further = said(rim, drafting)
    title = max(text_width(Text(0j, drafting.word("flywheel"), hand.title)), text_width(Text(0j, first)))
    far, corners = OFF * hand.symbol, Outlines(rim).corners
    margins = around(MARGINS, hand, 2 * far, AXIS * hand.symbol, far + hand.text)
    room = picture(NAME, corners, (SYMBOL, UNIT), margins, title, LETTERS * hand.letter)
    return explained(room._replace(most=MOST * hand.letter), further, hand)


def draw(rim: Wheel, room: Picture, spot: Spot, drafting: Drafting) -> LetteredFigure:
    """Draw the sketch in its spot: the cut hatched, the side view, axes, sizes; mass and inertia under its scale."""
    place, hand, wheel = room.place(*spot), drafting.hand, Outlines(rim)
    title, scale = drafting.word("flywheel"), drafting.scale(spot.scale)
    told = telling(NAME, heading(spot.box, title, scale, hand, *said(rim, drafting)))
    sizes = tuple(_sizes(wheel, place, drafting))
    marks = (
        _marked(line, letter, value, spot.scale, hand) for line, (letter, value) in zip(sizes, true(rim), strict=True)
    )
    lines = (told, *_cut(wheel, place, hand), *_side(wheel, place, hand), *_axes(wheel, place, hand), *marks)
    return LetteredFigure(NAME, lines, partial(_letters, sizes, hand))


def _letters(sizes: Sequence[Dimension], hand: Hand, labels: Labels) -> Iterator[Stroke]:
    """Letter the sizes along their lines."""
    for line in sizes:
        side = math.pi / 2 if line.off.imag else math.pi
        yield telling(NAME, labels.along(*line.lines[0], line.letter, hand.number, ABOVE, side))


def true(rim: Wheel) -> tuple[tuple[str, complex], ...]:
    """Give the sizes that are dimensioned by their letters, m: mean diameter, thickness, breadth."""
    return ("D", 1j * rim.diameter), ("t", 1j * rim.thickness), ("b", complex(rim.breadth))


def said(rim: Wheel, drafting: Drafting) -> list[str]:
    """Say the mass of the rim and its moment of inertia on its own shaft, and what both shafts have to do."""
    own = drafting.phrase("rim mass", mass=Slot("m", rim.mass, DIGITS), inertia=Slot("J", rim.inertia, DIGITS))
    return [own, *on_its_shaft(rim, drafting)]


def on_its_shaft(rim: Wheel, drafting: Drafting) -> list[str]:
    """Say how fast the flywheel's shaft turns, and its inertia reduced to the crank, where that is another shaft."""
    if rim.ratio == 1:
        return []
    reduced = Slot("J_{fly}", rim.inertia * rim.ratio**2, DIGITS)
    return [drafting.phrase("rim geared", ratio=Slot("u", rim.ratio, DIGITS), reduced=reduced)]


def size(letter: str, metres: float, drafting: Drafting) -> str:
    """Letter a size in millimetres of the machine."""
    return joined("", (f"{letter} = ", drafting.slot(Slot(letter, 1000 * metres, DIGITS))))


def _sizes(wheel: Outlines, place: Place, drafting: Drafting) -> Iterator[Dimension]:
    """Dimension the mean diameter left of the cut, the thickness right of it, the breadth above it."""
    rim, far = wheel.rim, OFF * drafting.hand.symbol
    broad, reach = rim.breadth / 2, place.length(wheel.long)
    ends = (
        (-1j * rim.diameter / 2, 1j * rim.diameter / 2, complex(-reach - far)),
        (complex(broad, wheel.inner), complex(broad, wheel.outer), complex(far)),
        (complex(-broad, wheel.outer), complex(broad, wheel.outer), 1j * far),
    )
    for (letter, value), (start, end, off) in zip(true(rim), ends, strict=True):
        yield Dimension(size(letter, abs(value), drafting), place.on(start), place.on(end), off)


def _marked(dimension: Dimension, letter: str, value: complex, scale: Scale, hand: Hand) -> Group:
    """Draw a dimension; its line can be measured."""
    data = Subject(NAME, SYMBOL, None).data("vector", letter, value, scale)
    return Group(dimension.draw(hand), "", data, dimension.letter)


def _cut(wheel: Outlines, place: Place, hand: Hand) -> Iterator[Stroke]:
    upper = [place.on(corner) for corner in wheel.half]
    lower = [place.on(corner.conjugate()) for corner in wheel.half]
    for outline in (upper, lower):
        yield Group(tuple(hatching(outline, hand)))
        yield Polyline(tuple(outline), True, hand.result)
    for x in (-1, 1):  # the bore's and the hub's ends beyond the cut
        end = x * wheel.long
        yield Line(place.on(complex(end, wheel.bore)), place.on(complex(end, -wheel.bore)), hand.result)


def _side(wheel: Outlines, place: Place, hand: Hand) -> Iterator[Stroke]:
    middle = place.on(wheel.side)
    for radius in (wheel.outer, wheel.inner, wheel.hub, wheel.bore):
        yield Circle(middle, place.length(radius), hand.result)
    mean = place.length(wheel.rim.diameter / 2)
    yield Circle(middle, mean, fit(hand.axis, 2 * math.pi * mean, True))


def _axes(wheel: Outlines, place: Place, hand: Hand) -> Iterator[Stroke]:
    """Draw the axis of the shaft through both views, and the upright one of the side view."""
    past = AXIS * hand.symbol
    across, up = place.length(wheel.long) + past, place.length(wheel.outer) + past
    middle = place.on(wheel.side)
    for start, end in (
        (place.on(0j) - across, place.on(0j) + across),
        (middle - up, middle + up),
        (middle - 1j * up, middle + 1j * up),
    ):
        yield Line(start, end, fit(hand.axis, abs(end - start)))
