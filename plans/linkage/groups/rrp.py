"""Dyad of kind 2, RRP (ВВП): a rod and a slider; the slider-crank's connecting rod and piston (book figure 6.12)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from geometry.board import Mark
from geometry.meet import Sizes
from plans.linkage.groups import guide, lead
from plans.linkage.groups import lead as crank_line
from plans.linkage.groups.vectors import Vector
from plans.linkage.plan import Plan
from plans.model.dyad import Dyad
from plans.model.motion import Floats
from plans.words.words import because


def positions(plan: Plan, dyad: Dyad, side: Sizes) -> None:
    """Notch the guide by the arc |AB| about A; side +1 takes the meeting ahead of A's foot along the guide (M1.6)."""
    board, a, name = plan.board, plan.point(dyad.hinge(0)), dyad.pin
    left = guide.offset(plan, dyad.slide(1), dyad.links[1], name).left
    along = guide.line(plan, dyad.slide(1), dyad.hosts[1], left)
    arc = board.arc(f"{a.name}{name}", a, abs(lead.vector(plan, dyad, 0)), f"|{a.name}{name}|")
    b = plan.name(name, board.meet(name, along, arc, side, because("on_guide", point=name, start=a.name)))
    lead.keep_place(plan, dyad, 0, a, b)
    guide.ride(plan, dyad, 1, b, plan.mechanism.links[dyad.links[1]].points[name])


def velocities(plan: Plan, dyad: Dyad) -> None:
    """Meet the velocity of B about A, square to AB, with that along the guide (M3.3)."""
    a, slide = plan.point(dyad.hinge(0)), dyad.slide(1)
    along = guide.sliding_line(plan, slide, dyad.hosts[1], plan.positions.point(dyad.pin))
    b = lead.meet_directions(plan, dyad.pin, along, lead.about(plan, dyad.links[0], a))
    guide.slip(plan, slide, along, b, (dyad.pin, dyad.hosts[1]))
    lead.keep_turning(plan, dyad.links[0], a, a, b)
    guide.ride(plan, dyad, 1, b, plan.positions.images[dyad.links[1]].at)


def accelerations(plan: Plan, dyad: Dyad) -> None:
    """Meet the tangential part, square to AB on the normal one, with the guide's line on Coriolis (M3.3)."""
    a = plan.point(dyad.hinge(0))
    n = lead.normal(plan, dyad.links[0], a, (dyad.hinge(0), dyad.pin))
    along = guide.coriolis_line(plan, dyad.slide(1), dyad.hosts[1], plan.positions.point(dyad.pin))
    b = lead.meet_directions(plan, dyad.pin, along, lead.about(plan, dyad.links[0], n))
    lead.keep_turning(plan, dyad.links[0], a, n, b)
    guide.ride(plan, dyad, 1, b, plan.positions.images[dyad.links[1]].at)


def vectors(dyad: Dyad) -> Iterator[Vector]:
    """Tell the vectors of its plans: the rod turns about its outer hinge; the slider slides on what moves."""
    yield lead.turning(dyad, 0)
    yield from guide.sliding(dyad, 1)


def pressure(plan: Plan, dyad: Dyad) -> Floats:
    """Read off its pressure angle, (N,) rad: the rod's acute angle to the guide, signed from the guide to the rod."""
    turned = np.asarray(plan.arm(dyad.links[0]).point) / np.asarray(guide.known_direction(plan, dyad.slide(1)).point)
    return np.asarray(np.arctan2(turned.imag, np.abs(turned.real)))


def extremes(plan: Plan, dyad: Dyad, side: float) -> list[Mark]:
    """Notch the crank and the rod in one line on the guide (M1.6); none where the crank bears the guide."""
    if dyad.hosts[0] != plan.mechanism.drive.link:
        return []
    slide = dyad.slide(1)
    left = guide.offset(plan, slide, dyad.links[1], dyad.pin).left

    def notch(arc: Mark, side: float, name: str) -> Mark:
        along = guide.line(plan, slide, dyad.hosts[1], left)
        return plan.board.meet(name, along, arc, side, because("arc_guide"))

    return crank_line.extremes(plan, dyad, side, notch)
