"""Dyads that a hinge joins, and the table of all kinds: a new kind is a class, and its forces (группы II класса)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from geometry.board import Mark
from geometry.meet import Sizes
from plans.linkage import leads
from plans.linkage.leads import GroupKind
from plans.linkage.plan import Plan, Vector
from plans.linkage.slotted_dyads import RPP, RPR
from plans.linkage.triads import Triads
from plans.model.dyad import Dyad
from plans.model.motion import Floats
from plans.words.words import because


class Hinged(GroupKind[Dyad]):
    """Two leads that an inner hinge joins."""

    def meeting(self, plan: Plan, dyad: Dyad) -> Mark:
        """Give the inner hinge: where it has no place, the group has none."""
        return plan.letters[dyad.pin]


class RRR(Hinged):
    """Dyad of kind 1, RRR (ВВВ): two links, three hinges; the four-bar's coupler and rocker (book figure 6.12)."""

    def positions(self, plan: Plan, dyad: Dyad, side: Sizes) -> None:
        """Place B by notches |AB| from A and |CB| from C, on the chosen side of the ray AC (метод засечек, M1.1)."""
        board, (a, c), name = plan.board, leads.outer_hinges(plan, dyad), dyad.pin
        arcs = [
            board.arc(f"{start.name}{name}", start, abs(leads.vector(plan, dyad, end)), f"|{start.name}{name}|")
            for end, start in enumerate((a, c))
        ]
        why = because("notched", point=name, start=a.name, end=c.name)
        b = plan.name(name, board.meet(name, arcs[0], arcs[1], side, why))
        leads.keep_place(plan, dyad, 0, a, b)
        leads.keep_place(plan, dyad, 1, c, b)

    def velocities(self, plan: Plan, dyad: Dyad) -> None:
        """Meet the velocity of B about A, square to AB, with that about C, square to CB (M3.2)."""
        a, c = leads.outer_hinges(plan, dyad)
        lines = leads.about(plan, dyad.links[0], a), leads.about(plan, dyad.links[1], c)
        b = leads.meet_directions(plan, dyad.pin, *lines)
        leads.keep_turning(plan, dyad.links[0], a, a, b)
        leads.keep_turning(plan, dyad.links[1], c, c, b)

    def accelerations(self, plan: Plan, dyad: Dyad) -> None:
        """Lay off the normal parts towards A and C, then meet the tangential ones, square to AB and CB (M3.2)."""
        starts = leads.outer_hinges(plan, dyad)
        ends = [
            leads.normal(plan, link, start, (dyad.hinge(end), dyad.pin))
            for end, (link, start) in enumerate(zip(dyad.links, starts, strict=True))
        ]
        lines = leads.about(plan, dyad.links[0], ends[0]), leads.about(plan, dyad.links[1], ends[1])
        b = leads.meet_directions(plan, dyad.pin, *lines)
        for link, start, end in zip(dyad.links, starts, ends, strict=True):
            leads.keep_turning(plan, link, start, end, b)

    def vectors(self, dyad: Dyad) -> Iterator[Vector]:
        """Tell the vectors of its plans: both leads turn about their outer hinges."""
        yield leads.turning(dyad, 0)
        yield leads.turning(dyad, 1)

    def pressure(self, plan: Plan, dyad: Dyad) -> Floats:
        """Read off its pressure angle, (N,) rad: 90 degrees less the transmission angle ABC (угол передачи, M1.3)."""
        ab, cb = (np.asarray(plan.arm(link).point) for link in dyad.links)
        return np.asarray(np.pi / 2 - np.abs(np.angle(ab / cb)))

    def extremes(self, plan: Plan, dyad: Dyad, side: float) -> list[Mark]:
        """Notch the crank and the coupler in one line on the rocker's arc (M1.2)."""
        end = leads.crank_end(plan, dyad)
        fixed, rocker = plan.point(dyad.hinge(1 - end)), abs(leads.vector(plan, dyad, 1 - end))

        def notch(arc: Mark, side: float, name: str) -> Mark:
            other = plan.board.arc(f"{fixed.name}{name}", fixed, rocker, because("rocker_end"))
            return plan.board.meet(name, arc, other, side if end == 0 else -side, because("arcs"))

        return leads.extremes(plan, dyad, side, notch)


class RRP(Hinged):
    """Dyad of kind 2, RRP (ВВП): a rod and a slider; the slider-crank's rod and piston (book figure 6.12)."""

    def positions(self, plan: Plan, dyad: Dyad, side: Sizes) -> None:
        """Notch the guide by the arc |AB| about A; side +1 is ahead of A's foot along the guide (M1.6)."""
        board, a, name = plan.board, plan.point(dyad.hinge(0)), dyad.pin
        left = leads.offset(plan, dyad.slide(1), dyad.links[1], name)
        along = leads.line(plan, dyad.slide(1), dyad.hosts[1], left)
        arc = board.arc(f"{a.name}{name}", a, abs(leads.vector(plan, dyad, 0)), f"|{a.name}{name}|")
        b = plan.name(name, board.meet(name, along, arc, side, because("on_guide", point=name, start=a.name)))
        leads.keep_place(plan, dyad, 0, a, b)
        leads.ride(plan, dyad, 1, b, plan.mechanism.links[dyad.links[1]].points[name])

    def velocities(self, plan: Plan, dyad: Dyad) -> None:
        """Meet the velocity of B about A, square to AB, with that along the guide (M3.3)."""
        a, slide = plan.point(dyad.hinge(0)), dyad.slide(1)
        along = leads.sliding_line(plan, slide, dyad.hosts[1], plan.positions.point(dyad.pin))
        b = leads.meet_directions(plan, dyad.pin, along, leads.about(plan, dyad.links[0], a))
        leads.slip(plan, slide, along, b, (dyad.pin, dyad.hosts[1]))
        leads.keep_turning(plan, dyad.links[0], a, a, b)
        leads.ride(plan, dyad, 1, b, plan.positions.images[dyad.links[1]].at)

    def accelerations(self, plan: Plan, dyad: Dyad) -> None:
        """Meet the tangential part, square to AB on the normal one, with the guide's line on Coriolis (M3.3)."""
        a = plan.point(dyad.hinge(0))
        n = leads.normal(plan, dyad.links[0], a, (dyad.hinge(0), dyad.pin))
        along = leads.coriolis_line(plan, dyad.slide(1), dyad.hosts[1], plan.positions.point(dyad.pin))
        b = leads.meet_directions(plan, dyad.pin, along, leads.about(plan, dyad.links[0], n))
        leads.keep_turning(plan, dyad.links[0], a, n, b)
        leads.ride(plan, dyad, 1, b, plan.positions.images[dyad.links[1]].at)

    def vectors(self, dyad: Dyad) -> Iterator[Vector]:
        """Tell the vectors of its plans: the rod turns about its outer hinge; the slider slides on what moves."""
        yield leads.turning(dyad, 0)
        yield from leads.sliding(dyad, 1)

    def pressure(self, plan: Plan, dyad: Dyad) -> Floats:
        """Read off its pressure angle, (N,) rad: the rod's acute angle to the guide, signed from the guide."""
        guide = leads.known_direction(plan, dyad.slide(1))
        turned = np.asarray(plan.arm(dyad.links[0]).point) / np.asarray(guide.point)
        return np.asarray(np.arctan2(turned.imag, np.abs(turned.real)))

    def extremes(self, plan: Plan, dyad: Dyad, side: float) -> list[Mark]:
        """Notch the crank and the rod in one line on the guide (M1.6); none where the crank bears the guide."""
        if dyad.hosts[0] != plan.mechanism.drive.link:
            return []
        slide = dyad.slide(1)
        left = leads.offset(plan, slide, dyad.links[1], dyad.pin)

        def notch(arc: Mark, side: float, name: str) -> Mark:
            along = leads.line(plan, slide, dyad.hosts[1], left)
            return plan.board.meet(name, along, arc, side, because("arc_guide"))

        return leads.extremes(plan, dyad, side, notch)


class PRP(Hinged):
    """Dyad of kind 4, PRP (ПВП): two sliders hinged to each other; the tangent mechanism (book figure 6.12)."""

    assemblies = 1

    def positions(self, plan: Plan, dyad: Dyad, side: Sizes) -> None:
        """Meet the two guides, each shifted by the pin's offset from it, in the pin B (M3.7, kind 4)."""
        name = dyad.pin
        lines = [
            leads.line(plan, dyad.slide(end), dyad.hosts[end], leads.offset(plan, dyad.slide(end), link, name))
            for end, link in enumerate(dyad.links)
        ]
        b = plan.name(name, plan.board.meet(name, lines[0], lines[1], why=because("both_guides", point=name)))
        for end, link in enumerate(dyad.links):
            leads.ride(plan, dyad, end, b, plan.mechanism.links[link].points[name])

    def velocities(self, plan: Plan, dyad: Dyad) -> None:
        """Meet the two velocities of the pin along its guides (M3.6)."""
        over = plan.positions.point(dyad.pin)
        lines = [leads.sliding_line(plan, dyad.slide(end), dyad.hosts[end], over) for end in (0, 1)]
        b = _met(plan, dyad, lines)
        for end in (0, 1):
            leads.slip(plan, dyad.slide(end), lines[end], b, (dyad.pin, dyad.hosts[end]))

    def accelerations(self, plan: Plan, dyad: Dyad) -> None:
        """Meet the two accelerations of the pin along its guides, each laid on its Coriolis part (M3.6)."""
        over = plan.positions.point(dyad.pin)
        _met(plan, dyad, [leads.coriolis_line(plan, dyad.slide(end), dyad.hosts[end], over) for end in (0, 1)])

    def vectors(self, dyad: Dyad) -> Iterator[Vector]:
        """Tell the vectors of its plans: its pin slides on what moves."""
        yield from leads.sliding(dyad, 0)
        yield from leads.sliding(dyad, 1)

    def pressure(self, plan: Plan, dyad: Dyad) -> Floats:
        """Read off its pressure angle, (N,) rad: one guide to the square of the other."""
        return leads.crossing(plan, dyad.slide(0), dyad.slide(1))


KINDS: Mapping[str, GroupKind[Any]] = {
    "RRR": RRR(), "RRP": RRP(), "RPR": RPR(), "PRP": PRP(), "RPP": RPP(), "triad": Triads(),
}  # fmt: skip


def _met(plan: Plan, dyad: Dyad, lines: list[Mark]) -> Mark:
    b = leads.meet_directions(plan, dyad.pin, lines[0], lines[1])
    for end, link in enumerate(dyad.links):
        leads.ride(plan, dyad, end, b, plan.positions.images[link].at)
    return b
