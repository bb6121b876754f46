"""How the figures of a machine's motion go on from each other: works, surplus, loop, cuts, speeds (динамика)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from drawings.due.dynamics import LOOP
from drawings.due.turn import INERTIA, MOMENTS, SURPLUS, WORKS, Turn
from drawings.grading.curves.asked_figure import Sizes, Values
from drawings.grading.curves.strip_means import moved_means
from plans.model.dynamics import TURN, Flywheel

BEARING, CUT = "bearings of the loop", "cuts of the loop"


class Turned(NamedTuple):
    """A turn in strips, and how the figures of its motion follow from one another."""

    expected: Turn
    scales: tuple[float, float] = (1.0, 1.0)  # of the loop: kg*m2 and J a mm

    @property
    def turned(self) -> Sizes:
        """The edges of the strips, rad."""
        return self.expected.cycle.turned

    def works(self, own: Mapping[str, Values]) -> Values:
        """Add up the areas of the strips under a graph of moments, whose means are out as their edges are."""
        after, before = self.expected.graphs[MOMENTS], self.expected.before
        means = moved_means(own[MOMENTS].imag, after, before, -self.expected.cycle.means)
        return np.asarray(1j * np.concatenate(([0.0], np.cumsum(means * np.diff(self.turned)))))

    def surplus(self, own: Mapping[str, Values]) -> Values:
        """Take the works of the loads from those of the drive, which gives as much over the turn."""
        works = own[WORKS].imag
        return np.asarray(1j * (works[0] + (works[-1] - works[0]) * self.turned / TURN - works))

    def loop(self, own: Mapping[str, Values]) -> Values:
        """Lay the surplus off over the inertia, mm."""
        inertia, energy = self.scales
        return np.asarray(own[INERTIA].real / inertia + 1j * own[SURPLUS].imag / energy)

    def cuts(self, own: Mapping[str, Values]) -> Values:
        """Give what tangents of some bearings cut off the axis of energy, J: o1l, o1k."""
        points, (low, high) = own[LOOP], (one.imag / one.real for one in own[BEARING])
        energy = self.scales[1]
        least = (points.imag - low * points.real).min() * energy
        most = (points.imag - high * points.real).max() * energy
        return np.array([1j * least, 1j * most])

    def speeds(self, own: Mapping[str, Values]) -> Values:
        """Give the speeds above their mean from energies, inertias and what the tangents cut off, rad/s."""
        low, high = self.wheel.slopes
        least, most = own[CUT].imag
        whole = (most - least) / (high - low)
        energy = whole * high - most
        with np.errstate(divide="ignore", invalid="ignore"):
            omega = np.sqrt(2 * (energy + own[SURPLUS].imag) / (whole + own[INERTIA].real))
        return np.asarray(1j * (omega - self.expected.mean))

    @property
    def wheel(self) -> Flywheel:
        """The flywheel that is asked for."""
        assert self.expected.wheel is not None  # asked before
        return self.expected.wheel

    @property
    def true(self) -> dict[str, Values]:
        """The graphs by analysis."""
        return {
            name: np.asarray((1 if name == INERTIA else 1j) * row, dtype=np.complex128)
            for name, row in self.expected.graphs.items()
        }

    def speed_slips(self, scales: Mapping[str, float]) -> Sizes:
        """Give how far a hand that slips by a mm is out in the speeds that it reckons from what it measures, rad/s."""
        true = {**self.true, CUT: np.array([1j * cut for cut in self.wheel.cuts])}
        rise = {SURPLUS: 1j * scales[SURPLUS], INERTIA: scales[INERTIA], CUT: 1j * self.scales[1]}
        parts = []
        for name, step in rise.items():
            rows = [np.full(len(true[name]), step)] if name != CUT else [step * row for row in np.eye(2)]
            parts += [self.speeds({**true, name: true[name] + row}) - self.speeds(true) for row in rows]
        return np.sqrt(sum(np.abs(part) ** 2 for part in parts))
