"""A quantity of the turn that jumps or bends, as Chebyshev's polynomials on pieces within which it is smooth.

A piece on which the polynomial's last coefficients are not yet rounding is halved. Its nodes lie inside it, so that
each side of a jump counts on its own.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.polynomial import chebyshev

from plans.analytic.closure import EPS, transfer
from plans.analytic.kinematics import Analysis
from plans.analytic.points import TURN as SPIN
from plans.analytic.points import Constraints, speed
from plans.analytic.positions import blocks
from plans.analytic.power import reduced_inertia, reduced_moment
from plans.model.dynamics import ANALYSIS, TURN, Reduced
from plans.model.kinetostatics import Loading
from plans.model.machine import Machine
from plans.model.motion import Complexes, Floats, Motion

Loads = Callable[[Motion], Loading]  # the loads over the positions of a motion


class ReducedRows(NamedTuple):
    """Over some positions, (N,): moment of loads and weights N*m, inertia kg*m2 and its derivative, that of weights.

    `gross` N*m is the moment that all loads would have if none worked against another: the measure of its rounding.
    """

    moment: Floats
    inertia: Floats
    slope: Floats
    weight: Floats
    gross: Floats


class ExactReduction:
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

    def ordinates(self, motion: Motion) -> ReducedRows:
        """Reduce at the positions of a motion; NaN at gaps.

        Positive is the sense of rotation; so derivatives by the angle turned are those by the crank's angle times it.
        """
        constraints, poses = self.road.constraints, self.road.poses(motion)
        first, second = _transfers(constraints, poses, motion)
        loading = self.loads(motion)
        down, weight = self.machine.gravity.conjugate(), np.zeros(len(poses))
        for link, body in self.machine.bodies.items():
            weight += body.mass * (down * speed(self.road.constraints, poses, first, link, body.centre)).real
        moment = reduced_moment(self.road, motion, loading, first) + weight
        inertia = reduced_inertia(constraints, self.machine, poses, first)
        slope = self._slope(poses, first, second)
        turning = self.sense * moment, inertia, self.sense * slope, self.sense * weight
        return ReducedRows(*turning, self._gross(loading, poses, first))

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


def reduced(reduction: ExactReduction, phi: Floats) -> Reduced:
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


def _bend(
    constraints: Constraints, poses: Floats, first: Floats, second: Floats, link: int, spot: complex
) -> Complexes:
    """Give the second derivative of a point's place by the crank's angle, m."""
    on = constraints.numbers.index(link)
    x, y, growth = np.moveaxis(second[:, on], -1, 0)
    arm = spot * np.exp(1j * poses[:, on, SPIN])
    return np.asarray(constraints.size * (x + 1j * y) + (1j * growth - first[:, on, SPIN] ** 2) * arm)


NODES = 32
TAIL = NODES // 4  # coefficients that must have died away
LOOKS = 24  # places on a piece, among which every zero of its polynomial that matters shows
ROUNDINGS = 4.0  # of the largest: what fitting leaves
NARROWEST = 2.0 * np.pi / 2.0**20  # rad: what does not settle on such a piece settles on none
MOST = 2048  # pieces

# Angles turned (N,) to several quantities there, (k, N), and to the largest of what each of them sums up, (k,): what
# is less than its rounding is nothing.
Sample = Callable[[Floats], tuple[Floats, Floats]]

_ANGLES = np.pi * (np.arange(NODES) + 0.5) / NODES
_PLACES = np.cos(_ANGLES)  # of the nodes, from 1 down to -1
_FIT = np.cos(np.outer(np.arange(NODES), _ANGLES)) * 2.0 / NODES
_FIT[0] /= 2.0


@dataclass(frozen=True)
class Pieced:
    """Edges (p + 1,) rad of the pieces, coefficients (p, n) of the quantity and (p, n + 1) of its integral from 0.

    `error` is the share of the largest that the last coefficients still have; where it `settled` that is rounding.
    """

    edges: Floats
    coefficients: Floats
    integrals: Floats
    error: float
    settled: bool

    @property
    def looks(self) -> Floats:
        """Angles rad among which every change of sign shows."""
        low, wide = self.edges[:-1, None], np.diff(self.edges)[:, None]
        return np.append((low + wide * np.arange(LOOKS) / LOOKS).ravel(), self.edges[-1])

    def at(self, turned: Floats, side: int = 1) -> Floats:
        """Give the quantity at angles turned rad, (N,); at an edge by the piece beyond it, or before it if side < 0."""
        return self._sum(self.coefficients, turned, side)

    @property
    def slope(self) -> Pieced:
        """Its derivative by the angle turned."""
        fitted = chebyshev.chebder(self.coefficients, axis=1) * 2.0 / np.diff(self.edges)[:, None]
        return Pieced(self.edges, fitted, self.coefficients, self.error, self.settled)

    @cached_property
    def value(self) -> Callable[[float], float]:
        """The quantity at one angle turned rad, of any turn: for a solver that asks for one at a time (Clenshaw)."""
        edges: list[float] = self.edges.tolist()
        sums: list[list[float]] = self.coefficients[:, ::-1].tolist()

        def at_angle(turned: float) -> float:
            turned %= edges[-1]
            k = min(bisect_right(edges, turned) - 1, len(sums) - 1)
            place = ((turned - edges[k]) - (edges[k + 1] - turned)) / (edges[k + 1] - edges[k])
            later = after = 0.0
            for coefficient in sums[k]:
                after, later = later, coefficient + 2.0 * place * later - after
            return later - place * after

        return at_angle

    def since(self, turned: Floats) -> Floats:
        """Give its integral from 0."""
        return self._sum(self.integrals, turned, 1)

    def _sum(self, coefficients: Floats, turned: Floats, side: int) -> Floats:
        turned = np.asarray(turned, dtype=np.float64)
        on = np.searchsorted(self.edges, turned, "right" if side > 0 else "left") - 1
        on = np.clip(on, 0, len(self.edges) - 2)
        low, high = self.edges[on], self.edges[on + 1]
        place = ((turned - low) - (high - turned)) / (high - low)
        return np.asarray(chebyshev.chebval(place, np.moveaxis(coefficients[on], -1, 0), tensor=False))


def pieces(sample: Sample, knots: Floats, noise: float) -> list[Pieced]:
    """Fit quantities on the pieces between knots, rad, the first 0 and the last a turn; `noise`: share of rounding."""
    low, high = knots[:-1], knots[1:]
    before = np.full(len(low), np.inf)
    kept: list[tuple[Floats, Floats, Floats]] = []
    largest, error, settled = np.zeros((1, 1)), 0.0, True
    while low.size:
        at = (low[:, None] * (1.0 - _PLACES) + high[:, None] * (1.0 + _PLACES)) / 2.0
        ordinates, sizes = sample(at.ravel())
        fitted, size = ordinates.reshape(-1, *at.shape) @ _FIT.T, sizes[:, None]
        largest = np.fmax(largest, size)  # NaN at gaps
        whole = np.where(largest == 0.0, 1.0, largest)  # of nothing at all there is no share
        tails = (np.abs(fitted[:, :, -TAIL:]).max(axis=2) / whole).max(axis=0)
        tails = np.where(np.isfinite(tails), tails, np.inf)
        rounding = (tails <= noise) & (tails >= before / 2.0)  # of a smooth quantity halving leaves far less than half
        done = rounding | (tails <= ROUNDINGS * EPS)
        lost = ~done & ((high - low <= NARROWEST) | np.isinf(tails) | (2 * low.size > MOST))
        settled &= not lost.any()
        error = max(error, float(np.max(tails[done | lost], initial=0.0)))
        kept.append((low[done | lost], high[done | lost], fitted[:, done | lost]))
        more = ~(done | lost)
        low, high, before = *_halves(low[more], high[more]), np.tile(tails[more], 2)
    return _joined(kept, error, settled)


def _halves(low: Floats, high: Floats) -> tuple[Floats, Floats]:
    middle = (low + high) / 2.0
    return np.concatenate((low, middle)), np.concatenate((middle, high))


def _joined(kept: list[tuple[Floats, Floats, Floats]], error: float, settled: bool) -> list[Pieced]:
    low, high = (np.concatenate([part[k] for part in kept]) for k in (0, 1))
    order = np.argsort(low)
    edges = np.append(low[order], high[order][-1])
    fitted = np.concatenate([part[2] for part in kept], axis=1)[:, order]
    return [Pieced(edges, fit, _integrals(fit, np.diff(edges)), error, settled) for fit in fitted]


def _integrals(coefficients: Floats, wide: Floats) -> Floats:
    """Integrate polynomials on pieces one after another, from the beginning of the first."""
    found = chebyshev.chebint(coefficients, lbnd=-1, axis=1) * wide[:, None] / 2.0
    found[1:, 0] += np.cumsum(found.sum(axis=1))[:-1]
    return np.asarray(found)
