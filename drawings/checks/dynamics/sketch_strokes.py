"""The strokes of the flywheel's sketch: outlines of cut and side view, hatching, axes, sizes (линии эскиза)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.dynamics.dynamics_expected import KNOWN
from drawings.checks.graphs.figure_strokes import FLUSH
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_line
from drawings.checks.letters import along
from drawings.checks.precise import precise, tells
from drawings.checks.wrong import Wrong, on
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Circle, Group, Line, Polyline, Text
from drawings.symbols.hatching import hatching
from plans.model.flywheel_rim import Wheel

SKETCH = "flywheel_sketch"
# Usual wheels: shaft and hub of the mean diameter, web of the breadth; the hub at most so much of the inner diameter.
SHAFT, HUB, WEB, MOST = 0.12, 0.24, 0.35, 0.7
BETWEEN = 0.3  # of the mean diameter: between the two views
DIGITS = 4
RING = 0.25  # of the outer diameter: by its circles the side view is told from any dot


@dataclass(frozen=True)
class SketchStrokes:
    """The sketch on a sheet with the rim that the analysis asks for; its scale, m a mm."""

    group: Group
    rim: Wheel
    mu: float
    drafting: Drafting

    @cached_property
    def inventory(self) -> Inventory:
        """What is drawn."""
        return Inventory(SKETCH, (self.group,), FLUSH + KNOWN * self.rim.diameter / self.mu)

    def faults(self) -> Iterator[Wrong]:
        """Hold all of it."""
        own = self.inventory
        middle = self._middle
        if middle is None:
            own.wrong.append(on("circle", SKETCH, name="D"))
            return own.faults()
        self._words()
        self._side(middle)
        zero = middle - self._apart
        self._cut(zero)
        self._axes(zero, middle)
        self._sizes(zero)
        return own.faults()

    @property
    def _middle(self) -> complex | None:
        """The middle of the side view on paper, mm, by its largest circle."""
        largest = max(self.inventory.left(Circle), key=lambda one: one.radius, default=None)
        return None if largest is None or largest.radius < RING * self._mm(self.rim.diameter) else largest.centre

    def _mm(self, size: float) -> float:
        return size / self.mu

    @property
    def _radii(self) -> tuple[float, float, float, float]:
        """The radii of rim, outer and inner, hub and shaft, m."""
        inner = (self.rim.diameter - self.rim.thickness) / 2
        hub = min(HUB * self.rim.diameter / 2, MOST * inner)
        return inner + self.rim.thickness, inner, hub, hub * SHAFT / HUB

    @property
    def _long(self) -> float:
        """Half the length of the hub, m: as long as the rim is broad, and no shorter than thick."""
        return max(self.rim.breadth / 2, self._radii[2])

    @property
    def _apart(self) -> float:
        """How far the side view is from the cut, mm."""
        return self._mm(self._long + BETWEEN * self.rim.diameter + self._radii[0])

    def _words(self) -> None:
        own, word = self.inventory, self.drafting.word
        number = precise(self.drafting).number
        own.text(word("flywheel"), on("title", SKETCH, text=word("flywheel")))
        scale = scale_line(self.mu, "l", "m", self.drafting)
        own.text(scale, on("scale_missing", SKETCH, text=scale))
        told = word("rim mass", mass=number(self.rim.mass), inertia=number(self.rim.inertia))
        own.take(Text, lambda one: tells(one.plain, told, (DIGITS,), KNOWN), on("letter", SKETCH, name="m, J"))

    def _side(self, middle: complex) -> None:
        """Hold the circles of the side view, that of the mean diameter among them as an axis."""
        own, thick = self.inventory, self.drafting.hand.main
        for radius in map(self._mm, self._radii):
            own.take(Circle, lambda one, radius=radius: self._rings(one, middle, radius, thick), self._wrong("rim"))  # type: ignore[misc]
        mean = self._mm(self.rim.diameter / 2)
        wrong = on("circle", SKETCH, name="D")
        own.take(Circle, lambda one: bool(one.style.dash) and self._rings(one, middle, mean, one.style.width), wrong)

    def _rings(self, one: Circle, centre: complex, radius: float, width: float) -> bool:
        own = self.inventory
        return own.at(one.centre, centre) and abs(one.radius - radius) <= own.near and one.style.width == width

    def _wrong(self, key: str) -> Wrong:
        return on(key, SKETCH, name=self.drafting.word("flywheel"))

    def _cut(self, zero: complex) -> None:
        """Hold both halves of the cut, each hatched within its outline, and what of hub and shaft is seen beyond it."""
        own, hand = self.inventory, self.drafting.hand
        upper = [zero + self._mm(1) * corner for corner in self._outline]
        for outline in (upper, [zero + (spot - zero).conjugate() for spot in upper]):
            own.take(Polyline, lambda one, outline=outline: self._follows(one, outline), self._wrong("rim"))  # type: ignore[misc]
            for line in hatching(outline, hand):
                own.line(line.start, line.end, on("line", SKETCH))
        ends = (self._mm(x * self._long) for x in (-1, 1))
        half = 1j * self._mm(self._radii[3])
        for end in ends:
            own.line(zero + end - half, zero + end + half, on("line", SKETCH))

    @property
    def _outline(self) -> list[complex]:
        """The outline of the upper half, m, from the shaft up on the right and down on the left."""
        outer, inner, hub, shaft = self._radii
        broad, web = self.rim.breadth / 2, WEB * self.rim.breadth / 2
        right = [self._long + 1j * shaft, self._long + 1j * hub, web + 1j * hub]
        right += [web + 1j * inner, broad + 1j * inner, broad + 1j * outer]
        return [*right, *(-corner.conjugate() for corner in reversed(right))]

    def _follows(self, one: Polyline, outline: list[complex]) -> bool:
        if len(one.points) != len(outline) or not one.closed or one.style.width != self.drafting.hand.main:
            return False
        return bool((np.abs(np.array(one.points) - np.array(outline)) <= self.inventory.near).all())

    def _axes(self, zero: complex, middle: complex) -> None:
        """Hold the axis of the shaft through both views, and the upright one of the side view."""
        spans = (zero, self._long, 1.0), (middle, self._radii[0], 1.0), (middle, self._radii[0], 1j)
        for centre, reach, way in spans:
            self.inventory.take(
                Line,
                lambda one, centre=centre, reach=reach, way=way: self._axis(one, centre, self._mm(reach), way),  # type: ignore[misc]
                on("axis_line", SKETCH),
            )

    def _axis(self, one: Line, centre: complex, reach: float, way: complex) -> bool:
        """Tell whether a line is a dashed axis about a place that goes past both ends alike."""
        half = (one.end - one.start) / 2 / way
        middled = self.inventory.at((one.start + one.end) / 2, centre)
        return middled and bool(one.style.dash) and abs(half.imag) <= self.inventory.near and abs(half) > reach

    def _sizes(self, zero: complex) -> None:
        """Hold the dimensions: the mean diameter, the thickness right of the cut, the breadth over it."""
        rim, (outer, inner, _, _) = self.rim, self._radii
        broad, number = rim.breadth / 2, precise(self.drafting).number
        ends = {
            "D": (-1j * rim.diameter / 2, 1j * rim.diameter / 2),
            "t": (broad + 1j * inner, broad + 1j * outer),
            "b": (-broad + 1j * outer, broad + 1j * outer),
        }
        for name, (start, end) in ends.items():
            wrong, due = on("size", SKETCH, name=name), f"{name} = {number(1000 * abs(end - start))}"
            line = self.inventory.dimension(zero + self._mm(1) * start, zero + self._mm(1) * end, wrong)
            if line is not None:
                self._lettered(line, due, on("letter", SKETCH, name=name))

    def _lettered(self, line: Line, due: str, wrong: Wrong) -> None:
        own, spots = self.inventory, tuple(along(line.start, line.end))
        own.take(Text, lambda one: tells(one.plain, due, (DIGITS,), KNOWN) and own.beside(one, spots), wrong)
