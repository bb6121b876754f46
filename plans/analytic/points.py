"""Points given by their places in a link's own frame: where they are, and how they move (точки звеньев)."""

from __future__ import annotations

import numpy as np

from plans.analytic.constraints import TURN, Constraints
from plans.model.mechanism import Mechanism
from plans.model.motion import Complexes, Floats, Motion


def place(constraints: Constraints, poses: Floats, link: int, own: complex) -> Complexes:
    """Place a point of a link, m from the datum, at poses (..., links, 3)."""
    x, y, turn = np.moveaxis(poses[..., constraints.numbers.index(link), :], -1, 0)
    return np.asarray(constraints.size * (x + 1j * y) + own * np.exp(1j * turn))


def speed(constraints: Constraints, poses: Floats, rates: Floats, link: int, own: complex) -> Complexes:
    """Give its velocity at rates (..., links, 3) of the poses."""
    on = constraints.numbers.index(link)
    arm, (x, y, spin) = own * np.exp(1j * poses[..., on, TURN]), np.moveaxis(rates[..., on, :], -1, 0)
    return np.asarray(constraints.size * (x + 1j * y) + 1j * spin * arm)


def acceleration(mechanism: Mechanism, motion: Motion, link: int, own: complex) -> Complexes:
    """Carry the acceleration m/s2 of the link's first point to another of its points."""
    point, first = next(iter(mechanism.links[link].points.items()))
    turn, omega, epsilon = motion.links[link]
    return np.asarray(motion.points[point].a + (1j * epsilon - omega**2) * (own - first) * np.exp(1j * turn))
