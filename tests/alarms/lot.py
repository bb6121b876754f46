"""The lot (жребий) by which sizes of a scene are drawn: within a usual range, near an end of it, or exact."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import exp, log
from random import Random
from typing import TypeVar

Any = TypeVar("Any")

ORDINARY, EXTREME, EXACT = "ordinary", "extreme", "exact"
CYCLE = (ORDINARY, ORDINARY, EXTREME, ORDINARY, ORDINARY, EXACT, ORDINARY, EXTREME, ORDINARY, ORDINARY)
EDGE = 0.03  # of a range: so near its end are sizes of an extreme scene
SHARE = 0.5  # of the sizes of an extreme scene lie there
CHOSEN = 0.7  # of the sizes of an exact scene are those that it names; the others are round numbers
WIDE = 6  # times its beginning: the end of a range in which each decade has the same share
DIGITS = 3


class Lot:
    """Draws one scene: the same for ever by its key and kind."""

    def __init__(self, key: str, kind: str = ORDINARY) -> None:
        self.chance, self.kind = Random(key), kind

    def size(self, low: float, high: float, *exact: float) -> float:
        """Draw a size of a range; an exact scene takes one of those that are named, or a round number."""
        if self.kind == EXACT and exact and self.on(CHOSEN):
            return self.any(*exact)
        share = self.chance.random()
        if self.kind == EXTREME and self.on(SHARE):
            share = share * EDGE if self.on(0.5) else 1 - share * EDGE
        found = exp(log(low) + share * log(high / low)) if 0 < low * WIDE < high else low + share * (high - low)
        rounded = float(f"{found:.{1 if self.kind == EXACT else DIGITS}g}")
        return min(max(rounded, low), high)

    def whole(self, low: int, high: int) -> int:
        """Draw a whole number of a range, its ends among them."""
        return self.any(low, high) if self.kind == EXTREME else self.chance.randint(low, high)

    def any(self, *choices: Any) -> Any:
        """Draw one of several."""
        return self.chance.choice(choices)

    def on(self, share: float) -> bool:
        """Draw whether something is so, which in that share of the scenes it is."""
        return self.chance.random() < share

    def some(self, share: float, *lines: str) -> Sequence[str]:
        """Give lines in that share of the scenes, else none."""
        return lines if self.on(share) else ()


def rows(*lines: str | Iterable[str]) -> str:
    """Join lines, and groups of lines, to a text."""
    return "\n".join(line for group in lines for line in ([group] if isinstance(group, str) else group)) + "\n"


def length(size: float) -> str:
    """Write a length, m, in millimetres to three digits."""
    return f'"{float(f"{1000 * size:.{DIGITS}g}"):g} mm"'


def place(point: complex) -> str:
    """Write a place, m."""
    return f"[{round(point.real, 6) + 0.0:g}, {round(point.imag, 6) + 0.0:g}]"
