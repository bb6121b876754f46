"""A part of a figure: its lines, and the letters that still look for their places (часть чертежа)."""

from __future__ import annotations

import math
from typing import NamedTuple

from drawings.layout.labels import Labels
from drawings.lettering.lettering import text_width
from drawings.lettering.phrase import telling
from drawings.paper.formats import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Stroke, Text

LEFT, RIGHT, OVER, UNDER = math.pi, 0.0, math.pi / 2, -math.pi / 2
BETWEEN = 3.0  # mm from a part's title to its scales


class Letter(NamedTuple):
    """A lettering that looks for its place: beside which spot, on which side preferably, how far off, mm."""

    at: complex
    text: str
    size: float
    side: float
    gap: float = 1.2


class Part(NamedTuple):
    """A graph or a loop on paper: its lines, its letters; those of small numbers come last."""

    name: str
    lines: tuple[Stroke, ...]
    letters: tuple[Letter, ...]

    def group(self, labels: Labels) -> Group:
        """Give it whole, its letters placed among the lines of all figures."""
        ranked = sorted(self.letters, key=lambda one: -one.size)
        placed = (labels.beside(one.at, one.text, one.size, one.gap, one.side) for one in ranked)
        letters = tuple(telling(self.name, one) for one in placed)
        return Group((*self.lines, Group(letters)), self.name)


def caption(title: str, scales: str, field: Field, hand: Hand) -> Group:
    """Write a part's title and its scales on one line at the top of a field, in its middle if it is no longer."""
    start = complex(max(field.centre.real - wide(title, scales, hand) / 2, field.left), field.top - hand.title)
    then = start + text_width(Text(0j, title, hand.title)) + BETWEEN
    return Group((Text(start, title, hand.title, "start", True), Text(then, scales, hand.text, "start", True)))


def wide(title: str, scales: str, hand: Hand) -> float:
    """Give the length of a caption, mm."""
    return text_width(Text(0j, title, hand.title)) + BETWEEN + text_width(Text(0j, scales, hand.text))
