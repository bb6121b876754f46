"""Places of links as sums of linearly independent vectors, and the loops among them (метод независимых векторов).

Every link that turns by itself gives a vector e^(i theta), every sliding pair one along its line, s*e^(i theta) of its
owner; a link that slides turns with its owner. The place of any point is a row of complex coefficients of these, told
once for all positions; a loop is a row that is zero in all of them. The first column is of what never moves.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.motion import Complexes

CONSTANT = 0  # the column of what never moves


class Turned(NamedTuple):
    """A link's direction: the link whose direction it has but for a fixed turn, and that turn as a unit vector."""

    leader: int
    by: complex


class Formal:
    """The links of a mechanism as rows of coefficients, m, and the rows of its loops."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism
        self.turned = _turned(mechanism)
        leaders = sorted({one.leader for one in self.turned.values()} - {FRAME})
        self.columns = {link: k for k, link in enumerate((FRAME, *leaders))}
        self.size = len(self.columns) + len(mechanism.slides)
        self.origins = {FRAME: self._none()}
        self.loops = list(self._laid())

    def _none(self) -> Complexes:
        return np.zeros(self.size, dtype=np.complex128)

    def along(self, link: int, own: complex) -> Complexes:
        """Give the row of a vector fixed in a link, of its own frame."""
        row, turned = self._none(), self.turned[link]
        row[self.columns[turned.leader]] = own * turned.by
        return row

    def place(self, link: int, own: complex) -> Complexes:
        """Give the row of a point of a link."""
        return np.asarray(self.origins[link] + self.along(link, own))

    def of(self, point: str) -> Complexes:
        """Give the row of a point by its letter."""
        link = self.mechanism.link_of(point)
        return self.place(link, self.mechanism.links[link].points[point])

    def _laid(self) -> Iterator[Complexes]:
        """Lay the links out joint by joint from the frame; what closes a loop gives its row."""
        waiting = list(_joints(self.mechanism))
        while waiting:
            here = next(one for one in waiting if not self.origins.keys().isdisjoint(one[:2]))
            waiting.remove(here)
            first, second, joint = here
            apart = self._slid(joint) if isinstance(joint, Slide) else self._pinned(first, second, joint)
            if first in self.origins and second in self.origins:
                yield self.origins[first] - self.origins[second] - apart
            elif first in self.origins:
                self.origins[second] = self.origins[first] - apart
            else:
                self.origins[first] = self.origins[second] + apart

    def _pinned(self, first: int, second: int, point: str) -> Complexes:
        """Give how far the origin of a hinge's first link is from that of its second."""
        own = self.mechanism.links
        return np.asarray(self.along(second, own[second].points[point]) - self.along(first, own[first].points[point]))

    def _slid(self, slide: Slide) -> Complexes:
        """Give how far the origin of a slider is from that of its owner: along the line by what it slides."""
        row = self.along(slide.owner, slide.on_owner.through) - self.along(slide.slider, slide.on_slider.through)
        way = self.turned[slide.owner].by * slide.on_owner.direction
        row[len(self.columns) + self.mechanism.slides.index(slide)] = way / abs(way)
        return np.asarray(row)


def _joints(mechanism: Mechanism) -> Iterator[tuple[int, int, str | Slide]]:
    """Give all pairs: two links and what joins them, of a slide slider and owner."""
    for point, links in mechanism.hinges.items():
        yield from ((links[0], link, point) for link in links[1:])
    yield from ((slide.slider, slide.owner, slide) for slide in mechanism.slides)


def _turned(mechanism: Mechanism) -> dict[int, Turned]:
    """Tell of every link with which other it turns; the frame, or else the lowest, leads those that turn together."""
    found: dict[int, Turned] = {}
    for leader in sorted(mechanism.links):
        if leader not in found:
            found[leader] = Turned(leader, 1 + 0j)
            _follow(mechanism, leader, found)
    return found


def _follow(mechanism: Mechanism, link: int, found: dict[int, Turned]) -> None:
    for slide in mechanism.slides:
        if link in (slide.slider, slide.owner):
            other = slide.owner if link == slide.slider else slide.slider
            if other not in found:
                way, its = slide.way(link).direction, slide.way(other).direction
                by = found[link].by * way / its
                found[other] = Turned(found[link].leader, by / abs(by))
                _follow(mechanism, other, found)
