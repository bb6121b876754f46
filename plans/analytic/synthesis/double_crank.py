"""A double crank by closed forms: a crank-rocker whose crank is fixed; both of its cranks turn by π ∓ θ (M1.4)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from dataclasses import replace

from plans.analytic.synthesis import rocker
from plans.model.synthesis.design import Design, TaskReading
from plans.model.synthesis.extremes import BEYOND, DoubleCrankTask


def readings(task: DoubleCrankTask) -> Iterator[TaskReading]:
    """Give every double crank of each circle."""
    for side, reading in zip(task.inverted.sides, rocker.readings(task.inverted), strict=True):
        yield TaskReading(("coupler", "swing", "overlap"), tuple(_inverted(one, side) for one in reading.found))


def _inverted(made: Design, side: int) -> Design:
    """Fix the crank: seen from it the frame turns the other way, by less than half a turn over the quick stroke."""
    size, place = made.sizes, made.places
    crank, coupler, pivot = size["l_1"], size["l_2"], place["O"]
    way = (place["A_1"] - pivot) / crank
    turned = -cmath.rect(1.0, size["θ"] if side == BEYOND else -size["θ"])
    lengths = {"l_1": size["l_4"], "l_2": size["l_3"], "l_3": coupler, "l_4": crank}
    kept = {name: one for name, one in size.items() if name[0] in "ψθμ"}
    ratios = {"i_1": 1 + crank / coupler, "i_2": 1 - crank / coupler}  # of both speeds, O, A and B being in line
    places = {**place, "C'": pivot - turned * pivot, "B'": pivot - (coupler - crank) * way}
    return replace(made, sizes={**lengths, **kept, **ratios}, places=places)
