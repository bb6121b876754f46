"""The units of a follower's travel and of its derivatives by the cam's turn or travel (размерности движения)."""

from __future__ import annotations

from plans.model.cam import Cam

RATIO = "1"  # the unit of what has none
UNITS = {  # whether the follower rocks and whether the cam translates
    (False, False): ("m", "m/rad", "m/rad2"),
    (False, True): ("m", RATIO, "1/m"),
    (True, False): ("rad", RATIO, "1/rad"),
    (True, True): ("rad", "rad/m", "rad/m2"),
}


def dimensions(cam: Cam) -> tuple[str, str, str]:
    """Give the units of S, S' and S''."""
    return UNITS[cam.rocks, cam.translates]
