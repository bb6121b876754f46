"""The pole and the rays of graphical integration beside the diagram of moments (полюс и лучи)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.figures.dynamics.strips import middles
from drawings.figures.graphs.axes import Axes, chosen
from drawings.figures.graphs.part import LEFT, UNDER, Letter, Part
from drawings.paper.hand import Hand
from drawings.paper.strokes import Line, Stroke
from drawings.symbols.dimension import Dimension
from drawings.symbols.symbols import pole
from plans.model.dynamics import Cycle

NAME = "pole"
POLE, DISTANCE = "P", "H_p"  # H alone is a stroke
APART = 1.0  # sizes of a letter between the ends of two rays that are drawn
OFF = 2.2  # sizes of a letter from the axis to the dimension of the pole distance


def pole_part(cycle: Cycle, axes: Axes, distance: float, hand: Hand) -> Part:
    """Draw the pole at its distance, mm, and rays to the mean ordinates that lie apart, each carried to the axis."""
    at = axes.zero - distance
    size = Dimension(DISTANCE, at, axes.zero, _off(cycle) * OFF * hand.letter)
    rays = (line for k in rays_of(cycle, axes, hand) for line in _ray(cycle, k, at, axes, hand))
    base = Line(at, axes.zero, hand.drafted)
    letters = (Letter(at, POLE, hand.letter, LEFT), Letter(size.middle, DISTANCE, hand.letter, UNDER))
    return Part(NAME, (base, *rays, *size.draw(hand), pole(at)), letters)


def rays_of(cycle: Cycle, axes: Axes, hand: Hand) -> tuple[int, ...]:
    """Choose the strips whose rays are drawn: those whose ends lie apart."""
    return chosen((-cycle.means / axes.up.mu).tolist(), APART * hand.letter)


def _off(cycle: Cycle) -> complex:
    """Give the side of the axis on which the diagram is lower."""
    return -1j if -cycle.means.min() >= cycle.means.max() else 1j


def _ray(cycle: Cycle, k: int, at: complex, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Draw the ray of a strip, and its mean ordinate carried to the axis."""
    mean = float(-cycle.means[k])
    carried = axes.on(0.0, mean)
    yield Line(at, carried, hand.drafted)
    if carried != axes.zero:
        yield Line(carried, axes.on(float(middles(cycle.turned)[k]), mean), hand.drafted)
