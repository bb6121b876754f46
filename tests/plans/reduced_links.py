"""Reduced links known in figures: the slider-crank of methods 4.2 with the planing load of 4.7 (звено приведения)."""

from __future__ import annotations

import cmath
import math
from functools import lru_cache

from plans.model.dynamics import TURN
from plans.model.run import OfTurn, ReducedLink

CRANK, ROD = 0.10, 0.40
ON, OFF = math.radians(23.1632606), math.radians(150.3837539)
TINY = 1e-30  # a complex step: its derivative has no error but rounding


def _rates(q: complex) -> tuple[complex, complex, complex, complex]:
    """Give what the slider, the rod's mass centre (x, y) and the rod move for a radian of the crank."""
    tilt = cmath.asin(-CRANK / ROD * cmath.sin(q))
    turning = -CRANK * cmath.cos(q) / (ROD * cmath.cos(tilt))
    x, y = -CRANK * cmath.sin(q) - 0.15 * cmath.sin(tilt) * turning, CRANK * cmath.cos(q)
    y += 0.15 * cmath.cos(tilt) * turning
    return -CRANK * cmath.sin(q) - ROD * cmath.sin(tilt) * turning, x, y, turning


def crank_inertia(q: complex) -> complex:
    slider, x, y, turning = _rates(q)
    return 0.01 + 3 * 0.04**2 + 4 * (x * x + y * y) + 0.06 * turning * turning + 8 * slider * slider


@lru_cache(maxsize=8)  # a solver asks for inertia and slope of one place, one after the other
def _stepped(q: float) -> complex:
    return crank_inertia(complex(q, TINY))


def planing(force: float) -> OfTurn:
    def moment(q: float) -> float:
        return force * _rates(complex(q))[0].real if ON < q % TURN < OFF else 0.0

    return moment


def slider_crank(constant: float, force: float = 0.0, share: float = 1.0) -> ReducedLink:
    """Give the machine with a constant inertia kg*m2 beside a share of the linkage's own, and a planing force N."""
    return ReducedLink(
        lambda q: constant + share * _stepped(q).real,
        lambda q: share * _stepped(q).imag / TINY,
        planing(force),
        breaks=(ON, OFF) if force else (),
    )


def steady(inertia: float, resistance: float = 0.0, breaks: tuple[float, ...] = ()) -> ReducedLink:
    """Give a link of constant inertia against a constant moment N*m."""
    return ReducedLink(lambda q: inertia, lambda q: 0.0, lambda q: -resistance, breaks=breaks)
