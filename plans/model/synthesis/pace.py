"""How fast a slider is to work: its mean speed, and how many working strokes it makes a second (средняя скорость)."""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from plans.model.synthesis.design import EPS


def told(**demands: float | None) -> dict[str, float]:
    """Give the demands that a task has, by their letters."""
    return {name: one for name, one in demands.items() if one is not None}


ROUNDED: Final = 4 * EPS  # what three roundings may leave of no overlap


class Pace(NamedTuple):
    """What is asked of a stroke in time: mean speed m/s of the working stroke, output 1/s (производительность)."""

    speed: float | None = None
    output: float | None = None

    @property
    def asked(self) -> dict[str, float]:
        """The demands by the letters of the speeds that they are."""
        return told(v=self.speed, ω_1=None if self.output is None else math.tau * self.output)

    @property
    def both(self) -> bool:
        """Whether the two, with a stroke, tell the overlap."""
        return self.speed is not None and self.output is not None

    def overlap(self, stroke: float) -> float:
        """Give the overlap angle rad: the part φ* of the period T = 1/n that the working stroke takes is H n / v.

        >>> round(math.degrees(Pace(0.3, 0.75).overlap(0.24)), 9)
        36.0
        """
        assert self.speed is not None and self.output is not None  # asked before
        over = stroke * self.output / self.speed - 0.5
        return math.tau * over if abs(over) > ROUNDED else 0.0


IDLE = Pace()
