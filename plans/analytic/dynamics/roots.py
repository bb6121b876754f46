"""Zeros of a quantity over the turn, by halving between places where its sign differs (корни)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from plans.model.motion import Floats

HALVINGS = 54  # of a stretch of the turn: its last place

Sided = Callable[[Floats, int], Floats]  # angles turned (N,), and a side of them, to the quantity


def roots(quantity: Sided, looks: Floats) -> Floats:
    """Give the angles rad at which a quantity changes its sign within stretches between looks, where it is smooth."""
    low, high = looks[:-1], looks[1:]
    rising = quantity(high, -1) >= 0.0
    changes = (quantity(low, 1) >= 0.0) != rising
    low, high, rising = low[changes], high[changes], rising[changes]
    for _ in range(HALVINGS if low.size else 0):
        middle = (low + high) / 2.0
        beyond = (quantity(middle, 1) >= 0.0) == rising
        low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
    return np.asarray((low + high) / 2.0)
