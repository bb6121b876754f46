"""Where a ruler that is pushed to the loop touches it: a corner, or a point of the curve between two (TANDIR)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from plans.model.dynamics import Cycle, Touch
from plans.model.motion import Floats

SAME = 1e-12  # of the height of the loop: points whose heights differ by less are on one line
PARTS = 16  # of a strip: in none of them the drawn curve turns back twice
HALVINGS = 50  # of such a part: more than the digits of an angle


class Strips(NamedTuple):
    """A quantity as it is drawn in each strip: what it begins with, its rise, its slopes at both ends, all (n, 1)."""

    first: Floats
    rise: Floats
    start: Floats
    end: Floats

    def value(self, s: Floats) -> Floats:
        """Give it at shares of the strips, (n, m)."""
        return self.first + self.rise * s + s * (1 - s) * self._bent(s)

    def slope(self, s: Floats) -> Floats:
        """Give its derivative by the share."""
        return self.rise + (1 - 2 * s) * self._bent(s) + s * (1 - s) * (2 * self.rise - self.start - self.end)

    def rows(self, chosen: np.ndarray[tuple[int, ...], np.dtype[np.intp]]) -> Strips:
        """Give some of the strips."""
        return Strips(*(row[chosen] for row in self))

    def _bent(self, s: Floats) -> Floats:
        return np.asarray((self.start - self.rise) * (1 - s) + (self.rise - self.end) * s)


def touched(cycle: Cycle, slope: float, sign: int) -> Touch:
    """Give the point that a ruler of a slope touches first, from above if sign > 0; of several the first corner."""
    wide = np.diff(cycle.turned)[:, None]
    energy = _strips(cycle.surplus, (cycle.driving + cycle.moments) * wide)
    inertia = _strips(cycle.varying, np.column_stack([cycle.leaning[:-1], cycle.leaning[1:]]) * wide)
    beyond = Strips(*(sign * (work - slope * other) for work, other in zip(energy, inertia, strict=True)))
    k, s = _tops(beyond)
    turned = np.append(cycle.turned, cycle.turned[k] + s[:, 0] * wide[k, 0])
    varying = np.append(cycle.varying, inertia.rows(k).value(s))
    surplus = np.append(cycle.surplus, energy.rows(k).value(s))
    heights = sign * (surplus - slope * varying)
    first = int(np.argmax(heights >= heights.max() - SAME * np.ptp(heights)))
    return Touch(float(turned[first]), float(varying[first]), float(surplus[first]))


def _strips(edges: Floats, slopes: Floats) -> Strips:
    return Strips(edges[:-1, None], np.diff(edges)[:, None], slopes[:, :1], slopes[:, 1:])


def _tops(height: Strips) -> tuple[np.ndarray[tuple[int, ...], np.dtype[np.intp]], Floats]:
    """Close in on the points between two edges where a height rises no more: their strips, and their shares (m, 1)."""
    shares = np.linspace(0.0, 1.0, PARTS + 1)
    rising = height.slope(shares) > 0
    k, part = np.nonzero(rising[:, :-1] & ~rising[:, 1:])
    low, high, strips = shares[part][:, None], shares[part + 1][:, None], height.rows(k)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        rises = strips.slope(middle) > 0
        low, high = np.where(rises, middle, low), np.where(rises, high, middle)
    return k, low
