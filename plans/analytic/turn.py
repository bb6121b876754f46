"""The way round the turn: poses at stations of the crank, each reached from the last by continuity.

The march goes from the assembled position in both senses abreast, never across a singular position. A step is taken
only if the second-order Taylor polynomial lands close to the closed poses, Newton's corrections shrink fast, and the
determinant of every block of the Jacobian keeps its sign and at least half its size; otherwise the step is halved.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plans.analytic.assembly import ClosedPosition, Closure
from plans.analytic.blocks import Block
from plans.analytic.closure import EPS, ROUNDINGS, SQRT_EPS, as_poses, close, closed, inverses, solutions
from plans.analytic.ends import BESIDE, CLEAR, DOUBTFUL, MERGED, SHORTEST, Halt, Station, determinants, end_of, least_of
from plans.analytic.points import Constraints
from plans.model.motion import CHANGE_POINT, NOT_REACHABLE, Floats

Blocks = Sequence[Block]

FULL = 2.0 * np.pi
STRIDE = FULL / 48  # rad, the longest step: 7.5 degrees
FIRST_STRIDE = STRIDE / 8  # the start may lie beside a singular position that a whole step would jump
LEAST = 2.0**-46  # rad, 1e-14: a few roundings of an angle
THERE = 64.0 * EPS  # rad: a few roundings of an angle of several turns
STEPS = 4096  # a march longer than this is given up
# A correction of this share of the way gone: the pose arrived at belongs to the pose left, not to another assembly.
TRUST = 1.0 / 16.0


@dataclass(frozen=True, eq=False, repr=False)
class Marched:
    """All stations of both marches in order of the crank angle, and what ended them."""

    stations: tuple[Station, ...]
    lower: Halt | None
    upper: Halt | None
    passed: tuple[Halt, ...] = ()  # change points on the way that the linkage is carried through

    @property
    def ends(self) -> tuple[Halt, ...]:
        """List the ends that the march met."""
        return tuple(end for end in (self.lower, self.upper) if end)

    def near(self, phi: float) -> Station:
        """Give the station nearest to a crank angle of the march, rad."""
        return self.stations[int(np.argmin(np.abs(self.angles - phi)))]

    @cached_property
    def angles(self) -> Floats:
        """Give the crank angles of the stations, rad, rising."""
        return np.array([station.phi for station in self.stations])

    def passes(self, start: ClosedPosition, ahead: Floats) -> bool:
        """Tell whether it goes freely from an assembly past all angles `ahead` of it."""
        low, high = self.angles[0] - SHORTEST - start.phi, self.angles[-1] + SHORTEST - start.phi
        return not self.ends and bool(((ahead <= high) | (ahead - FULL >= low)).all())

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

    def __init__(self, way: list[Station], goal: float, sense: float) -> None:
        self.way, self.goal, self.stride = way, goal, FIRST_STRIDE
        self.sense = sense
        self.shortest = LEAST  # the start may lie right beside a singular position, and leads away from it
        self.passed: list[Halt] = []
        self.looked = False  # beyond the goal

    @property
    def left(self) -> float:
        """The angle still to go, rad; a few roundings short of the goal is there."""
        left = self.sense * (self.goal - self.way[-1].phi)
        return left if left > THERE else 0.0

    def look_beyond(self) -> None:
        """Go on a little where the goal may lie right before a singular position, so that this is known."""
        if not (self.left or self.looked) and self.way[-1].sharp < DOUBTFUL:
            self.looked = True
            self.goal += self.sense * BESIDE

    @property
    def stuck(self) -> bool:
        """Whether no step is short enough."""
        return self.stride < self.shortest

    @property
    def next(self) -> float:
        """The crank angle of the next step, rad."""
        return self.goal if self.stride >= self.left else self.way[-1].phi + self.sense * self.stride

    def take(self, reached: Station | None) -> None:
        """Step to a station, or shorten the stride where there is none."""
        if reached is None:
            self.stride /= 2.0
        else:
            self.shortest = min(max(abs(reached.phi - self.way[-1].phi) / 64.0, LEAST), SHORTEST)
            self.way.append(reached)
            self.stride = min(2.0 * self.stride, STRIDE)

    def carry(self, beyond: Station, end: Halt) -> None:
        """Go on beyond a change point."""
        self.way.append(beyond)
        self.passed.append(end)
        self.stride = CLEAR


def survey(shape: Closure, start: ClosedPosition, ahead: Floats) -> Marched:
    """March from the assembly until all angles `ahead` of it, rad in [0, 2 pi), are passed in either sense."""
    first = station(shape.constraints, shape.blocks, start)
    most = start.phi + float(np.max(ahead, where=ahead <= np.pi, initial=0.0))
    least = start.phi - float(np.max(FULL - ahead, where=ahead > np.pi, initial=0.0))
    up, down = _March([first], most, 1.0), _March([first], least, -1.0)
    upper, lower = _march(shape, up, down)
    # What lies beyond one end may be reached the other way round, where there is a way round.
    round_ = not shape.mechanism.drive.pushed  # a crank's angles come round, also those of one that a cylinder turns
    if round_ and upper and not lower:
        lost = ahead > upper.reached - start.phi
        down.goal = start.phi - (FULL - float(np.min(ahead, where=lost, initial=FULL)))
        (lower,) = _march(shape, down)
    elif round_ and lower and not upper:
        lost = ahead < FULL + lower.reached - start.phi
        up.goal = start.phi + float(np.max(ahead, where=lost, initial=0.0))
        (upper,) = _march(shape, up)
    return Marched((*reversed(down.way[1:]), *up.way), lower, upper, (*down.passed, *up.passed))


def whole_turn(shape: Closure, turn: Marched) -> Marched | None:
    """Lengthen a march on both sides until it comes round; None where the drive cannot make a full turn."""
    if turn.ends or not shape.mechanism.drive.turns:
        return None
    low, high = turn.stations[0].phi, turn.stations[-1].phi
    half = (FULL - (high - low)) / 2.0
    up, down = _March([*turn.stations], high + half, 1.0), _March([*reversed(turn.stations)], low - half, -1.0)
    if any(_march(shape, up, down)):
        return None
    added = down.way[len(turn.stations) :]
    return Marched((*reversed(added), *up.way), None, None, (*down.passed, *turn.passed, *up.passed))


def station(constraints: Constraints, blocks: Blocks, start: ClosedPosition) -> Station:
    """Begin a march at an assembly."""
    return _stations(constraints, blocks, start.poses[None], np.array([start.phi]))[0]


def _march(shape: Closure, *marches: _March) -> list[Halt | None]:
    """Lengthen all ways to their goals, abreast; tell what ended each of them, where it could go no further."""
    constraints, blocks = shape.constraints, shape.blocks
    for march in marches:
        if march.way[-1].sharp <= MERGED:
            march.stride = 0.0
    for _ in range(STEPS):
        for march in marches:
            march.look_beyond()
        under_way = [march for march in marches if march.left and (not march.stuck or _carried(shape, march))]
        if not under_way:
            break
        here = [march.way[-1] for march in under_way]
        stations = _steps(constraints, blocks, here, np.array([march.next for march in under_way]))
        for march, reached in zip(under_way, stations, strict=True):
            march.take(reached)
    return [_end(constraints, blocks, march) for march in marches]


def _carried(shape: Closure, march: _March) -> bool:
    """Carry a linkage smoothly through a change point, if something does; tell whether it is beyond."""
    constraints, blocks = shape.constraints, shape.blocks
    if not shape.mechanism.through or len(march.way) < 2:
        return False
    end = end_of(constraints, blocks, march.way, march.sense)
    if end.reason != CHANGE_POINT or end.loose is not None:
        return False
    before = [s for s in march.way if abs(s.phi - end.singular) >= CLEAR]
    phi = np.array([end.singular + march.sense * CLEAR])
    (beyond,) = stations_at(constraints, blocks, before[-1:] or march.way[:1], phi)
    over = (beyond.dets * march.way[-1].dets < 0.0).sum()
    if over != 1 or beyond.sharp <= MERGED:
        return False
    march.carry(beyond, end)
    return True


def _end(constraints: Constraints, blocks: Blocks, march: _March) -> Halt | None:
    last = march.way[-1]
    if march.stuck or last.sharp <= MERGED:
        return end_of(constraints, blocks, march.way, march.sense)
    return Halt(last.phi, last.phi, NOT_REACHABLE, march.sense) if march.left else None


def _steps(constraints: Constraints, blocks: Blocks, here: Sequence[Station], phi: Floats) -> list[Station | None]:
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
    stations = _stations(constraints, blocks, there[near], phi[near])
    # A step from right beside a singular position may lead far away, where small corrections mean nothing.
    whole = closed(constraints, np.array([reached.poses for reached in stations]), phi[near], SQRT_EPS)
    for k, reached, joined in zip(near, stations, whole.tolist(), strict=True):
        if joined and reached.sharp > MERGED and _follows(here[k], reached, there[k], size[k], moved[k]):
            found[k] = reached
    return found


def _follows(left: Station, reached: Station, there: Floats, size: float, moved: float) -> bool:
    """Tell whether a station is of the assembly left: corrections shrink fast, determinants keep sign and half size."""
    again = np.abs(reached.poses - there).max()
    noise = ROUNDINGS * EPS / reached.sharp  # how well the poses are known at all
    same = (reached.dets * np.sign(left.dets) >= np.abs(left.dets) / 2.0).all()
    return bool(same and again <= TRUST * size + SQRT_EPS * moved + noise)


def _stations(constraints: Constraints, blocks: Blocks, poses: Floats, phi: Floats) -> list[Station]:
    """Close nearly closed poses by one Newton correction and differentiate them with the same Jacobians."""
    at = constraints.place(poses)
    jacobian = constraints.jacobian(at)
    inverse = inverses(jacobian)
    closed = poses - as_poses((inverse @ constraints.residual(at, phi)[..., None])[..., 0])
    first = as_poses(inverse[:, :, -1])
    second = as_poses(-(inverse @ constraints.convective(at, first)[..., None])[..., 0])
    found = determinants(blocks, jacobian)
    dets, sharp = found.T, least_of(blocks, found, jacobian, closed)
    return [Station(float(phi[k]), closed[k], first[k], second[k], dets[k], float(sharp[k])) for k in range(len(phi))]


def stations_at(constraints: Constraints, blocks: Blocks, near: Sequence[Station], phi: Floats) -> list[Station]:
    """Move from stations to crank angles close by, closed to rounding level."""
    guess = np.array([left.predict(angle) for left, angle in zip(near, phi, strict=True)])
    return _stations(constraints, blocks, close(constraints, guess, phi)[0], phi)
