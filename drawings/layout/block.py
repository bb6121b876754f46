"""Lettering that stands among figures: equations, a table, notes (надписи среди фигур)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

NARROW = 20.0  # sizes of its letters, the least width of a column of notes
BROKEN = 0.9  # share of a line that words fill on average when it is broken between them
WIDTHS = 8  # in which notes are tried, from their least to the width of the sheet


class TextBlock(NamedTuple):
    """Lettering that is kept together: the sizes that it may have, width and height in mm, the narrowest first."""

    name: str
    sizes: tuple[tuple[float, float], ...]


class Notes(NamedTuple):
    """What the sheet says in words: the length of each paragraph in one line, the step of the lines, mm.

    They stand in no column of less than `least` mm.
    """

    lengths: tuple[float, ...]
    step: float
    least: float = NARROW * 3.5

    def height(self, width: float) -> float:
        """Give the height, mm, of the notes broken at a width."""
        return sum(high for _, high in self.lines(width))

    def lines(self, width: float) -> Iterator[tuple[float, float]]:
        """Give width and height, mm, of each paragraph written in a width: short lines leave paper beside them."""
        for length in self.lengths:
            yield min(width, length), math.ceil(length / (BROKEN * width)) * self.step

    def sizes(self, widest: float) -> tuple[tuple[float, float], ...]:
        """Give widths and heights, mm, that they may have up to a width, the narrowest first, each lower than the last.

        >>> Notes((100.0,), 5.0, 60.0).sizes(120.0)
        ((60.0, 10.0), (120.0, 5.0))
        """
        widths = [self.least * max(widest / self.least, 1.0) ** (k / (WIDTHS - 1)) for k in range(WIDTHS)]
        found: list[tuple[float, float]] = []
        for width in widths:
            if not found or self.height(width) < found[-1][1]:
                found.append((width, self.height(width)))
        return tuple(found)
