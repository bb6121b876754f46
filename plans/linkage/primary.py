"""The table of primary links: by what a mechanism is driven, and the plans that start from it (начальные звенья)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import NamedTuple

from plans.linkage.crank_positions import CrankPositions
from plans.linkage.groups.vectors import Vector
from plans.linkage.plan import Plan
from plans.linkage.primaries import crank, slider
from plans.model.mechanism import CRANK, SLIDER, Mechanism
from plans.model.motion import Complexes, Rates


class Primary(NamedTuple):
    """The constructions of one kind of primary link, on which the first group hangs."""

    positions: Callable[[Mechanism, CrankPositions], Plan]  # starts the plan
    velocities: Callable[[Plan, Rates], None]
    accelerations: Callable[[Plan, Rates], None]
    vectors: Callable[[Mechanism], Iterable[Vector]]  # that its plans must have, beside those of its points
    free: str  # the given mark that takes another value in each position
    values: Callable[[Mechanism, CrankPositions], Complexes]  # of that mark
    ends: Callable[[Mechanism, CrankPositions], Complexes]  # m: of its end, known where nothing is assembled too


PRIMARIES: Mapping[str, Primary] = {
    CRANK: Primary(
        crank.positions, crank.velocities, crank.accelerations, crank.vectors, crank.FREE, crank.values, crank.ends
    ),
    SLIDER: Primary(
        slider.positions,
        slider.velocities,
        slider.accelerations,
        slider.vectors,
        slider.FREE,
        slider.values,
        slider.ends,
    ),
}
