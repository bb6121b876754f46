"""The pole of a graph, from which it is differentiated or integrated by rays (полюс и лучи)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.graphs.axes import Axes, chosen
from drawings.figures.graphs.part import LEFT, OVER, Letter, Part
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Stroke
from drawings.paper.ties import tied
from drawings.symbols.dimension import Dimension
from drawings.symbols.symbols import pole
from plans.model.motion import Floats


class Pole(NamedTuple):
    """A pole on the axis of the abscissas, left of zero, and the values that its rays cut off the axis of ordinates."""

    letters: tuple[str, str]  # of the pole and of its distance
    distance: float  # mm
    places: Floats  # (n,): the abscissas where the values belong, true units
    values: Floats  # (n,): true units
    apart: float  # mm between the ends of two rays that are drawn
    off: complex  # mm from the axis to the dimension of the distance
    side: float = OVER  # of that dimension on which its letter stands

    def part(self, name: str, axes: Axes, hand: Hand) -> Part:
        """Draw the pole, and rays to values that lie apart, each value carried to where it belongs."""
        at, (letter, own) = axes.zero - self.distance, self.letters
        size = Dimension(own, at, axes.zero, self.off)
        rays = (line for k in self._drawn(axes) for line in self._ray(k, at, axes, hand))
        base = Line(at, axes.zero, hand.drafted)
        letters = (Letter(at, letter, hand.letter, LEFT), Letter(size.middle, own, hand.letter, self.side))
        return Part(name, (base, *rays, *size.draw(hand), pole(at)), letters)

    def _drawn(self, axes: Axes) -> tuple[int, ...]:
        """Choose the values whose rays are drawn: those whose ends lie apart."""
        return chosen((self.values / axes.up.mu).tolist(), self.apart)

    def _ray(self, k: int, at: complex, axes: Axes, hand: Hand) -> Iterator[Stroke]:
        """Draw the ray of a value, and what it cuts off carried from the axis to where it belongs."""
        value = float(self.values[k])
        cut = axes.on(0.0, value)
        yield Line(at, cut, hand.drafted)
        if tied(abs(cut - axes.zero)):
            yield Line(cut, axes.on(float(self.places[k]), value), hand.drafted)
