"""The letters and units of a cam's motion: travel, its derivatives, the turn (обозначения движения толкателя)."""

from __future__ import annotations

from plans.model.cam import Cam

ACCELERATION, VELOCITY, TRAVEL = "acceleration", "velocity", "travel"
RATIO = "1"  # the unit of what has none
UNITS = {  # whether the follower rocks and whether the cam translates
    (False, False): ("m", "m/rad", "m/rad2"),
    (False, True): ("m", RATIO, "1/m"),
    (True, False): ("rad", RATIO, "1/rad"),
    (True, True): ("rad", "rad/m", "rad/m2"),
}


def letters(cam: Cam) -> tuple[str, str]:
    """Give the letter of the follower's travel and that of the cam's turn."""
    return "ψ" if cam.rocks else "S", "x" if cam.translates else "φ"


def units(cam: Cam) -> dict[str, str]:
    """Give the units of the rows: of travel, then once and twice over that of the cam's turn."""
    own = UNITS[cam.rocks, cam.translates]
    return dict(zip((TRAVEL, VELOCITY, ACCELERATION), own, strict=True))
