"""The poses at all crank angles asked for, from one assembly by continuity; what was not found is a gap."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from plans.analytic.assembly import DYAD, INFINITE, ClosedPosition, Closure, assemblies, gap, signs_of
from plans.analytic.blocks import Block
from plans.analytic.closure import EPS, SQRT_EPS, Flags, close, close_singular, closed, far
from plans.analytic.ends import AT_CHANGE, BESIDE, CLEAR, DOUBTFUL, SHORTEST, Halt, Station, least
from plans.analytic.points import TURN, Indices
from plans.analytic.turn import FULL, Marched, survey
from plans.model.mechanism import Drive
from plans.model.motion import (
    BEYOND_CHANGE_POINT,
    CHANGE_POINT,
    DEAD_CENTRE,
    NOT_REACHABLE,
    OUT_OF_REACH,
    PARALLEL_GUIDES,
    Floats,
    Gap,
)

BLOCK = 2048  # positions solved together: their matrices stay in the cache
# So near to a dead centre, rad, that a rounding of the crank angle moves a velocity by a thousandth of itself: more
# than can be seen on a plan. There is a position, but no velocity is told.
UNBORNE = 1000.0 * EPS
NOWHERE = 8.0 * UNBORNE  # rad from a change point in which a block has any place: no true digit of its place is left


@dataclass(eq=False, repr=False)
class Positions:
    """Poses (N, links, 3) at crank angles phi rad, NaN where there are none; `regular` where velocities exist."""

    phi: Floats
    poses: Floats
    regular: Flags
    drive: Drive
    turn: Marched | None = None  # the way round that was marched
    gaps: list[Gap] = field(default_factory=list)

    def miss(self, position: int, plan: str, reason: str, end: Halt | None) -> None:
        """Note a gap."""
        self.gaps.append(gap(position, float(self.phi[position]), plan, reason, end, self.drive))

    def known(self) -> set[int]:
        """Give the positions of which a gap is noted."""
        return {missing.position for missing in self.gaps}


def find(
    shape: Closure, phi: Floats, start: ClosedPosition | None, tolerance: float = EPS, known: Marched | None = None
) -> Positions:
    """Find the poses at crank angles phi rad, (N,), by a march from where the mechanism is assembled to its sketch.

    The way round the turn is always marched to rounding level; `tolerance` is for the positions asked for. A `known`
    march from there is taken where it passes all of them.
    """
    found = Positions(phi, *_none(shape, phi), shape.mechanism.drive)
    if start is None:
        for k in range(len(phi)):
            found.miss(k, "positions", OUT_OF_REACH, None)
        return found
    ahead = (phi - start.phi) % FULL
    turn = found.turn = known if known and known.passes(start, ahead) else survey(shape, start, ahead)
    crank = start.phi + ahead
    behind = (crank > turn.angles[-1] + SHORTEST) & (crank - FULL >= turn.angles[0] - SHORTEST)
    crank[behind] -= FULL
    passed = behind | (crank <= turn.angles[-1] + SHORTEST)
    for end in (*turn.ends, *turn.passed):
        passed &= ~_at_the_end(found, shape, turn, end)
    _along(found, shape, turn, crank, passed, tolerance)
    _tell_lost(found, shape, turn)
    found.gaps.sort(key=lambda missing: missing.position)
    return found


def along(shape: Closure, phi: Floats, turn: Marched, tolerance: float = EPS) -> Positions:
    """Find the poses at crank angles phi rad, (N,), on a whole turn that was marched and meets nothing singular."""
    found = Positions(phi, *_none(shape, phi), shape.mechanism.drive)
    crank = turn.angles[0] + (phi - turn.angles[0]) % FULL
    _along(found, shape, turn, crank, np.ones(len(phi), dtype=bool), tolerance)
    _tell_lost(found, shape, turn)
    return found


def _none(shape: Closure, phi: Floats) -> tuple[Floats, Flags]:
    return np.full((len(phi), len(shape.constraints.numbers), 3), np.nan), np.zeros(len(phi), bool)


def blocks(count: int) -> Iterator[slice]:
    """Cut `count` positions into blocks."""
    return (slice(begin, begin + BLOCK) for begin in range(0, count, BLOCK))


def wrapped(poses: Floats) -> Floats:
    """Bring the turns into (-pi, pi] without touching those that are."""
    within = poses.copy()
    within[..., TURN] -= FULL * np.ceil((poses[..., TURN] - np.pi) / FULL)
    return within


def _along(found: Positions, shape: Closure, turn: Marched, crank: Floats, passed: Flags, tolerance: float) -> None:
    """Close the poses at the positions that the march has passed."""
    places = np.flatnonzero(passed)
    for block in blocks(len(places)):
        here = places[block]
        poses, reached = close(shape.constraints, wrapped(turn.predict(crank[here])), found.phi[here], tolerance)
        found.poses[here[reached]] = poses[reached]
        found.regular[here[reached]] = True
        if min(station.sharp for station in turn.stations) < DOUBTFUL:
            _tell_unborne(found, shape, turn, here[reached])


def _tell_unborne(found: Positions, shape: Closure, turn: Marched, here: Indices) -> None:
    """Tell no velocities right beside a change point, or where a block all but comes to its dead centre."""
    jacobian = shape.constraints.jacobian(shape.constraints.place(found.poses[here]))
    for k in here[least(shape.blocks, jacobian, found.poses[here]) ** 2 < UNBORNE].tolist():
        near = [end for end in (*turn.ends, *turn.passed) if abs(_apart(found.phi[[k]], end)[0]) < BESIDE]
        if near and near[0].reason != CHANGE_POINT:
            continue  # a dead centre or parallel guides are told by the angle
        found.regular[k] = False
        found.miss(k, "velocities", CHANGE_POINT if near else DEAD_CENTRE, near[0] if near else None)


def _at_the_end(found: Positions, shape: Closure, turn: Marched, end: Halt) -> Flags:
    """Treat the positions that the march cannot tell from the singular one; tell which they are."""
    apart = _apart(found.phi, end)
    at = np.abs(apart) <= end.blind
    places = [k for k in np.flatnonzero(at).tolist() if k not in found.known()]  # both may end at one position
    treat = {CHANGE_POINT: _at_change, DEAD_CENTRE: _at_dead_centre, PARALLEL_GUIDES: _at_parallel}.get(end.reason)
    if treat is None or not places:
        return np.zeros_like(at)
    treat(found, shape, turn, end, places, apart[places])
    return at


def _at_change(found: Positions, shape: Closure, turn: Marched, end: Halt, places: list[int], apart: Floats) -> None:
    """Place the links at a change point, where they have one place but no one velocity, and right beside it."""
    clear = [s for s in turn.stations if abs(s.phi - end.singular) >= CLEAR] or list(turn.stations)
    near = min(clear, key=lambda s: abs(s.phi - end.singular))
    for k, beyond in zip(places, (end.sense * apart).tolist(), strict=True):
        if beyond > AT_CHANGE and end not in turn.passed:
            continue  # lost
        guess = wrapped(near.predict(end.singular + end.sense * beyond)[None])
        if end.loose is not None and _apart_by(shape.blocks[end.loose], end, near, guess[0]) < NOWHERE:
            found.miss(k, "positions", DEAD_CENTRE, end)
            continue
        # Newton's method would only magnify roundings there.
        flat = abs(beyond) <= AT_CHANGE and (end.loose is None or not _borne(shape, guess))
        poses, reached = close(shape.constraints, guess, found.phi[[k]])
        if flat or not reached[0]:
            poses = close_singular(shape.constraints, guess, found.phi[[k]])
        if not closed(shape.constraints, poses, found.phi[[k]], SQRT_EPS)[0]:
            continue  # lost
        flat = flat or not reached[0] or not _borne(shape, poses)
        found.poses[k], found.regular[k] = poses[0], not flat
        if flat:
            found.miss(k, "velocities", CHANGE_POINT, end)


def _apart_by(block: Block, end: Halt, near: Station, poses: Floats) -> float:
    """Give the angle rad from a change point by a block's determinant, which passes zero there as the angle does."""
    whole, there = np.linalg.det(block.of_own(near.poses)), np.linalg.det(block.of_own(poses))
    return float(abs(there * (near.phi - end.singular) / whole)) if whole else 0.0


def _borne(shape: Closure, poses: Floats) -> bool:
    """Tell whether the condition bears the velocities at poses (1, links, 3)."""
    jacobian = shape.constraints.jacobian(shape.constraints.place(poses))
    return bool(least(shape.blocks, jacobian, poses)[0] ** 2 >= UNBORNE)


def _at_dead_centre(
    found: Positions, shape: Closure, turn: Marched, end: Halt, places: list[int], apart: Floats
) -> None:
    """Place the links beside a dead centre, by their path there; at it they have no velocity, beyond it no place."""
    before = -end.sense * apart  # rad on this side of it
    for k, left in zip(places, before.tolist(), strict=True):
        if end.fold is None or left < -end.limit:
            continue  # lost, for whatever reason
        guess = wrapped(end.fold.predict(-end.sense * max(left, 0.0))[None])
        poses, reached = close(shape.constraints, guess, found.phi[[k]])
        if left >= UNBORNE and reached[0] and _same(shape, turn.near(end.reached), poses[0]):
            found.poses[k], found.regular[k] = wrapped(poses)[0], True
        else:
            found.poses[k] = guess[0]
            found.miss(k, "velocities", DEAD_CENTRE, end)


def _at_parallel(found: Positions, shape: Closure, turn: Marched, end: Halt, places: list[int], apart: Floats) -> None:
    """Place the links where guides are nearly parallel, far away; where they are parallel there is no place."""
    last = turn.stations[-1 if end is turn.upper else 0]
    for k, left in zip(places, (-end.sense * apart).tolist(), strict=True):
        guess = wrapped(_away(last, end, max(left, UNBORNE))[None])
        poses, reached = close(shape.constraints, guess, found.phi[[k]])
        if left >= UNBORNE and reached[0] and _same(shape, turn.near(end.reached), poses[0]):
            found.poses[k], found.regular[k] = wrapped(poses)[0], True
        elif abs(left) < UNBORNE or not (
            reached[0] and far(poses)[0] < INFINITE
        ):  # the march knows their angle not to its last digits
            found.miss(k, "positions", PARALLEL_GUIDES, end)


def _away(last: Station, end: Halt, left: float) -> Floats:
    """Predict poses `left` rad before guides are parallel: what slides on them is as far away as that is short."""
    whole = abs(end.singular - last.phi)
    runs = np.array([whole * (whole / left - 1.0)] * 2 + [whole - left])
    return np.asarray(last.poses + end.sense * runs * last.first)


def _same(shape: Closure, near: Station, poses: Floats) -> bool:
    jacobian = shape.constraints.jacobian(shape.constraints.place(poses[None]))[0]
    return bool((signs_of(shape.blocks, jacobian) == np.sign(near.dets)).all())


def _tell_lost(found: Positions, shape: Closure, turn: Marched) -> None:
    """Say of every position not found why that is."""
    untold = np.isnan(found.poses[:, 0, 0])
    untold[list(found.known())] = False
    lost = np.flatnonzero(untold)
    if not lost.size:
        return
    ends = [_bounding(phi, turn) for phi in found.phi[lost]]
    # Beyond a change point or parallel guides it does not matter whether the links would meet.
    open_ = np.array([end is None or end.reason in (DEAD_CENTRE, NOT_REACHABLE) for end in ends])
    exists = np.ones(len(lost), dtype=bool)
    if any(len(block.links) > DYAD and not block.linear for block in shape.blocks):
        exists[open_] = False  # of several assemblies of either sign none is that which the march follows
    elif open_.any():
        exists[open_] = _assembles(shape, turn, found.phi[lost[open_]])
    for k, end, other in zip(lost.tolist(), ends, exists.tolist(), strict=True):
        folded = end is not None and end.reason == DEAD_CENTRE and abs(float(_apart(found.phi[k], end))) < BESIDE
        if folded or not other:
            found.miss(k, "positions", OUT_OF_REACH, end)
        elif end and end.reason == CHANGE_POINT:
            found.miss(k, "positions", BEYOND_CHANGE_POINT, end)
        else:
            found.miss(k, "positions", NOT_REACHABLE, end)


def _bounding(phi: float, turn: Marched) -> Halt | None:
    """Give the end that keeps the crank from an angle, rad: the nearer one, of two as near the upper."""
    apart = [np.inf if end is None else abs(float(_apart(np.array(phi), end))) for end in (turn.upper, turn.lower)]
    return turn.upper if apart[0] <= apart[1] + BESIDE else turn.lower


def _assembles(shape: Closure, turn: Marched, phi: Floats) -> Flags:
    """Tell whether the links can be joined at these crank angles in the assembly that the march follows."""
    return np.asarray(np.isfinite(assemblies(shape, phi, np.sign(turn.stations[0].dets))).all(axis=(1, 2)))


def _apart(phi: Floats, end: Halt) -> Floats:
    """Give the angle rad, in [-pi, pi), from the singular position of an end."""
    return np.asarray((phi - end.singular + np.pi) % FULL - np.pi)
