"""A law by the shape of its acceleration, as the user gives it by points (закон движения по форме ускорения)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from plans.cam.pieces import Push, Shares, shares
from plans.model.cam import Law

Points = Sequence[tuple[float, float]]


class Balance(NamedTuple):
    """What a shape of acceleration comes to, in its own scale: the areas above and below the axis, the lift.

    The follower stops at the end only if both areas are alike; it goes the right way only if the lift is above 0.
    """

    above: float
    below: float
    lift: float

    @property
    def lack(self) -> float:
        """By how much the areas do not cancel, in shares of the larger: above 0 where that above the axis is larger."""
        return (self.above - self.below) / (max(self.above, self.below) or 1.0)


def balance(points: Points) -> Balance:
    """Weigh a shape: it can be a law if `lack` is 0 and `lift` is above 0.

    >>> balance([(0, 1), (0.5, 1), (0.5, -1), (1, -1)]), balance([(0, 2), (1, -1)]).lack
    (Balance(above=0.5, below=0.5, lift=0.25), 0.75)
    """
    areas = [area for one, other in pairwise(points) for area in _areas(one, other)]
    above, below = (sum(max(sign * area, 0.0) for area in areas) for sign in (1, -1))
    return Balance(above, below, sum(_moment(one, other) for one, other in pairwise(points)))


def shape(law: Law) -> Shares:
    """Give the law of a shape in pieces, from one point to the next.

    >>> import numpy as np
    >>> shape(Law("shape", points=((0, 1), (0.5, 1), (0.5, -1), (1, -1)))).at(np.array([0.25]), 0).tolist()
    [0.125]
    """
    return shares(_pushes(law.points))


def _pushes(points: Points) -> Iterator[Push]:
    for (k, a), (end, b) in pairwise(points):
        if end > k:
            yield Push(end - k, (a, (b - a) / (end - k)))


def _areas(one: tuple[float, float], other: tuple[float, float]) -> tuple[float, ...]:
    """Give the areas under a straight piece of a shape: two triangles where it goes through the axis."""
    (k, a), (end, b) = one, other
    if a * b >= 0:
        return ((a + b) / 2 * (end - k),)
    crossing = (end - k) * a / (a - b)
    return a / 2 * crossing, b / 2 * (end - k - crossing)


def _moment(one: tuple[float, float], other: tuple[float, float]) -> float:
    """Give the static moment of the area under a straight piece about the end of the phase: its part of the lift."""
    (k, a), (end, b) = one, other
    return (end - k) * ((1 - end) * (a + b) / 2 + (end - k) * (2 * a + b) / 6)
