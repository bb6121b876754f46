"""What a vector may be out as a fair hand draws it, and what a teacher allows instead (допуск)."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from drawings.grading.asked import PlanAsked
from drawings.paper.limits import QUANTUM
from geometry.hand_error import EVEN, SlippingHand, slopes
from plans.quantity import SLIP
from plans.words.words import Message, message

# Of ten thousand vectors that a fair hand draws one may be refused: a sheet has some forty.
REFUSED = 1e-4
DEVIATIONS = math.sqrt(-2 * math.log(REFUSED))  # of a vector whose ends are spread evenly about the true one
MOST = 5.0  # mm: a hand that slips by more draws nothing
_WRITTEN = re.compile(r"(\d+(?:[.,]\d+)?)\s*(mm|мм|%)?")


class Allowance(NamedTuple):
    """What a hand may slip by, mm, and the share of the largest vector of a plan that is allowed instead, if any."""

    slip: float = SLIP
    share: float | None = None

    @property
    def stated(self) -> Message:
        """How it is written.

        >>> Allowance(0.2).stated.worded("ru"), str(Allowance(share=0.02).stated), str(EXACT.stated)
        ('0,2 мм', '2 %', 'exact')
        """
        if self == EXACT:
            return message("grade.allowance.exact")
        if self.share is None:
            return message("grade.allowance.slip", size=f"{self.slip:g}", unit="mm")
        return message("grade.allowance.share", share=f"{100 * self.share:g}")


EXACT = Allowance(QUANTUM)


def allowance(text: str) -> Allowance | None:
    """Read a tolerance; None of what is none.

    >>> allowance("0.5 mm"), allowance("0,5 мм") == allowance("0.5"), allowance("2 %").share, allowance("much")
    (Allowance(slip=0.5, share=None), True, 0.02, None)
    """
    if text.strip() == "exact":
        return EXACT
    match = _WRITTEN.fullmatch(text.strip())
    if match is None:
        return None
    size = float(match[1].replace(",", "."))
    if match[2] == "%":
        return Allowance(share=size / 100) if 0 < size <= 100 else None
    return Allowance(size) if 0 < size <= MOST else None


class Allowances(NamedTuple):
    """What is allowed to all quantities, and to some by their names or by how their letters begin."""

    by: Allowance = Allowance()
    named: Mapping[str, Allowance] = MappingProxyType({})

    def of(self, plan: PlanAsked, drawn: Mapping[str, float], coarse: float) -> dict[tuple[str, str], float]:
        """Give what each vector of a plan may be out, true units, by its letters."""
        kinds = {by: _allowed(plan, drawn, by, coarse) for by in {self.by, *self.named.values()}}
        return {vector.letters: kinds[self.to(vector.name)][vector.letters] for vector in plan.vectors}

    def to(self, name: str) -> Allowance:
        """Give what is allowed to a quantity."""
        return self.named.get(name, self.named.get(name.partition("_")[0], self.by))


def _allowed(plan: PlanAsked, drawn: Mapping[str, float], by: Allowance, coarse: float) -> dict[tuple[str, str], float]:
    """Give what each vector of a plan may be out, true units, by its letters; NaN: slips tell nothing of it.

    `drawn` are the scales of the student's plans, true units a mm, by their subjects; `coarse` is how finely his sheet
    is written, mm.
    """
    if by.share is not None:
        most = max((abs(vector.true) for vector in plan.vectors), default=0.0)
        return {vector.letters: by.share * most for vector in plan.vectors}
    scales, slip = {**plan.scales, **drawn}, max(by.slip, coarse)
    hand = SlippingHand(slip, {name: np.array([mu]) for name, mu in scales.items()})
    found = slopes(hand, *(mark for vector in plan.vectors if vector.found for mark in vector.found.span))
    ends = EVEN * slip * scales[plan.plan] * np.array([1, 1j, 1, 1j])[:, None]  # of the arrow itself
    spans = {vector.letters: () if vector.found is None else (vector.found.span,) for vector in plan.vectors}
    moved = {
        key: np.concatenate([*(found[end] - found[start] for start, end in rows), ends]) for key, rows in spans.items()
    }
    # The standard deviation along the line on which slips spread an end most.
    spread = {key: ((np.abs(by) ** 2).sum() + abs((by**2).sum())) / 2 for key, by in moved.items()}
    return {key: DEVIATIONS * float(np.sqrt(square)) for key, square in spread.items()}
