"""The strokes of a load diagram: heading, axes, courses there and back, corners, the stroke and overruns (линии)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from drawings.checks.dynamics.load_law import branches
from drawings.checks.graphs.figure_strokes import FLUSH, read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_text
from drawings.checks.letters import along
from drawings.checks.precise import precise, tells
from drawings.checks.wrong import Wrong, on
from drawings.lettering.words import letter as lettered
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle, Fill, Group, Line, Polyline, Text
from plans.model.machine import Force, Moment

DIGITS = 4
SHORT = 0.05  # mm: a shorter ordinate, or a shorter part of a course, is a point
OVERRUNS = ("overrun_1", "overrun_2")

Course = list[tuple[float, float]]  # shares of the stroke with the load, N or N*m, in the order of the motion


class Laid(NamedTuple):
    """Where a diagram lies on paper: its zero, mm, its stroke, m or degrees, the scales of the way and of the load."""

    zero: complex
    length: float
    across: float
    up: float

    def on(self, share: float, size: float = 0.0) -> complex:
        """Give the place on paper of a load at a share of the stroke, mm."""
        return self.zero + share * self.length / self.across + 1j * size / self.up


@dataclass(frozen=True)
class LoadStrokes:
    """A load diagram on a sheet with all that must be drawn of it."""

    plan: str
    group: Group
    laid: Laid
    load: Force | Moment
    sliding: bool
    marks: Sequence[MeasuredVector]  # the ordinates of corners
    spots: Sequence[complex]  # of the load in the positions, on paper: a sheet of forces shows them
    near: float
    drafting: Drafting

    @cached_property
    def inventory(self) -> Inventory:
        """What is drawn."""
        return Inventory(self.plan, (self.group,), self.near + FLUSH)

    @cached_property
    def courses(self) -> list[Course]:
        """The courses of the load there and back."""
        return list(courses(self.load))

    def faults(self) -> Iterator[Wrong]:
        """Hold all of it."""
        self._heading()
        self._axes()
        self._dimensions()
        self._corners()
        self._branches()
        for k, spot in enumerate(self.spots):
            if np.isfinite(spot):
                self.inventory.every(Circle, lambda one, spot=spot: self.inventory.at(one.centre, spot))  # type: ignore[misc]
                self.inventory.letter(str(k), [spot])
        return self.inventory.faults()

    @property
    def _letters(self) -> tuple[tuple[str, str, str], tuple[str, str]]:
        """Give letter and unit of the way, the letter of the whole stroke; letter and unit of the load."""
        way = ("S", "m", "H") if self.sliding else ("ψ", "°", "ψ")
        return way, ("M", "N*m") if isinstance(self.load, Moment) else ("F", "N")

    def _heading(self) -> None:
        own, ((way, unit, _), up), language = self.inventory, self._letters, self.drafting.language
        head, _, index = self.load.name.partition("_")
        name = lettered(language, f"{head}_{{{index}}}" if index else head)
        title = read(self.drafting.word("load diagram of", name=name))
        own.text(title, on("title", self.plan, text=title))
        how = (language, self.drafting.notation)
        under = f"{scale_text(self.laid.across, way, unit, how)};  {scale_text(self.laid.up, *up, how)}"
        own.text(under, on("scale_missing", self.plan, text=under))

    def _axes(self) -> None:
        """Hold both axes past all that is drawn over them, with their heads and letters."""
        own, laid, wrong = self.inventory, self.laid, on("axis_line", self.plan)
        (way, unit, _), (up, force) = self._letters
        sizes = [size for course in self.courses for _, size in course]
        low, high = min(0.0, *sizes) / laid.up, max(0.0, *sizes) / laid.up
        spans = (1 + 0j, 0.0, laid.length / laid.across, f"{way}, {self.drafting.word(unit)}")
        for axis, least, most, letter in (spans, (1j, low, high, f"{up}, {self.drafting.word(force)}")):
            line = own.take(
                Line,
                lambda one, axis=axis, least=least, most=most: self._spans(one, axis, least, most),  # type: ignore[misc]
                wrong,
            )
            if line is not None:
                own.head(line.end, axis, wrong)
                own.letter(letter, [line.end], on("letter", self.plan, name=letter))

    def _spans(self, one: Line, way: complex, low: float, high: float) -> bool:
        start, end = ((spot - self.laid.zero) / way for spot in (one.start, one.end))
        near = self.inventory.near
        return max(abs(start.imag), abs(end.imag)) <= near and abs(start.real - low) <= near and end.real > high + near

    def _dimensions(self) -> None:
        """Hold the dimension of the stroke, in mm or degrees, and those of the overruns in shares of it."""
        number, (_, unit, whole) = precise(self.drafting).number, self._letters[0]
        told = f"{number(1000 * self.laid.length)}" if self.sliding else f"{number(self.laid.length)}{unit}"
        self._dimension(0.0, 1.0, f"{whole} = {told}")
        first, last = self.load.overrun
        for share, start, end in ((first, 0.0, first), (last, 1 - last, 1.0)):
            if share:
                self._dimension(start, end, f"{number(share)}{whole}")

    def _dimension(self, start: float, end: float, due: str) -> None:
        own, wrong = self.inventory, on("size", self.plan, name=due)
        line = own.dimension(self.laid.on(start), self.laid.on(end), wrong)
        if line is not None:
            spots = tuple(along(line.start, line.end))
            own.take(Text, lambda one: tells(one.plain, due, (DIGITS,), self.near) and own.beside(one, spots), wrong)

    def _corners(self) -> None:
        """Hold tick, ordinate, point and letter of each corner that has an ordinate; letters follow the courses."""
        own, laid = self.inventory, self.laid
        places = [laid.on(*corner) for course in self.courses for corner in course]
        order = []
        for one in sorted(self.marks, key=lambda one: (len(one.name), one.name)):
            wrong = on("corner_of", self.plan, name=one.name)
            foot, tip = one.start, one.end
            own.tick(foot, wrong)
            line = own.line(foot, tip, wrong)
            if line is not None and line.style.width >= self.drafting.hand.main:
                own.wrong.append(wrong)
            own.circle(tip, wrong)
            own.letter(one.name, [tip], on("letter", self.plan, name=one.name))
            order.append(next((k for k, place in enumerate(places) if own.at(place, tip)), -1))
        if order != sorted(order):
            own.wrong.append(on("letter", self.plan, name=self.marks[0].name))
        for place in (place for place in places if abs((place - laid.zero).imag) <= SHORT):
            if own.circle(place) is not None:
                own.tick(complex(place.real, laid.zero.imag))

    def _branches(self) -> None:
        """Hold the courses with their arrows in the sense of the motion, and what joins them at the ends."""
        chains = [[self.laid.on(*corner) for corner in course] for course in self.courses]
        for chain in chains:
            self._chain(chain)
            parts = [(one, other) for one, other in pairwise(chain) if abs(other - one) > SHORT]
            if parts and len(chain) > 2:
                self.inventory.take(
                    Fill,
                    lambda one, parts=parts: any(self._heads(one, *part) for part in parts),  # type: ignore[misc]
                    on("head", self.plan, name=self.load.name),
                )
        if len(chains) > 1:
            there, back = chains
            for ends in ((there[0], back[-1]), (there[-1], back[0])):
                if abs(ends[1] - ends[0]) > SHORT:
                    self._chain(ends)

    def _heads(self, one: Fill, start: complex, end: complex) -> bool:
        """Tell whether a head stands in the middle of a part of a course, and points on along it."""
        tip, back = one.points[0], sum(one.points[1:]) / max(len(one.points) - 1, 1)
        way = (tip - back) / (end - start)
        return self.inventory.at(tip, (start + end) / 2) and way.real > 0 and abs(way.imag) <= FLUSH * way.real

    def _chain(self, due: Sequence[complex]) -> None:
        own, wrong = self.inventory, on("curve", self.plan)
        if max(abs(spot - due[0]) for spot in due) <= SHORT:
            return
        spots, thick = self._apart(due), self.drafting.hand.main
        if len(spots) == 2:
            line = own.line(spots[0], spots[1])
            if line is not None and line.style.width == thick:
                return
        own.take(
            Polyline,
            lambda one: one.style.width == thick and self._follows(self._apart(one.points), spots),
            wrong,
        )

    def _apart(self, points: Sequence[complex]) -> list[complex]:
        """Give the corners of a chain, those left out that stand where the one before does."""
        found = list[complex]()
        for spot in points:
            if not found or abs(spot - found[-1]) > self.inventory.near:
                found.append(spot)
        return found

    def _follows(self, points: Sequence[complex], due: Sequence[complex]) -> bool:
        if len(points) != len(due):
            return False
        ways = (list(zip(points, way, strict=True)) for way in (due, due[::-1]))
        return any(all(self.inventory.at(*pair) for pair in pairs) for pairs in ways)


def courses(load: Force | Moment) -> Iterator[Course]:
    """Give the course of a load over its stroke there, and that back, by its law alone; it may rest on one of them."""
    begin, end = load.overrun[0], 1 - load.overrun[1]
    for back, shares, found in branches(load):
        own: Course = list(zip(shares.tolist(), found.tolist(), strict=True))
        own = [*([(0.0, 0.0), (begin, 0.0)] if begin else []), *own, *([(end, 0.0), (1.0, 0.0)] if end < 1 else [])]
        yield own[::-1] if back else own
