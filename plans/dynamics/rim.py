"""The rim of the flywheel by its section: the area that a ring of the inertia asked for must have (обод маховика)."""

from __future__ import annotations

import math

from plans.model.dynamics import Rim
from plans.model.flywheel_rim import Wheel


def rim_of(inertia: float, rim: Rim) -> Wheel | None:
    """Size the rim of a flywheel of kg*m2 at the crank's shaft; None without a diameter, or without a flywheel.

    The ring is thin: J = rho pi D s (D/2)^2 of a section s, on a shaft that turns u times as fast J/u^2.
    """
    if rim.diameter is None or not inertia > 0:
        return None
    own = inertia / rim.ratio**2
    around = rim.density * math.pi * rim.diameter  # kg for a square metre of the section
    section = own / (around * (rim.diameter / 2) ** 2)
    breadth = math.sqrt(section * rim.breadth)
    return Wheel(own, rim.diameter, around * section, section / breadth, breadth)
