"""The table of group kinds: a new kind is a file beside this one and a line here."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from geometry.meet import Sizes
from plans.linkage.groups import prp, rpp, rpr, rrp, rrr
from plans.linkage.plan import Plan
from plans.model.structure import Dyad

if TYPE_CHECKING:
    from plans.forces.cut import Cut
    from plans.forces.force import ForcePlan


class Kind(NamedTuple):
    """The constructions of one kind of group, and how many assemblies its position has (сборки)."""

    positions: Callable[[Plan, Dyad, Sizes], None]
    velocities: Callable[[Plan, Dyad], None]
    accelerations: Callable[[Plan, Dyad], None]
    forces: Callable[[ForcePlan, Dyad], Cut]
    assemblies: int


KINDS: dict[str, Kind] = {
    "RRR": Kind(rrr.positions, rrr.velocities, rrr.accelerations, rrr.forces, 2),
    "RRP": Kind(rrp.positions, rrp.velocities, rrp.accelerations, rrp.forces, 2),
    "RPR": Kind(rpr.positions, rpr.velocities, rpr.accelerations, rpr.forces, 2),
    "PRP": Kind(prp.positions, prp.velocities, prp.accelerations, prp.forces, 1),
    "RPP": Kind(rpp.positions, rpp.velocities, rpp.accelerations, rpp.forces, 1),
}
