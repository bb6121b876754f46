"""Couples at their points: an arc of some radius with an arrowhead in their sense (пары сил)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Stroke
from drawings.symbols.force_arrow import plain_name
from drawings.symbols.symbols import turning_arrow

HALF, THREE_QUARTERS = math.pi, 1.5 * math.pi  # rad: the arcs of a couple
RADIUS = 8.0  # mm, to the factor of the hand's symbols
SIDE = 0.3 * math.tau  # rad that arcs about one place face apart at the least: three can, in steps of thirty degrees
BESIDE = 1.2  # mm from the arc to its letter


class CoupleArc(NamedTuple):
    """A couple about a place on paper: +1 counter-clockwise, -1 clockwise; the arc's middle faces a direction, rad."""

    letter: str
    at: complex
    sense: int
    radius: float = RADIUS
    facing: float = math.pi / 2
    sweep: float = THREE_QUARTERS

    @property
    def place(self) -> complex:
        """The middle of the arc: beside it stands the letter."""
        return self.at + cmath.rect(self.radius, self.facing)

    def crowded(self, others: Iterable[CoupleArc]) -> int:
        """Count the arcs about the same place that face nearly the same way: whose a letter is could not be told.

        >>> [CoupleArc("M_2", 0j, 1).crowded([CoupleArc("M_3", 0j, 1, facing=turn)]) for turn in (0.6, 4.7)]
        [1, 0]
        """
        return sum(math.cos(other.facing - self.facing) > math.cos(SIDE) for other in others)

    def draw(self, hand: Hand) -> Group:
        """Draw the arc and its head."""
        start = self.facing - self.sense * self.sweep / 2
        arrow = turning_arrow(self.at, self.radius, start, self.sense * self.sweep, hand, hand.relative)
        data = {"kind": "couple", "name": plain_name(self.letter), "sense": f"{self.sense:+d}"}
        return Group(arrow, "", data, self.letter)

    def letter_beside(self, labels: Labels, hand: Hand) -> Stroke:
        """Letter it beyond the middle of its arc."""
        return labels.beside(self.place, self.letter, hand.letter, BESIDE, self.facing)
