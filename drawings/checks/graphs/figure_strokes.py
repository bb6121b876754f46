"""The strokes of a laid-out figure, to be found by where they must lie on paper (линии фигуры)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple, TypeVar

import numpy as np

from drawings.checks.letters import NEAREST, Label, distance, labels_of
from drawings.paper.strokes import Arc, Circle, Fill, Group, Leaf, Line, Polyline, Stroke, Text
from drawings.paper.walk import flat, groups
from plans.model.motion import Complexes

Kind = TypeVar("Kind", bound=Stroke)
# mm: what arithmetic moves a place on paper by, and what two roads that agree in 1e-9 of a metre differ by.
NEAR = 1e-6
FLUSH = 1e-3  # mm: chains and points of one curve that are so near are on it; no eye sees less
STEEP = 1e-9  # rad by which a direction on paper may be off


class Turning(NamedTuple):
    """An arc with an arrowhead: where it begins and where its tip is, mm, its sense, and how long its head is, mm."""

    centre: complex
    radius: float
    start: complex
    tip: complex
    sense: int
    head: float

    @property
    def swept(self) -> float:
        """How far it goes round from its beginning to its tip, rad."""
        return abs(cmath.phase((self.tip - self.centre) / (self.start - self.centre)) % (self.sense * math.tau))

    @property
    def middle(self) -> complex:
        """The middle of its arc."""
        half = cmath.phase((self.tip - self.centre) / (self.start - self.centre)) % (self.sense * math.tau) / 2
        return self.centre + (self.start - self.centre) * cmath.rect(1.0, half)


class Pointing(NamedTuple):
    """A straight arrow: its ends, mm."""

    start: complex
    tip: complex


@dataclass(frozen=True)
class FigureStrokes:
    """The strokes of one figure, and its letters."""

    group: Group

    @cached_property
    def plain(self) -> tuple[Stroke, ...]:
        """All strokes from back to front, those of the marks too."""
        return tuple(flat((self.group,)))

    def of(self, kind: type[Kind]) -> Iterator[Kind]:
        """Give the strokes of one kind."""
        return (one for one in self.plain if isinstance(one, kind))

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """The straight lines."""
        return tuple(self.of(Line))

    @cached_property
    def circles(self) -> tuple[Circle, ...]:
        """The whole circles."""
        return tuple(self.of(Circle))

    @cached_property
    def arcs(self) -> tuple[Arc, ...]:
        """The arcs."""
        return tuple(self.of(Arc))

    @cached_property
    def chains(self) -> tuple[Polyline, ...]:
        """The chains of lines."""
        return tuple(self.of(Polyline))

    @cached_property
    def heads(self) -> tuple[Fill, ...]:
        """The arrowheads and the points of followers."""
        return tuple(self.of(Fill))

    @cached_property
    def turnings(self) -> tuple[Turning, ...]:
        """The arcs that bear an arrowhead."""
        pairs = pairwise(self.plain)
        return tuple(_turning(one, head) for one, head in pairs if isinstance(one, Arc) and isinstance(head, Fill))

    @cached_property
    def pointings(self) -> tuple[Pointing, ...]:
        """The lines that bear an arrowhead at one end alone."""
        pairs = pairwise(self.plain)
        heads = ((one, head.points[0]) for one, head in pairs if isinstance(one, Line) and isinstance(head, Fill))
        return tuple(
            Pointing(*((one.start, tip) if abs(tip - one.end) <= NEAR else (one.end, tip)))
            for one, tip in heads
            if min(abs(tip - one.end), abs(tip - one.start)) <= NEAR
        )

    @cached_property
    def labels(self) -> dict[str, list[Label]]:
        """The letters as they are read, with the places that they point to."""
        return labels_of((self.group,))

    @cached_property
    def texts(self) -> tuple[str, ...]:
        """All that is written, as it is read."""
        return tuple(one.plain for one in self.of(Text))

    def far(self, letter: str, spots: Iterable[complex]) -> float:
        """Give how far a letter is from the nearest of some spots, mm."""
        return distance(self.labels.get(read(letter), ()), spots)

    def lettered(self, letter: str, spots: Iterable[complex]) -> bool:
        """Tell whether a letter stands beside one of some spots."""
        return self.far(letter, spots) <= NEAREST

    @cached_property
    def _ends(self) -> tuple[Complexes, Complexes]:
        return np.array([one.start for one in self.lines]), np.array([one.end for one in self.lines])

    def through(self, spot: complex, way: complex, near: float = NEAR) -> list[Line]:
        """Give the lines that go through a place in a direction or against it, so near to it, mm."""
        if not self.lines:
            return []
        start, end = self._ends
        run, along = end - start, way / abs(way)
        size = np.maximum(np.abs(run), near)
        gone = ((spot - start) * run.conj()).real / size
        aside = np.abs(((spot - start) * along.conjugate()).imag)
        straight = np.abs((run * along.conjugate()).imag) <= 2 * near
        found = straight & (aside <= near) & (gone >= -near) & (gone <= size + near)
        return [self.lines[k] for k in np.flatnonzero(found)]

    def joins(self, start: complex, end: complex, near: float = NEAR) -> bool:
        """Tell whether a line goes from one place to another, or back."""
        if not self.lines:
            return False
        one, other = self._ends
        off = np.minimum(
            np.maximum(np.abs(one - start), np.abs(other - end)), np.maximum(np.abs(one - end), np.abs(other - start))
        )
        return bool(off.min() <= near)

    def circled(self, centre: complex, radius: float) -> bool:
        """Tell whether a circle is drawn."""
        return any(abs(one.centre - centre) <= NEAR and abs(one.radius - radius) <= NEAR for one in self.circles)

    def arched(self, centre: complex, spot: complex) -> bool:
        """Tell whether an arc about a centre goes through a place."""
        radius, turn = abs(spot - centre), cmath.phase(spot - centre)
        own = (one for one in self.arcs if abs(one.centre - centre) <= NEAR and abs(one.radius - radius) <= NEAR)
        return any((turn - one.start_angle + STEEP) % math.tau <= one.sweep + 2 * STEEP for one in own)


def read(letter: str) -> str:
    """Write a letter as it is read, without its levels."""
    return Text(0j, letter).plain


def figure(leaf: Leaf, name: str) -> FigureStrokes | None:
    """Give a figure of a sheet, or a part of one, by its name."""
    return next((FigureStrokes(one) for one in groups(leaf.groups) if one.name == name), None)


def _turning(arc: Arc, head: Fill) -> Turning:
    """Read an arrow: its tip goes on from that end of the arc which its wings are nearer to."""
    tip, back = head.points[0], sum(head.points[1:]) / 2
    ends = [arc.centre + cmath.rect(arc.radius, turn) for turn in (arc.start_angle, arc.end_angle)]
    sense = 1 if ((tip - back) / (back - arc.centre)).imag > 0 else -1
    start, neck = ends if sense > 0 else ends[::-1]
    length = arc.radius * abs(cmath.phase((tip - arc.centre) / (neck - arc.centre)))
    return Turning(arc.centre, arc.radius, start, tip, sense, length)
