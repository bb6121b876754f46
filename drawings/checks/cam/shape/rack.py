"""The body of a cam that translates, on the ground that it slides on, by the analysis (кулачок-рейка)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.graphs.figure_strokes import FLUSH, FigureStrokes
from drawings.checks.graphs.linework import Way
from drawings.checks.wrong import Wrong, on
from drawings.paper.strokes import Line, Polyline
from drawings.symbols.symbols import HATCH
from plans.analytic.cam.contour import contour
from plans.model.cam_motion import CamFound, Contour

MANY = 1441  # places at which the profile is known
DEEP = 0.8  # of the lift: how far below its lowest place the body goes
UNDER, GROUND = 1.2, 30.0  # mm from the body to the ground, and the length of that


@dataclass(frozen=True)
class Rack:
    """A cam that translates on paper: where its O is, mm, its scale m/mm, the factor of symbols."""

    found: CamFound
    origin: complex
    mu: float
    symbol: float

    @cached_property
    def contour(self) -> Contour:
        """Its contour at many places."""
        turned = np.linspace(0.0, self.found.cam.turn, MANY)
        return contour(self.found.cam, self.found.sizes, self.found.roller, turned)

    @cached_property
    def corners(self) -> tuple[complex, complex, complex, complex]:
        """The corners of its body on paper, from the left end of the profile down and round to the right one."""
        profile = self.contour.profile
        low = float(profile.imag.min()) - DEEP * self.found.cam.lift
        left, right = (complex(x, low) for x in (float(profile.real.min()), float(profile.real.max())))
        first, last = sorted((complex(profile[0]), complex(profile[-1])), key=lambda spot: spot.real)
        on = (self.origin + one / self.mu for one in (first, left, right, last))
        return next(on), next(on), next(on), next(on)

    def faults(self, strokes: FigureStrokes, plan: str) -> Iterator[Wrong]:
        """Hold the body: one chain of main lines under the profile."""
        chains = [one.points for one in strokes.of(Polyline) if not one.closed]
        near = [
            len(one) == len(self.corners)
            and max(abs(a - b) for a, b in zip(one, self.corners, strict=True)) <= 10 * FLUSH
            for one in chains
        ]
        if near != [True]:
            yield on("rim", plan, name="O")

    @property
    def _base(self) -> tuple[complex, complex]:
        left, right = self.corners[1:3]
        middle, half = (left + right) / 2 - 1j * UNDER * self.symbol, GROUND * self.symbol / 2
        return middle - half, middle + half

    def ways(self) -> Iterator[Way]:
        """Give the lines that there must be: the ground, and the level of O as long as the body."""
        yield Way("0", *self._base)
        left, right = (complex(one.real, self.origin.imag) for one in self.corners[1:3])
        yield Way("O", left, right, abs(right - left), due=False)

    def hatching(self, line: Line) -> bool:
        """Tell whether a line is of the hatching of the ground."""
        start, end = self._base
        deep = start.imag - HATCH * self.symbol - FLUSH
        ends = (line.start, line.end)
        return all(
            start.real - HATCH * self.symbol - FLUSH <= one.real <= end.real + FLUSH
            and deep <= one.imag <= start.imag + FLUSH
            for one in ends
        )
