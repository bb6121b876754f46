"""Where many half-planes leave room: the nearest place, and places on a circle, by position (полуплоскости)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from plans.model.cam_motion import Points
from plans.model.motion import Floats

ROUNDS = 200  # each takes one more line into account, of some hundreds
SLACK = 1e-12  # of the size of the lines: seeds of Newton's method need no more


def _beyond(at: complex | Points, normals: Points, bounds: Floats) -> Floats:
    return np.asarray((normals.conj() * at).real - bounds)


def nearest(to: complex, normals: Points, bounds: Floats) -> tuple[complex, list[int]] | None:
    """Give the place nearest to a point within half-planes, and the lines that it lies on; None: there is no room."""
    slack, known, own, at = SLACK * float(np.abs(bounds).max() + abs(to)), list[int](), list[int](), to
    for _ in range(ROUNDS):
        beyond = _beyond(at, normals, bounds)
        worst = int(np.argmax(beyond))
        if beyond[worst] <= slack:
            return at, own
        places = _with(to, worst, known, normals, bounds)
        known.append(worst)
        within = [one for one in places if (_beyond(one[0], normals[known], bounds[known]) <= slack).all()]
        if not within:
            return None
        at, own = min(within, key=lambda one: abs(one[0] - to))
    return None


def _with(
    to: complex, own: int, others: Sequence[int], normals: Points, bounds: Floats
) -> list[tuple[complex, list[int]]]:
    """Give the places on one line: the foot from a point, the meetings with others."""
    n, b = complex(normals[own]), float(bounds[own])
    foot = to - ((n.conjugate() * to).real - b) * n / abs(n) ** 2
    found = [(foot, [own])]
    for other in others:
        m, c = complex(normals[other]), float(bounds[other])
        turn = (n.conjugate() * m).imag
        if turn:
            found.append((1j * (c * n - b * m) / turn, [own, other]))
    return found


def on_circle(radius: float, normals: Points, bounds: Floats) -> tuple[Points, list[int]]:
    """Give the ends of the arcs of a circle that half-planes leave, and the line that each lies on."""
    size = np.abs(normals)
    cut = np.flatnonzero(np.abs(bounds) <= radius * size)
    half = np.arccos(bounds[cut] / (radius * size[cut]))
    turned: Points = np.exp(1j * np.concatenate([half, -half]))
    places = np.asarray(radius * np.tile(normals[cut] / size[cut], 2) * turned, dtype=np.complex128)
    beyond = _beyond(places[:, None], normals, bounds)
    kept = np.flatnonzero((beyond <= SLACK * radius * size).all(axis=1))
    return places[kept], np.tile(cut, 2)[kept].tolist()
