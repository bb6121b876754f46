"""The kinematic diagrams by analysis: the output's course by its closed loops, mean rates of its parts (разности)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from plans.analytic.kinematics import Analysis
from plans.model.diagrams import TURN, Axis, Count, Diagrams, OutputRates, axis_of, still, unfollowed
from plans.model.mechanism import FRAME, Mechanism, Output
from plans.model.motion import Extremes, Floats, Motion

NODES = 360  # of the axis at least, close enough to follow an angle by
SAME = 1e-12  # rad: what rounding sets an angle and itself apart by


def alone(road: Analysis, output: Output, extremes: Extremes | None, motion: Motion, whole: bool) -> Diagrams | None:
    """Find the diagrams with an axis of its own, as far as the way round goes; None where there are none."""
    lost = np.isnan(motion.links[output.link].angle)
    sense = -1 if road.mechanism.drive.omega < 0 else 1
    axis = axis_of(motion.phi, sense, lost, road.ends, whole)
    if unfollowed(axis):
        return None
    found = diagrams(ExactCourse(road, output, axis, float(motion.phi[0]), extremes), motion)
    return None if still(found.at, found.count, abs(road.mechanism.drive.omega), output.link) else found


def diagrams(far: ExactCourse, motion: Motion) -> Diagrams:
    """Find the diagrams of a course over its axis; `motion` is that at all positions of the scene.

    v over a part is the way over it by its time, a between two parts what v gains from middle to middle by that time.
    """
    axis, mechanism = far.axis, far.road.mechanism
    omega, lead = abs(mechanism.drive.omega), mechanism.drive.epsilon / mechanism.drive.omega
    rows = far.followed(axis.turned, _rows(mechanism, far.output, motion, axis.numbers))
    at = far.count.course(axis.turned, rows, omega)
    speeds = _rates(at.s, axis.turned, omega, axis.joined)
    return Diagrams(
        by="analysis",
        axis=axis,
        count=far.count,
        lead=lead,
        at=at,
        speeds=speeds,
        growths=_gains(speeds, axis, omega),
        true_speeds=np.where(axis.joined, far.course(axis.middles).v, np.nan),
        true_growths=np.where(axis.between, far.course(axis.places).even(lead), np.nan),
    )


class ExactCourse:
    """The output's coordinate over an axis by analysis, an angle followed from node to node."""

    def __init__(self, road: Analysis, output: Output, axis: Axis, first: float, extremes: Extremes | None) -> None:
        self.road, self.output, self.axis = road, output, axis
        self.first = first  # rad: the crank angle at which the road looks for the sketch's assembly
        self.nodes = axis.fine(NODES)
        self.along, *rates = self.at(self.nodes, followed=False)
        self.turns = _slide_of(road.mechanism, output) is None
        if self.turns:
            self.along = np.unwrap(self.along)
        self.count = self._count(extremes)
        self.dense = self.count.course(self.nodes, [self.along, *rates], abs(road.mechanism.drive.omega))

    def course(self, turned: Floats) -> OutputRates:
        """Give the course at angles of the axis, (N,), as the diagrams count; NaN at NaN. At its nodes it is known."""
        if turned.shape == self.nodes.shape and np.abs(turned - self.nodes).max() <= SAME:
            return self.dense
        return self.count.course(turned, self.at(turned), abs(self.road.mechanism.drive.omega))

    def at(self, turned: Floats, followed: bool = True) -> list[Floats]:
        """Give the coordinate, its velocity and acceleration at angles of the axis, (N,) each; NaN at NaN."""
        known = np.flatnonzero(np.isfinite(turned))
        sense = -1.0 if self.road.mechanism.drive.omega < 0 else 1.0
        phi = np.append(self.first, self.axis.start + sense * turned[known])
        rows = [np.full(len(turned), np.nan) for _ in range(3)]
        for row, values in zip(rows, _rows(self.road.mechanism, self.output, self.road.around(phi)), strict=True):
            row[known] = values[1:]
        return self.followed(turned, rows) if followed else rows

    def followed(self, turned: Floats, rows: Sequence[Floats]) -> list[Floats]:
        """Add whole turns to an angle so that it goes on from node to node."""
        first, *rest = rows
        if self.turns:
            first = first + TURN * np.round((np.interp(turned, self.nodes, self.along) - first) / TURN)
        return [first, *rest]

    def _count(self, extremes: Extremes | None) -> Count:
        """Count from where the working stroke begins, in its sense; else an even turn aside, or from the least."""
        along, axis = self.along, self.axis
        if extremes is not None:
            begun, ended = extremes.reach
            middle = (along.max() + along.min() - begun - ended) / 2 if self.turns else 0.0
            return Count(begun + TURN * float(np.round(middle / TURN)), float(np.sign(ended - begun)))
        net = float(np.round((along[-1] - along[0]) / TURN)) if self.turns and axis.closed else 0.0
        at = self.at(axis.turned)[0]
        return Count(float(np.mean((at - net * axis.turned)[:-1])), 1.0, net) if net else Count(float(np.nanmin(at)))


def _slide_of(mechanism: Mechanism, output: Output) -> tuple[complex, complex, str] | None:
    """Give the guide of an output on the frame: a place of it, its direction, the point that is followed."""
    for slide in mechanism.slides:
        if {slide.slider, slide.owner} == {FRAME, output.link}:
            way = slide.way(FRAME)
            return way.through, way.direction, output.point or slide.point
    return None


def _rows(
    mechanism: Mechanism, output: Output, motion: Motion, chosen: Sequence[int] | slice = slice(None)
) -> list[Floats]:
    """Read the coordinate, its velocity and acceleration off a motion, (N,) each."""
    numbers, guide = (list(chosen) if not isinstance(chosen, slice) else chosen), _slide_of(mechanism, output)
    if guide is None:
        return [np.asarray(row[numbers], dtype=np.float64) for row in motion.links[output.link]]
    through, direction, point = guide
    place, *rates = motion.points[point]
    return [np.asarray(((row * direction.conjugate()).real)[numbers]) for row in (place - through, *rates)]


def _rates(values: Floats, turned: Floats, omega: float, there: np.ndarray) -> Floats:
    """Give what values gain over each part, by its time; NaN of a part that is not passed."""
    return np.asarray(np.where(there, omega * np.diff(values) / np.diff(turned), np.nan))


def _gains(speeds: Floats, axis: Axis, omega: float) -> Floats:
    """Give what the mean velocity gains from part to part, by the time from middle to middle, (M,)."""
    gains = np.full(len(axis.turned), np.nan)
    gains[1:-1] = omega * np.diff(speeds) / np.diff(axis.middles)
    if axis.closed:
        apart = axis.middles[0] + TURN - axis.middles[-1]
        gains[[0, -1]] = omega * (speeds[0] - speeds[-1]) / apart
    return gains
