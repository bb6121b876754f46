"""The numbers that the notes of force sheets tell of friction, by the analysis alone (пояснения о трении)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from drawings.checks.expected import NOTES, Expected
from drawings.paper.statement import Kind
from plans.checks.force_comparison import ForceComparison
from plans.forces.cut import indices
from plans.model.kinetostatics import NOTHING
from plans.model.motion import Floats


def notes(comparison: ForceComparison, shown: Sequence[int]) -> Iterator[Expected]:
    """Give the powers and the efficiency in the shown positions, the efficiency over the cycle, the shares of wear."""
    if comparison.friction is None:
        return
    found, slack = comparison.friction[1], {one.name: one.allowed for one in comparison.of("friction")}
    pairs = {key: indices(*map(int, key.split("-"))) for key in found.powers}
    none = NOTHING * max(float(np.nanmax(np.abs(row), initial=0.0)) for row in (found.lost, found.useful))
    row = Expected(Kind.PHRASE, NOTES, "", 0.0)
    for k in (k for k in shown if np.isfinite(found.lost[k])):
        off = none + sum(float(slack[f"N_{own}"][k]) for own in pairs.values())
        yield row._replace(name=f"friction index {k}", value=float(found.lost[k]), allowed=off, digits=4)
        off = none + float(slack["N_us"][k])
        yield row._replace(name=f"useful index {k}", value=float(found.useful[k]), allowed=off, digits=4)
        own = row._replace(name=f"η {k}", value=float(found.efficiency[k]), allowed=float(slack["η"][k]), digits=3)
        yield own._replace(may_lack=not np.isfinite(found.efficiency[k]))
    own = row._replace(digits=3, may_lack=True)
    if found.cycle is not None:
        yield own._replace(name="η", value=found.cycle, allowed=_one(slack, "η cycle"))
    for key, share in found.wear.items():
        off = 100 * _one(slack, f"wear {pairs.get(key, key)}")
        yield own._replace(name=f"wear {key}", value=100 * share, allowed=off)


def _one(slack: Mapping[str, Floats], name: str) -> float:
    return float(slack[name][0]) if name in slack else math.inf
