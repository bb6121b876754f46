"""The forces of triads: moments about the special point, then a polygon closed along two leads (M5.9)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from geometry.board import Mark
from geometry.three_leads import GUIDE, ROD
from plans.forces import polygon
from plans.forces.cut import PART, REACTION, Couple, CutGroup, ForcePlan, Load, MomentEquation, Support, indices
from plans.forces.polygon import Split
from plans.linkage import leads
from plans.linkage.triads import Special, line_of_force
from plans.model.mechanism import Slide
from plans.model.triad import Triad, TriadLead
from plans.words.words import because


class _LeadKnown(NamedTuple):
    """What is known of a lead before its force is: a part of its outer reaction, the moment of its guide."""

    equation: MomentEquation | None
    part: Mark | None
    holding: Couple | None


def triad(plan: ForcePlan, group: Triad) -> CutGroup:
    """Find the third lead's force by moments about S of two, then close the polygon along these two (M5.9)."""
    special = Special.of(plan.positions, group)
    first, second = special.pair
    known = {lead: _known(plan, lead) for lead in group.leads}
    about = _about(plan, group, special, known)
    laid = (*_parts(known[first]), *_loads(plan, first.link)), _loads(plan, group.basis)
    third = (*_loads(plan, special.out.link), *_parts(known[special.out]), (about.found.name, about.found, PART))
    last = (*_loads(plan, second.link), *_parts(known[second]))
    chained = polygon.chain(plan, "-".join(map(str, group.links)), *laid[0], *laid[1], *third, *last)
    names = [_force_name(lead, known[lead]) for lead in (first, second)]
    lines = [_line(plan, lead, start) for lead, start in ((first, chained.start), (second, chained.end))]
    closed = polygon.close(plan, chained, (names[0], names[1]), (lines[0], lines[1]))
    at = [len(laid[0]), len(laid[0]) + len(laid[1]), len(chained.corners) - 1 - len(last)]
    corners = [chained.corners[k] for k in at]
    ends = {
        first: (closed.corner, corners[0]),
        special.out: (corners[1], corners[2]),
        second: (corners[2], closed.corner),
    }
    forces = {
        first: plan.board.join(names[0], closed.corner, chained.start, because("closing")),
        special.out: about.found,
        second: plan.board.join(names[1], chained.end, closed.corner, because("closing")),
    }
    wholes = {
        first: (closed.corner, chained.corners[len(_parts(known[first]))]),
        special.out: (chained.corners[at[2] - len(_parts(known[special.out])) - 1], corners[2]),
        second: (chained.corners[-1 - len(_parts(known[second]))], closed.corner),
    }
    supports, inner = list[Support](), list[Support]()
    for lead in group.leads:
        pressed = plan.board.join(f"R_{indices(group.basis, lead.link)}", *ends[lead][::-1], _closes(lead))
        whole = forces[lead]
        if known[lead].part is not None:
            whole = plan.board.join(_name(lead), *wholes[lead], because("both_parts"))
        outer, within = _supports(plan, group, lead, (whole, forces[lead], known[lead].part), pressed)
        supports.append(outer)
        inner.append(within)
    loads, couples = plan.acting(*group.links)
    found = (*(one.equation for one in known.values()), about, *(each.holding for each in (*supports, *inner)))
    kept = tuple(equation for equation in found if equation is not None)
    return CutGroup(
        group, group.links, tuple(loads), tuple(couples), tuple(supports), tuple(inner), kept, closed.polygon
    )


def splits(group: Triad) -> Iterator[Split]:
    """Split the outer reactions of hinges along the leads, those of stones along their slots."""
    for lead, outer, inner in zip(group.leads, group.outer_pairs, group.inner_pairs, strict=True):
        if lead.kind == ROD:
            yield Split(outer, (lead.hinge, lead.pin), "nt")
        elif lead.kind != GUIDE:
            yield Split(outer, inner, "un")


def _known(plan: ForcePlan, lead: TriadLead) -> _LeadKnown:
    if lead.kind == ROD:
        equation = polygon.tangential_part(plan, (lead.host, lead.link), (lead.hinge, lead.pin))
        return _LeadKnown(equation, equation and equation.found, None)
    if lead.kind != GUIDE:
        return _LeadKnown(None, polygon.slot_part(plan, (lead.host, lead.link), lead.slide), None)
    about, (loads, couples) = plan.positions.point(lead.pin), plan.acting(lead.link)
    terms = polygon.moments(plan, about, loads, couples)
    if not terms:
        return _LeadKnown(None, None, None)
    name = f"M_{indices(lead.host, lead.link)}"
    why = because("moments", point=about.name, link=lead.link)
    return _LeadKnown(None, None, Couple(name, lead.link, plan.board.close(name, *terms, why=why), REACTION))


def _about(plan: ForcePlan, group: Triad, special: Special, known: dict[TriadLead, _LeadKnown]) -> MomentEquation:
    """Take moments of the whole group about S, which the forces of two leads pass: they give that of the third."""
    loads, couples = plan.acting(*group.links)
    parts = [
        Load(one.part.name, lead.link, plan.positions.point(lead.hinge), one.part, PART)
        for lead, one in known.items()
        if one.part is not None
    ]
    holding = [one.holding for one in known.values() if one.holding is not None]
    acting, turning = [*parts, *loads], [*couples, *holding]
    terms = polygon.moments(plan, special.mark, acting, turning)
    line = line_of_force(plan.positions, special.out)
    why, name = because("group_moments", point=special.name), _force_name(special.out, known[special.out])
    found = plan.board.balance(name, special.mark, line, *terms, why=why)
    return MomentEquation(special.mark, tuple(acting), tuple(turning), line, found)


def _parts(known: _LeadKnown) -> list[tuple[str, Mark, str]]:
    return [] if known.part is None else [(known.part.name, known.part, PART)]


def _loads(plan: ForcePlan, link: int) -> list[tuple[str, Mark, str]]:
    return polygon.known_sides(plan.acting(link)[0])


def _line(plan: ForcePlan, lead: TriadLead, start: Mark) -> Mark:
    """Draw the line of a lead's force on the plan of forces."""
    base = plan.positions
    if lead.kind == ROD:
        along = polygon.direction_on(plan, base.arm(lead.link))
        return plan.board.parallel(f"∥{along.name}", start, along, because("along_normal", line=along.name))
    along = polygon.direction_on(plan, leads.known_direction(base, lead.slide))
    return plan.board.square(f"⊥{along.name}", start, along, because("guide_presses"))


def _name(lead: TriadLead) -> str:
    return f"R_{indices(lead.host, lead.link)}"


def _force_name(lead: TriadLead, known: _LeadKnown) -> str:
    return _name(lead) if known.part is None else _name(lead).replace("R", "R^n", 1)


def _closes(lead: TriadLead) -> object:
    return because("closes", link=lead.link)


def _supports(
    plan: ForcePlan, group: Triad, lead: TriadLead, outer: tuple[Mark, Mark, Mark | None], pressed: Mark
) -> tuple[Support, Support]:
    """Keep a lead's outer reaction and that of the basis link on it."""
    whole, force, part = outer
    loads, couples = plan.acting(lead.link)
    pair, within = (lead.host, lead.link), (group.basis, lead.link)
    parts = () if part is None else (part, force)
    if isinstance(lead.outer, Slide):
        inner = polygon.support(plan, within, lead.pin, pressed)
        loaded, _ = polygon.on_taker(inner)
        return polygon.support(plan, pair, lead.outer, whole, (), [*loads, *loaded], couples), inner
    hung = polygon.support(plan, pair, lead.outer, whole, parts)
    if isinstance(lead.inner, str):
        return hung, polygon.support(plan, within, lead.inner, pressed)
    loaded, _ = polygon.on_taker(hung)
    return hung, polygon.support(plan, within, lead.inner, pressed, (), [*loads, *loaded], couples)
