"""How far numbers of a balance may be off by which both roads differ by rounding alone (допуски чисел баланса)."""

from __future__ import annotations

import numpy as np

from drawings.checks.balance.balance_expected import Expected
from drawings.checks.precise import KNOWN
from plans.balance.study import CENTRE, COSTS
from plans.model.motion import Floats

FINE = 1e-6  # of a number: near a change point of the links rounding may reach all, but not so much of what is largest


def of_largest(expected: Expected, name: str, value: float) -> float:
    """Give how far the largest of a quantity over the turn may be off.

    Where it is largest by analysis it is off as much as there; elsewhere it may come out larger by what is more.
    """
    for one in (one for one in expected.comparison.of(COSTS) if one.name == name):
        sizes, allowed = np.abs(one.analysis), np.where(np.isfinite(one.allowed), one.allowed, 0.0)
        above = float(np.nanmax(sizes + allowed)) - float(np.nanmax(sizes))
        here = float(allowed[int(np.nanargmax(sizes))])
        return min(2 * max(above, here), FINE * value) + KNOWN * value
    return KNOWN * value


def in_positions(expected: Expected, name: str) -> Floats:
    """Give how far a quantity may be off in each position of the scene; where it has no bound it is infinite."""
    (row,) = [one.allowed for one in expected.comparison.of(CENTRE) if one.name == name]
    told = np.broadcast_to(row, len(expected.balance.before.centre.phi))
    return np.where(np.isnan(told), np.inf, 2 * told)
