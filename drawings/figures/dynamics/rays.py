"""The pole and the rays of graphical integration beside the diagram of moments (полюс и лучи)."""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

import numpy as np

from drawings.figures.graphs.axes import Axes
from drawings.figures.graphs.part import UNDER, Part
from drawings.figures.graphs.pole import Pole
from drawings.lettering.thinning import every
from drawings.paper.hand import Hand
from plans.model.dynamics import TURN, Cycle
from plans.model.edge_names import edge_names
from plans.model.motion import Floats

MARKED = 72  # strips: of more only the numbered edges have a point and a tick
NUMBERED = 36  # positions that are numbered at most where not all edges are marked
SEEN = 1e-3  # of the largest moment: a smaller jump cannot be seen


class Strips(NamedTuple):
    """The edges of the strips, rad, their names, and the places of those at which a load jumps."""

    turned: Floats
    names: tuple[str, ...]
    jumps: tuple[int, ...]

    @property
    def steps(self) -> Floats:
        """The numbers of the edges as positions, NaN between two of them."""
        return np.array([float(name) if name.isdigit() else np.nan for name in self.names])

    def told(self, every: int) -> tuple[int, ...]:
        """Choose both ends, the jumps, and every so many positions."""
        last = len(self.turned) - 1
        return tuple(sorted({0, last, *self.jumps, *np.flatnonzero(self.steps % every == 0).tolist()}))

    def every(self, least: float) -> int:
        """Choose how many positions apart numbers stand: a divisor of the turn, if there is one not much above."""
        return every(least, round(float(np.nanmax(self.steps))))

    @property
    def crowded(self) -> bool:
        """Whether there are so many edges that only the numbered ones are marked."""
        return len(self.turned) > MARKED + 1

    @property
    def candidates(self) -> tuple[int, ...]:
        """The edges that may be numbered."""
        return self.told(self.every(float(np.nanmax(self.steps)) / NUMBERED) if self.crowded else 1)

    def marked(self, numbered: Collection[int]) -> Collection[int]:
        """Give the edges that have a point, if some are numbered."""
        return numbered if self.crowded else range(len(self.turned))

    def spaced(self, length: float, apart: float) -> tuple[int, ...]:
        """Choose the edges that can be numbered along an axis of some length mm, both ends and jumps first."""
        places = self.turned * (length / TURN)
        every = self.every(apart / length * float(np.nanmax(self.steps)))
        kept: list[int] = []
        for k in (0, len(places) - 1, *self.jumps, *self.told(every)):
            if all(abs(places[k] - places[other]) >= apart for other in kept):
                kept.append(k)
        return tuple(sorted(kept))


def strips(cycle: Cycle, divisions: int) -> Strips:
    """Name the edges: positions by their numbers, an edge between two of them by the first one's with a prime."""
    return Strips(cycle.turned, edge_names(cycle.turned, divisions), _jumps(cycle))


def _jumps(cycle: Cycle) -> tuple[int, ...]:
    """Find the inner edges at which the two sides of the moment differ to the eye."""
    apart = np.abs(cycle.moments[1:, 0] - cycle.moments[:-1, 1])
    return tuple(int(k) + 1 for k in np.flatnonzero(apart > SEEN * np.abs(cycle.moments).max()))


def middles(turned: Floats) -> Floats:
    """Give the middles of the strips, rad."""
    return (turned[1:] + turned[:-1]) / 2


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
