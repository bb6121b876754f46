"""Dimensions of places along the shaft, each on a level of its own under the rotor (размеры вдоль вала)."""

from __future__ import annotations

from drawings.lettering.lettering import text_reach, text_width
from drawings.lettering.phrase import telling
from drawings.lettering.rotor_letters import INDEX, lowered
from drawings.page.drafting import Drafting
from drawings.paper.hand import Hand
from drawings.paper.statement import Statement
from drawings.paper.strokes import Group, Line, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.symbols import ARROW_LENGTH, arrowhead

FEW, MOST = 9, 40  # masses: of more each is numbered alone; of more still the table alone tells them apart


def letter(name: str, count: int, drafting: Drafting) -> str:
    """Letter one of so many vectors: with its letters, or of many masses by the number of its mass alone."""
    number = INDEX.search(name)
    if count > FEW and number is not None and number[1].isdigit():
        return number[1]
    return lowered(name, drafting.language)


def size(text: str, drafting: Drafting) -> float:
    """Give the size of a letter, mm: numbers alone are smaller."""
    return drafting.hand.number if text.isdigit() else drafting.hand.letter


PAST = 1.5  # mm an extension line goes past the lowest arrow
ABOVE = 0.9  # mm from the dimension line to its number
TALL = 1.6  # sizes of a number with its index, and paper over it
TAIL = 8.0  # mm of a dimension line outside its extension lines, where its arrows stand outside


def dimension(base: float, last: float, level: float, sense: float, text: str, hand: Hand, states: Statement) -> Group:
    """Draw a level dimension from a base, mm, in a sense +1 or -1: where it is short its number is beyond the base."""
    wide = text_width(Text(0j, text, hand.number, "middle", True))
    start, end = complex(base, level), complex(last, level)
    along, tail = complex(sense), TAIL * hand.symbol
    roomy, fits = abs(end - start) >= 2 * ARROW_LENGTH * hand.symbol + 2, abs(end - start) >= room_for(text, hand)
    tips = [(end, start), (start, end)] if roomy else [(start - 2 * tail * along, start), (end + 2 * tail * along, end)]
    shelf = start if roomy and fits else start - (tail + (0.0 if fits else wide + 2)) * along
    line = Line(shelf, end if roomy else end + tail * along, hand.drafted)
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


def extension(across: float, top: float, bottom: float, hand: Hand) -> Stroke:
    """Draw the extension line of some dimensions down to the lowest of them."""
    return Line(complex(across, top), complex(across, bottom - PAST), hand.drafted)
