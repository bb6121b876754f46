"""How the figures of a machine's motion go on from each other: works, surplus, loop, cuts, speeds (динамика)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from drawings.due.dynamics import LOOP
from drawings.due.turn import INERTIA, MOMENTS, SURPLUS, WORKS, Turn
from drawings.grading.curves.asked_figure import Sizes, Values
from plans.model.dynamics import TURN, Flywheel, settled

ALIKE = 0.05  # by how much the factors at both edges of a strip may differ that are taken for one: a fair hand's do


def moved_means(drawn: Sizes, after: Sizes, before: Sizes, means: Sizes) -> Sizes:
    """Give the means of the strips by the values behind their edges, where the true ones are known.

    A strip whose edges are out by one factor is out by it, any other by how far both are; a jump keeps its share.

    >>> true = np.array([0.0, 2.0, 4.0])
    >>> moved_means(2 * true, true, true, np.array([1.1, 3.1])).tolist()
    [2.2, 6.2]
    >>> moved_means(true + 1, true, true, np.array([1.1, 3.1])).round(3).tolist()
    [2.1, 4.1]
    """
    after, before = (settled(row, float(np.abs(after).max())) for row in (after, before))
    end, jumps = before[1:], settled(before[1:] - after[1:], float(np.abs(after).max())) != 0
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        first = drawn[:-1] / after[:-1]
        last = np.where(jumps, first, drawn[1:] / end)
        first = np.where((after[:-1] == 0) & (drawn[:-1] == 0), last, first)
        last = np.where((end == 0) & (drawn[1:] == 0) & ~jumps, first, last)
        right = np.where(jumps, end * first, drawn[1:])
        one = np.abs(first - last) <= ALIKE
        moved = (drawn[:-1] - after[:-1] + right - end) / 2
    moved = np.where(np.isfinite(moved), moved, drawn[:-1] - after[:-1])
    factor = np.where(one, first, 0.0) / 2 + np.where(one, last, 0.0) / 2
    return np.where(one, means * factor, means + moved)


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
