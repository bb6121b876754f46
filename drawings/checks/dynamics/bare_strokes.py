"""The strokes of the graph of speeds without the flywheel: heading, axes, ticks, points, curve, numbers (линии)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.dynamics.dynamics_expected import KNOWN, Expected
from drawings.checks.graphs.figure_strokes import FLUSH, read
from drawings.checks.graphs.inventory import Inventory
from drawings.checks.graphs.scale_line import scale_text
from drawings.checks.wrong import Wrong, on
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Line, Polyline
from plans.model.dynamics import TURN, Speeds

BEFORE = "before"
NUMBERED = 36  # positions: of more the curve alone is drawn
BULGE, SWAY = 0.6, 0.02  # of the largest step beside a strip, and of all: how far a smooth curve may leave its ends


@dataclass(frozen=True)
class BareStrokes:
    """The graph on a sheet: its scales, degrees and rad/s a mm, the speeds by the analysis."""

    group: Group
    across: float
    up: float
    expected: Expected
    speeds: Speeds
    drafting: Drafting

    @cached_property
    def inventory(self) -> Inventory:
        """What is drawn."""
        return Inventory(BEFORE, (self.group,), FLUSH + KNOWN * float(self.speeds.omega.max()) / self.up)

    def faults(self) -> Iterator[Wrong]:
        """Hold all of it."""
        self._words()
        zero = self._axes()
        self._positions(zero)
        self.inventory.take(Polyline, lambda one: self._follows(one, zero), on("curve", BEFORE))
        return self.inventory.faults()

    def _words(self) -> None:
        own, title = self.inventory, self.drafting.word("speed without flywheel")
        how = self.drafting.language, self.drafting.notation
        own.text(title, on("title", BEFORE, text=title))
        under = f"{scale_text(self.across, 'φ', '°', how)};  {scale_text(self.up, 'ω', 'rad/s', how)}"
        own.text(under, on("scale_missing", BEFORE, text=under))

    def _axes(self) -> complex:
        """Hold both axes past all that is drawn over them, with their heads and letters; give the zero."""
        own, wrong = self.inventory, on("axis_line", BEFORE)
        letters = read(f"ω_0, {self.drafting.word('rad/s')}"), "φ"
        level = max(own.left(Line), key=lambda one: (one.end - one.start).real, default=None)
        zero = 0j if level is None else level.start
        reaches = float(self.speeds.omega.max()) / self.up, 360 / self.across
        for way, reach, letter in zip((1j, 1 + 0j), reaches, letters, strict=True):
            tip = own.arrow(zero, lambda tip, way=way, reach=reach: self._beyond(tip - zero, way, reach), wrong)  # type: ignore[misc]
            if tip is not None:
                own.letter(letter, [tip], on("letter", BEFORE, name=letter))
        return zero

    def _beyond(self, gone: complex, way: complex, least: float) -> bool:
        return abs((gone / way).imag) <= self.inventory.near and (gone / way).real > least

    def _on(self, zero: complex, angle: float, omega: float = 0.0) -> complex:
        return zero + 360 * angle / TURN / self.across + 1j * omega / self.up

    def _positions(self, zero: complex) -> None:
        """Hold tick and point of each position, ordinates that are thin, numbers; the end has those of a whole turn."""
        own, divisions = self.inventory, self.expected.task.divisions
        places = TURN * np.arange(divisions) / divisions
        edges = np.searchsorted(self.speeds.turned, places - KNOWN)
        for k, edge in enumerate(edges.tolist() if divisions <= NUMBERED else ()):
            foot, tip = (self._on(zero, float(places[k]), omega) for omega in (0.0, float(self.speeds.omega[edge])))
            own.tick(foot, on("tick", BEFORE, name=str(k)))
            line = own.line(foot, tip)
            if line is not None and line.style.width >= self.drafting.hand.main:
                own.wrong.append(on("line_named", BEFORE, name=str(k)))
            own.circle(tip, on("edge", BEFORE, name=str(k)))
            numbered = on("letter", BEFORE, name=str(k)) if line is not None else None
            own.letter(str(k), [foot], numbered)
        last = self._on(zero, TURN)
        own.tick(last, on("tick", BEFORE, name=str(divisions)))
        own.letter(str(divisions), [last], on("letter", BEFORE, name=str(divisions)))

    def _follows(self, one: Polyline, zero: complex) -> bool:
        """Tell whether a thick chain goes through all edges, never back, and between two never far from both."""
        speeds = self.speeds
        points = np.array(one.points) - zero
        x, y = points.real * self.across * TURN / 360, points.imag * self.up
        near = self.inventory.near
        tips = [self._on(0j, *pair) for pair in zip(speeds.turned.tolist(), speeds.omega.tolist(), strict=True)]
        through = all(float(np.abs(points - tip).min()) <= near for tip in tips)
        if one.style.width != self.drafting.hand.main or (np.diff(x) < -KNOWN).any() or not through:
            return False
        low, high = self._band(near * self.up)
        strip = np.clip(np.searchsorted(speeds.turned, x) - 1, 0, len(low) - 1)
        return bool(((y >= low[strip]) & (y <= high[strip])).all())

    def _band(self, near: float) -> Sequence[np.ndarray[tuple[int, ...], np.dtype[np.float64]]]:
        """Give between which speeds the curve runs over each strip, rad/s."""
        omega = self.speeds.omega
        step = np.abs(np.diff(omega))
        loose = BULGE * np.max([np.roll(step, 1), step, np.roll(step, -1)], axis=0) + SWAY * np.ptp(omega) + near
        return np.minimum(omega[1:], omega[:-1]) - loose, np.maximum(omega[1:], omega[:-1]) + loose
