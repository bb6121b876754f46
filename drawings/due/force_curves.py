"""What the curves of force sheets must be, by the analysis alone: what balances the drive, hodographs (кривые сил)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.expected import Expected
from drawings.due.acting import Acting
from drawings.paper.limits import SEEN
from drawings.paper.statement import Kind
from plans.analytic.kinetostatics import kinetostatics
from plans.checks.force_comparison import ForceComparison
from plans.forces.cut import indices
from plans.forces.primary import balancing_quantity
from plans.forces.statics import Statics
from plans.model.mechanism import FRAME
from plans.model.motion import Floats

BALANCING = "balancing"
TURN = 360.0


def curves(
    statics: Statics, comparison: ForceComparison, shown: Sequence[int], scales: Mapping[str, float]
) -> Iterator[Expected]:
    """Give the graph of what balances the drive, and the hodographs of the reactions that are asked for."""
    own = _Curves(statics, comparison, shown)
    yield from own.ordinates()
    for key in statics.form.sheet.hodographs:
        yield from own.hodograph(key)


@dataclass(frozen=True)
class _Curves:
    """The forces of a machine over its positions."""

    statics: Statics
    comparison: ForceComparison
    shown: Sequence[int]

    @cached_property
    def slack(self) -> float:
        """What the two roads may differ by in what balances the drive."""
        name, _, share = balancing_quantity(self.statics.study.mechanism.drive)
        found = self.comparison.analysis
        bounds = [found.counted(one.allowed) for one in self.comparison.of("forces") if one.name.startswith(name)]
        return 2 * float(max(map(np.nanmax, bounds))) + share * found.nothing[1]

    @cached_property
    def sizes(self) -> Floats:
        """What balances the drive in the positions."""
        found, motion = self.comparison.analysis, self.comparison.motion
        given = self.statics.given(found, motion.analysis, self.statics.over(motion.road.extremes))
        return np.asarray(found.counted(given))

    def ordinates(self) -> Iterator[Expected]:
        """Give the ordinates of the positions; where numbers have no room some have none."""
        for k, size in enumerate(self.sizes):
            if np.isfinite(size):
                yield Expected(Kind.VECTOR, BALANCING, str(k), 1j * float(size), self.slack, k, may_lack=True)

    def hodograph(self, key: str) -> Iterator[Expected]:
        """Give the points of the positions and the vectors of the shown ones."""
        plan, one = f"hodograph-{key}", self.comparison.analysis.reactions[key]
        slack = 2 * float(np.nanmax([np.nanmax(row.allowed) for row in self.comparison.of("forces") if row.unit == "N"]))
        for k, value in enumerate(one.force):
            if np.isfinite(value):
                yield Expected(Kind.POINT, plan, str(k), complex(value), slack, k, may_lack=True)
        for k in self.shown:
            acting = Acting(self.statics, self.comparison, k)
            name = f"R_{indices(one.giver, one.taker)}"
            value, letter = complex(one.force[k]), acting.letter(name)
            yield Expected(Kind.VECTOR, plan, acting.name(name), value, slack, k, may_lack=True, letter=letter)
