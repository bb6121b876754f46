"""Pairing letters with arrows so that all together stand as close as they can (наименьшая сумма расстояний)."""

from __future__ import annotations

import math
from collections.abc import Sequence


def paired(costs: Sequence[Sequence[float]]) -> list[int]:
    """Give each row the column of its own that makes the sum of costs least; there are no fewer columns than rows.

    Rows are added one by one, each by the shortest path of exchanges with those before it (the Hungarian method).

    >>> paired([[1.0, 2.0, 9.0], [1.0, 5.0, 9.0]])
    [1, 0]
    """
    count = len(costs[0]) if costs else 0
    rows, columns = [0.0] * (len(costs) + 1), [0.0] * (count + 1)
    owner = [0] * (count + 1)  # by columns, from 1 on: the row that has it
    for row in range(1, len(costs) + 1):
        _exchange(costs, row, (rows, columns), owner)
    found = [0] * len(costs)
    for column, row in enumerate(owner[1:]):
        if row:
            found[row - 1] = column
    return found


def _exchange(
    costs: Sequence[Sequence[float]], row: int, prices: tuple[list[float], list[float]], owner: list[int]
) -> None:
    """Give a row its column, and those whose columns it takes others."""
    rows, columns = prices
    least, before = [math.inf] * len(columns), [0] * len(columns)
    used, here = set[int](), 0
    owner[0] = row
    while owner[here]:
        used.add(here)
        one = owner[here]
        free = [k for k in range(1, len(columns)) if k not in used]
        for k in free:
            cost = costs[one - 1][k - 1] - rows[one] - columns[k]
            if cost < least[k]:
                least[k], before[k] = cost, here
        there = min(free, key=lambda k: least[k])
        step = least[there]
        for k in used:
            rows[owner[k]] += step
            columns[k] -= step
        for k in free:
            least[k] -= step
        here = there
    while here:
        owner[here] = owner[before[here]]
        here = before[here]
