"""The strokes of Wittenbauer's loop: heading, axes, points, curve, tangents, angles, cuts (линии петли)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.dynamics.dynamics_expected import Expected
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.wrong import Wrong, on
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Arc, Circle, Group, Line, Polyline
from plans.model.dynamics import Flywheel
from plans.model.motion import Complexes

LOOP = "loop"
CUTS, ANGLES = ("l", "k"), ("ψ_{min}", "ψ_{max}")
MEASURED = ("ψmin", "ψmax")
SHORT = 1.0  # mm: a segment that is shorter may have no dimension
SWAY = 0.7  # of the longest step beside a part of the loop: how far its curve may leave its ends
BROKEN = 6  # corners of a tangent that is broken off towards the origin
FINE = 1e-4  # rad that an arc may end off its direction


@dataclass(frozen=True)
class LoopStrokes:
    """The loop on a sheet with all that must be drawn of it: its origin on paper, mm, its scales, its points, mm."""

    group: Group
    origin: complex
    scales: tuple[float, float]  # of inertia and of energy
    places: Complexes  # (n + 1,), from the origin
    expected: Expected
    names: Sequence[str]
    tangents: Sequence[MeasuredVector]
    near: float
    drafting: Drafting

    @cached_property
    def inventory(self) -> Inventory:
        """What is drawn."""
        return Inventory(LOOP, (self.group,), self.near)

    def faults(self) -> Iterator[Wrong]:
        """Hold all of it."""
        self._heading()
        self._axes()
        own = self.inventory
        own.take(Polyline, lambda one: self._follows(one.points), on("curve", LOOP))
        own.circle(self.origin, on("missing_on", LOOP, name="o1"))
        if self.expected.wheel is not None:
            for which in (0, 1):
                self._tangent(self.expected.wheel, which)
        for place in self.places[:-1].tolist():
            own.every(Circle, lambda one, place=place: own.at(one.centre, self.origin + place))  # type: ignore[misc]
        for name, place in zip(self.names[:-1], self.places[:-1].tolist(), strict=True):
            own.letter(name, [self.origin + place])
        return own.faults()

    def _heading(self) -> None:
        title, (inertia, energy) = self.drafting.word("loop"), self.scales
        self.inventory.text(title, on("title", LOOP, text=title))
        lines = scale_line(energy, "T", "J", self.drafting), scale_line(inertia, "J", "kg*m2", self.drafting)
        under = ";  ".join(lines)
        self.inventory.text(under, on("scale_missing", LOOP, text=under))

    def _axes(self) -> None:
        """Hold both axes with their heads, past all points, and their letters."""
        word, own = self.drafting.word, self.inventory
        letters = (1 + 0j, f"ΔJ, {word('kg*m2')}"), (1j, f"ΔT, {word('J')}")
        for way, letter in letters:
            low, high = (float(end([*(self.places / way).real.tolist(), 0.0])) for end in (min, max))
            wrong = on("axis_line", LOOP)
            line = own.take(Line, lambda one, way=way, low=low, high=high: self._spans(one, way, low, high), wrong)  # type: ignore[misc]
            if line is not None:
                own.head(line.end, way, wrong)
                own.letter(letter, [line.end], on("letter", LOOP, name=letter))
        own.letter("o1", [self.origin], on("letter", LOOP, name="o1"))

    def _spans(self, one: Line, way: complex, low: float, high: float) -> bool:
        start, end = ((spot - self.origin) / way for spot in (one.start, one.end))
        level = max(abs(start.imag), abs(end.imag)) <= self.near
        return level and start.real <= low + self.near and end.real > high

    def _follows(self, points: Sequence[complex]) -> bool:
        """Tell whether a chain goes from point to point in their order, and between two of them not far from both."""
        own, at = np.array(points), self.origin + self.places
        first = list[int]()
        for place in at[:-1].tolist():
            later = np.flatnonzero(np.abs(own[first[-1] if first else 0 :] - place) <= self.near)
            if not later.size:
                return False
            first.append(int(later[0]) + (first[-1] if first else 0))
        steps = np.abs(np.diff(at))
        far = SWAY * np.max([np.roll(steps, 1), steps, np.roll(steps, -1)], axis=0) + self.near
        pieces = np.split(own, first[1:])
        return all(
            float(_aside(piece, start, end).max(initial=0.0)) <= reach
            for piece, start, end, reach in zip(pieces, at[:-1], at[1:], far.tolist(), strict=True)
        )

    def _tangent(self, wheel: Flywheel, which: int) -> None:
        """Hold a tangent: both pieces, its break, its angle with its letter, what it cuts off."""
        own, name, wrong = self.inventory, MEASURED[which], on("line_of", LOOP, name=MEASURED[which])
        inertia, energy = self.scales
        cut = self.origin + 1j * wheel.cuts[which] / energy
        along = complex(1.0, wheel.slopes[which] * inertia / energy)
        seen = next((one for one in self.tangents if one.name == name), None)
        if seen is None:
            return
        own.line(seen.start, seen.end, wrong)
        own.circle(cut, on("missing_on", LOOP, name=CUTS[which]))
        own.letter(CUTS[which], [cut], on("letter", LOOP, name=CUTS[which]))
        near = own.take(Line, lambda one: own.at(one.start, cut) and self._lies(one.end - cut, along), wrong)
        ends = [cut, seen.end, *([near.end] if near is not None else [])]
        right, left = (end(ends, key=lambda spot: spot.real) for end in (max, min))
        own.take(Polyline, lambda one: len(one.points) == BROKEN and own.at(one.points[0], left), wrong)
        self._angle(right, along, on("arc", LOOP, name=ANGLES[which]))
        letter = read(ANGLES[which])
        longer = abs(right - cut) - abs(cut - left)  # the letter stands where the longer piece is: beside its end
        spots = [spot for spot, due in ((right, longer > -self.near), (cut, longer < self.near)) if due]
        own.letter(letter, spots, on("letter", LOOP, name=letter))
        segment, letter = self.origin - cut, f"o1{CUTS[which]}"
        if abs(segment) >= SHORT:
            line = own.dimension(self.origin, cut, on("size", LOOP, name=letter))
            spots = [] if line is None else [(line.start + line.end) / 2]
            own.letter(letter, spots, on("letter", LOOP, name=letter))

    def _lies(self, run: complex, along: complex) -> bool:
        return abs((run * along.conjugate()).imag) <= 2 * self.near * abs(along)

    def _angle(self, end: complex, along: complex, wrong: Wrong) -> None:
        """Hold the angle at the right end of a tangent: both its sides and its arc between them."""
        own = self.inventory
        for way in (along, 1 + 0j):
            own.take(
                Line,
                lambda one, way=way: (
                    own.at(one.start, end)  # type: ignore[misc]
                    and abs(cmath.phase((one.end - end) / way)) <= FINE
                ),
                wrong,
            )
        own.take(Arc, lambda one: own.at(one.centre, end) and _between(one, cmath.phase(along)), wrong)


def _between(one: Arc, turn: float) -> bool:
    return abs(one.start_angle) <= FINE and abs(one.end_angle - turn) <= FINE


def _aside(points: Complexes, start: complex, end: complex) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Give how far points are from the nearer of two others, mm."""
    return np.minimum(np.abs(points - start), np.abs(points - end))
