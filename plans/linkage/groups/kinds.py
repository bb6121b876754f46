"""The table of group kinds: a new kind is a file beside this one, a row here, and its forces."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Generic, NamedTuple, TypeVar

from geometry.board import Mark
from geometry.meet import Sizes
from plans.linkage.groups import lead, prp, rpp, rpr, rrp, rrr
from plans.linkage.groups.vectors import Vector
from plans.linkage.plan import Plan
from plans.model.motion import Floats

Of = TypeVar("Of")  # what groups of the kind are, such as dyads


class Kind(NamedTuple, Generic[Of]):
    """What is special to one kind of group."""

    positions: Callable[[Plan, Of, Sizes], None]
    velocities: Callable[[Plan, Of], None]
    accelerations: Callable[[Plan, Of], None]
    assemblies: int  # that its position has: two, or one (сборки)
    meeting: Callable[[Plan, Of], Mark]  # on the plan of positions: where it fails, the group bars the crank
    vectors: Callable[[Of], Iterable[Vector]]  # that its plans must have, beside those of its points
    pressure: Callable[[Plan, Of], Floats]  # signed pressure angle, (N,) rad, read off the plan of positions
    pivoted: bool = False  # whether its meeting is the direction of a slot from a pivot, any where the pin comes to it
    # Of a group between crank and frame, of some side: the crank's end in both extremes of the link that it drives.
    extremes: Callable[[Plan, Of, float], list[Mark]] | None = None


KINDS: Mapping[str, Kind[Any]] = {
    "RRR": Kind(
        rrr.positions,
        rrr.velocities,
        rrr.accelerations,
        2,
        lead.meeting,
        rrr.vectors,
        rrr.pressure,
        extremes=rrr.extremes,
    ),
    "RRP": Kind(
        rrp.positions,
        rrp.velocities,
        rrp.accelerations,
        2,
        lead.meeting,
        rrp.vectors,
        rrp.pressure,
        extremes=rrp.extremes,
    ),
    "RPR": Kind(
        rpr.positions,
        rpr.velocities,
        rpr.accelerations,
        2,
        rpr.meeting,
        rpr.vectors,
        rpr.pressure,
        True,
        rpr.extremes,
    ),
    "PRP": Kind(prp.positions, prp.velocities, prp.accelerations, 1, lead.meeting, prp.vectors, prp.pressure),
    "RPP": Kind(rpp.positions, rpp.velocities, rpp.accelerations, 1, rpp.meeting, rpp.vectors, rpp.pressure),
}
