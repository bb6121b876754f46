"""Of very many positions the graphs of a balance tell every so many, and the shown one (выбор положений)."""

from __future__ import annotations

import math

from drawings.paper.limits import MANY

ROOMY = 3 * MANY  # positions that all have room


def told(count: int, shown: int) -> tuple[int, ...]:
    """Choose the positions that are told.

    >>> told(12, 2) == tuple(range(12)), told(72, 1)[:4]
    (True, (0, 1, 6, 12))
    """
    every = 1 if count <= ROOMY else math.ceil(count / MANY)
    return tuple(k for k in range(count) if k % every == 0 or k == shown)
