"""Numerals of a pen: coordinates with fixed decimals, without needless zeros, never an exponent or -0."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from functools import lru_cache

from drawings.paper.limits import DECIMALS, REACH
from drawings.paper.strokes import SheetError

_ZEROS = re.compile(r"0+(?![\d.!])")


def numbers(template: str, values: Iterable[float], decimals: int = DECIMALS) -> str:
    """Write coordinates into a template of `%s`: fixed decimals without needless zeros, no exponent, no -0.

    >>> numbers("M%s %sL%s %s", (10, -0.0, 1e-7, 100.25))
    'M10 0L0 100.25'
    """
    values = tuple(values)
    if values and not (math.isfinite(sum(values)) and max(values) <= REACH and min(values) >= -REACH):
        raise SheetError(f"no place on paper: {[value for value in values if not abs(value) <= REACH][:2]} mm")
    written = template.replace("%s", f"%.{decimals}f") % values
    return _ZEROS.sub("", written.replace("." + "0" * decimals, "!").replace("-0!", "0!")).replace("!", "")


@lru_cache(maxsize=1024)
def number(value: float) -> str:
    """Write one number.

    >>> number(-0.00001), number(594), number(0.35)
    ('0', '594', '0.35')
    """
    return numbers("%s", (value,))
