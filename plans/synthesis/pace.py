"""The speed of a crank by how long the working stroke takes, the overlap read off the drawing (скорость кривошипа)."""

from __future__ import annotations

import math

from plans.model.synthesis.pace import Pace


def paced(pace: Pace, stroke: float, overlap: float) -> dict[str, float]:
    """Give the crank's speed rad/s and the mean speed m/s of the working stroke, over which it turns by π + θ."""
    turned = math.pi + overlap
    if pace.output is not None:
        omega = math.tau * pace.output
    elif pace.speed is not None:
        omega = pace.speed * turned / stroke
    else:
        return {}
    return {"ω_1": omega, "v": stroke * omega / turned}
