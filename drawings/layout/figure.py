"""What every figure is: lines in its spot, and letters that find their places among the lines of all (фигура)."""

from __future__ import annotations

from typing import NamedTuple, Protocol

from drawings.layout.labels import Labels
from drawings.paper.strokes import Group, Stroke


class Figure(Protocol):
    """A figure in its spot on paper. Its file has the same few functions as every other figure's:

    `measure` gives the room that it needs, `draw` draws its lines in a spot, and the figure letters itself.
    """

    @property
    def lines(self) -> tuple[Stroke, ...]:
        """All that is drawn before any letter is placed."""
        ...

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure, its letters placed among the lines of all figures."""
        ...


class StillFigure(NamedTuple):
    """A figure that has no letters to be placed."""

    lines: tuple[Group, ...]

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole figure."""
        return self.lines
