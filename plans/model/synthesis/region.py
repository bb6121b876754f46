"""What a free parameter makes of a mechanism, by whichever road (область свободного параметра)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, NamedTuple

import numpy as np

from plans.model.motion import Floats

POINTS: Final = 180  # of a curve


class Region(NamedTuple):
    """Sizes over the angle rad, at the centre of its circle, from B2 to O: as far as some mechanism is, and on."""

    places: Floats
    curves: Mapping[str, Floats]
    end: float  # beyond it there is no mechanism
    whole: float  # the angle of the arc's middle: beyond it all is mirrored
    best: tuple[float, float]  # where the first of the curves has its best value, and that value
    chosen: float  # where O is


def stations(end: float) -> Floats:
    """Give angles between B2 and an end of the arc, at whose ends links vanish."""
    return (np.arange(POINTS) + 0.5) * end / POINTS
