"""Dyad of kind 4, PRP (ПВП): two sliders hinged to each other; the tangent mechanism (book figure 6.12)."""

from __future__ import annotations

from collections.abc import Iterator

from geometry.board import Mark
from geometry.meet import Sizes
from plans.linkage.groups import guide, lead
from plans.linkage.groups.vectors import Vector
from plans.linkage.plan import Plan
from plans.model.dyad import Dyad
from plans.model.motion import Floats
from plans.words.words import because


def positions(plan: Plan, dyad: Dyad, side: Sizes) -> None:
    """Meet the two guides, each shifted by the pin's offset from it, in the pin B (M3.7, kind 4)."""
    name = dyad.pin
    lines = [
        guide.line(plan, dyad.slide(end), dyad.hosts[end], guide.offset(plan, dyad.slide(end), link, name).left)
        for end, link in enumerate(dyad.links)
    ]
    b = plan.name(name, plan.board.meet(name, lines[0], lines[1], why=because("both_guides", point=name)))
    for end, link in enumerate(dyad.links):
        guide.ride(plan, dyad, end, b, plan.mechanism.links[link].points[name])


def velocities(plan: Plan, dyad: Dyad) -> None:
    """Meet the two velocities of the pin along its guides (M3.6)."""
    over = plan.positions.point(dyad.pin)
    lines = [guide.sliding_line(plan, dyad.slide(end), dyad.hosts[end], over) for end in (0, 1)]
    b = _met(plan, dyad, lines)
    for end in (0, 1):
        guide.slip(plan, dyad.slide(end), lines[end], b, (dyad.pin, dyad.hosts[end]))


def accelerations(plan: Plan, dyad: Dyad) -> None:
    """Meet the two accelerations of the pin along its guides, each laid on its Coriolis part (M3.6)."""
    over = plan.positions.point(dyad.pin)
    _met(plan, dyad, [guide.coriolis_line(plan, dyad.slide(end), dyad.hosts[end], over) for end in (0, 1)])


def vectors(dyad: Dyad) -> Iterator[Vector]:
    """Tell the vectors of its plans: its pin slides on what moves."""
    yield from guide.sliding(dyad, 0)
    yield from guide.sliding(dyad, 1)


def pressure(plan: Plan, dyad: Dyad) -> Floats:
    """Read off its pressure angle, (N,) rad: one guide to the square of the other."""
    return guide.crossing(plan, dyad.slide(0), dyad.slide(1))


def _met(plan: Plan, dyad: Dyad, lines: list[Mark]) -> Mark:
    b = lead.meet_directions(plan, dyad.pin, lines[0], lines[1])
    for end, link in enumerate(dyad.links):
        guide.ride(plan, dyad, end, b, plan.positions.images[link].at)
    return b
