"""Dimensions of places along the shaft, each on a level of its own under the rotor (размеры вдоль вала)."""

from __future__ import annotations

from drawings.lettering.lettering import text_width
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, Stroke, Text
from drawings.symbols.symbols import ARROW_LENGTH, arrowhead

PAST = 2.0  # mm an extension line goes past the lowest arrow
ABOVE = 0.9  # mm from the dimension line to its number
TAIL = 8.0  # mm of a dimension line outside its extension lines, where its arrows stand outside


def dimension(base: float, last: float, level: float, text: str, hand: Hand) -> Group:
    """Draw a level dimension from a base, mm: arrows and number outside, beyond the base, where it is short."""
    wide = text_width(Text(0j, text, hand.number, "middle", True))
    start, end = complex(base, level), complex(last, level)
    along, tail = (end - start) / abs(end - start), TAIL * hand.symbol
    roomy, fits = abs(end - start) >= 2 * ARROW_LENGTH * hand.symbol + 2, abs(end - start) >= wide + 2
    tips = [(end, start), (start, end)] if roomy else [(start - 2 * tail * along, start), (end + 2 * tail * along, end)]
    shelf = start if roomy and fits else start - (tail + (0.0 if fits else wide + 2)) * along
    line = Line(shelf, end if roomy else end + tail * along, hand.drafted)
    middle = (start + end) / 2 if fits else shelf + (wide / 2 + 1) * along
    letters = Text(middle + ABOVE * 1j, text, hand.number, "middle", True)
    heads = [head for tip in tips if (head := arrowhead(*tip, hand.symbol)) is not None]
    return Group((line, *heads, letters))


def extension(across: float, top: float, bottom: float, hand: Hand) -> Stroke:
    """Draw the extension line of some dimensions down to the lowest of them."""
    return Line(complex(across, top), complex(across, bottom - PAST), hand.drafted)
