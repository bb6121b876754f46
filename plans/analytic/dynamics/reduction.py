"""Loads and masses reduced to the crank at any angle turned (приведение сил и масс; M4.2, M4.4)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from plans.analytic.closure import transfer
from plans.analytic.inertia import reduced_inertia
from plans.analytic.kinematics import Analysis
from plans.analytic.points import TURN as SPIN
from plans.analytic.points import Constraints, speed
from plans.analytic.positions import blocks
from plans.analytic.power import reduced_moment
from plans.model.dynamics import ANALYSIS, TURN, Reduced
from plans.model.kinetostatics import Loading
from plans.model.machine import Machine
from plans.model.motion import Complexes, Floats, Motion

Loads = Callable[[Motion], Loading]  # the loads over the positions of a motion


class Ordinates(NamedTuple):
    """Over some positions, (N,): moment of loads and weights N*m, inertia kg*m2 and its derivative by the angle.

    `gross` N*m is the moment that all loads would have if none worked against another: the measure of its rounding.
    """

    moment: Floats
    inertia: Floats
    slope: Floats
    gross: Floats


class Reduction:
    """A machine whose crank turns at unit speed in its sense from position 0, at `start` rad."""

    def __init__(self, road: Analysis, machine: Machine, loads: Loads, start: float) -> None:
        drive = road.mechanism.drive
        self.sense, self.start = (-1.0 if drive.omega < 0.0 else 1.0), start
        steady = replace(road.mechanism, drive=drive._replace(omega=self.sense, epsilon=0.0))
        self.road = Analysis(steady, road.tolerance, road.first, road.looks)
        self.machine, self.loads = machine, loads
        self._even: dict[int, Motion] = {}

    def turned(self, phi: float) -> float:
        """Give the angle turned, rad in [0, 2 pi), at which the crank stands at phi rad."""
        return float(np.mod(self.sense * (phi - self.start), TURN) % (TURN))

    def even(self, count: int) -> Motion:
        """Solve the motion at even angles over a turn, the first 0, once for all that ask."""
        if count not in self._even:
            self._even[count] = self.motion(np.asarray(np.arange(count) * (TURN / count), dtype=np.float64))
        return self._even[count]

    def motion(self, turned: Floats) -> Motion:
        """Solve the motion at angles turned, (N,); position 0 goes before them, for the sketch may show it alone."""
        phi = self.start + self.sense * np.asarray(turned, dtype=np.float64)
        whole = self.road.around(np.concatenate(([self.start], phi)))
        gaps = tuple(gap._replace(position=gap.position - 1) for gap in whole.gaps if gap.position)
        return whole.made(phi, lambda row: row[1:])._replace(gaps=gaps)

    def ordinates(self, motion: Motion) -> Ordinates:
        """Reduce at the positions of a motion; NaN at gaps.

        Positive is the sense of rotation; so derivatives by the angle turned are those by the crank's angle times it.
        """
        constraints, poses = self.road.constraints, self.road.poses(motion)
        first, second = _transfers(constraints, poses, motion)
        loading = self.loads(motion)
        moment = reduced_moment(self.road, motion, loading, first) + self._weights(poses, first)
        inertia = reduced_inertia(constraints, self.machine, poses, first)
        slope = self._slope(poses, first, second)
        return Ordinates(self.sense * moment, inertia, self.sense * slope, self._gross(loading, poses, first))

    def _weights(self, poses: Floats, first: Floats) -> Floats:
        """Reduce the weights to the crank, N*m."""
        down, total = self.machine.gravity.conjugate(), np.zeros(len(poses))
        for link, body in self.machine.bodies.items():
            total += body.mass * (down * speed(self.road.constraints, poses, first, link, body.centre)).real
        return total

    def _gross(self, loading: Loading, poses: Floats, first: Floats) -> Floats:
        """Add up what every load and weight could do if it acted along the motion, N*m."""
        constraints, total = self.road.constraints, np.zeros(len(poses))
        for load in loading.forces:
            total += np.abs(load.force) * np.abs(speed(constraints, poses, first, load.link, load.at))
        for twist in loading.moments:
            total += np.abs(twist.moment * first[:, constraints.numbers.index(twist.link), SPIN])
        for link, body in self.machine.bodies.items():
            weight = body.mass * abs(self.machine.gravity)
            total += weight * np.abs(speed(constraints, poses, first, link, body.centre))
        return total

    def _slope(self, poses: Floats, first: Floats, second: Floats) -> Floats:
        """Differentiate the reduced inertia: 2 sum (m S' . S'' + J phi_i' phi_i''), by transfer functions."""
        constraints, total = self.road.constraints, np.zeros(len(poses))
        for link, body in self.machine.bodies.items():
            on = constraints.numbers.index(link)
            rise = speed(constraints, poses, first, link, body.centre)
            bend = _bend(constraints, poses, first, second, link, body.centre)
            total += 2.0 * body.mass * (rise.conj() * bend).real
            total += 2.0 * body.inertia * first[:, on, SPIN] * second[:, on, SPIN]
        return total


def reduced(reduction: Reduction, phi: Floats) -> Reduced:
    """Reduce loads and masses at crank angles phi rad, (N,), the first of them that of position 0."""
    motion = reduction.motion(reduction.sense * (np.asarray(phi) - reduction.start))
    return Reduced(ANALYSIS, np.asarray(phi), *reduction.ordinates(motion)[:3], motion.gaps)


def _transfers(constraints: Constraints, poses: Floats, motion: Motion) -> tuple[Floats, Floats]:
    """Give first and second transfer functions of the poses; NaN at gaps."""
    first, second = np.full_like(poses, np.nan), np.full_like(poses, np.nan)
    whole = np.asarray(np.isfinite(poses).all(axis=(1, 2)))
    whole[[gap.position for gap in motion.gaps]] = False
    known = np.flatnonzero(whole)
    for block in blocks(len(known)):
        here = known[block]
        first[here], second[here] = transfer(constraints, poses[here], 2)
    return first, second


def _bend(constraints: Constraints, poses: Floats, first: Floats, second: Floats, link: int, own: complex) -> Complexes:
    """Give the second derivative of a point's place by the crank's angle, m."""
    on = constraints.numbers.index(link)
    x, y, growth = np.moveaxis(second[:, on], -1, 0)
    arm = own * np.exp(1j * poses[:, on, SPIN])
    return np.asarray(constraints.size * (x + 1j * y) + (1j * growth - first[:, on, SPIN] ** 2) * arm)
