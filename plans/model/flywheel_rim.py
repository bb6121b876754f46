"""The rim of a flywheel (обод маховика): mass and section of the ring that has its moment of inertia (M4.11).

The ring is thin: its mass is taken at the mean diameter. A section of thickness t adds the share (t/D)^2 to m D^2/4.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from plans.model.dynamics import Rim

THICKEST = 0.5  # of the mean diameter: a thicker ring leaves no room for shaft, hub and spokes


class FlywheelRim(NamedTuple):
    """A rim: its moment of inertia kg*m2 on its own shaft, mean diameter m, density kg/m3, breadth over thickness."""

    inertia: float
    diameter: float
    density: float
    shape: float

    @property
    def mass(self) -> float:
        """The mass of the rim, kg.

        >>> round(FlywheelRim(11.8, 0.9, 7200.0, 1.5).mass, 8)
        58.27160494
        """
        return 4 * self.inertia / self.diameter**2

    @property
    def thickness(self) -> float:
        """The radial thickness of its section, m (толщина обода)."""
        return math.sqrt(self.mass / (self.density * math.pi * self.diameter * self.shape))

    @property
    def breadth(self) -> float:
        """The axial breadth of its section, m (ширина обода)."""
        return self.shape * self.thickness

    @property
    def added(self) -> float:
        """The share of the inertia that the thickness of the section adds: a ring of t has m (D^2 + t^2)/4."""
        return (self.thickness / self.diameter) ** 2

    @property
    def fits(self) -> bool:
        """Whether a wheel can have it: a ring so thick that no shaft goes through it is none."""
        return self.thickness <= THICKEST * self.diameter

    @property
    def least_diameter(self) -> float:
        """The least mean diameter m at which the rim fits."""
        return float((4 * self.inertia / (self.density * math.pi * self.shape * THICKEST**2)) ** 0.2)

    def at_speed(self, omega: float) -> float:
        """Give the speed of the mean circle, m/s, of a shaft that turns at rad/s."""
        return abs(omega) * self.diameter / 2


def rim_of(inertia: float, rim: Rim) -> FlywheelRim | None:
    """Give the rim of a flywheel's inertia kg*m2 at the crank; None where no diameter or no flywheel is asked for."""
    if rim.diameter is None or not inertia > 0:
        return None
    return FlywheelRim(inertia / rim.ratio**2, rim.diameter, rim.density, rim.breadth)
