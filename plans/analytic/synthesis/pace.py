"""The speed of a crank from the part of its turn that the working stroke takes (коэффициент производительности φ*)."""

from __future__ import annotations

import math
from dataclasses import replace

from plans.model.synthesis.design import Design
from plans.model.synthesis.pace import Pace


def paced(made: Design, pace: Pace) -> Design:
    """Tell how fast the crank turns, rad/s, and how fast the working stroke goes, m/s: it takes φ* = (π + θ)/2π."""
    part, stroke = (math.pi + made.sizes.get("θ", 0.0)) / math.tau, made.sizes.get("H")
    if stroke is None or pace == Pace():
        return made
    if pace.output is not None:
        period = 1 / pace.output
    else:
        assert pace.speed is not None  # one of both is told
        period = stroke / (part * pace.speed)
    speeds = {"ω_1": math.tau / period, "v": pace.speed or stroke / (part * period)}
    return replace(made, sizes={**made.sizes, **speeds})
