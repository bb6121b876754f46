"""Derivatives by the crank angle: central differences of order 4, with what they may be off."""

from __future__ import annotations

import numpy as np

from plans.model.motion import Complexes, Floats

STEP = 2.0**-9  # rad: the difference's remainder and the rounding over the step are both far below a wrong formula
REACH = STEP * np.array([-4, -2, -1, 0, 1, 2, 4])


def derivative(values: Floats | Complexes, margin: float) -> tuple[complex, float]:
    """Differentiate by the crank angle; what halving the step changes, and the rounding over it, bound the error."""
    wide, close = (
        (8 * (values[5] - values[1]) - (values[6] - values[0])) / (24 * STEP),
        (8 * (values[4] - values[2]) - (values[5] - values[1])) / (12 * STEP),
    )
    return complex(close), abs(wide - close) + 2 * margin / STEP
