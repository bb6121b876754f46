"""The arcs, pins and dots of a profile's figure: each about a place of the construction (дуги и точки профиля)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from drawings.checks.cam.cam_expected import Expected
from drawings.checks.cam.cam_lines import CHORDED, SMALL, ProfileLines
from drawings.checks.graphs.figure_strokes import NEAR
from drawings.checks.wrong import Wrong, on
from drawings.measure.measured import MeasuredVector
from drawings.paper.strokes import Arc

PLAN = "profile"
PIN, DOT = 0.9, 0.5  # mm, radii of a roller's pin and of the points of a circle of curvature


@dataclass(frozen=True)
class RoundLines:
    """The figure of one profile, and the vector of its least radius, if that is drawn."""

    lines: ProfileLines
    least: MeasuredVector | None

    def faults(self) -> Iterator[Wrong]:
        """See that the pin, the arc of a rocker's tip and the centre of curvature are there, and that no arc strays."""
        expected, strokes, lines = self.lines.expected, self.lines.strokes, self.lines
        symbol, tip = lines.drafting.hand.symbol, lines.on(complex(expected.contour.tip[0]))
        if expected.found.roller and not strokes.circled(tip, PIN * symbol):
            yield on("roller", PLAN, name="0")
        known = [*self._arcs(expected)]
        turning = [(one.centre, one.radius) for one in strokes.turnings]
        for arc in strokes.arcs:
            hinge = abs(arc.centre - known[0][0]) <= CHORDED and arc.radius <= SMALL * symbol
            if not hinge and not self._osculates(arc) and not any(_alike(arc, *one) for one in (*known, *turning)):
                yield on("stray", PLAN, x=f"{arc.at(0.5).real:.1f}", y=f"{arc.at(0.5).imag:.1f}")
        if expected.cam.rocks and not expected.cam.flat and not any(_alike(arc, *known[0]) for arc in strokes.arcs):
            yield on("path", PLAN, name="K")
        yield from self._curvature()

    def _arcs(self, expected: Expected) -> Iterator[tuple[complex, float]]:
        """Give centre and radius of every arc of the construction: of a rocker's tip, notches, of curvature."""
        own, lines = expected.contour, self.lines
        pivot = lines.on(expected.sizes.pivot)
        yield pivot, abs(lines.on(complex(own.tip[0])) - pivot)
        pivots = expected.back(np.full_like(own.pitch, expected.sizes.pivot), own.turned)
        for spot, turned in zip(lines.spots.tolist(), pivots.tolist(), strict=True):
            yield lines.origin, abs(spot - lines.origin)
            yield lines.on(turned), abs(spot - lines.on(turned))

    def _osculates(self, arc: Arc) -> bool:
        """Tell whether an arc is that of the least radius, which touches the curve where it is so bent."""
        sharpest = self.lines.expected.found.sharpest
        if sharpest is None:
            return False
        spot = self.lines.on(self.lines.expected.at(sharpest.turned))
        radius = abs(sharpest.value) / self.lines.mu
        return abs(arc.radius - radius) <= CHORDED and abs(abs(arc.centre - spot) - radius) <= CHORDED

    def _curvature(self) -> Iterator[Wrong]:
        """Hold the dot in the centre of the least radius."""
        size = DOT * self.lines.drafting.hand.symbol
        if self.least is not None and not any(
            abs(one.centre - self.least.start) <= CHORDED and abs(one.radius - size) <= NEAR
            for one in self.lines.strokes.circles
        ):
            yield on("circle", PLAN, name="ρ_min")


def _alike(arc: Arc, centre: complex, radius: float) -> bool:
    return abs(arc.centre - centre) <= CHORDED and abs(arc.radius - radius) <= CHORDED
