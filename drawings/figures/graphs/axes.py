"""The axes of a graph on paper: where its values lie, arrows at their ends, a scale for each of them (оси графика)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.page.scale import Scale
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import Line, Stroke
from drawings.paper.ties import tied
from drawings.paper.walk import stating
from drawings.symbols.symbols import arrowhead
from plans.model.motion import Floats

BEYOND = 9.0  # mm that an axis goes beyond the graph, for its arrowhead


class Curve(NamedTuple):
    """A curve in true units, its abscissas and ordinates, (N,); where it jumps two of its points have one abscissa."""

    x: Floats
    y: Floats


class Axes(NamedTuple):
    """Where the values of a graph lie on paper: its zero, mm, and the scale and the direction of each axis."""

    zero: complex
    across: Scale
    up: Scale
    along: complex = 1 + 0j  # the way of the abscissas on paper
    rise: complex = 1j  # that of the ordinates

    def on(self, x: float, y: float = 0.0) -> complex:
        """Give the place on paper of true values, mm."""
        return self.zero + self.along * (x / self.across.mu) + self.rise * (y / self.up.mu)

    def below(self, y: float) -> bool:
        """Tell whether a true value lies below the axis of abscissas: none that is but rounding does."""
        return tied(y / self.up.mu) < 0

    def lines(
        self, across: tuple[float, float], up: tuple[float, float], hand: Hand, figure: str = ""
    ) -> Iterator[Stroke]:
        """Draw both axes over ranges of true values, each with its arrowhead beyond the end; they state a figure's."""
        (left, right), (low, high) = across, up
        level = arrow(self.on(left), self.on(right) + BEYOND * self.along, hand)
        upright = arrow(self.on(0.0, low), self.on(0.0, high) + BEYOND * self.rise, hand)
        if not figure:
            yield from (*level, *upright)
            return
        yield stating(Statement(Kind.AXIS, figure, "x", scale=self.across.mu), *level)
        yield stating(Statement(Kind.AXIS, figure, "y", scale=self.up.mu), *upright)


def arrow(start: complex, end: complex, hand: Hand) -> Iterator[Stroke]:
    """Draw an axis with its arrowhead."""
    yield Line(start, end, hand.other)
    head = arrowhead(start, end, hand.symbol)
    if head is not None:
        yield head


def chosen(values: Sequence[float], apart: float) -> tuple[int, ...]:
    """Choose the places of values that lie apart from one another.

    >>> chosen([1.0, 1.2, 3.0, 2.9], 0.5)
    (0, 2)
    """
    kept: list[int] = []
    for k, value in enumerate(values):
        if all(tied(abs(value - values[other]) - apart) >= 0 for other in kept):
            kept.append(k)
    return tuple(kept)
