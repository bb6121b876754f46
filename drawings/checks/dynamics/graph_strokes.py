"""The strokes of a graph over the turn: heading, axes, ticks, points, curves between them, numbers (линии диаграмм)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.checks.dynamics.dynamics_expected import INERTIA, KNOWN, MOMENTS, SPEEDS, SURPLUS, WORKS, Expected
from drawings.checks.graphs.figure_strokes import FLUSH, read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.wrong import Wrong, on
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle, Group, Line, Polyline, Text
from plans.model.dynamics import TURN
from plans.model.motion import Floats

TICKED = 2.5  # mm: so far from the axis at most goes a tick
DIGITS = 5  # of the mean speed
BULGE, SWAY = 0.6, 0.02  # of the largest step beside a strip, and of all: how far a smooth curve may leave its ends
SMOOTH = 120  # edges: of more the chords are as good as a curve
DRAWN = 72  # strips: of more only those with an ordinate have points


class Drawn(NamedTuple):
    """How a quantity is drawn: the phrase of its title, the letters of its axis, of its scale and of its curves."""

    title: str
    axis: str
    scale: tuple[str, str]
    curves: tuple[str, ...] = ()


QUANTITIES: Mapping[str, Drawn] = {
    MOMENTS: Drawn("reduced moments", "M_{red}", ("M", "N*m"), ("M_{us}", "M_{dr}")),
    WORKS: Drawn("works", "A", ("A", "J"), ("A_{us}", "A_{dr}")),
    SURPLUS: Drawn("surplus energy", "ΔT", ("T", "J")),
    INERTIA: Drawn("reduced inertia", "ΔJ", ("J", "kg*m2")),
    SPEEDS: Drawn("speed over the turn", "ω", ("ω", "rad/s")),
}


@dataclass(frozen=True)
class Laid:
    """Where a graph lies on paper: its zero, mm, its scales, the ways of its axes, the edges that have ordinates."""

    zero: complex
    across: float  # rad/mm
    up: float
    along: complex
    rise: complex
    told: frozenset[int]

    def on(self, angle: float, value: float = 0.0) -> complex:
        """Give the place on paper of a value, mm."""
        return self.zero + self.along * angle / self.across + self.rise * value / self.up


@dataclass(frozen=True)
class GraphStrokes:
    """A graph on a sheet with all that must be drawn of it."""

    name: str
    group: Group
    laid: Laid
    expected: Expected
    names: Sequence[str]
    drafting: Drafting

    @cached_property
    def inventory(self) -> Inventory:
        """What is drawn."""
        values = [np.abs(row).max(initial=0.0) for row in self._rows]
        return Inventory(self.name, (self.group,), FLUSH + KNOWN * float(max(values)) / self.laid.up)

    @property
    def _rows(self) -> list[Floats]:
        """The values behind the edges, and of the moments those before them."""
        values = self.expected.graphs[self.name]
        return [values, self.expected.before] if self.name == MOMENTS else [values]

    def faults(self) -> Iterator[Wrong]:
        """Hold all of it."""
        self._heading()
        ends = self._axes()
        self._edges()
        chains = self._curves()
        self._letters(ends, chains)
        return self.inventory.faults()

    def _heading(self) -> None:
        own, told = self.inventory, QUANTITIES[self.name]
        title = self.drafting.word(told.title)
        own.text(title, on("title", self.name, text=title))
        up, angle = scale_line(self.laid.up, *told.scale, self.drafting), self._angle()
        under = f"{up};  {angle}"
        wrong = on("scale_missing", self.name, text=under)
        if self.name == WORKS:  # the pole distance is held by itself
            own.take(
                Text, lambda one: one.plain.startswith(under) and one.plain.endswith(self.drafting.word("mm")), wrong
            )
        else:
            own.text(under, wrong)

    def _angle(self) -> str:
        """Write what stands beside the scale: that of the angle, of the works the pole distance, the mean speed."""
        if self.name == WORKS:
            return "Hp = "
        if self.name == SPEEDS:
            speed = self.drafting.number(self.expected.task.speed, DIGITS)
            return f"ωm = {speed} {self.drafting.word('rad/s')}"
        return scale_line(self.laid.across, "φ", "rad", self.drafting)

    def _axes(self) -> tuple[complex, complex]:
        """Hold both axes with their heads, past all that is drawn over them; give their ends."""
        laid, wrong = self.laid, on("axis_line", self.name)
        low, high = (float(end([end(row) for row in self._rows] + [0.0])) for end in (min, max))
        last = self.inventory.arrow(laid.zero, lambda tip: self._beyond(tip, laid.along, TURN / laid.across), wrong)
        line = self.inventory.take(
            Line,
            lambda one: (
                self._beyond(one.end, laid.rise, high / laid.up)
                and self._beyond(2 * laid.zero - one.start, laid.rise, -low / laid.up - 2 * self.inventory.near)
            ),
            wrong,
        )
        if line is not None:
            self.inventory.head(line.end, line.end - line.start, wrong)
        return last or laid.zero, laid.zero if line is None else line.end

    def _beyond(self, tip: complex, way: complex, least: float) -> bool:
        gone = (tip - self.laid.zero) / way
        return abs(gone.imag) <= self.inventory.near and gone.real > least

    def _edges(self) -> None:
        """Hold the tick, the ordinate and the points of each edge."""
        own, turned = self.inventory, self.expected.cycle.turned
        crowded = len(turned) > DRAWN + 1
        for k, angle in enumerate(turned.tolist()):
            foot, tips = self.laid.on(angle), list(dict.fromkeys(self._tips(k)))
            if crowded and not own.take(Line, lambda one, foot=foot: self._ticks(one, foot)):  # type: ignore[misc]
                if k in self.laid.told:
                    own.wrong.append(on("tick", self.name, name=self.names[k]))
                continue
            if not crowded:
                own.take(
                    Line,
                    lambda one, foot=foot: self._ticks(one, foot),  # type: ignore[misc]
                    on("tick", self.name, name=self.names[k]),
                )
            line = own.line(foot, tips[0])
            if line is not None and line.style.width >= self.drafting.hand.main:
                own.wrong.append(on("line_named", self.name, name=self.names[k]))
            dots = [own.every(Circle, lambda one, tip=tip: own.at(one.centre, tip)) for tip in tips]  # type: ignore[misc]
            if not dots[0]:
                own.wrong.append(on("edge", self.name, name=self.names[k]))

    def _tips(self, k: int) -> Iterator[complex]:
        angle = float(self.expected.cycle.turned[k])
        yield from (self.laid.on(angle, float(row[k])) for row in self._rows)

    def _ticks(self, one: Line, foot: complex) -> bool:
        """Tell whether a line is the tick at a place of the axis."""
        half = (one.end - one.start) / 2 / self.laid.rise
        near = self.inventory.near
        return (
            self.inventory.at((one.start + one.end) / 2, foot) and abs(half.imag) <= near and near < abs(half) < TICKED
        )

    def _curves(self) -> list[tuple[str, Polyline]]:
        """Hold the curve of the quantity between its points, and the straight lines beside it; one may be dashed."""
        own, letters = self.inventory, QUANTITIES[self.name].curves or ("",)
        found = []
        main = self.drafting.hand.main
        chain = own.take(
            Polyline, lambda one: one.style.width == main and self._follows(one.points), on("curve", self.name)
        )
        found += [(letters[0], chain)] if chain is not None else []
        lines = self.expected.lines.get(self.name, ())
        for k, (start, end) in enumerate(lines):
            ends, text = (self.laid.on(0.0, start), self.laid.on(TURN, end)), (*letters[1:], "ω_{min}", "ω_{max}")[k]
            line = own.take(Polyline, lambda one, ends=ends: self._straight(one.points, *ends), on("line", self.name))  # type: ignore[misc]
            found += [(text, line)] if line is not None else []
        if self.name == SPEEDS:
            before = own.take(Polyline, lambda one: bool(one.style.dash) and self._bare(one.points))
            found += [("ω_0", before)] if before is not None else []
        return found

    def _bare(self, points: Sequence[complex]) -> bool:
        """Tell whether a chain goes through the speeds without the flywheel at all edges."""
        before = self.expected.account.before
        if before is None:
            return False
        tips = zip(self.expected.cycle.turned.tolist(), (before.omega - self.expected.mean).tolist(), strict=True)
        return self._through(points, [[self.laid.on(angle, value)] for angle, value in tips])

    def _straight(self, points: Sequence[complex], start: complex, end: complex) -> bool:
        way, near = (end - start) / abs(end - start), self.inventory.near
        off = [abs(((spot - start) / way).imag) for spot in points]
        return max(abs(points[0] - start), abs(points[-1] - end), *off) <= near

    def _follows(self, points: Sequence[complex]) -> bool:
        """Tell whether a chain goes from edge to edge, never back, and between two of them never far from both."""
        turned = self.expected.cycle.turned
        places = (np.array(points) - self.laid.zero) / self.laid.along
        x, y = places.real * self.laid.across, (places / (self.laid.rise / self.laid.along)).real * self.laid.up
        if (np.diff(x) < -KNOWN).any() or not self._through(points, [list(self._tips(k)) for k in range(len(turned))]):
            return False
        between = (
            np.abs(x[:, None] - turned).min(axis=1) > self.inventory.near * self.laid.across
        )  # at an edge a load may jump
        x, y = x[between], y[between]
        strip, (low, high) = np.clip(np.searchsorted(turned, x) - 1, 0, len(turned) - 2), self._band
        smooth = self.name == WORKS or len(turned) > SMOOTH or len(x) >= 2 * len(turned)  # works go by chords
        return smooth and bool(((y >= low[strip]) & (y <= high[strip])).all())

    def _through(self, points: Sequence[complex], tips: Sequence[Sequence[complex]]) -> bool:
        own = np.array(points)
        return all(np.abs(own - tip).min() <= self.inventory.near for some in tips for tip in some)

    @cached_property
    def _band(self) -> tuple[Floats, Floats]:
        """Give how low and how high the curve may go over each strip."""
        after, before = self._rows[0], self._rows[-1]
        ends = np.stack([after[:-1], before[1:]])
        step = np.abs(ends[1] - ends[0])
        beside = np.max([np.roll(step, 1), step, np.roll(step, -1)], axis=0)
        loose = BULGE * beside + SWAY * np.ptp(ends) + self.inventory.near * self.laid.up
        if self.name == MOMENTS:
            loose += 2 * np.abs(-self.expected.cycle.means - ends.mean(axis=0))
        return ends.min(axis=0) - loose, ends.max(axis=0) + loose

    def _letters(self, ends: tuple[complex, complex], chains: Sequence[tuple[str, Polyline]]) -> None:
        """Hold the letters of the axes with the unit, of the curves, and the numbers of the edges."""
        own, told, word = self.inventory, QUANTITIES[self.name], self.drafting.word
        axis = f"{read(self.drafting.letter(told.axis))}, {word(told.scale[1])}"
        own.letter(axis, [ends[1]], on("letter", self.name, name=axis))
        own.letter("φ", [ends[0]], on("letter", self.name, name="φ"))
        for letter, chain in chains:
            text = read(self.drafting.letter(letter))
            if text:
                own.letter(text, chain.points, on("letter", self.name, name=text))
        last = len(self.names) - 1
        for k, name in enumerate(self.names):
            due = k in self.laid.told or k in (0, last)
            foot = self.laid.on(float(self.expected.cycle.turned[k]))
            own.letter(name, [foot], on("letter", self.name, name=name) if due else None)
