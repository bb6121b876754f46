"""The unit vector at an angle in degrees, quarter turns exact (направление)."""

from __future__ import annotations

import cmath
import math
from fractions import Fraction

QUARTERS = (1 + 0j, 1j, -1 + 0j, -1j)


def heading(angle: Fraction) -> complex:
    """Give the direction at an angle; taken from the nearest quarter turn it loses no digit.

    >>> heading(Fraction(90)), heading(Fraction(540))
    (1j, (-1+0j))
    """
    quarter = round(angle / 90)
    rest = float(angle - 90 * quarter)
    return QUARTERS[quarter % 4] * cmath.rect(1.0, math.radians(rest)) if rest else QUARTERS[quarter % 4]
