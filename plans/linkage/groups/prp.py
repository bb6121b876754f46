"""Dyad of kind 4, PRP (ПВП): two sliders hinged to each other; the tangent mechanism (book figure 6.12)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from geometry.board import Mark
from geometry.meet import Sizes
from plans.linkage.groups import guide, lead
from plans.linkage.plan import Plan
from plans.model.structure import Dyad

if TYPE_CHECKING:
    from plans.forces.cut import Cut
    from plans.forces.force import ForcePlan


def positions(plan: Plan, dyad: Dyad, side: Sizes) -> None:
    """Meet the two guides, each shifted by the pin's offset from it, in the pin B (M3.7, kind 4)."""
    name = dyad.pin
    lines = [
        guide.line(plan, dyad.slide(end), dyad.hosts[end], guide.offset(plan, dyad.slide(end), link, name).left)
        for end, link in enumerate(dyad.links)
    ]
    b = plan.name(name, plan.board.meet(name, lines[0], lines[1], why=f"{name} lies on both guides"))
    for end, link in enumerate(dyad.links):
        guide.ride(plan, dyad, end, b, plan.mechanism.links[link].points[name])


def velocities(plan: Plan, dyad: Dyad) -> None:
    """Meet the two velocities of the pin along its guides (M3.6)."""
    over = plan.positions.point(dyad.pin)
    lines = [guide.sliding_line(plan, dyad.slide(end), dyad.hosts[end], over) for end in (0, 1)]
    b = _met(plan, dyad, lines)
    for end in (0, 1):
        guide.slip(plan, dyad.slide(end), lines[end], b, dyad.pin)


def accelerations(plan: Plan, dyad: Dyad) -> None:
    """Meet the two accelerations of the pin along its guides, each laid on its Coriolis part (M3.6)."""
    over = plan.positions.point(dyad.pin)
    _met(plan, dyad, [guide.coriolis_line(plan, dyad.slide(end), dyad.hosts[end], over) for end in (0, 1)])


def forces(plan: ForcePlan, dyad: Dyad) -> Cut:
    """Close the polygon of all forces square to both guides; the pin's moments give their moments (M5.5)."""
    from plans.forces import polygon as statics  # noqa: PLC0415  (only a force plan pays for it)

    laid, inner = statics.laid(plan, dyad)
    guides = statics.guide_of(plan, dyad, 0), statics.guide_of(plan, dyad, 1)
    lines = [
        plan.board.square(f"⊥{along.name}", start, along, "a guide presses square to itself")
        for along, start in zip(guides, (laid.start, laid.end), strict=True)
    ]
    names = statics.name_of(dyad, 0), statics.name_of(dyad, 1)
    closed = statics.closed(plan, laid, names, (lines[0], lines[1]))
    pin = statics.support(plan, dyad.links[::-1], dyad.pin, statics.cut_at(plan, dyad, closed.corner, inner))
    supports = [statics.guided(plan, dyad, end, closed, pin) for end in (0, 1)]
    return statics.cut(plan, dyad, supports, pin, [], closed.polygon)


def _met(plan: Plan, dyad: Dyad, lines: list[Mark]) -> Mark:
    b = lead.met(plan, dyad.pin, lines[0], lines[1])
    for end, link in enumerate(dyad.links):
        guide.ride(plan, dyad, end, b, plan.positions.images[link].at)
    return b
