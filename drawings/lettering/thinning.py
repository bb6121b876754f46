"""Which of many numbers along a line or a curve are written: as many as have room (прореживание номеров)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from drawings.paper.ties import tied


def every(least: float, whole: int) -> int:
    """Choose how many positions apart numbers stand: a divisor of the whole turn, if one is not much above the least.

    >>> every(1.4, 24), every(4.1, 24), every(2.0, 23)
    (2, 6, 2)
    """
    first = max(math.ceil(tied(least)), 1)
    return next((step for step in range(first, 2 * first) if whole % step == 0), first)


def numbered(places: Sequence[complex], length: float, apart: float, first: Iterable[int] = ()) -> tuple[int, ...]:
    """Choose which places on a curve of some length, mm, bear their numbers: those named first always.

    Where all have room, that is all; else every so many, and none nearer than `apart` mm to another. A gap has none.

    >>> numbered([0j, 5 + 0j, 10 + 0j, 15 + 0j], 20.0, 4.0), numbered([0j, 5 + 0j, 10 + 0j, 15 + 0j], 20.0, 8.0, (3,))
    ((0, 1, 2, 3), (3, 0))
    """
    free = [k for k, place in enumerate(places) if not math.isnan(abs(place))]
    kept = [k for k in first if k in set(free)]
    step = every(apart * len(places) / length, len(places)) if length and places else 1
    if step == 1:
        return tuple(free)
    for k in free:
        if k % step == 0 and all(tied(abs(places[k] - places[other]) - apart) >= 0 for other in kept):
            kept.append(k)
    return tuple(kept)
