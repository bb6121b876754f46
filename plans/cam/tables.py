"""A law by a table of S over φ: joined by lines, or by a ruler that bends (закон движения по таблице, гибкая линейка).

The ruler is the cubic spline with no slope at both ends. Its moments, the accelerations at the points, are what is
solved for; between two points they go straight. Of springs in place of the points it departs a little and bends less.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from plans.cam.pieces import Piece, Shares
from plans.model.cam import LINES, SOFTNESSES, Law
from plans.model.motion import Floats


class Ruler(NamedTuple):
    """A bent ruler: where its points are, in shares of the phase, s there, and the accelerations there, (N,)."""

    share: Floats
    s: Floats
    moments: Floats

    def departure(self, law: Law) -> tuple[float, float]:
        """Give how far it is from a table's points at most, in shares of the lift, and at which share of the phase."""
        off = np.abs(self.s - np.array(law.points)[:, 1])
        worst = int(np.argmax(off.round(9)))  # of a table and its mirror image the first
        return float(off[worst]), float(self.share[worst])


def table(law: Law) -> Shares:
    """Give the law of a table in pieces.

    >>> table(Law("table", points=((0, 0), (0.5, 0.4), (1, 1)), through="lines")).at(np.array([0.75]), 1).tolist()
    [1.2]
    """
    return _lines(law) if law.through == LINES else _cubics(ruler(law))


def smoothing(law: Law) -> tuple[float, float]:
    """Tell how far a table's curve is from its points at most, in shares of the lift, and where: never unsaid.

    >>> smoothing(Law("table", points=((0, 0), (0.5, 0.4), (1, 1))))
    (0.0, 0.0)
    """
    return (0.0, 0.0) if law.through == LINES else ruler(law).departure(law)


@lru_cache(maxsize=64)
def ruler(law: Law) -> Ruler:
    """Bend a ruler through a table's points, or as near to them as its tolerance allows with the least bending."""
    k, y = np.array(law.points, dtype=float).T
    equations = _equations(np.diff(k))
    best, low, high = y, -1, len(SOFTNESSES) if law.tolerance > 0 else 0
    while high - low > 1:
        middle = (low + high) // 2
        found = _sprung(equations, y, SOFTNESSES[middle])
        if np.abs(found - y).max() <= law.tolerance:
            best, low = found, middle
        else:
            high = middle
    return Ruler(k, best, np.linalg.solve(equations.bends, equations.kinks @ best))


class Equations(NamedTuple):
    """The equations of three moments: `bends` by the moments are the `kinks` by the ordinates, (N, N) each.

    `given` are the kinks of what springs under all points but the first and the last give: their forces are kinks too.
    """

    bends: Floats
    kinks: Floats
    given: Floats


def _equations(h: Floats) -> Equations:
    """Set the equations up for points at some distances, shares of the phase."""
    kinks = np.diag(-np.append(1 / h, 0.0) - np.append(0.0, 1 / h)) + np.diag(1 / h, 1) + np.diag(1 / h, -1)
    bends = np.diag(np.append(h, 0.0) + np.append(0.0, h)) / 3 + np.diag(h, 1) / 6 + np.diag(h, -1) / 6
    return Equations(bends, kinks, kinks[:, 1:-1] @ kinks[1:-1])


def _sprung(equations: Equations, y: Floats, softness: float) -> Floats:
    """Give the ordinates of a ruler on springs of some softness, (N,)."""
    moments = np.linalg.solve(equations.bends + softness * equations.given, equations.kinks @ y)
    forces = equations.kinks @ moments
    return np.asarray(y - softness * np.array([0.0, *forces[1:-1], 0.0]))


def _cubics(bent: Ruler) -> Shares:
    h, (first, last) = np.diff(bent.share), (bent.moments[:-1], bent.moments[1:])
    slopes = np.diff(bent.s) / h - h * (2 * first + last) / 6
    rows = np.column_stack([bent.s[:-1], slopes, first / 2, (last - first) / (6 * h)])
    return Shares(
        tuple(Piece(start, tuple(row)) for start, row in zip(bent.share.tolist(), rows.tolist(), strict=False))
    )


def _lines(law: Law) -> Shares:
    return Shares(tuple(Piece(k, (s, (b - s) / (a - k))) for (k, s), (a, b) in pairwise(law.points)))
