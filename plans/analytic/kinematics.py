"""Positions, velocities, accelerations and kinematic diagrams by analysis: the independent road beside the plans."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from plans.analytic.assembly import ClosedPosition, Closure, home
from plans.analytic.blocks import triangular
from plans.analytic.closure import EPS, transfer
from plans.analytic.extremes import extremes
from plans.analytic.points import TURN, Constraints, X, Y
from plans.analytic.positions import Positions, along, blocks, find, wrapped
from plans.analytic.turn import Marched, whole_turn
from plans.model.diagrams import Axis, Count, Diagrams, OutputRates, axis_of, still, unfollowed
from plans.model.mechanism import FRAME, Mechanism, Output, output_way
from plans.model.motion import (
    Complexes,
    Extremes,
    Floats,
    Gap,
    LinkMotion,
    Motion,
    Pace,
    PointMotion,
    Rates,
    rates_at,
    steady,
)

DEGREES = np.radians(np.arange(360.0))  # the whole degrees of a turn


class Analysis:
    """The analytic road of one mechanism: its equations, and the way round the turn, marched once for all questions."""

    def __init__(
        self,
        mechanism: Mechanism,
        tolerance: float = EPS,
        first: bool = True,
        looks: Floats = DEGREES,
        pace: Pace | None = None,
    ) -> None:
        self.mechanism, self.constraints = mechanism, Constraints.of(mechanism)
        self.tolerance, self.first = tolerance, first  # whether the sketch shows the first position asked for
        self.looks = looks  # crank angles rad among which the one is sought that the sketch shows, if not the first
        self.shape = Closure(mechanism, self.constraints, triangular(self.constraints))
        self.pace = pace  # the drive's rates at crank angles; None: those of the mechanism in all
        self._start: ClosedPosition | None = None  # from where the last way was marched
        self._turn: Marched | None = None
        self._whole: Marched | None = None
        self._round = True  # whether the crank may turn fully, for all that is known
        self._homes: dict[float | None, ClosedPosition | None] = {}  # by the first crank angle that the sketch may show
        self._extremes: dict[Output, tuple[Marched | None, Extremes | None]] = {}

    def rates(self, phi: Floats) -> Rates:
        """Give the rates of the drive at crank angles rad."""
        return rates_at(self.pace, phi) if self.pace else steady(self.mechanism.drive)

    def motion(self, phi: Floats, order: int = 2) -> Motion:
        """Solve all positions phi rad: order 0 positions, 1 and velocities, 2 and accelerations; from the datum, SI."""
        phi = np.asarray(phi, dtype=np.float64)
        start = self._home(phi) if phi.size else None
        found = find(self.shape, phi, start, self.tolerance, self._turn if start is self._start else None)
        self._turn, self._start = found.turn, start
        return self._moved(found, order)

    @property
    def whole(self) -> Marched | None:
        """The turn, marched once for all; None where the crank does not come round, or nothing was solved yet."""
        if self._round and self._whole is None and self._turn is not None:
            self._whole = whole_turn(self.shape, self._turn)
            self._round = self._whole is not None
        return self._whole

    def around(self, phi: Floats, order: int = 2) -> Motion:
        """Solve positions as `motion` does; where the crank turns fully and freely, by the whole turn."""
        whole = self.whole
        if whole is None or whole.passed:
            return self.motion(phi, order)
        phi = np.asarray(phi, dtype=np.float64)
        return self._moved(along(self.shape, phi, whole, self.tolerance), order)

    def _moved(self, found: Positions, order: int) -> Motion:
        """Differentiate poses by the crank angle, and read the motion off them."""
        slopes = [np.full_like(found.poses, np.nan) for _ in range(order)]
        moving = np.flatnonzero(found.regular)
        for block in blocks(len(moving)):
            here = moving[block]
            for slope, values in zip(slopes, transfer(self.constraints, found.poses[here], order), strict=True):
                slope[here] = values
        gaps = tuple(missing for missing in found.gaps if order or missing.plan == "positions")
        rows = [wrapped(found.poses), *_rates(slopes, self.rates(found.phi))]
        return _motion(self.mechanism, self.constraints, found.phi, rows, gaps)

    def _home(self, phi: Floats) -> ClosedPosition | None:
        """Assemble the mechanism as the sketch shows it, at the first position if it can be, once for each such one."""
        first = float(phi[0]) if self.first else None
        if first not in self._homes:
            self._homes[first] = home(self.shape, first, self.looks)
        return self._homes[first]

    def extremes(self, output: Output) -> Extremes | None:
        """Find the output's extreme positions on the way round, once for each way."""
        turn, found = self._extremes.get(output, (None, None))
        if output not in self._extremes or turn is not self._turn:
            found = extremes(self.shape, output, self.looks, self._turn)
            self._extremes[output] = self._turn, found
        return found

    @property
    def ends(self) -> tuple[float, ...]:
        """The crank angles, rad, beyond which the positions that were solved last cannot go on."""
        return tuple(end.singular for end in self._turn.ends) if self._turn else ()

    def poses(self, motion: Motion) -> Floats:
        """Read the poses of all links off either road's motion, (N, links, 3); NaN at gaps."""
        poses = np.zeros((len(motion.phi), len(self.constraints.numbers), 3))
        for place, number in enumerate(self.constraints.numbers):
            if number != FRAME:
                point, local = next(iter(self.mechanism.links[number].points.items()))
                turn = motion.links[number].angle
                origin = (motion.points[point].r - local * np.exp(1j * turn)) / self.constraints.size
                poses[:, place] = np.stack((origin.real, origin.imag, turn), axis=1)
        return poses

    def conditions(self, motion: Motion) -> Floats:
        """Give the 2-norm condition of the scaled Jacobian at every position of either road's motion; NaN at gaps."""
        poses = self.poses(motion)
        found = np.full(len(poses), np.nan)
        whole = np.flatnonzero(np.isfinite(poses).all(axis=(1, 2)))
        for block in blocks(len(whole)):
            here = whole[block]
            found[here] = np.linalg.cond(self.constraints.jacobian(self.constraints.place(poses[here])))
        return found


def solve(mechanism: Mechanism, phi: Floats, order: int = 2, tolerance: float = EPS, first: bool = True) -> Motion:
    """Solve all positions phi rad of a mechanism by analysis.

    A `tolerance` above eps, a share of the mechanism's size, leaves the loops open by so much: for the bench alone.
    """
    return Analysis(mechanism, tolerance, first).motion(phi, order)


def conditions(mechanism: Mechanism, motion: Motion) -> Floats:
    """Give the condition of the scaled Jacobian at every position of a motion, (N,)."""
    return Analysis(mechanism).conditions(motion)


def _rates(slopes: list[Floats], drive: Rates) -> Iterator[Floats]:
    """Turn the transfer functions of all poses (N, links, 3) into rates by those of the drive."""
    omega, epsilon = drive.against(2)
    if slopes:
        yield omega * slopes[0]
    if len(slopes) > 1:
        yield omega**2 * slopes[1] + epsilon * slopes[0]


def _motion(
    mechanism: Mechanism, constraints: Constraints, phi: Floats, rows: list[Floats], gaps: tuple[Gap, ...]
) -> Motion:
    """Read points and links off the poses and their rates (N, links, 3)."""
    points: dict[str, PointMotion] = {}
    links: dict[int, LinkMotion] = {}
    for place, number in enumerate(constraints.numbers):
        moved = [row[:, place] for row in rows]
        for point, local in mechanism.links[number].points.items():
            if point not in points:
                points[point] = PointMotion(_point(constraints.size, local, *moved))
        if number != FRAME:
            links[number] = LinkMotion(row[:, TURN] for row in moved)
    return Motion("analysis", phi, points, links, gaps)


def _point(size: float, local: complex, pose: Floats, *rates: Floats) -> Iterator[Complexes]:
    """Give place, velocity and acceleration of a link's point, as far as the rates (N, 3) of its pose go."""
    arm = local / size * np.exp(1j * pose[:, TURN])
    yield size * (pose[:, X] + 1j * pose[:, Y] + arm)
    for speed in rates[:1]:
        yield size * (speed[:, X] + 1j * speed[:, Y] + 1j * speed[:, TURN] * arm)
    for growth in rates[1:]:
        turned = (1j * growth[:, TURN] - rates[0][:, TURN] ** 2) * arm
        yield size * (growth[:, X] + 1j * growth[:, Y] + turned)


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
    rows = far.followed(axis.turned, output_rates(mechanism, far.output, motion, axis.numbers))
    at = far.count.course(axis.turned, rows, omega)
    speeds = np.asarray(np.where(axis.joined, omega * np.diff(at.s) / np.diff(axis.turned), np.nan))
    gains = np.full(len(axis.turned), np.nan)
    gains[1:-1] = omega * np.diff(speeds) / np.diff(axis.middles)
    if axis.closed:
        apart = axis.middles[0] + math.tau - axis.middles[-1]
        gains[[0, -1]] = omega * (speeds[0] - speeds[-1]) / apart
    return Diagrams(
        by="analysis",
        axis=axis,
        count=far.count,
        lead=lead,
        at=at,
        speeds=speeds,
        growths=gains,
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
        self.turns = output_way(road.mechanism, output) is None
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
        for row, values in zip(
            rows, output_rates(self.road.mechanism, self.output, self.road.around(phi)), strict=True
        ):
            row[known] = values[1:]
        return self.followed(turned, rows) if followed else rows

    def followed(self, turned: Floats, rows: Sequence[Floats]) -> list[Floats]:
        """Add whole turns to an angle so that it goes on from node to node."""
        first, *rest = rows
        if self.turns:
            first = first + math.tau * np.round((np.interp(turned, self.nodes, self.along) - first) / math.tau)
        return [first, *rest]

    def _count(self, extremes: Extremes | None) -> Count:
        """Count from where the working stroke begins, in its sense; else an even turn aside, or from the least."""
        along, axis = self.along, self.axis
        if extremes is not None:
            begun, ended = extremes.reach
            middle = (along.max() + along.min() - begun - ended) / 2 if self.turns else 0.0
            return Count(begun + math.tau * float(np.round(middle / math.tau)), float(np.sign(ended - begun)))
        net = float(np.round((along[-1] - along[0]) / math.tau)) if self.turns and axis.closed else 0.0
        at = self.at(axis.turned)[0]
        return Count(float(np.mean((at - net * axis.turned)[:-1])), 1.0, net) if net else Count(float(np.nanmin(at)))


def output_rates(
    mechanism: Mechanism, output: Output, motion: Motion, chosen: Sequence[int] | slice = slice(None)
) -> list[Floats]:
    """Read an output's coordinate, its velocity and acceleration off a motion, (N,) each."""
    numbers, counted = (list(chosen) if not isinstance(chosen, slice) else chosen), output_way(mechanism, output)
    if counted is None:
        return [np.asarray(row[numbers], dtype=np.float64) for row in motion.links[output.link]]
    point, way = counted
    place, *rates = motion.points[point]
    return [np.asarray(((row * way.direction.conjugate()).real)[numbers]) for row in (place - way.through, *rates)]
