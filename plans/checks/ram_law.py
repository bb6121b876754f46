"""A cylinder's law against the motion by analysis: the distance of its two points, and its rates (закон хода)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from geometry.meet import EPS
from plans.checks.comparison import Finding
from plans.linkage.primaries.ram import lever, triangle
from plans.linkage.study import LinkageStudy
from plans.model.motion import Floats, Motion
from plans.model.order import ORDERS
from plans.model.rates import stroke_rates

SYMBOLS = ("s", "v", "a")
ROUNDINGS = 16.0  # of a distance by two places, each of a few roundings itself


def law(study: LinkageStudy, solved: Motion, kappa: Floats, order: int) -> Iterator[Finding]:
    """Hold the law of the cylinder that drives against the distance of its points, and what that grows by."""
    corner = triangle(study.mechanism)
    ram, count = corner.ram, len(solved.phi)
    lengths = np.linspace(ram.begin, ram.end, count)
    told = (lengths, *stroke_rates(study.mechanism.drive, lengths, ram.speed, ram.acceleration))
    rows = solved.points[ram.point]
    span = rows.r - corner.fixed
    length = np.abs(span)
    along = np.conj(span / length)
    found = [length]
    found += [(along * rows.v).real] if order > 0 else []
    found += [(along * rows.a).real + (along * rows.v).imag ** 2 / length] if order > 1 else []
    # The crank's angle is known to a rounding of the length over the share of its turning that goes along the cylinder.
    blunt = np.maximum(abs(corner.own), length) / lever(study.mechanism, rows.r)
    for k, row in enumerate(found):
        due = np.where(np.isnan(row), np.nan, told[k])
        fastest = float(np.abs(told[1]).max()) ** k / abs(corner.own) ** (k - 1)
        largest = max(float(np.nanmax(np.abs(due), initial=0.0)), fastest)
        allowed = ROUNDINGS * EPS * (kappa * blunt) ** (k + 1) * largest
        name = f"{SYMBOLS[k]}_{ram.fixed}{ram.point}"
        yield Finding(ORDERS[k].plan, name, ORDERS[k].point.unit, due, row, np.abs(due - row), allowed, largest)
