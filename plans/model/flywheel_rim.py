"""The flywheel as a rim on spokes that weigh nothing: mass and section (обод маховика)."""

from __future__ import annotations

from typing import NamedTuple


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
