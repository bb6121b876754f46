"""Stretches of the turn between two joints, where all that is told of a profile is smooth (гладкие участки).

A value is looked at densely; where it changes its sign the place is closed in on to the last digit. No stretch is gone
across: on a joint a value has the side of its own stretch.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Final, NamedTuple

import numpy as np

from plans.cam.course import Course
from plans.cam.false_position import closed_in
from plans.cam.profile.tip import Tip
from plans.model.cam_motion import Extreme, Sizes
from plans.model.motion import Floats

PARTS: Final = 48  # of a stretch: a law has at most seven turning points on one, and what is made of it not many more
Value = Callable[[Tip], Floats]


class Place(NamedTuple):
    """A turn of the cam, rad, and the side on which a value is taken there."""

    turned: float
    before: bool


class Span(NamedTuple):
    """A part of the turn, rad, and its places at which a value can be the worst."""

    start: float
    end: float
    places: tuple[Place, ...]


@dataclass(frozen=True)
class Stretches:
    """The stretches of a cam's turn; a value is looked at on all of them at once."""

    course: Course
    sizes: Sizes

    @cached_property
    def edges(self) -> Floats:
        """The joints, rad."""
        return np.array(self.course.joints)

    @cached_property
    def grid(self) -> Floats:
        """Where a value is looked at: a row a stretch, its ends among them, and closer towards those.

        At an end a law begins so gently that a derivative vanishes there; its last change of sign lies close by.
        """
        shares = (1 - np.cos(np.linspace(0.0, np.pi, PARTS + 1))) / 2
        found = self.edges[:-1, None] + np.diff(self.edges)[:, None] * shares
        found[:, -1] = self.edges[1:]
        return np.asarray(found)

    def at(self, value: Value, turned: Floats) -> Floats:
        """Give a value within stretches; at a joint after it."""
        return value(Tip(self.course, self.sizes, turned))

    def ends(self, value: Value) -> Floats:
        """Give a value at the ends of the stretches, after the first and before the second, (2, stretches)."""
        last = value(Tip(self.course, self.sizes, self.edges[1:], before=True))
        return np.array([self.at(value, self.edges[:-1]), last])

    def sampled(self, value: Value) -> Floats:
        """Give a value on the grid."""
        found = self.at(value, self.grid.ravel()).reshape(self.grid.shape)
        found[:, -1] = self.ends(value)[1]
        return found

    def roots(self, value: Value) -> Floats:
        """Give the turns where a value changes its sign inside a stretch, rising."""
        found = self.sampled(value)
        row, part = np.nonzero(found[:, :-1] * found[:, 1:] < 0)
        near, far = self.grid[row, part], self.grid[row, part + 1]
        inner = closed_in(lambda phi: self.at(value, phi), near, far, found[row, part], found[row, part + 1])
        on = self.grid[:, 1:-1][(found[:, 1:-1] == 0) & ((found[:, :-2] != 0) | (found[:, 2:] != 0))]
        return np.sort(np.concatenate([inner, on]))

    def places(self, slope: Value) -> tuple[Place, ...]:
        """Give where a value can be greatest or least: ends of stretches, and where its derivative vanishes."""
        starts = [Place(phi, False) for phi in self.edges[:-1].tolist()]
        ends = [Place(phi, True) for phi in self.edges[1:].tolist()]
        return (*starts, *ends, *(Place(phi, False) for phi in self.roots(slope).tolist()))

    def read(self, value: Value, places: tuple[Place, ...]) -> Floats:
        """Give a value at places."""
        turned = np.array([one.turned for one in places])
        found = self.at(value, turned)
        back = np.array([one.before for one in places], dtype=bool)
        found[back] = value(Tip(self.course, self.sizes, turned[back], before=True))
        return found

    def most(self, value: Value, places: tuple[Place, ...]) -> Extreme | None:
        """Give the greatest value at places, the first where there are several."""
        found = self.read(value, places)
        if not places or np.isnan(found).all():
            return None
        best = int(np.nanargmax(found))
        return Extreme(float(found[best]), places[best].turned)

    def spans(self, value: Value, places: tuple[Place, ...]) -> Iterator[Span]:
        """Give the parts of the turn where a value is above 0; places on two sides of a joint make one part."""
        cuts = np.unique(np.concatenate([self.edges, self.roots(value), [one.turned for one in places]]))
        above = self.at(value, (cuts[:-1] + cuts[1:]) / 2) > 0
        start = np.flatnonzero(above & ~np.concatenate([[False], above[:-1]]))
        end = np.flatnonzero(above & ~np.concatenate([above[1:], [False]]))
        for one, other in zip(cuts[start].tolist(), cuts[end + 1].tolist(), strict=True):
            yield Span(one, other, tuple(place for place in places if one <= place.turned <= other))
