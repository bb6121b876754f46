"""How fast the error of a method falls with the number of its strips or pieces (порядок метода)."""

from __future__ import annotations

import math
from collections.abc import Sequence


def order(errors: Sequence[float], counts: Sequence[int]) -> float:
    """Give the order of a method: by which power of the count its error falls from the first to the last.

    >>> order([0.25, 0.0625], [2, 4])
    2.0
    """
    return math.log(errors[0] / errors[-1]) / math.log(counts[-1] / counts[0])
