"""Laws that the user gives, by other ways than the construction's: a beam on springs, areas and their moments.

Through a table's points lies a beam, clamped level at both ends: unknown are its slopes, and its ordinates too where
springs hold it. Under a shape of acceleration s is the sum of areas passed, each times its distance (закон по точкам).
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
    stiffness = _stiffness(np.diff(share))
    best = _rigid(stiffness, share, y)
    low, high = 0, len(SOFTNESSES) if law.tolerance > 0 else 0
    while low < high:
        middle = (low + high - 1) // 2
        found = _sprung(SOFTNESSES[middle] * stiffness, share, y)
        if _off(found, law) <= law.tolerance:
            best, low = found, middle + 1
        else:
            high = middle
    return best


def _off(bent: Beam, law: Law) -> float:
    return float(np.max(np.abs(bent.s - np.array(law.points)[:, 1])))


def _stiffness(h: Floats) -> Floats:
    """Give the matrix of the integral of s''^2 over all ordinates and slopes, by turns, (2N, 2N)."""
    whole = np.zeros((2 * len(h) + 2, 2 * len(h) + 2))
    for number, x in enumerate(h.tolist()):
        rows = ((12, 6 * x, -12, 6 * x), (6 * x, 4 * x * x, -6 * x, 2 * x * x))
        part = np.array([*rows, [-c for c in rows[0]], (6 * x, 2 * x * x, -6 * x, 4 * x * x)]) / x**3
        whole[2 * number : 2 * number + 4, 2 * number : 2 * number + 4] += part
    return whole


def _rigid(stiffness: Floats, share: Floats, y: Floats) -> Beam:
    """Let the points hold the beam: only the slopes within are unknown."""
    free = np.arange(3, len(stiffness) - 1, 2)
    slopes = np.zeros_like(y)
    if len(free):
        slopes[1:-1] = np.linalg.solve(stiffness[np.ix_(free, free)], -stiffness[free, ::2] @ y)
    return Beam(share, y, slopes)


def _sprung(stiffness: Floats, share: Floats, y: Floats) -> Beam:
    """Let springs of stiffness 1 draw the beam to the points within, and both ends be clamped."""
    free, springs = slice(2, -2), np.zeros(len(stiffness))
    springs[2:-2:2] = 1.0
    clamped = np.zeros_like(springs)
    clamped[[0, -2]] = y[[0, -1]]
    load = springs * np.repeat(y, 2) - stiffness @ clamped
    clamped[free] = np.linalg.solve((stiffness + np.diag(springs))[free, free], load[free]) if len(y) > 2 else ()
    return Beam(share, clamped[::2], clamped[1::2])
