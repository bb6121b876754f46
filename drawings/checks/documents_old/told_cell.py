"""A cell of a table read back: its value, with the decimals or the digits that it must have (ячейка таблицы)."""

from __future__ import annotations

import math
import re
from typing import NamedTuple

from drawings.checks import reading
from drawings.checks.precise import KNOWN
from drawings.checks.reading import reads


class Cell(NamedTuple):
    """What a cell must say: its value, its decimals or else its digits; of an angle whole turns are left aside."""

    true: float
    places: int = 0
    digits: int = 0
    turns: bool = False

    def holds(self, text: str) -> bool:
        """Tell whether a text says it."""
        if math.isinf(self.true):
            return text == "∞"
        value = reading.value(text)
        if value is None or (self.places and len(re.split("[.,]", text)[-1]) != self.places):
            return False
        whole = 360.0 * round((value - self.true) / 360.0) if self.turns else 0.0
        return reads(text, self.true + whole, KNOWN * max(abs(self.true), 1.0), self.digits)
