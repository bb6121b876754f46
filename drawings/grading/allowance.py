"""What is allowed to a vector: how far a fair hand may be out that draws it as the record does (допуск)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from drawings.grading.asked import Asked, PlanAsked
from drawings.paper.limits import QUANTUM
from geometry.board import Mark
from geometry.hand_error import EVEN, SlippingHand, Slopes, slopes
from plans.checks.hand.quantity import SLIP

# Of ten thousand vectors that a fair hand draws one may be refused: a sheet has some forty.
REFUSED = 1e-4
DEVIATIONS = math.sqrt(-2 * math.log(REFUSED))  # of a vector whose ends are spread evenly about the true one


class Allowance(NamedTuple):
    """What a hand may slip by, mm, and the share of the largest vector of a plan that is allowed instead, if any."""

    slip: float = SLIP
    share: float | None = None


EXACT = Allowance(QUANTUM)


class Allowances(NamedTuple):
    """What is allowed to all quantities, and to some by their names or by how their letters begin."""

    by: Allowance = Allowance()
    own: Mapping[str, Allowance] = MappingProxyType({})

    def of(self, plan: PlanAsked, drawn: Mapping[str, float], coarse: float) -> dict[tuple[str, str], float]:
        """Give what each vector of a plan may be out, true units, by its letters."""
        kinds = {by: allowed(plan, drawn, by, coarse) for by in {self.by, *self.own.values()}}
        return {one.letters: kinds[self.to(one.name)][one.letters] for one in plan.vectors}

    def to(self, name: str) -> Allowance:
        """Give what is allowed to a quantity."""
        return self.own.get(name, self.own.get(name.partition("_")[0], self.by))


def allowed(
    plan: PlanAsked, drawn: Mapping[str, float], by: Allowance, coarse: float = QUANTUM
) -> dict[tuple[str, str], float]:
    """Give what each vector of a plan may be out, true units, by its letters; NaN: slips tell nothing of it.

    `drawn` are the scales of the student's plans, true units a mm, by their subjects; `coarse` is how finely his sheet
    is written, mm.
    """
    scales = {**plan.scales, **drawn}
    if by.share is not None:
        most = max((abs(one.true) for one in plan.vectors), default=0.0)
        return {one.letters: by.share * most for one in plan.vectors}
    slip = max(by.slip, coarse)
    hand = SlippingHand(slip, {name: np.array([mu]) for name, mu in scales.items()})
    found = slopes(hand, *(mark for one in plan.vectors if one.found for mark in one.found.span))
    own = EVEN * slip * scales[plan.plan] * np.array([1, 1j, 1, 1j])[:, None]  # of both ends of the arrow itself
    return {one.letters: DEVIATIONS * _deviation(np.concatenate([_moved(one, found), own])) for one in plan.vectors}


def _moved(one: Asked, found: Mapping[Mark, Slopes]) -> Slopes:
    if one.found is None:
        return np.zeros((0, 1), dtype=np.complex128)
    start, end = one.found.span
    return np.asarray(found[end] - found[start])


def _deviation(moved: Slopes) -> float:
    """Give the standard deviation along the line on which slips spread an end most."""
    total, lean = (np.abs(moved) ** 2).sum(), abs((moved**2).sum())
    return float(np.sqrt((total + lean) / 2))
