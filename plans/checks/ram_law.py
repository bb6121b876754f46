"""A cylinder's law against the motion by analysis: the distance of its two points, and its rates (закон хода)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from geometry.meet import EPS
from plans.checks.comparison import Finding
from plans.linkage.primaries.between import apart
from plans.linkage.primaries.ram import lever, triangle
from plans.linkage.study import LinkageStudy
from plans.model.mechanism import Mechanism, Ram
from plans.model.motion import Floats, Motion
from plans.model.order import ORDERS
from plans.model.rates import stroke_rates

SYMBOLS = ("s", "v", "a")
ROUNDINGS = 16.0  # of a distance by two places, each of a few roundings itself


def law(study: LinkageStudy, solved: Motion, kappa: Floats, order: int) -> Iterator[Finding]:
    """Hold the law of the cylinder that drives against the distance of its points, and what that grows by."""
    ram, told = study.mechanism.drive.ram, stroke_of(study.mechanism, len(solved.phi))
    assert ram is not None  # asked only where there is one
    rows = [apart(study.mechanism, solved, k) for k in range(order + 1)]
    length = np.abs(rows[0])
    along = np.conj(rows[0] / length)
    found = [length]
    found += [(along * rows[1]).real] if order > 0 else []
    found += [(along * rows[2]).real + (along * rows[1]).imag ** 2 / length] if order > 1 else []
    # The crank's angle is known to a rounding of the length over the share of its turning that goes along the cylinder.
    arm = _arm(study, ram)
    blunt = np.maximum(arm, length) / lever(study.mechanism, solved)
    for k, row in enumerate(found):
        due = np.where(np.isnan(row), np.nan, told[k])
        fastest = float(np.abs(told[1]).max()) ** k / arm ** (k - 1)
        largest = max(float(np.nanmax(np.abs(due), initial=0.0)), fastest)
        allowed = ROUNDINGS * EPS * (kappa * blunt) ** (k + 1) * largest
        name = f"{SYMBOLS[k]}_{ram.foot}{ram.point}"
        yield Finding(ORDERS[k].plan, name, ORDERS[k].point.unit, due, row, np.abs(due - row), allowed, largest)


def stroke_of(mechanism: Mechanism, count: int) -> tuple[Floats, Floats, Floats]:
    """Give what a scene says of its cylinder at so many even places of the stroke: length m, m/s, m/s2, (N,) each."""
    ram = mechanism.drive.ram
    assert ram is not None  # asked only where there is one
    lengths = np.linspace(ram.begin, ram.end, count)
    return lengths, *stroke_rates(mechanism.drive, lengths, ram.speed, ram.acceleration)


def _arm(study: LinkageStudy, ram: Ram) -> float:
    """Give the crank's arm m that a cylinder turns by; between two links none is nearer to that than its length."""
    return abs(triangle(study.mechanism).own) if ram.links is None else min(ram.begin, ram.end)
