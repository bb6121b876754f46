"""The poses at all crank angles asked for, from one assembly by continuity; what was not found is a gap."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import zip_longest

import numpy as np

from plans.analytic.assembly import assemble, assemble_anywhere
from plans.analytic.closure import EPS, Flags, close, close_singular, settle
from plans.analytic.constraints import TURN, Constraints
from plans.analytic.gaps import BEYOND, OUT_OF_REACH, gap
from plans.analytic.turn import CHANGE_POINT, DEAD_CENTRE, FULL, NOT_REACHABLE, SHORTEST, End, Turn, survey
from plans.mechanism import Mechanism
from plans.motion import Floats, Gap

BLOCK = 2048  # positions solved together: their matrices stay in the cache
PROBES = 64  # lost positions at which other assemblies are looked for,
STARTS = 4  # and poses of the march that each is tried from
# Taylor's polynomial from this distance misses by its cube, and the poses there are known to eps over the distance:
# both come to eps^(3/4) at the fourth root of eps.
CLEAR = EPS**0.25


@dataclass
class Positions:
    """Poses (N, links, 3) at crank angles phi rad, NaN where there are none; `regular` where velocities exist."""

    phi: Floats
    poses: Floats
    regular: Flags
    turn: Turn | None = None  # the way round that was marched
    gaps: list[Gap] = field(default_factory=list)

    def miss(self, position: int, plan: str, reason: str, end: End | None) -> None:
        """Note a gap."""
        self.gaps.append(gap(position, float(self.phi[position]), plan, reason, end))


def find(
    mechanism: Mechanism, constraints: Constraints, phi: Floats, tolerance: float = EPS, first: bool = True
) -> Positions:
    """Find the poses at crank angles phi rad, (N,), starting at the first of them if the links can be joined there.

    Where the sketch does not show the `first` one, the march starts where the mechanism fits the sketch best.
    The way round the turn is always marched to rounding level; `tolerance` is for the positions asked for.
    """
    found = Positions(phi, np.full((len(phi), len(constraints.numbers), 3), np.nan), np.zeros(len(phi), dtype=bool))
    if not phi.size:
        return found
    start = assemble(mechanism, constraints, float(phi[0])) if first else None
    start = start or assemble_anywhere(mechanism, constraints)
    if start is None:
        for k in range(len(phi)):
            found.miss(k, "positions", OUT_OF_REACH, None)
        return found
    ahead = (phi - start.phi) % FULL
    turn = found.turn = survey(constraints, start, ahead)
    crank = start.phi + ahead
    behind = (crank > turn.angles[-1] + SHORTEST) & (crank - FULL >= turn.angles[0] - SHORTEST)
    crank[behind] -= FULL
    passed = behind | (crank <= turn.angles[-1] + SHORTEST)
    for end in turn.ends:
        passed &= ~_at_the_end(found, constraints, turn, end)
    _along(found, constraints, turn, crank, passed, tolerance)
    _lost(found, constraints, turn)
    found.gaps.sort(key=lambda missing: missing.position)
    return found


def blocks(count: int) -> Iterator[slice]:
    """Cut `count` positions into blocks."""
    return (slice(begin, begin + BLOCK) for begin in range(0, count, BLOCK))


def wrapped(poses: Floats) -> Floats:
    """Bring the turns into (-pi, pi] without touching those that are."""
    within = poses.copy()
    within[..., TURN] -= FULL * np.ceil((poses[..., TURN] - np.pi) / FULL)
    return within


def _along(
    found: Positions, constraints: Constraints, turn: Turn, crank: Floats, passed: Flags, tolerance: float
) -> None:
    """Close the poses at the positions that the march has passed."""
    places = np.flatnonzero(passed)
    for block in blocks(len(places)):
        here = places[block]
        poses, reached = close(constraints, wrapped(turn.predict(crank[here])), found.phi[here], tolerance)
        found.poses[here[reached]] = poses[reached]
        found.regular[here[reached]] = True


def _at_the_end(found: Positions, constraints: Constraints, turn: Turn, end: End) -> Flags:
    """Treat the positions that the march cannot tell from the singular one; tell which they are."""
    apart = _apart(found.phi, end)
    at = np.abs(apart) <= end.blind
    untold = at.copy()
    untold[[missing.position for missing in found.gaps]] = False  # both marches may end at one position
    places = np.flatnonzero(untold)
    if end.reason == CHANGE_POINT and places.size:
        clear = [s for s in turn.stations if abs(s.phi - end.singular) >= CLEAR] or list(turn.stations)
        station = min(clear, key=lambda s: abs(s.phi - end.singular))
        guess = np.array([station.predict(end.singular + offset) for offset in apart[places]])
        found.poses[places] = close_singular(constraints, wrapped(guess), found.phi[places])
        for k in places:
            found.miss(int(k), "velocities", CHANGE_POINT, end)
    elif end.reason == DEAD_CENTRE and places.size:
        station = turn.stations[-1 if end is turn.upper else 0]
        poses, reached = close(constraints, np.repeat(station.poses[None], len(places), axis=0), found.phi[places])
        # Two assemblies merge here; the sign of the determinant tells them apart.
        reached &= np.linalg.det(constraints.jacobian(constraints.place(poses))) * station.det > 0.0
        found.poses[places[reached]], found.regular[places[reached]] = wrapped(poses[reached]), True
        for k in places[~reached]:
            found.miss(int(k), "positions", DEAD_CENTRE, end)
    return at


def _lost(found: Positions, constraints: Constraints, turn: Turn) -> None:
    """Say of every position not found why that is."""
    untold = np.isnan(found.poses[:, 0, 0])
    untold[[missing.position for missing in found.gaps]] = False
    lost = np.flatnonzero(untold)
    folds = any(end.reason == DEAD_CENTRE for end in turn.ends)
    exists = _assembles(constraints, turn, found.phi[lost]).tolist() if folds and lost.size else []
    for k, other in zip_longest(lost.tolist(), exists, fillvalue=False):
        end = min(turn.ends, key=lambda e: float(abs(_apart(found.phi[k], e))), default=None)
        if end and end.reason == CHANGE_POINT:
            found.miss(k, "positions", BEYOND, end)
        elif end and end.reason == DEAD_CENTRE and not other:
            found.miss(k, "positions", OUT_OF_REACH, end)
        else:
            found.miss(k, "positions", NOT_REACHABLE, end)


def _assembles(constraints: Constraints, turn: Turn, phi: Floats) -> Flags:
    """Tell whether the links can be joined at all at these crank angles, tried from poses all along the march.

    Of many angles a sample is tried, and each of the others takes the answer of a neighbour.
    """
    sample = np.array(sorted(set(np.linspace(0, len(phi) - 1, PROBES).round().astype(np.intp).tolist())))
    stations = turn.stations[:: max(1, len(turn.stations) // STARTS)]
    starts = np.array([station.poses for station in stations])
    _, reached = settle(constraints, np.tile(starts, (len(sample), 1, 1)), np.repeat(phi[sample], len(starts)))
    exists = np.logical_or.reduce(reached.reshape(len(sample), -1), axis=1)
    return np.asarray(exists[np.searchsorted(sample, np.arange(len(phi)))])


def _apart(phi: Floats, end: End) -> Floats:
    """Give the angle rad, in [-pi, pi), from the singular position of an end."""
    return np.asarray((phi - end.singular + np.pi) % FULL - np.pi)
