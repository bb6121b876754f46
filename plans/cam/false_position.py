"""Roots by the rule of false position with a standing end that is halved (правило ложного положения, Illinois)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np

from plans.model.motion import Floats

CLOSINGS: Final = 60  # a false position whose standing end is halved needs about ten
SETTLED: Final = 1e-12  # of what was begun with: the next step would be a rounding, as fast as they shrink


def closed_in(value: Callable[[Floats], Floats], near: Floats, far: Floats, first: Floats, last: Floats) -> Floats:
    """Close in on changes of sign between two places each, whose values are known: false position, a half each time.

    >>> closed_in(lambda x: x**2 - 2, np.array([1.0]), np.array([2.0]), np.array([-1.0]), np.array([2.0])).round(9)
    array([1.41421356])
    """
    near, far, first, last = near.copy(), far.copy(), first.copy(), last.copy()
    wide = np.abs(far - near)
    for _ in range(CLOSINGS if len(near) else 0):
        guess = np.where(first == last, near, far - last * (far - near) / np.where(first == last, 1.0, last - first))
        found = value(guess)
        turns = found * last < 0
        near, first = np.where(turns, far, near), np.where(turns, last, first / 2)
        still = np.all((found == 0) | (np.abs(guess - far) <= SETTLED * wide))
        far, last = guess, found
        if still:
            break
    return far
