"""The quantities of any technique, timed by both roads and judged: nothing here knows which it is (величины)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from plans.bench.trial import Errors, Timing
from plans.quantity import Quantity
from plans.study import Study

CONSTRUCTION, ANALYSIS = "{}: construction", "{}: analysis, compared"
DEFINED = (
    "error: how far the two roads are apart, of each quantity of a technique in shares of the largest of its plan over "
    "all positions; the worst and the median of all, in per cent, and the worst in roundings of float64 (2.2e-16)"
)


def quantities(study: Study, technique: str) -> Sequence[Quantity]:
    """Give the quantities of a technique by both roads."""
    found: Sequence[Quantity] = study.comparison(technique).findings
    return found


def apart(found: Sequence[Quantity]) -> Errors | None:
    """Judge the quantities of a technique by how far its two roads are apart."""
    return Errors.of({f"{quantity.plan}: {quantity.name}": _share(quantity) for quantity in found})


def _share(quantity: Quantity) -> float:
    """Give the largest difference in shares of the plan's largest; what one road alone finds is infinitely wrong."""
    if not np.isfinite(quantity.excess).all():
        return float("inf")
    off = float(np.nanmax(quantity.difference, initial=0.0))
    if quantity.largest > 0:
        return off / quantity.largest
    return 0.0 if (quantity.excess <= 1.0).all() else float("inf")


def follows(found: Sequence[Quantity], count: int | None) -> bool:
    """Tell whether a technique finds something at every position, so that more of them are more work."""
    return any(quantity.construction.size == count for quantity in found)


def roads(study: Study, technique: str, count: int | None) -> Iterator[Timing]:
    """List both roads to the quantities of a technique, over what it rests on; each begins anew with every run."""
    errors = apart(quantities(study, technique))

    def constructed() -> None:
        study.anew(technique)[technique].construct(study.plans)

    def analysed() -> None:
        quantities(study.anew(technique, constructed=True), technique)

    for name, run in ((CONSTRUCTION, constructed), (ANALYSIS, analysed)):
        yield Timing(run, count, {name.format(technique): lambda _: errors})
