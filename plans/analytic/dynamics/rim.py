"""Mass and section of a flywheel's rim by its moment of inertia (масса и размеры обода; M4.11)."""

from __future__ import annotations

from math import pi, sqrt

from plans.model.dynamics import Rim
from plans.model.flywheel_rim import Wheel


def wheel(inertia: float, rim: Rim) -> Wheel | None:
    """Size a flywheel of an inertia kg*m2 at the crank's shaft on its own; None without a diameter, or of none.

    On a shaft that turns U times faster J/U^2 stores as much energy; all the mass m = 4 J / D^2 is at the diameter D,
    and its volume is pi D times the section, whose breadth is so many times its thickness.
    """
    if rim.diameter is None or inertia <= 0.0:
        return None
    own = inertia / rim.ratio**2
    mass = 4.0 * own / rim.diameter**2
    section = mass / (rim.density * pi * rim.diameter)
    thickness = sqrt(section / rim.breadth)
    return Wheel(own, rim.diameter, mass, thickness, rim.breadth * thickness)
