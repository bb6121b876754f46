"""What would mend a pressure angle beyond its limits: R0 with the offset as it is, or other sizes (размеры, 5.9.4)."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from plans.cam.course import Course
from plans.cam.profile.stretches import Stretches
from plans.cam.profile.tip import Tip
from plans.cam.sizes import sizing
from plans.model.cam import NO_SIZES, RETURN, RISE, Cam, interval_of
from plans.model.cam_faults import CamError
from plans.model.cam_motion import Sizes
from plans.model.motion import Floats


def base_needed(stretches: Stretches) -> float | None:
    """Give R0, m, with which the pressure angle keeps to its limits; None of a rocker, a flat face, a cam on a bar.

    Every position asks for S0 >= (S' - e)/tan α - S with both limits α: the lines of the S-S' diagram through O at the
    offset e.
    """
    cam = stretches.course.cam
    intervals = {kind: interval for kind in (RISE, RETURN) if (interval := interval_of(cam, kind)) is not None}
    if cam.rocks or cam.flat or cam.translates or not intervals:
        return None
    asked = [_height(stretches, kind, 1 / math.tan(end)) for kind, interval in intervals.items() for end in interval]
    return math.hypot(max(0.0, *asked), stretches.sizes.offset)


def sizes_advised(cam: Cam) -> Sizes | None:
    """Give the sizes that the limits alone would give; None where there are none, of a flat face, of a cam on a bar."""
    if cam.flat or cam.translates:
        return None
    try:
        return sizing(Course(replace(cam, given=NO_SIZES))).sizes
    except CamError:
        return None


def _height(stretches: Stretches, kind: str, slope: float) -> float:
    """Give the S0 that the positions on a kind of phase ask for, to one side."""
    offset = stretches.sizes.offset

    def height(tip: Tip) -> Floats:
        asked = (tip.travel.slope - offset) * slope - tip.travel.s
        return np.where(on(tip, kind), asked, -np.inf)

    places = stretches.places(lambda tip: tip.travel.bend * slope - tip.travel.slope)
    found = stretches.most(height, places)
    return found.value if found else 0.0


def on(tip: Tip, kind: str) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Tell which turns are on a kind of phase: on a joint by the side that is taken."""
    sides = [tip.within(one) for one in tip.cam.phases if one.kind == kind]
    return np.any(sides, axis=0) if sides else np.zeros(len(tip.turned), dtype=bool)
