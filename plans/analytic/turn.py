"""The way round the turn: poses at stations of the crank, each reached from the last by continuity.

The march goes from the assembled position in both senses abreast, never across a singular position. A step is taken
only if the second-order Taylor polynomial lands close to the closed poses, Newton's corrections shrink fast, and the
determinant of the Jacobian keeps its sign and at least half its size; otherwise the step is halved.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from plans.analytic.assembly import Assembly
from plans.analytic.closure import EPS, SQRT_EPS, as_poses, close, inverses, rank_loss, sharpness, solutions
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


class Station(NamedTuple):
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


class End(NamedTuple):
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


class _March:
    """A march under way: its stations, the crank angle where it is to end, its sense and its next stride, rad."""

    def __init__(self, way: list[Station], goal: float) -> None:
        self.way, self.goal, self.stride = way, goal, FIRST_STRIDE
        self.sense = 1.0 if goal >= way[-1].phi else -1.0

    @property
    def left(self) -> float:
        """The angle still to go, rad; one rounding short of the goal is there."""
        left = self.sense * (self.goal - self.way[-1].phi)
        return left if left > SHORTEST else 0.0

    @property
    def stuck(self) -> bool:
        """Whether no step is short enough."""
        return self.stride < SHORTEST or self.way[-1].sharpness <= SQRT_EPS

    @property
    def next(self) -> float:
        """The crank angle of the next step, rad."""
        return self.goal if self.stride >= self.left else self.way[-1].phi + self.sense * self.stride

    def take(self, reached: Station | None) -> None:
        """Step to a station, or shorten the stride where there is none."""
        if reached is None:
            self.stride /= 2.0
        else:
            self.way.append(reached)
            self.stride = min(2.0 * self.stride, STRIDE)


def survey(constraints: Constraints, start: Assembly, ahead: Floats) -> Turn:
    """March from the assembly until all angles `ahead` of it, rad in [0, 2 pi), are passed in either sense."""
    first = station(constraints, start)
    up, down = [first], [first]
    most = start.phi + float(np.max(ahead, where=ahead <= np.pi, initial=0.0))
    least = start.phi - float(np.max(FULL - ahead, where=ahead > np.pi, initial=0.0))
    upper, lower = _march(constraints, _March(up, most), _March(down, least))
    # What lies beyond one end may be reached the other way round.
    if upper and not lower:
        lost = ahead > upper.reached - start.phi
        least = start.phi - (FULL - float(np.min(ahead, where=lost, initial=FULL)))
        (lower,) = _march(constraints, _March(down, least))
    elif lower and not upper:
        lost = ahead < FULL + lower.reached - start.phi
        (upper,) = _march(constraints, _March(up, start.phi + float(np.max(ahead, where=lost, initial=0.0))))
    return Turn((*reversed(down[1:]), *up), lower, upper)


def whole_turn(constraints: Constraints, turn: Turn) -> Turn | None:
    """Lengthen a march on both sides until it comes round; None where the crank cannot make a full turn."""
    if turn.ends:
        return None
    up, down = [*turn.stations], [*reversed(turn.stations)]
    half = (FULL - (up[-1].phi - down[-1].phi)) / 2.0
    ends = _march(constraints, _March(up, up[-1].phi + half), _March(down, down[-1].phi - half))
    return None if any(ends) else Turn((*reversed(down[len(turn.stations) :]), *up), None, None)


def station(constraints: Constraints, start: Assembly) -> Station:
    """Begin a march at an assembly."""
    return _stations(constraints, start.poses[None], np.array([start.phi]))[0]


def _march(constraints: Constraints, *marches: _March) -> list[End | None]:
    """Lengthen all ways to their goals, abreast; tell what ended each of them earlier."""
    for _ in range(STEPS):
        under_way = [march for march in marches if march.left and not march.stuck]
        if not under_way:
            break
        here = [march.way[-1] for march in under_way]
        stations = _steps(constraints, here, np.array([march.next for march in under_way]))
        for march, reached in zip(under_way, stations, strict=True):
            march.take(reached)
    return [_end(constraints, march.way) if march.left else None for march in marches]


def _steps(constraints: Constraints, here: Sequence[Station], phi: Floats) -> list[Station | None]:
    """Step from each station to its crank angle, or refuse."""
    guess = np.array([left.predict(angle) for left, angle in zip(here, phi, strict=True)])
    at = constraints.place(guess)
    step = solutions(constraints.jacobian(at), constraints.residual(at, phi))
    there = guess - as_poses(step)
    moved = np.abs(there - np.array([left.poses for left in here])).max(axis=(1, 2))
    size = np.abs(step).max(axis=1)
    found: list[Station | None] = [None] * len(here)
    near = np.flatnonzero(size <= TRUST * moved).tolist()
    if not near:
        return found
    for k, reached in zip(near, _stations(constraints, there[near], phi[near]), strict=True):
        again = np.abs(reached.poses - there[k]).max()
        shrinks = again <= TRUST * size[k] + SQRT_EPS * moved[k]
        same = reached.det * np.sign(here[k].det) >= abs(here[k].det) / 2.0
        if shrinks and same and reached.sharpness > SQRT_EPS:
            found[k] = reached
    return found


def _stations(constraints: Constraints, poses: Floats, phi: Floats) -> list[Station]:
    """Close nearly closed poses by one Newton correction and differentiate them with the same Jacobians."""
    at = constraints.place(poses)
    jacobian = constraints.jacobian(at)
    inverse = inverses(jacobian)
    closed = poses - as_poses((inverse @ constraints.residual(at, phi)[..., None])[..., 0])
    first = as_poses(inverse[:, :, -1])
    second = as_poses(-(inverse @ constraints.convective(at, first)[..., None])[..., 0])
    det = np.linalg.det(jacobian)
    return [
        Station(float(phi[k]), closed[k], first[k], second[k], float(det[k]), float(sharp))
        for k, sharp in enumerate(sharpness(jacobian, inverse))
    ]


def _end(constraints: Constraints, way: Sequence[Station]) -> End:
    """Say why a march ended, and where its singular position lies by the run of the determinant."""
    last = way[-1]
    jacobian = constraints.jacobian(constraints.place(last.poses[None]))[0]
    faint, dead = rank_loss(jacobian)
    if faint > EPS**0.25:
        return End(last.phi, last.phi, NOT_REACHABLE)
    singular = last.phi
    if len(way) > 1 and last.det:
        before, power = way[-2], 2 if dead else 1  # det falls as the root of the distance at a dead centre
        fall = (before.det / last.det) ** power - 1.0
        singular += (last.phi - before.phi) / fall if fall > 0.0 else 0.0
    return End(last.phi, float(singular), DEAD_CENTRE if dead else CHANGE_POINT)


def stations_at(constraints: Constraints, near: Sequence[Station], phi: Floats) -> list[Station]:
    """Move from stations to crank angles close by, closed to rounding level."""
    guess = np.array([left.predict(angle) for left, angle in zip(near, phi, strict=True)])
    return _stations(constraints, close(constraints, guess, phi)[0], phi)
