"""Tasks of a rocker that drives a slider (коромыслово-ползунный механизм), SI: m, rad."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final, NamedTuple

from plans.model.synthesis.pace import told


class RockerSliderTask(NamedTuple):
    """A rocker-slider is wanted: its stroke m, and of pressure angle rad and ratio rocker/rod what is asked.

    With the rocker's angles rad to the guide at both ends of the stroke it is axial. Without them its pressure angle
    is the same, to either side, at the middle of the stroke and at its ends, the rocker square to the guide between.
    """

    stroke: float
    pressure: float | None = None
    ratio: float | None = None
    angles: tuple[float, float] | None = None

    @property
    def asked(self) -> Mapping[str, float]:
        """The demands by the letters of their sizes."""
        first, second = self.angles or (None, None)
        return told(H=self.stroke, α_max=self.pressure, λ=self.ratio, ψ_1=first, ψ_2=second)

    @property
    def readings(self) -> tuple[RockerSliderTask, ...]:
        """The tasks that it may mean: with angles one of ratio and pressure angle fixes the mechanism."""
        if self.angles is None or self.pressure is None or self.ratio is None:
            return (self,)
        return self._replace(pressure=None), self._replace(ratio=None)

    @property
    def kept(self) -> tuple[str, ...]:
        """The demands beside the stroke and the angles, by their names."""
        return tuple(name for name in ("ratio", "pressure") if getattr(self, name) is not None)

    @property
    def steepest(self) -> float:
        """The angle rad within the stroke at which the rocker's end is farthest from the guide."""
        assert self.angles is not None  # asked of an axial one
        return min(max(math.pi / 2, min(self.angles)), max(self.angles))


STILL: Final = 1e-9  # of the rocker: a slider that goes no farther, or no farther a radian, stands
