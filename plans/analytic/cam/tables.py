"""Laws that the user gives, by other ways than the construction's: a clamped beam, areas and their moments (по точкам).

Through a table's points lies a beam, clamped level at both ends: unknown are its slopes; where springs hold it, their
forces, by the beam's influence function. Under a shape of acceleration s is the sum of the areas passed, each times its
distance.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Final, NamedTuple

import numpy as np

from plans.model.cam import LINES, SHAPE, SOFTNESSES, TABLE, Law
from plans.model.motion import Floats


class Beam(NamedTuple):
    """A bent beam: its points in shares of the phase, s there and the slopes there, (N,)."""

    share: Floats
    s: Floats
    slopes: Floats


def along_table(law: Law, k: Floats, order: int, before: bool) -> Floats:
    """Give s, s' or s'' of a table at shares of the phase, (N,)."""
    share, s = np.array(law.points, dtype=float).T
    if law.through == LINES:
        slopes = np.diff(s) / np.diff(share)
        return (np.interp(k, share, s), slopes[_interval(share, k, before)], np.zeros_like(k))[order]
    return _hermite(beam(law), k, order, before)


def along_shape(law: Law, k: Floats, order: int, before: bool) -> Floats:
    """Give s, s' or s'' under a shape of acceleration at shares of the phase, (N,)."""
    share, a = np.array(law.points, dtype=float).T
    wide, low, high = np.diff(share), a[:-1], a[1:]
    areas = wide * (low + high) / 2
    moments = share[:-1] * areas + wide**2 * (low + 2 * high) / 6  # about the start of the phase
    passed, turned = (np.concatenate([[0.0], np.cumsum(one)]) for one in (areas, moments))
    own = _interval(share, k, before)
    t, rise = k - share[own], (high - low)[own] / wide[own]
    s = k * passed[own] - turned[own] + t**2 * (low[own] / 2 + rise * t / 6)
    found = (s, passed[own] + t * (low[own] + rise * t / 2), low[own] + rise * t)[order]
    return np.asarray(found / (passed[-1] - turned[-1]))


GIVEN: Final[Mapping[str, Callable[[Law, Floats, int, bool], Floats]]] = {TABLE: along_table, SHAPE: along_shape}


def departure(law: Law) -> float:
    """Tell how far a table's curve is from its points at most, in shares of the lift."""
    return 0.0 if law.through == LINES else _off(beam(law), law)


def _interval(share: Floats, k: Floats, before: bool) -> np.ndarray[tuple[int], np.dtype[np.int_]]:
    """Give the interval of points, one beyond the other, that each share lies in."""
    own = np.searchsorted(share, k, side="left" if before else "right") - 1
    solid = np.flatnonzero(np.diff(share) > 0)
    return np.asarray(np.clip(own, solid[0], solid[-1]), dtype=int)


def _hermite(bent: Beam, k: Floats, order: int, before: bool) -> Floats:
    """Follow each interval by the cubic that has the ordinates and slopes of its ends."""
    own = _interval(bent.share, k, before)
    h, rise = np.diff(bent.share)[own], np.diff(bent.s)[own]
    x = (k - bent.share[own]) / h
    left, right = bent.slopes[own] * h - rise, rise - bent.slopes[own + 1] * h
    first = bent.s[own] + rise * x + x * (1 - x) * (left * (1 - x) + right * x)
    second = rise + left * (1 - x) * (1 - 3 * x) + right * x * (2 - 3 * x)
    third = left * (6 * x - 4) + right * (2 - 6 * x)
    return np.asarray((first, second / h, third / h**2)[order])


@lru_cache(maxsize=64)
def beam(law: Law) -> Beam:
    """Lay the beam through a table's points, or on the softest springs that let it depart by its tolerance at most."""
    share, y = np.array(law.points, dtype=float).T
    yielding, low, high = y, 0, len(SOFTNESSES) if law.tolerance > 0 else 0
    sag = _influence(share[1:-1])
    while low < high:
        middle = (low + high - 1) // 2
        found = _sprung(SOFTNESSES[middle], sag, share, y)
        if np.max(np.abs(found - y)) <= law.tolerance:
            yielding, low = found, middle + 1
        else:
            high = middle
    return Beam(share, yielding, _slopes(share, yielding))


def _off(bent: Beam, law: Law) -> float:
    return float(np.max(np.abs(bent.s - np.array(law.points)[:, 1])))


def _influence(x: Floats) -> Floats:
    """Give how far a clamped beam of stiffness 1 gives at each point under a force of 1 at each other, (N, N)."""
    near, far = np.minimum(x, x[:, None]), np.maximum(x, x[:, None])
    return np.asarray(near**2 * (1 - far) ** 2 * (3 * far - near * (1 + 2 * far)) / 6)


def _sprung(softness: float, sag: Floats, share: Floats, y: Floats) -> Floats:
    """Let springs draw the beam to the points within; each gives by its softness times its force, (N,)."""
    free = share[1:-1]
    unloaded = y[0] + (y[-1] - y[0]) * free**2 * (3 - 2 * free)
    forces = np.linalg.solve(sag + softness * np.eye(len(free)), y[1:-1] - unloaded)
    return y - softness * np.array([0.0, *forces, 0.0])


def _slopes(share: Floats, s: Floats) -> Floats:
    """Give the slopes at the points that leave no jump of curvature: none at both ends, (N,)."""
    stiff, chords = 1 / np.diff(share), np.diff(s) / np.diff(share)
    slopes = np.zeros_like(s)
    if len(s) > 2:
        own = np.diag(2 * (stiff[:-1] + stiff[1:])) + np.diag(stiff[1:-1], 1) + np.diag(stiff[1:-1], -1)
        slopes[1:-1] = np.linalg.solve(own, 3 * (stiff[:-1] * chords[:-1] + stiff[1:] * chords[1:]))
    return slopes
