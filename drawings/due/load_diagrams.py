"""What load diagrams must show, by the laws of the loads alone: corners, the stroke, overruns (диаграммы нагрузок)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from drawings.checks.expected import Expected
from drawings.paper.statement import Kind
from plans.forces.stroke import Stroke, asks
from plans.model.machine import Machine, Track
from string import ascii_lowercase


def load_diagrams(machine: Machine, strokes: Mapping[Track, Stroke]) -> Iterator[Expected]:
    """Give the load diagrams of the loads that change over a stroke."""
    for load in (one for one in machine.loads if asks(one)):
        plan, stroke = f"load_diagram-{load.name}", strokes[load.stroke]
        length = abs(stroke.reach[1] - stroke.reach[0])
        length, whole = (length, "H") if stroke.sliding else (math.degrees(length), "ψ")
        yield Expected(Kind.VECTOR, plan, whole, length, 1e-9 * length)
