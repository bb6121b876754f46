"""The speed of a crank by how long the working stroke takes, the overlap read off the drawing (скорость кривошипа)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace

from plans.model.synthesis.pace import Pace
from plans.synthesis.drawn import DrawnDesign, DrawnReading


def paced(reading: DrawnReading, pace: Pace) -> DrawnReading:
    """Tell of each mechanism how fast its crank turns, and how fast the stroke goes."""
    return reading._replace(found=tuple(_timed(one, pace) for one in reading.found))


def _timed(made: DrawnDesign, pace: Pace) -> DrawnDesign:
    speeds = dict(_speeds(made.design.sizes, pace)) if "H" in made.design.sizes else {}
    return made._replace(design=replace(made.design, sizes={**made.design.sizes, **speeds}))


def _speeds(sizes: Mapping[str, float], pace: Pace) -> Iterator[tuple[str, float]]:
    """Give the crank's speed rad/s and the mean speed m/s of the working stroke, over which it turns by π + θ."""
    turned = math.pi + sizes.get("θ", 0.0)
    if pace.output is not None:
        omega = math.tau * pace.output
    elif pace.speed is not None:
        omega = pace.speed * turned / sizes["H"]
    else:
        return
    yield from (("ω_1", omega), ("v", sizes["H"] * omega / turned))
