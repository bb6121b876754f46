"""Dyad of kind 5, RPP (ВПП): a stone in a slot whose link slides; the sine mechanism's yoke (book figure 6.12)."""

from __future__ import annotations

from collections.abc import Iterator

from geometry.board import Mark
from geometry.meet import Sizes
from plans.linkage.groups import guide
from plans.linkage.groups.vectors import Sliding, Vector
from plans.linkage.plan import Image, Plan
from plans.model.dyad import Dyad
from plans.model.mechanism import Way
from plans.model.motion import Floats
from plans.words.words import because


def positions(plan: Plan, dyad: Dyad, side: Sizes) -> None:
    """Meet the slot through the pin A, at its fixed angle to the guide, with the guide in N (M3.7, kind 5)."""
    board, a, (stone, yoke) = plan.board, plan.point(dyad.hinge(0)), dyad.links
    inner, outer = dyad.slide(), dyad.slide(1)
    guided = guide.direction(plan, outer, dyad.hosts[1])
    angle = inner.way(yoke).direction / outer.way(yoke).direction
    slot = board.turn(plan.written.own("u", yoke), guided, angle, because("slot_angle"))
    plan.units[guide.key(inner)] = slot
    left = guide.offset(plan, inner, stone, dyad.hinge(0)).left
    through = guide.shift(plan, a, slot, -left, f"slot of {dyad.hinge(0)}")
    local, own = _crossing(inner.way(yoke), outer.way(yoke)), plan.mechanism.links[yoke].points
    name = next((point for point, place in own.items() if place == local), f"N{yoke}")
    n = board.meet(name, through, guide.line(plan, outer, dyad.hosts[1], 0.0), why=because("slot_crosses"))
    plan.images[stone] = Image(a, slot, plan.mechanism.links[stone].points[dyad.hinge(0)], inner.way(stone).direction)
    plan.images[yoke] = Image(n, guided, local, outer.way(yoke).direction)
    _read(plan, dyad)


def velocities(plan: Plan, dyad: Dyad) -> None:
    """Meet the slip along the slot from a with the sliding along the guide in a3 (M3.5)."""
    board, a, slot = plan.board, plan.point(dyad.hinge(0)), guide.direction(plan, dyad.slide(), dyad.links[1])
    along = board.parallel(f"∥{slot.name}", a, plan.carry(slot), because("slip_slot"))
    guided = guide.sliding_line(plan, dyad.slide(1), dyad.hosts[1], plan.positions.point(dyad.hinge(0)))
    under = _met(plan, dyad, along, guided)
    guide.slip(plan, dyad.slide(), along, under, (dyad.hinge(0), dyad.links[1]))
    guide.slip(plan, dyad.slide(1), guided, under, (dyad.hinge(0), dyad.hosts[1]))


def accelerations(plan: Plan, dyad: Dyad) -> None:
    """Meet the slot's line and the guide's, each laid on its Coriolis part, in a3 (M3.5)."""
    board, a, inner = plan.board, plan.point(dyad.hinge(0)), dyad.slide()
    slot = guide.direction(plan, inner, dyad.links[1])
    spun = plan.velocities.units.get(guide.key(inner))
    k = guide.coriolis(plan, inner, a, slot, spun, plan.written.coriolis(dyad.hinge(0), dyad.links[1]))
    along = board.parallel(f"∥{slot.name}", k, plan.carry(slot), because("slip_slot"))
    guided = guide.coriolis_line(plan, dyad.slide(1), dyad.hosts[1], plan.positions.point(dyad.hinge(0)))
    _met(plan, dyad, along, guided)


def meeting(plan: Plan, dyad: Dyad) -> Mark:
    """Give the point in which the slot crosses the guide."""
    return plan.images[dyad.links[1]].origin


def vectors(dyad: Dyad) -> Iterator[Vector]:
    """Tell the vectors of its plans: the yoke slides under the pin."""
    yield Sliding(guide.key(dyad.slide()), dyad.links[1], dyad.hinge(0), held=True)


def pressure(plan: Plan, dyad: Dyad) -> Floats:
    """Read off its pressure angle, (N,) rad: the guide to the square of the slot."""
    return guide.crossing(plan, dyad.slide(1), dyad.slide())


def _met(plan: Plan, dyad: Dyad, along: Mark, guided: Mark) -> Mark:
    """Meet in the image of the yoke's point under the pin, and carry it to the yoke's own point N."""
    board, base, (stone, yoke) = plan.board, plan.positions, dyad.links
    a, inner, outer = plan.point(dyad.hinge(0)), dyad.slide(), dyad.slide(1)
    under = board.meet(plan.written.under(dyad.hinge(0), yoke), along, guided, why=because("under_pin", link=yoke))
    turned = guide.unit(plan, outer, dyad.hosts[1])
    n, slot = under, None
    if turned is not None:
        still = guide.direction(plan, outer, dyad.hosts[1])
        back = base.board.join(f"{a.name}N", base.point(dyad.hinge(0)), base.images[yoke].origin)
        carried = board.similar(
            f"{under.name}n", turned, plan.carry(still), plan.carry(back), why=because("turns", link=yoke)
        )
        n = board.lay_off(plan.written.own("n", yoke), under, carried, because("similar", point="N", link=yoke))
        slot = board.turn(
            plan.written.own("u", yoke),
            turned,
            inner.way(yoke).direction / outer.way(yoke).direction,
            because("slot_turns"),
        )
    plan.units[guide.key(inner)] = slot
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
