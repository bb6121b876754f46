"""The way round the turn: poses at stations of the crank, each reached from the last by continuity.

The march goes from the assembled position in both senses, never across a singular position. A step is taken only if the
second-order Taylor polynomial lands close to the closed poses, Newton's corrections shrink fast, and the determinant of
the Jacobian keeps its sign and at least half its size; otherwise the step is halved.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plans.analytic.assembly import Assembly
from plans.analytic.closure import EPS, SQRT_EPS, as_poses, close
from plans.analytic.constraints import Constraints
from plans.motion import Floats

FULL = 2.0 * np.pi
STRIDE = FULL / 48  # rad, the longest step: 7.5 degrees
FIRST_STRIDE = STRIDE / 8  # the start may lie beside a singular position that a whole step would jump
SHORTEST = 2.0**-30  # rad, 1e-9: a dead centre is located this closely
STEPS = 4096  # a march longer than this is given up
# A correction of this share of the way gone: the pose arrived at belongs to the pose left, not to another assembly.
TRUST = 1.0 / 16.0
DEAD_CENTRE, CHANGE_POINT, NOT_REACHABLE = "dead centre", "change point", "not reachable"


@dataclass(frozen=True)
class Station:
    """A closed position: crank angle, poses (links, 3), their two transfer functions, and the state of the Jacobian."""

    phi: float  # rad, continuous along the march
    poses: Floats
    first: Floats
    second: Floats
    det: float
    sharpness: float  # reciprocal condition (Frobenius) of the Jacobian with columns of unit length

    def predict(self, phi: float) -> Floats:
        """Predict the poses at a crank angle close by, rad, by Taylor's polynomial."""
        step = phi - self.phi
        return self.poses + step * (self.first + step / 2.0 * self.second)


@dataclass(frozen=True)
class End:
    """Where a march could go no further: the last crank angle reached, and where the Jacobian loses rank, rad."""

    reached: float
    singular: float
    reason: str

    @property
    def blind(self) -> float:
        """Angle rad on either side of the singular position within which the march could not step."""
        return max(abs(self.singular - self.reached), SHORTEST)


@dataclass(frozen=True)
class Turn:
    """All stations of both marches in order of the crank angle, and what ended them."""

    stations: tuple[Station, ...]
    lower: End | None
    upper: End | None

    @property
    def ends(self) -> tuple[End, ...]:
        """List the ends that the march met."""
        return tuple(end for end in (self.lower, self.upper) if end)

    @cached_property
    def angles(self) -> Floats:
        """Give the crank angles of the stations, rad, rising."""
        return np.array([station.phi for station in self.stations])

    @cached_property
    def taylor(self) -> Floats:
        """Give poses, first and second transfer functions of the stations, (3, stations, links, 3)."""
        return np.array([(s.poses, s.first, s.second) for s in self.stations]).swapaxes(0, 1)

    def predict(self, phi: Floats) -> Floats:
        """Predict poses at crank angles of the march, rad, by Taylor's polynomial from the nearest station."""
        nearest = np.searchsorted((self.angles[1:] + self.angles[:-1]) / 2.0, phi)
        poses, first, second = self.taylor[:, nearest]
        step = (phi - self.angles[nearest])[:, None, None]
        return np.asarray(poses + step * (first + step / 2.0 * second))


def survey(constraints: Constraints, start: Assembly, ahead: Floats) -> Turn:
    """March from the assembly until all angles `ahead` of it, rad in [0, 2 pi), are passed in either sense."""
    first = _station(constraints, start.poses, start.phi)
    up = [first]
    down = [first]
    upper = _march(constraints, up, float(np.max(ahead, where=ahead <= np.pi, initial=0.0)))
    lower = _march(constraints, down, -float(np.max(FULL - ahead, where=ahead > np.pi, initial=0.0)))
    # What lies beyond one end may be reached the other way round.
    if upper and not lower:
        lost = ahead > upper.reached - start.phi
        lower = _march(constraints, down, -(FULL - float(np.min(ahead, where=lost, initial=FULL))))
    elif lower and not upper:
        lost = ahead < FULL + lower.reached - start.phi
        upper = _march(constraints, up, float(np.max(ahead, where=lost, initial=0.0)))
    return Turn((*reversed(down[1:]), *up), lower, upper)


def _march(constraints: Constraints, way: list[Station], target: float) -> End | None:
    """Lengthen the way to `target` rad from its start, either sense; tell what ended it earlier."""
    goal, sense = way[0].phi + target, 1.0 if target >= 0.0 else -1.0
    stride = FIRST_STRIDE
    for _ in range(STEPS):
        left = sense * (goal - way[-1].phi)
        if left <= SHORTEST:  # one rounding short of the goal is there
            return None
        if stride < SHORTEST or way[-1].sharpness <= SQRT_EPS:
            break
        phi = goal if stride >= left else way[-1].phi + sense * stride
        station = _step(constraints, way[-1], phi)
        if station is None:
            stride /= 2.0
        else:
            way.append(station)
            stride = min(2.0 * stride, STRIDE)
    return _end(constraints, way)


def _step(constraints: Constraints, here: Station, phi: float) -> Station | None:
    """Step to a crank angle, or refuse."""
    guess = here.predict(phi)
    at = constraints.place(guess[None])
    try:
        step = np.linalg.solve(constraints.jacobian(at)[0], constraints.residual(at, np.array([phi]))[0])
    except np.linalg.LinAlgError:
        return None
    there = guess - as_poses(step[None])[0]
    moved, size = np.abs(there - here.poses).max(), np.abs(step).max()
    if not size <= TRUST * moved:
        return None
    station = _station(constraints, there, phi)
    again = np.abs(station.poses - there).max()
    shrinks = again <= TRUST * size + SQRT_EPS * moved
    same = station.det * np.sign(here.det) >= abs(here.det) / 2.0
    return station if shrinks and same and station.sharpness > SQRT_EPS else None


def _station(constraints: Constraints, poses: Floats, phi: float) -> Station:
    """Close nearly closed poses by one Newton correction and differentiate them with the same Jacobian."""
    at = constraints.place(poses[None])
    jacobian = constraints.jacobian(at)[0]
    still = np.zeros_like(poses)
    try:
        inverse = np.linalg.inv(jacobian)
    except np.linalg.LinAlgError:
        return Station(phi, poses, still, still, 0.0, 0.0)
    lengths = np.sqrt((jacobian**2).sum(axis=0))
    sharpness = 1.0 / (np.sqrt(len(lengths)) * np.linalg.norm(lengths[:, None] * inverse))
    closed = poses - as_poses((inverse @ constraints.residual(at, np.array([phi]))[0])[None])[0]
    first = as_poses(inverse[None, :, -1])
    second = as_poses(-(inverse @ constraints.convective(at, first)[0])[None])[0]
    return Station(phi, closed, first[0], second, float(np.linalg.det(jacobian)), float(sharpness))


def _end(constraints: Constraints, way: Sequence[Station]) -> End:
    """Say why a march ended, and where its singular position lies by the run of the determinant."""
    last = way[-1]
    jacobian = constraints.jacobian(constraints.place(last.poses[None]))[0]
    left, values, _ = np.linalg.svd(jacobian / np.sqrt((jacobian**2).sum(axis=0)))
    faint = values[-1] / values[0]
    # The share of the drive in the condition that rank loss puts on the right sides: of order 1 at a dead centre, where
    # the crank cannot move; at a change point as faint as the singular value itself.
    dead = abs(left[-1, -1]) > np.sqrt(faint)
    if faint > EPS**0.25:
        return End(last.phi, last.phi, NOT_REACHABLE)
    singular = last.phi
    if len(way) > 1 and last.det:
        before, power = way[-2], 2 if dead else 1  # det falls as the root of the distance at a dead centre
        fall = (before.det / last.det) ** power - 1.0
        singular += (last.phi - before.phi) / fall if fall > 0.0 else 0.0
    return End(last.phi, float(singular), DEAD_CENTRE if dead else CHANGE_POINT)


def whole_turn(constraints: Constraints, start: Assembly) -> Turn | None:
    """Survey a full turn from the assembly upwards; None where the crank cannot make it."""
    way = [_station(constraints, start.poses, start.phi)]
    end = _march(constraints, way, FULL)
    return None if end else Turn(tuple(way), None, None)


def station_at(constraints: Constraints, near: Station, phi: float) -> Station:
    """Move from a station to a crank angle close by, closed to rounding level."""
    poses, _ = close(constraints, near.predict(phi)[None], np.array([phi]))
    return _station(constraints, poses[0], phi)
