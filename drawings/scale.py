"""Standard scales: the textbook's scale factors mu, true units per millimetre (масштабные коэффициенты)."""

from __future__ import annotations

import math
from typing import NamedTuple

from drawings.strokes import SheetError
from drawings.words import number, word

MANTISSAS = (1.0, 2.0, 2.5, 4.0, 5.0)
# GOST 2.302-68: reductions 1:b and enlargements a:1, as mu in m/mm.
REDUCTIONS = (1, 2, 2.5, 4, 5, 10, 15, 20, 25, 40, 50, 75, 100, 200, 400, 500, 800, 1000)
ENLARGEMENTS = (2, 2.5, 4, 5, 10, 20, 40, 50, 100)


class Scale(NamedTuple):
    """A scale factor: `mu` true units per millimetre, of a letter such as l, v or a, in a unit such as m/s."""

    mu: float
    letter: str
    unit: str

    def written(self, language: str) -> str:
        """Write the scale as the textbook does: μ_v = 0.02 (m/s)/mm."""
        unit, mm = word(language, self.unit), word(language, "mm")
        true = f"({unit})" if "/" in unit else unit
        ratio = f" ({self.ratio(language)})" if self.letter == "l" else ""
        return f"μ_{self.letter} = {number(self.mu, language)} {true}/{mm}{ratio}"

    def ratio(self, language: str) -> str:
        """Write a scale of lengths as a ratio such as 1:2.5."""
        reduction = self.mu * 1000
        if reduction >= 1:
            return f"1:{number(reduction, language)}"
        return f"{number(1 / reduction, language)}:1"


def fitting(extent: float, room: float, letter: str, unit: str) -> Scale:
    """Choose the largest standard picture of an extent (true units) that fits into some room (mm).

    >>> fitting(0.7, 380.0, "l", "m").mu, fitting(12.0, 150.0, "a", "m/s2").mu
    (0.002, 0.1)
    """
    if room <= 0:
        raise SheetError(f"no room is left for a figure of scale mu_{letter}")
    if extent <= 0 or not math.isfinite(extent):
        return Scale(1.0 if letter != "l" else 0.001, letter, unit)
    least = extent / room * (1 - 1e-12)  # a picture that fits exactly is not lost to a rounding
    lengths = [0.001 / a for a in reversed(ENLARGEMENTS)] + [b / 1000 for b in REDUCTIONS]
    if letter == "l" and lengths[0] / 2 < least <= lengths[-1]:
        return Scale(next(mu for mu in lengths if mu >= least), letter, unit)
    # Beyond the table lengths are enlarged (100 n):1, as the standard allows: no 250:1, so no mantissa 4.
    mantissas = [m for m in MANTISSAS if letter != "l" or m != 4.0]
    power = math.floor(math.log10(least))
    mu = next(m * 10.0**p for p in (power, power + 1) for m in mantissas if m * 10.0**p >= least)
    return Scale(float(f"{mu:.12g}"), letter, unit)
