"""The book's laws of motion by pieces of their acceleration (законы движения толкателя, 5.9.2, figures 5.44-5.46)."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import lru_cache
from itertools import pairwise
from typing import Final

from plans.cam.tables import Push, Shares, shares, table
from plans.model.cam import SHAPE, TABLE, Law

EIGHTH: Final = 1 / 8  # of the phase: a ramp of the trapezoids and of the modified sine
PI = math.pi


def _constant(law: Law) -> Shares:
    """Give constant accelerations: areas alike, so that the speed ends where it began, at none."""
    first, rest = law.first, 1 - law.first
    return shares([Push(first, (1 / first,)), Push(rest, (-1 / rest,))])


def _wave(size: float, rate: float, phase: float = 0.0, length: float = 1.0) -> Push:
    return Push(length, (), size, rate, phase)


def _polynomial(first: tuple[float, ...], second: tuple[float, ...]) -> Shares:
    """Give a law whose acceleration is one polynomial: from the start, and from the middle, where its powers are odd.

    Powers of the whole phase would lose two digits at its end.
    """
    return shares([Push(0.5, first), Push(0.5, second)])


def _trapezoid() -> Shares:
    ramp, flat = Push(EIGHTH, (0.0, 1 / EIGHTH)), 2 * EIGHTH
    down, up = Push(2 * EIGHTH, (1.0, -1 / EIGHTH)), Push(EIGHTH, (-1.0, 1 / EIGHTH))
    return shares([ramp, Push(flat, (1.0,)), down, Push(flat, (-1.0,)), up])


def _modified_trapezoid() -> Shares:
    flat = 2 * EIGHTH
    middle = _wave(1.0, 4 * PI, PI / 2, 2 * EIGHTH)  # a half wave from the greatest to the least
    ramps = _wave(1.0, 4 * PI, 0.0, EIGHTH), _wave(-1.0, 4 * PI, PI / 2, EIGHTH)
    return shares([ramps[0], Push(flat, (1.0,)), middle, Push(flat, (-1.0,)), ramps[1]])


def _modified_sine() -> Shares:
    slow = _wave(1.0, 4 * PI / 3, PI / 2, 6 * EIGHTH)  # from the greatest to the least
    return shares([_wave(1.0, 4 * PI, 0.0, EIGHTH), slow, _wave(-1.0, 4 * PI, PI / 2, EIGHTH)])


def _shape(law: Law) -> Shares:
    """Give a law by the shape of its acceleration, of which the areas cancel and the lift is above 0."""
    parts = ((end - k, a, b - a) for (k, a), (end, b) in pairwise(law.points) if end > k)
    return shares([Push(length, (a, rise / length)) for length, a, rise in parts])


_LAWS: Final[Mapping[str, Callable[[Law], Shares]]] = {
    "constant velocity": lambda _: shares([Push(1.0)], slope=1.0),
    "constant acceleration": _constant,
    "cosine": lambda _: shares([_wave(1.0, PI, PI / 2)]),
    "sine": lambda _: shares([_wave(1.0, 2 * PI)]),
    "3-4-5": lambda _: _polynomial((0.0, 1.0, -3.0, 2.0), (0.0, -0.5, 0.0, 2.0)),  # k(1 - k)(1 - 2k)
    "4-5-6-7": lambda _: _polynomial(  # k2(1 - k)2(1 - 2k)
        (0.0, 0.0, 1.0, -4.0, 5.0, -2.0), (0.0, -0.125, 0.0, 1.0, 0.0, -2.0)
    ),
    "trapezoid": lambda _: _trapezoid(),
    "modified trapezoid": lambda _: _modified_trapezoid(),
    "modified sine": lambda _: _modified_sine(),
    TABLE: table,
    SHAPE: _shape,
}


@lru_cache(maxsize=64)
def law_of(law: Law) -> Shares:
    """Give a law in shares of phase and lift.

    >>> import numpy as np
    >>> round(float(law_of(Law("sine")).at(np.array([0.3]), 0)[0]), 10)
    0.1486346543
    """
    return _LAWS[law.name](law)
