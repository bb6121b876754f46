"""The law of a load over its stroke, there and back, as its scene states it (закон нагрузки)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from plans.model.machine import ALWAYS, BACKWARD, FORWARD, IDLE, WORKING, Force, Moment
from plans.model.motion import Floats


class Branch(NamedTuple):
    """A load on the way there or back: its bounds and corners by shares of the stroke, rising, and what it is there."""

    back: bool
    shares: Floats
    sizes: Floats


def branches(load: Force | Moment) -> Iterator[Branch]:
    """Give the load over its stroke there, and over that back; it may rest on one of them."""
    law = load.diagram if isinstance(load, Force) else None
    begin, end = load.overrun[0], 1 - load.overrun[1]
    shares = np.array(sorted({begin, end, *(share for share in (law.travel if law else ()) if begin < share < end)}))
    turns = load.against if isinstance(load, Moment) else load.resists or (load.direction is None and load.line is None)
    for during, sense in (((WORKING, FORWARD), 1.0), ((IDLE, BACKWARD), -1.0 if turns else 1.0)):
        if load.during in (ALWAYS, *during):
            back = IDLE in during
            sizes = (law.back or law.sizes if back else law.sizes) if law else ()
            found = np.interp(shares, law.travel, sizes) if law else np.ones(len(shares))
            yield Branch(back, shares, sense * load.size * found)
