"""Dyads whose inner pair is a stone in a slot (группы с внутренней поступательной парой)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from geometry.board import Mark, Reading
from geometry.meet import Sizes
from plans.linkage import leads
from plans.linkage.leads import GroupKind
from plans.linkage.plan import Image, Plan, Sliding, Slotted, Vector
from plans.model.dyad import Dyad
from plans.model.mechanism import Way
from plans.model.motion import Floats
from plans.words.words import because


class RPR(GroupKind[Dyad]):
    """Dyad of kind 3, RPR (ВПВ): a stone in a slotted link; the shaper's slotted lever (book figures 6.9, 6.12)."""

    pivoted = True

    def positions(self, plan: Plan, dyad: Dyad, side: Sizes) -> None:
        """Direct the slot from C through the pin A; side +1 where A lies ahead of C along the slot (M3.7, kind 3)."""
        (a, c), slide = leads.outer_hinges(plan, dyad), dyad.slide()
        left = [leads.offset(plan, slide, dyad.links[end], dyad.hinge(end)) for end in (0, 1)]
        name, why = plan.written.of_link("u", slide.owner), because("slot_holds", link=slide.owner, point=a.name)
        slot = plan.board.tangent(name, c, a, left[0] - left[1], side, why)
        plan.units[leads.key(slide)] = slot
        for end, pin in enumerate((a, c)):
            link = plan.mechanism.links[dyad.links[end]]
            way = slide.way(link.number)
            plan.images[link.number] = Image(pin, slot, link.points[dyad.hinge(end)], way.direction)

    def velocities(self, plan: Plan, dyad: Dyad) -> None:
        """Meet the slip along the slot from a with the turning about C, square to CA, in a3 (M3.4)."""
        board, (a, c), slide = plan.board, leads.outer_hinges(plan, dyad), dyad.slide()
        reach, slot = _reach(plan, dyad), plan.carry(leads.direction(plan, slide, slide.owner))
        along = board.parallel(f"∥{slot.name}", a, slot, because("slip_slot"))
        around = board.square(f"⊥{reach.name}", c, reach, because("turning_about", point=dyad.hinge(1)))
        under = board.meet(_under(plan, dyad), along, around, why=because("under_pin", link=dyad.links[1]))
        leads.slip(plan, slide, along, under, (dyad.hinge(0), dyad.links[1]))
        turning = board.join(f"{c.name}{under.name}", c, under)
        _keep(plan, dyad, (a, c), board.similar(f"{slot.name}'", turning, reach, slot, why=because("slot_turns_link")))
        for link in dyad.links:
            plan.readings[link] = Reading(reach, turning)

    def accelerations(self, plan: Plan, dyad: Dyad) -> None:
        """Lay off Coriolis from a and the normal part from c; meet along the slot and square to CA in a3 (M3.4)."""
        board, (a, c), slide = plan.board, leads.outer_hinges(plan, dyad), dyad.slide()
        reach, slot = _reach(plan, dyad), leads.direction(plan, slide, slide.owner)
        spun = leads.unit(plan.velocities, slide, slide.owner)
        k = leads.coriolis(plan, slide, a, slot, spun, plan.written.coriolis(dyad.hinge(0), dyad.links[1]))
        turning = plan.carry(plan.velocities.readings[dyad.links[1]].turning)
        name = plan.written.normal(_under(plan, dyad).upper())
        part = board.similar(f"a^{name}", turning, reach, turning, why=because("normal", line=reach.name))
        n = board.lay_off(name, c, part, because("to_centre"))
        along = board.parallel(f"∥{slot.name}", k, plan.carry(slot), because("slip_slot"))
        around = board.square(f"⊥{reach.name}", n, reach, because("tangential"))
        under = board.meet(_under(plan, dyad), along, around, why=because("under_pin", link=dyad.links[1]))
        whole = board.join(f"{c.name}{under.name}", c, under)
        turned = board.similar(f"{slot.name}''", whole, reach, plan.carry(slot), why=because("similarity"))
        _keep(plan, dyad, (a, c), turned)
        tangential = board.join(f"{n.name}{under.name}", n, under, because("tangential"))
        for link in dyad.links:
            plan.readings[link] = Reading(reach, tangential)

    def meeting(self, plan: Plan, dyad: Dyad) -> Mark:
        """Give the slot's direction: it has none where the pin comes to the pivot."""
        return leads.known_direction(plan, dyad.slide())

    def vectors(self, dyad: Dyad) -> Iterator[Vector]:
        """Tell the vectors of its plans: those of the slotted link's point under the pin, which slips."""
        yield Slotted(dyad.links[1], dyad.hinge(1), dyad.hinge(0))
        yield Sliding(leads.key(dyad.slide()), dyad.links[1], dyad.hinge(0), held=True)

    def pressure(self, plan: Plan, dyad: Dyad) -> Floats:
        """Read off its pressure angle, (N,) rad: from the slot to the arm from its link's pivot to the pin."""
        a, c = (np.asarray(mark.point) for mark in leads.outer_hinges(plan, dyad))
        turned = (a - c) / np.asarray(leads.known_direction(plan, dyad.slide()).point)
        return np.asarray(np.arctan2(turned.imag, np.abs(turned.real)))

    def extremes(self, plan: Plan, dyad: Dyad, side: float) -> list[Mark]:
        """Draw tangents to the crank circle from the slotted link's pivot: the crank is square to the slot (M1.7)."""
        board, drive, end = plan.board, plan.mechanism.drive, leads.crank_end(plan, dyad)
        sense = 1.0 if end == 0 else -1.0
        left = [leads.offset(plan, dyad.slide(), dyad.links[e], dyad.hinge(e)) for e in (0, 1)]
        pivot, fixed = plan.point(drive.pivot), plan.point(dyad.hinge(1 - end))
        radius_of_pin = leads.pin(plan, dyad)
        near, marks = abs(radius_of_pin), []
        for number, off in ((1, near), (2, -near)):
            away = sense * (left[0] - left[1]) + off
            slot = board.tangent(f"u_{number}", fixed, pivot, away, sense * side, because("tangent"))
            by = -1j * off * (leads.end(plan) / radius_of_pin)
            arm = board.turn(f"{pivot.name}{drive.end}_{number}", slot, by, because("crank_square"))
            marks.append(board.lay_off(f"{drive.end}_{number}", pivot, arm, because("extreme", number=number)))
        return marks


class RPP(GroupKind[Dyad]):
    """Dyad of kind 5, RPP (ВПП): a stone in a slot whose link slides; the sine mechanism's yoke (book figure 6.12)."""

    assemblies = 1

    def positions(self, plan: Plan, dyad: Dyad, side: Sizes) -> None:
        """Meet the slot through the pin A, at its fixed angle to the guide, with the guide in N (M3.7, kind 5)."""
        board, a, (stone, yoke) = plan.board, plan.point(dyad.hinge(0)), dyad.links
        inner, outer = dyad.slide(), dyad.slide(1)
        guided = leads.direction(plan, outer, dyad.hosts[1])
        angle = inner.way(yoke).direction / outer.way(yoke).direction
        slot = board.turn(plan.written.of_link("u", yoke), guided, angle, because("slot_angle"))
        plan.units[leads.key(inner)] = slot
        left = leads.offset(plan, inner, stone, dyad.hinge(0))
        through = leads.shift(plan, a, slot, -left, f"slot of {dyad.hinge(0)}")
        local, points = _crossing(inner.way(yoke), outer.way(yoke)), plan.mechanism.links[yoke].points
        name = next((point for point, place in points.items() if place == local), f"N{yoke}")
        n = board.meet(name, through, leads.line(plan, outer, dyad.hosts[1], 0.0), why=because("slot_crosses"))
        pin = plan.mechanism.links[stone].points[dyad.hinge(0)]
        plan.images[stone] = Image(a, slot, pin, inner.way(stone).direction)
        plan.images[yoke] = Image(n, guided, local, outer.way(yoke).direction)
        _read(plan, dyad)

    def velocities(self, plan: Plan, dyad: Dyad) -> None:
        """Meet the slip along the slot from a with the sliding along the guide in a3 (M3.5)."""
        board, a, slot = plan.board, plan.point(dyad.hinge(0)), leads.direction(plan, dyad.slide(), dyad.links[1])
        along = board.parallel(f"∥{slot.name}", a, plan.carry(slot), because("slip_slot"))
        guided = leads.sliding_line(plan, dyad.slide(1), dyad.hosts[1], plan.positions.point(dyad.hinge(0)))
        under = _met(plan, dyad, along, guided)
        leads.slip(plan, dyad.slide(), along, under, (dyad.hinge(0), dyad.links[1]))
        leads.slip(plan, dyad.slide(1), guided, under, (dyad.hinge(0), dyad.hosts[1]))

    def accelerations(self, plan: Plan, dyad: Dyad) -> None:
        """Meet the slot's line and the guide's, each laid on its Coriolis part, in a3 (M3.5)."""
        board, a, inner = plan.board, plan.point(dyad.hinge(0)), dyad.slide()
        slot = leads.direction(plan, inner, dyad.links[1])
        spun = plan.velocities.units.get(leads.key(inner))
        k = leads.coriolis(plan, inner, a, slot, spun, plan.written.coriolis(dyad.hinge(0), dyad.links[1]))
        along = board.parallel(f"∥{slot.name}", k, plan.carry(slot), because("slip_slot"))
        guided = leads.coriolis_line(plan, dyad.slide(1), dyad.hosts[1], plan.positions.point(dyad.hinge(0)))
        _met(plan, dyad, along, guided)

    def meeting(self, plan: Plan, dyad: Dyad) -> Mark:
        """Give the point in which the slot crosses the guide."""
        return plan.images[dyad.links[1]].origin

    def vectors(self, dyad: Dyad) -> Iterator[Vector]:
        """Tell the vectors of its plans: the yoke slides under the pin."""
        yield Sliding(leads.key(dyad.slide()), dyad.links[1], dyad.hinge(0), held=True)

    def pressure(self, plan: Plan, dyad: Dyad) -> Floats:
        """Read off its pressure angle, (N,) rad: the guide to the square of the slot."""
        return leads.crossing(plan, dyad.slide(1), dyad.slide())


def _under(plan: Plan, dyad: Dyad) -> str:
    """Name the point of the pivoted link that lies under the pin, such as a3."""
    return plan.written.under(dyad.hinge(0), dyad.links[1])


def _reach(plan: Plan, dyad: Dyad) -> Mark:
    """Carry the vector from the pivot C to the pin A, drawn once on the plan of positions."""
    base = plan.positions
    if dyad.links not in base.reaches:
        a, c = leads.outer_hinges(base, dyad)
        base.reaches[dyad.links] = base.board.join(f"{c.name}{a.name}", c, a, because("to_pin"))
    return plan.carry(base.reaches[dyad.links])


def _keep(plan: Plan, dyad: Dyad, pins: tuple[Mark, Mark], slot: Mark) -> None:
    plan.units[leads.key(dyad.slide())] = slot
    for link, pin in zip(dyad.links, pins, strict=True):
        base = plan.positions.images[link]
        plan.images[link] = Image(pin, slot, base.at, base.span)


def _met(plan: Plan, dyad: Dyad, along: Mark, guided: Mark) -> Mark:
    """Meet in the image of the yoke's point under the pin, and carry it to the yoke's own point N."""
    board, base, (stone, yoke) = plan.board, plan.positions, dyad.links
    a, inner, outer = plan.point(dyad.hinge(0)), dyad.slide(), dyad.slide(1)
    under = board.meet(plan.written.under(dyad.hinge(0), yoke), along, guided, why=because("under_pin", link=yoke))
    turned = leads.unit(plan, outer, dyad.hosts[1])
    n, slot = under, None
    if turned is not None:
        still = leads.direction(plan, outer, dyad.hosts[1])
        back = base.board.join(f"{a.name}N", base.point(dyad.hinge(0)), base.images[yoke].origin)
        why, angle = because("turns", link=yoke), inner.way(yoke).direction / outer.way(yoke).direction
        carried = board.similar(f"{under.name}n", turned, plan.carry(still), plan.carry(back), why=why)
        n = board.lay_off(plan.written.of_link("n", yoke), under, carried, because("similar", point="N", link=yoke))
        slot = board.turn(plan.written.of_link("u", yoke), turned, angle, because("slot_turns"))
    plan.units[leads.key(inner)] = slot
    plan.images[stone] = Image(a, slot, base.images[stone].at, base.images[stone].span)
    plan.images[yoke] = Image(n, turned, base.images[yoke].at, base.images[yoke].span)
    _read(plan, dyad)
    return under


def _read(plan: Plan, dyad: Dyad) -> None:
    """Both links turn as the guide's host does."""
    if dyad.hosts[1] in plan.readings:
        for link in dyad.links:
            plan.readings[link] = plan.readings[dyad.hosts[1]]


def _crossing(slot: Way, guided: Way) -> complex:
    """Give in the yoke's own frame the point where its slot crosses its sliding line."""
    base = guided.through - slot.through
    turn = (slot.direction.conjugate() * guided.direction).imag
    return slot.through + slot.direction * ((base.conjugate() * guided.direction).imag / turn)
