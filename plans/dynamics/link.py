"""The reduced link as the graphs of a turn give it: inertia by its ordinates and slopes, moment by strips (M4.5)."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass

from plans.dynamics.cycle import Works
from plans.model.dynamics import TURN
from plans.model.motion import Floats
from plans.model.run import ReducedLink


@dataclass(frozen=True)
class Ordinates:
    """Places rad from 0 to a whole turn, and a quantity there; at each strip's two ends it may have its own value."""

    places: Sequence[float]  # n + 1
    begins: Sequence[float]  # n: at the beginning of each strip
    ends: Sequence[float]  # n: at its end

    def strip(self, turned: float) -> tuple[int, float, float]:
        """Give the strip of an angle, the share of it that lies behind, and its breadth rad."""
        place = turned % TURN
        k = min(bisect_right(self.places, place) - 1, len(self.begins) - 1)
        breadth = self.places[k + 1] - self.places[k]
        return k, (place - self.places[k]) / breadth, breadth

    def straight(self, turned: float) -> float:
        """Give the quantity on a straight line in each strip; on an edge, by the strip beyond."""
        k, share, _ = self.strip(turned)
        return self.begins[k] + (self.ends[k] - self.begins[k]) * share


@dataclass(frozen=True)
class Curve:
    """A quantity through its ordinates and slopes, a cubic in each strip (Hermite): value and slope belong together."""

    ordinates: Ordinates
    slopes: Ordinates

    def value(self, turned: float) -> float:
        """Give the quantity."""
        k, x, breadth = self.ordinates.strip(turned)
        y, rise, first, last = self._strip(k, breadth)
        return y + x * (first + x * (3 * rise - 2 * first - last + x * (first + last - 2 * rise)))

    def slope(self, turned: float) -> float:
        """Give its derivative by the angle."""
        k, x, breadth = self.ordinates.strip(turned)
        _, rise, first, last = self._strip(k, breadth)
        return (first + x * (2 * (3 * rise - 2 * first - last) + 3 * x * (first + last - 2 * rise))) / breadth

    def _strip(self, k: int, breadth: float) -> tuple[float, float, float, float]:
        """Give the beginning of a strip, the rise in it, and the slopes at its ends for its whole breadth."""
        y, end = self.ordinates.begins[k], self.ordinates.ends[k]
        return y, end - y, self.slopes.begins[k] * breadth, self.slopes.ends[k] * breadth


def curve(places: Floats, values: Floats, slopes: Floats) -> Curve:
    """Put a curve through values (n + 1,) with slopes (n + 1,) at places from 0 to a whole turn."""
    at = places.tolist()
    both = [Ordinates(at, row[:-1].tolist(), row[1:].tolist()) for row in (values, slopes)]
    return Curve(*both)


def reduced_link(works: Works, constant: float) -> ReducedLink:
    """Read the reduced link off the graphs of a steady turn; `constant`: inertia kg*m2 of shafts and flywheel."""
    cycle = works.cycle
    inertia = curve(cycle.turned, cycle.inertia + constant, works.edge.slope)
    moments = Ordinates(cycle.turned.tolist(), *cycle.moments.T.tolist())
    return ReducedLink(inertia.value, inertia.slope, moments.straight, breaks=tuple(cycle.breaks.tolist()))
