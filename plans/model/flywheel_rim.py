"""The flywheel as a rim on spokes that weigh nothing: mass and section (обод маховика; M4.11)."""

from __future__ import annotations

from typing import NamedTuple

THICKEST = 0.5  # of the mean diameter: a thicker rim leaves no room for shaft, hub and spokes


class Wheel(NamedTuple):
    """A flywheel's rim on its own shaft: inertia kg*m2, mean diameter m, mass kg, section's thickness and breadth m."""

    inertia: float
    diameter: float
    mass: float
    thickness: float  # along the radius
    breadth: float  # along the shaft

    @property
    def outer(self) -> float:
        """Its outer diameter, m."""
        return self.diameter + self.thickness

    @property
    def inner(self) -> float:
        """Its inner diameter, m; not above zero where no rim of this mean diameter is heavy enough."""
        return self.diameter - self.thickness

    @property
    def added(self) -> float:
        """The share of the inertia that the thickness adds: a ring of thickness t has m (D^2 + t^2)/4."""
        return (self.thickness / self.diameter) ** 2

    @property
    def fits(self) -> bool:
        """Whether a wheel can have it: a ring so thick that no shaft goes through it is none."""
        return self.thickness <= THICKEST * self.diameter

    @property
    def least_diameter(self) -> float:
        """The least mean diameter m of a rim of this inertia, material and shape that fits: t/D falls as D^(-5/2)."""
        return float(self.diameter * (self.thickness / (THICKEST * self.diameter)) ** 0.4)

    def at_speed(self, omega: float) -> float:
        """Give the speed of the mean circle, m/s, of a shaft that turns at rad/s."""
        return abs(omega) * self.diameter / 2
