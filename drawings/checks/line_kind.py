"""A kind of line: by which pens it may be drawn, with which dashes (тип линии; ГОСТ 2.303, ISO 128-2)."""

from __future__ import annotations

from collections.abc import Collection
from itertools import pairwise
from typing import NamedTuple

from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Line, Polyline, Stroke

MAIN, MEDIUM, THIN, FINE = "main", "medium", "thin", "construction"  # pens, by their names in a hand
FULL, DASHED, DASH_DOT, TWO_DOTS = 0, 2, 4, 6  # kinds of lines by the parts that are drawn over and over
LEAST = {DASHED: 2.0, DASH_DOT: 5.0, TWO_DOTS: 5.0}  # mm: the shortest dash of GOST 2.303


class Kind(NamedTuple):
    """What a line may be: by which pens, with which dashes; one too short for two dashes may be full."""

    pens: Collection[str]
    dashes: int = FULL

    def takes(self, stroke: Stroke, hand: Hand) -> bool:
        """Tell whether a stroke is such a line."""
        style = stroke.style  # type: ignore[union-attr]
        if all(style.width != getattr(hand, pen) for pen in self.pens):
            return False
        return len(style.dash) == self.dashes or (not style.dash and _length(stroke) <= _short(self.dashes, hand))


def _length(stroke: Stroke) -> float:
    """Give how long a line is, mm; of what is bent smoothly no account is needed."""
    match stroke:
        case Line():
            return abs(stroke.end - stroke.start)
        case Polyline(points):
            return sum(abs(end - start) for start, end in pairwise(points))
        case Arc():
            return stroke.radius * stroke.sweep
    return 0.0


def _short(dashes: int, hand: Hand) -> float:
    """Give the length of a line that has no room for two dashes, mm; a full line is never broken."""
    if dashes == FULL:
        return 0.0
    broken = {DASHED: hand.dashed, DASH_DOT: hand.dash_dot, TWO_DOTS: hand.dash_two_dots}[dashes]
    return 2 * LEAST[dashes] + sum(broken[1:])
