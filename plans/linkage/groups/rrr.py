"""Dyad of kind 1, RRR (ВВВ): two links, three hinges; the four-bar's coupler and rocker (book figure 6.12)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from geometry.board import Mark
from geometry.meet import Sizes
from plans.linkage.groups import lead
from plans.linkage.groups import lead as crank_line
from plans.linkage.groups.vectors import Vector
from plans.linkage.plan import Plan
from plans.model.dyad import Dyad
from plans.model.motion import Floats
from plans.words.words import because


def positions(plan: Plan, dyad: Dyad, side: Sizes) -> None:
    """Place B by two notches, |AB| from A and |CB| from C, on the chosen side of the ray AC (метод засечек, M1.1)."""
    board, (a, c), name = plan.board, _outer(plan, dyad), dyad.pin
    arcs = [
        board.arc(f"{start.name}{name}", start, abs(lead.vector(plan, dyad, end)), f"|{start.name}{name}|")
        for end, start in enumerate((a, c))
    ]
    why = because("notched", point=name, start=a.name, end=c.name)
    b = plan.name(name, board.meet(name, arcs[0], arcs[1], side, why))
    lead.keep_place(plan, dyad, 0, a, b)
    lead.keep_place(plan, dyad, 1, c, b)


def velocities(plan: Plan, dyad: Dyad) -> None:
    """Meet the velocity of B about A, square to AB, with that about C, square to CB (M3.2)."""
    a, c = _outer(plan, dyad)
    b = lead.meet_directions(plan, dyad.pin, lead.about(plan, dyad.links[0], a), lead.about(plan, dyad.links[1], c))
    lead.keep_turning(plan, dyad.links[0], a, a, b)
    lead.keep_turning(plan, dyad.links[1], c, c, b)


def accelerations(plan: Plan, dyad: Dyad) -> None:
    """Lay off the normal parts towards A and C, then meet the tangential ones, square to AB and CB (M3.2)."""
    starts = _outer(plan, dyad)
    ends = [
        lead.normal(plan, link, start, (dyad.hinge(end), dyad.pin))
        for end, (link, start) in enumerate(zip(dyad.links, starts, strict=True))
    ]
    b = lead.meet_directions(
        plan, dyad.pin, lead.about(plan, dyad.links[0], ends[0]), lead.about(plan, dyad.links[1], ends[1])
    )
    for link, start, end in zip(dyad.links, starts, ends, strict=True):
        lead.keep_turning(plan, link, start, end, b)


def vectors(dyad: Dyad) -> Iterator[Vector]:
    """Tell the vectors of its plans: both leads turn about their outer hinges."""
    yield lead.turning(dyad, 0)
    yield lead.turning(dyad, 1)


def pressure(plan: Plan, dyad: Dyad) -> Floats:
    """Read off its pressure angle, (N,) rad: 90 degrees less the transmission angle ABC (угол передачи, M1.3)."""
    ab, cb = (np.asarray(plan.arm(link).point) for link in dyad.links)
    return np.asarray(np.pi / 2 - np.abs(np.angle(ab / cb)))


def extremes(plan: Plan, dyad: Dyad, side: float) -> list[Mark]:
    """Notch the crank and the coupler in one line on the rocker's arc (M1.2)."""
    end = crank_line.crank_end(plan, dyad)
    fixed, rocker = plan.point(dyad.hinge(1 - end)), abs(lead.vector(plan, dyad, 1 - end))

    def notch(arc: Mark, side: float, name: str) -> Mark:
        other = plan.board.arc(f"{fixed.name}{name}", fixed, rocker, because("rocker_end"))
        return plan.board.meet(name, arc, other, side if end == 0 else -side, because("arcs"))

    return crank_line.extremes(plan, dyad, side, notch)


def _outer(plan: Plan, dyad: Dyad) -> tuple[Mark, Mark]:
    return plan.point(dyad.hinge(0)), plan.point(dyad.hinge(1))
