"""Views of a shaft, along it and across it, with places along it dimensioned from one plane (виды вала)."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from typing import TypeAlias

from drawings.layout.picture import Place
from drawings.lettering.lettering import text_reach, text_width
from drawings.lettering.words import telling
from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Group, Line, Statement, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.figure import Subject, point
from drawings.symbols.symbols import ARROW_LENGTH, arrowhead, fit

SYMBOL, UNIT, QUANTITY = "l", "m", "r"
ORIGIN = "O"  # the letter of the axis, and of the plane that places are measured from
BESIDE = 1.0  # mm from a symbol to its letter
AXIS = 4.0  # mm that axes go past the outermost circle
SHAFT = 2.2  # mm, half the thickness of a shaft
END = 8.0  # mm that a shaft goes past what it bears
FIRST = 9.0  # mm from what a shaft bears to the first dimension
MOST = 9  # different places that are dimensioned: of more tables tell them
PAST = 1.5  # mm an extension line goes past the lowest arrow
ABOVE = 0.9  # mm from the dimension line to its number
TALL = 1.6  # sizes of a number with its index, and paper over it
TAIL = 8.0  # mm of a dimension line outside its extension lines, where its arrows stand outside


def square(reach: float) -> list[complex]:
    """Give the corners of the square about a circle about the shaft."""
    return [complex(x, y) for x in (-reach, reach) for y in (-reach, reach)]


def origin(plan: str, zero: complex, place: Place, circle: Circle, quantity: str = QUANTITY) -> Group:
    """Draw the place that a view is measured from."""
    return point(Subject(plan, quantity, None), ORIGIN, zero, place, circle, "pole")


def shaft(places: Collection[float], place: Place, hand: Hand) -> tuple[complex, complex, Line]:
    """Give the ends on paper of a shaft that bears something at places, and its axis."""
    first, last = (place.on(complex(end(places))) for end in (min, max))
    start, stop, past = first - END * hand.symbol, last + END * hand.symbol, 3 * hand.symbol
    return start, stop, Line(start - past, stop + past, fit(hand.axis, abs(stop - start) + 2 * past))


# A place that is dimensioned: where its extension line begins on paper, what its dimension says, and states.
Sized: TypeAlias = tuple[complex, str, Statement]


def dimensions(base: complex, first: float, sizes: Sequence[Sized], hand: Hand, side: int = -1) -> Iterator[Stroke]:
    """Dimension places from a base, each on its level from the `first` mm down or, with a `side` of 1, up."""
    short = {spot.real > base.real for spot, text, _ in sizes if abs(spot.real - base.real) < room_for(text, hand)}
    sizes = sorted(sizes, key=lambda size: (size[0].real > base.real) in short)  # their numbers are beyond the base
    for number, (spot, text, states) in enumerate(sizes):
        level = first + side * number * step(hand)
        yield _dimension(base.real, spot.real, level, text, hand, states)
        yield Line(spot, complex(spot.real, level + side * PAST), hand.drafted)
    if sizes:
        yield Line(base, complex(base.real, level + side * PAST), hand.drafted)


def _dimension(base: float, last: float, level: float, text: str, hand: Hand, states: Statement) -> Group:
    """Draw a level dimension from a base, mm: where it is short its number is beyond the base."""
    wide = text_width(Text(0j, text, hand.number, "middle", True))
    start, end = complex(base, level), complex(last, level)
    along = complex(math.copysign(1.0, last - base))
    tail = TAIL * hand.symbol * along
    roomy, fits = abs(end - start) >= 2 * ARROW_LENGTH * hand.symbol + 2, abs(end - start) >= room_for(text, hand)
    tips = [(end, start), (start, end)] if roomy else [(start - 2 * tail, start), (end + 2 * tail, end)]
    shelf = start if roomy and fits else start - tail - (0.0 if fits else wide + 2) * along
    line = Line(shelf, end if roomy else end + tail, hand.drafted)
    middle = (start + end) / 2 if fits else shelf + (wide / 2 + 1) * along
    above = ABOVE - text_reach(Text(0j, text, hand.number, "middle", True))[0]  # an index hangs below its line
    letters = Text(middle + above * 1j, text, hand.number, "middle", True)
    heads = [head for tip in tips if (head := arrowhead(*tip, hand.symbol)) is not None]
    return Group((stating(states, line, *heads), telling(states.figure, letters)))


def room_for(text: str, hand: Hand) -> float:
    """Give the length of a dimension line over which a text stands, mm."""
    return text_width(Text(0j, text, hand.number, "middle", True)) + 2


def step(hand: Hand) -> float:
    """Give how far one dimension is from the next, mm: an extension line that ends here stays clear of its number."""
    return PAST + ABOVE + TALL * hand.number
