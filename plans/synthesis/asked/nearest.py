"""The nearest demand that can be met, found by trial (ближайшее выполнимое условие)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

STEPS, TIMES = 400, 20.0  # tried times of a length, from a twentieth to twenty
CLOSER: Final = 30  # halvings of the way to the nearest


def nearest(meets: Callable[[float], bool]) -> float | None:
    """Give the number nearest to 1, as times go, that meets a demand which 1 does not; None where none tried does.

    >>> round(nearest(lambda times: times > 1.5), 4)
    1.5
    """
    for k in range(1, STEPS + 1):
        for sense in (1, -1):
            if meets(found := TIMES ** (sense * k / STEPS)):
                return _closer(meets, TIMES ** (sense * (k - 1) / STEPS), found)
    return None


def _closer(meets: Callable[[float], bool], failing: float, found: float) -> float:
    for _ in range(CLOSER):
        middle = (failing + found) / 2
        failing, found = (failing, middle) if meets(middle) else (middle, found)
    return found
