"""A dimension on paper, lettered beside its line: its arrows within or, where there is no room, outside (размер)."""

from __future__ import annotations

from typing import NamedTuple

from drawings.paper.hand import Hand
from drawings.paper.statement import Statement
from drawings.paper.strokes import Line, Stroke
from drawings.paper.ties import tied
from drawings.paper.walk import stating
from drawings.symbols.symbols import ARROW_LENGTH, arrowhead

PAST = 1.5  # mm that an extension line goes past the dimension line


class Dimension(NamedTuple):
    """A distance dimensioned beside it: its letter, its ends, and the way to its line, mm."""

    letter: str
    start: complex
    end: complex
    off: complex
    states: Statement | None = None

    @property
    def length(self) -> float:
        """The distance on paper, mm."""
        return abs(self.end - self.start)

    @property
    def middle(self) -> complex:
        """The middle of its line: beside it stands the letter."""
        return (self.start + self.end) / 2 + self.off

    @property
    def lines(self) -> tuple[tuple[complex, complex], ...]:
        """The dimension line, then the two extension lines."""
        past = self.off * (1 + PAST / abs(self.off))
        ends = ((one, one + past) for one in (self.start, self.end))
        return (self.start + self.off, self.end + self.off), *ends

    def draw(self, hand: Hand) -> tuple[Stroke, ...]:
        """Draw its lines, its arrows within or, where there is no room, outside."""
        line, *others = arrows(*self.lines[0], hand)
        extensions = (Line(*ends, hand.drafted) for ends in self.lines[1:])
        drawn = line, *extensions, *others
        return drawn if self.states is None else (stating(self.states, *drawn),)


def arrows(start: complex, end: complex, hand: Hand) -> tuple[Stroke, ...]:
    """Draw a dimension line with arrows at both ends: within or, where there is no room, outside."""
    along = (end - start) / abs(end - start) * ARROW_LENGTH * hand.symbol
    tails = (end, start) if tied(abs(end - start) - 3 * abs(along)) > 0 else (start - 2 * along, end + 2 * along)
    heads = (arrowhead(tail, tip, hand.symbol) for tail, tip in zip(tails, (start, end), strict=True))
    outer = () if tails[0] == end else (Line(tails[0], tails[1], hand.drafted),)
    return Line(start, end, hand.drafted), *outer, *(head for head in heads if head is not None)
