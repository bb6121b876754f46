"""Dyad of kind 3, RPR (ВПВ): a stone in a slotted link; the shaper's slotted lever (book figures 6.9, 6.12)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from geometry.board import Mark
from geometry.meet import Sizes
from geometry.steps import Reading
from plans.linkage.groups import guide, lead
from plans.linkage.groups.vectors import Sliding, Slotted, Vector
from plans.linkage.plan import Image, Plan
from plans.model.dyad import Dyad
from plans.model.motion import Floats
from plans.words.words import because


def positions(plan: Plan, dyad: Dyad, side: Sizes) -> None:
    """Direct the slot from C through the pin A; side +1 where A lies ahead of C along the slot (M3.7, kind 3)."""
    (a, c), slide = _outer(plan, dyad), dyad.slide()
    left = [guide.offset(plan, slide, dyad.links[end], dyad.hinge(end)).left for end in (0, 1)]
    slot = plan.board.tangent(
        plan.written.own("u", slide.owner),
        c,
        a,
        left[0] - left[1],
        side,
        because("slot_holds", link=slide.owner, point=a.name),
    )
    plan.units[guide.key(slide)] = slot
    for end, pin in enumerate((a, c)):
        link = plan.mechanism.links[dyad.links[end]]
        way = slide.way(link.number)
        plan.images[link.number] = Image(pin, slot, link.points[dyad.hinge(end)], way.direction)


def velocities(plan: Plan, dyad: Dyad) -> None:
    """Meet the slip along the slot from a with the turning about C, square to CA, in a3 (M3.4)."""
    board, (a, c), slide = plan.board, _outer(plan, dyad), dyad.slide()
    reach, slot = _reach(plan, dyad), plan.carry(guide.direction(plan, slide, slide.owner))
    along = board.parallel(f"∥{slot.name}", a, slot, because("slip_slot"))
    around = board.square(f"⊥{reach.name}", c, reach, because("turning_about", point=dyad.hinge(1)))
    under = board.meet(_under(plan, dyad), along, around, why=because("under_pin", link=dyad.links[1]))
    guide.slip(plan, slide, along, under, (dyad.hinge(0), dyad.links[1]))
    turning = board.join(f"{c.name}{under.name}", c, under)
    _keep(plan, dyad, (a, c), board.similar(f"{slot.name}'", turning, reach, slot, why=because("slot_turns_link")))
    for link in dyad.links:
        plan.readings[link] = Reading(reach, turning)


def accelerations(plan: Plan, dyad: Dyad) -> None:
    """Lay Coriolis off from a and the normal part from c, then meet along the slot and square to CA in a3 (M3.4)."""
    board, (a, c), slide = plan.board, _outer(plan, dyad), dyad.slide()
    reach, slot = _reach(plan, dyad), guide.direction(plan, slide, slide.owner)
    spun = guide.unit(plan.velocities, slide, slide.owner)
    k = guide.coriolis(plan, slide, a, slot, spun, plan.written.coriolis(dyad.hinge(0), dyad.links[1]))
    turning = plan.carry(plan.velocities.readings[dyad.links[1]].turning)
    name = plan.written.normal(_under(plan, dyad).upper())
    part = board.similar(f"a^{name}", turning, reach, turning, why=because("normal", line=reach.name))
    n = board.lay_off(name, c, part, because("to_centre"))
    along = board.parallel(f"∥{slot.name}", k, plan.carry(slot), because("slip_slot"))
    around = board.square(f"⊥{reach.name}", n, reach, because("tangential"))
    under = board.meet(_under(plan, dyad), along, around, why=because("under_pin", link=dyad.links[1]))
    whole = board.join(f"{c.name}{under.name}", c, under)
    _keep(
        plan, dyad, (a, c), board.similar(f"{slot.name}''", whole, reach, plan.carry(slot), why=because("similarity"))
    )
    tangential = board.join(f"{n.name}{under.name}", n, under, because("tangential"))
    for link in dyad.links:
        plan.readings[link] = Reading(reach, tangential)


def meeting(plan: Plan, dyad: Dyad) -> Mark:
    """Give the slot's direction: it has none where the pin comes to the pivot."""
    return guide.known_direction(plan, dyad.slide())


def vectors(dyad: Dyad) -> Iterator[Vector]:
    """Tell the vectors of its plans: those of the slotted link's point under the pin, which slips."""
    yield Slotted(dyad.links[1], dyad.hinge(1), dyad.hinge(0))
    yield Sliding(guide.key(dyad.slide()), dyad.links[1], dyad.hinge(0), held=True)


def pressure(plan: Plan, dyad: Dyad) -> Floats:
    """Read off its pressure angle, (N,) rad: from the slot to the arm from its link's pivot to the pin."""
    a, c = (np.asarray(mark.point) for mark in _outer(plan, dyad))
    turned = (a - c) / np.asarray(guide.known_direction(plan, dyad.slide()).point)
    return np.asarray(np.arctan2(turned.imag, np.abs(turned.real)))


def extremes(plan: Plan, dyad: Dyad, side: float) -> list[Mark]:
    """Draw from the slotted link's pivot the tangents to the crank circle: the crank is square to the slot (M1.7)."""
    board, drive, end = plan.board, plan.mechanism.drive, lead.crank_end(plan, dyad)
    sense = 1.0 if end == 0 else -1.0
    left = [guide.offset(plan, dyad.slide(), dyad.links[e], dyad.hinge(e)).left for e in (0, 1)]
    pivot, fixed = plan.point(drive.pivot), plan.point(dyad.hinge(1 - end))
    radius_of_pin = lead.pin(plan, dyad)
    near, marks = abs(radius_of_pin), []
    for number, off in ((1, near), (2, -near)):
        away = sense * (left[0] - left[1]) + off
        slot = board.tangent(f"u_{number}", fixed, pivot, away, sense * side, because("tangent"))
        by = -1j * off * (lead.end(plan) / radius_of_pin)
        arm = board.turn(f"{pivot.name}{drive.end}_{number}", slot, by, because("crank_square"))
        marks.append(board.lay_off(f"{drive.end}_{number}", pivot, arm, because("extreme", number=number)))
    return marks


def _outer(plan: Plan, dyad: Dyad) -> tuple[Mark, Mark]:
    return plan.point(dyad.hinge(0)), plan.point(dyad.hinge(1))


def _under(plan: Plan, dyad: Dyad) -> str:
    """Name the point of the pivoted link that lies under the pin, such as a3."""
    return plan.written.under(dyad.hinge(0), dyad.links[1])


def _reach(plan: Plan, dyad: Dyad) -> Mark:
    """Carry the vector from the pivot C to the pin A, drawn once on the plan of positions."""
    base = plan.positions
    if dyad.links not in base.reaches:
        a, c = _outer(base, dyad)
        base.reaches[dyad.links] = base.board.join(f"{c.name}{a.name}", c, a, because("to_pin"))
    return plan.carry(base.reaches[dyad.links])


def _keep(plan: Plan, dyad: Dyad, pins: tuple[Mark, Mark], slot: Mark) -> None:
    plan.units[guide.key(dyad.slide())] = slot
    for link, pin in zip(dyad.links, pins, strict=True):
        base = plan.positions.images[link]
        plan.images[link] = Image(pin, slot, base.at, base.span)
