"""The pole and the rays of graphical integration beside the diagram of moments (полюс и лучи)."""

from __future__ import annotations

from drawings.figures.dynamics.strips import middles
from drawings.figures.graphs.axes import Axes
from drawings.figures.graphs.part import UNDER, Part
from drawings.figures.graphs.pole import Pole
from drawings.paper.hand import Hand
from plans.model.dynamics import Cycle

NAME = "pole"
POLE, DISTANCE = "P", "H_p"  # H alone is a stroke
APART = 1.0  # sizes of a letter between the ends of two rays that are drawn
OFF = 2.2  # sizes of a letter from the axis to the dimension of the pole distance


def pole_part(cycle: Cycle, axes: Axes, distance: float, hand: Hand) -> Part:
    """Draw the pole at its distance, mm, and rays to the mean ordinates that lie apart, each carried to the axis."""
    size, off = hand.letter, _off(cycle) * OFF * hand.letter
    own = Pole((POLE, DISTANCE), distance, middles(cycle.turned), -cycle.means, APART * size, off, UNDER)
    return own.part(NAME, axes, hand)


def _off(cycle: Cycle) -> complex:
    """Give the side of the axis on which the diagram is lower."""
    return -1j if -cycle.means.min() >= cycle.means.max() else 1j
