"""The table of group kinds: a new kind is a file beside this one, a line here, and its forces."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from geometry.meet import Sizes
from plans.linkage.groups import prp, rpp, rpr, rrp, rrr
from plans.linkage.plan import Plan
from plans.model.structure import Dyad


class Kind(NamedTuple):
    """The constructions of one kind of group, and how many assemblies its position has (сборки)."""

    positions: Callable[[Plan, Dyad, Sizes], None]
    velocities: Callable[[Plan, Dyad], None]
    accelerations: Callable[[Plan, Dyad], None]
    assemblies: int


KINDS: dict[str, Kind] = {
    "RRR": Kind(rrr.positions, rrr.velocities, rrr.accelerations, 2),
    "RRP": Kind(rrp.positions, rrp.velocities, rrp.accelerations, 2),
    "RPR": Kind(rpr.positions, rpr.velocities, rpr.accelerations, 2),
    "PRP": Kind(prp.positions, prp.velocities, prp.accelerations, 1),
    "RPP": Kind(rpp.positions, rpp.velocities, rpp.accelerations, 1),
}
