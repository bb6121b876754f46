"""What is nothing on a sheet of balancing: less than rounding makes of the machine's largest force (ноль)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from plans.model.balance.linkage import State
from plans.model.motion import NOTHING


class Nothing(NamedTuple):
    """The force N, the moment N*m about the shaft and the way m that are no more than rounding."""

    force: float
    moment: float
    way: float


def nothing(states: Iterable[State], size: float) -> Nothing:
    """Tell what is nothing in all states of a mechanism of some size, m: by its largest forces in any of them."""
    largest = max(one.forces.largest for one in states)
    return Nothing(NOTHING * largest, NOTHING * largest * size, NOTHING * size)
