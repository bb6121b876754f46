"""A loading scheme as it lies on its sheet: where true places are, its arrows and its arcs (схема на листе)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from drawings.checks.graphs.figure_strokes import FigureStrokes
from drawings.paper.strokes import Fill, Group, Line, Polyline, Text
from plans.model.mechanism import FRAME
from plans.model.motion import Complexes

FAR = 1e4  # mm: more than all letters of a figure are from their points together
FINE = 0.02  # mm: less than a twentieth of the thinnest line; what rounding of coordinates moves a place by is far less


class Arrow(NamedTuple):
    """A straight arrow of one head: its ends, mm."""

    start: complex
    tip: complex

    @property
    def way(self) -> complex:
        """Its unit direction."""
        return (self.tip - self.start) / abs(self.tip - self.start)

    def aside(self, spot: complex) -> float:
        """Give how far a place is from its line of action, mm."""
        return abs(((spot - self.start) * self.way.conjugate()).imag)

    def ends(self, spot: complex) -> tuple[complex, complex]:
        """Give its end at a place, and its free end."""
        near, free = sorted((self.start, self.tip), key=lambda end: abs(end - spot))
        return near, free


@dataclass(frozen=True)
class LaidScheme:
    """The strokes of a scheme, the place on paper of its datum, mm, and its scale, m/mm."""

    strokes: FigureStrokes
    origin: complex
    mu: float

    def on(self, place: complex) -> complex:
        """Give where a true place lies on paper, mm."""
        return self.origin + place / self.mu

    @cached_property
    def arrows(self) -> tuple[Arrow, ...]:
        """The straight arrows of one head, which points away from the other end."""
        return tuple(_arrows(self.strokes))

    @cached_property
    def marked(self) -> tuple[complex, ...]:
        """The middles of its circles."""
        return tuple(one.centre for one in self.strokes.circles)

    @cached_property
    def ends(self) -> tuple[Complexes, Complexes]:
        """Where its straight lines begin and end."""
        lines = self.strokes.lines
        return np.array([one.start for one in lines]), np.array([one.end for one in lines])

    def has(self, spot: complex) -> bool:
        """Tell whether a circle stands at a place of the paper."""
        return any(abs(one - spot) <= FINE for one in self.marked)


def laid_scheme(group: Group, mu: float, points: Mapping[str, complex]) -> LaidScheme:
    """Find where a scheme lies: there most of its points have circles, and their letters beside these."""
    strokes = FigureStrokes(group)
    numbers = [one.at for one in strokes.of(Text) if one.plain.isdigit()]
    bare = [one for one in strokes.circles if all(abs(one.centre - at) > one.radius for at in numbers)]
    circles = np.array([one.centre for one in bare])
    spots = np.array(list(points.values()), dtype=np.complex128) / mu
    if not len(circles) or not len(spots):
        return LaidScheme(strokes, complex("nan"), mu)
    tries = np.unique(np.round((circles[:, None] - spots[None, :]).ravel(), 3))
    off = np.abs(tries[:, None, None] + spots[None, :, None] - circles[None, None, :]).min(axis=2)
    score = (off <= FINE).sum(axis=1).astype(float)
    for k in np.flatnonzero(score == score.max()):
        at = (complex(tries[k] + spot) for spot in spots)
        score[k] -= min(sum(strokes.far(name, [spot]) for name, spot in zip(points, at, strict=True)) / FAR, 0.5)
    return LaidScheme(strokes, _middle(circles, spots, complex(tries[int(score.argmax())])), mu)


def _middle(circles: Complexes, spots: Complexes, near: complex) -> complex:
    """Give the datum by the circles that stand where points are."""
    off = circles[None, :] - spots[:, None] - near
    found = off[np.abs(off) <= FINE]
    return near + complex(found.mean()) if found.size else near


def links_of(group: Group) -> tuple[int, ...]:
    """Give the links of a scheme by its name: scheme-4-5-2 is of the links 4 and 5 in position 2."""
    return tuple(int(link) for link in group.name.split("-")[1:-1] if int(link) != FRAME)


def _arrows(strokes: FigureStrokes) -> Iterator[Arrow]:
    solid = [*strokes.plain, None]
    for (line, head), after in zip(pairwise(strokes.plain), solid[2:], strict=True):
        if isinstance(line, Line) and not isinstance(after, Fill) and (tip := _tip(head)) is not None:
            spot, back = tip
            start, end = (line.start, line.end) if abs(line.end - spot) <= FINE else (line.end, line.start)
            ahead = ((spot - back) * (end - start).conjugate()).real > 0
            if abs(end - spot) <= FINE and ahead and abs(end - start) > 2 * abs(spot - back) - FINE:
                yield Arrow(start, end)


def _tip(head: object) -> tuple[complex, complex] | None:
    """Give the tip of an arrowhead, filled or open, and the middle of its back."""
    match head:
        case Fill((tip, one, other)) | Polyline((one, tip, other), False):
            return tip, (one + other) / 2
    return None
