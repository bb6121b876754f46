"""The self-check of where the wheel, springs and friction circles of a scheme stand (колесо, пружины, круги трения)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator

from drawings.checks.forces.laid_scheme import FINE, LaidScheme
from drawings.checks.wrong import Wrong, on
from drawings.paper.strokes import Circle
from drawings.paper.walk import groups
from plans.checks.force_bill import ForceBill
from plans.model.machine import GEAR
from plans.model.mechanism import FRAME


def faults(plan: str, laid: LaidScheme, bill: ForceBill) -> Iterator[Wrong]:
    """Hold the wheel that drives the primary link, springs at their ends, friction circles about their hinges."""
    machine = bill.expected.machine
    if bill.group is None and machine.transmission.kind == GEAR and not _meshed(laid, bill):
        yield on("missing_on", plan, name="α")
    for spring in machine.springs:
        ends = [name for name, link in zip(spring.points, spring.links, strict=True) if link in bill.links]
        for name in (name for name in ends if FRAME not in bill.links):
            spot = laid.on(bill.place(name))
            chains = (one.points for one in laid.strokes.chains if not one.closed)
            if not any(min(abs(one[0] - spot), abs(one[-1] - spot)) <= FINE for one in chains):
                yield on("differs_on", plan, name=spring.name)
    for group in groups((laid.strokes.group,)):
        circle = group.strokes[0] if group.data.get("kind") == "friction" else None
        if isinstance(circle, Circle) and abs(circle.centre - laid.on(bill.place(group.data["name"]))) > FINE:
            yield on("differs_on", plan, name=f"ρ_{group.data['name']}")


def _meshed(laid: LaidScheme, bill: ForceBill) -> bool:
    """Tell whether the wheel's circle, its pitch point and the line of action through it are drawn."""
    how, shaft = bill.expected.machine.transmission, bill.place(bill.expected.mechanism.drive.pivot)
    contact, centre = laid.on(shaft + cmath.rect(how.radius, how.at)), laid.on(shaft)
    arcs = (one for one in laid.strokes.arcs if abs(one.centre - centre) <= FINE)
    rims = (abs(one.radius - how.radius / laid.mu) <= FINE for one in arcs)
    way = bill.driving.value if bill.driving is not None else 0j
    lined = not abs(way) > 0 or bool(laid.strokes.through(contact, way, FINE))
    return any(rims) and laid.has(contact) and lined
