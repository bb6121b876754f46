"""What a sheet says once of its two roads: how far apart they are, and what a hand makes of it (сходимость)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from drawings.page.drafting import Drafting
from plans.checks.comparison import Finding
from plans.checks.hand.quantity import SLIP

NOISE = 11  # powers of ten: a smaller share of the largest is rounding, which differs from machine to machine


def agreed(findings: Sequence[Finding], drafting: Drafting, by_hand: bool = True) -> Iterator[str]:
    """Say how far construction and analysis are apart, and what the column of the hand tells; nothing of nothing."""
    if findings:
        yield drafting.word("accord of roads", share=share(findings))
        if by_hand:
            yield drafting.word("polygon hand note", slip=drafting.number(SLIP))


def share(findings: Sequence[Finding]) -> str:
    """Write the least power of ten of the largest values that no difference is beyond."""
    shares = [_apart(one) for one in findings if one.largest > 0]
    power = max(math.ceil(math.log10(max(shares, default=0.0) or math.ulp(0.0))), -NOISE)
    return f"10^{{−{-power}}}" if power else "1"


def _apart(one: Finding) -> float:
    """Give the worst difference as a share of the largest value, or of its own where a jam makes that larger."""
    sizes = np.fmax(np.abs(one.construction), one.largest)
    return float(np.nanmax(one.difference / sizes, initial=0.0))
