"""The forces of triads: moments about the special point, then a polygon closed along two leads (M5.9)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import accumulate, chain
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

    @property
    def parts(self) -> list[tuple[str, Mark, str]]:
        """The part as the link of a chain."""
        return [] if self.part is None else [(self.part.name, self.part, PART)]


class _LeadSides(NamedTuple):
    """A lead's part of the polygon: between which corners all its forces lie, and its outer ones; that along it."""

    all: tuple[Mark, Mark]
    outer: tuple[Mark, Mark]
    along: Mark


def triad(plan: ForcePlan, group: Triad) -> CutGroup:
    """Find the third lead's force by moments about S of two, then close the polygon along these two (M5.9)."""
    special = Special.of(plan.positions, group)
    known = {lead: _lead_moments(plan, lead) for lead in group.leads}
    about = _about_special(plan, group, special, known)
    closed, sides = _polygon(plan, group, special, known, about)
    found = [_reactions(plan, group, lead, known[lead].part, sides[lead]) for lead in group.leads]
    supports, inner = zip(*found, strict=True)
    return polygon.cut(plan, group, supports, inner, [*(one.equation for one in known.values()), about], closed.polygon)


def splits(group: Triad) -> Iterator[Split]:
    """Split the outer reactions of hinges along the leads, those of stones along their slots."""
    for lead, outer, inner in zip(group.leads, group.outer_pairs, group.inner_pairs, strict=True):
        if lead.kind == ROD:
            yield Split(outer, (lead.hinge, lead.pin), "nt")
        elif lead.kind != GUIDE:
            yield Split(outer, inner, "un")


def _lead_moments(plan: ForcePlan, lead: TriadLead) -> _LeadKnown:
    """Take the moments about a lead's inner hinge; of a stone the forces along its slot."""
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


def _about_special(
    plan: ForcePlan, group: Triad, special: Special, known: dict[TriadLead, _LeadKnown]
) -> MomentEquation:
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


def _polygon(
    plan: ForcePlan, group: Triad, special: Special, known: dict[TriadLead, _LeadKnown], about: MomentEquation
) -> tuple[polygon.Closed, dict[TriadLead, _LeadSides]]:
    """Lay off the first lead's forces, the basis link's, the third's and the second's; close along first and second."""
    (first, second), third = special.pair, special.out
    loads = {link: polygon.known_sides(plan.acting(link)[0]) for link in group.links}
    laid = [
        [*known[first].parts, *loads[first.link]],
        loads[group.basis],
        [*loads[third.link], *known[third].parts, (about.found.name, about.found, PART)],
        [*loads[second.link], *known[second].parts],
    ]
    chained = polygon.chain(plan, "-".join(map(str, group.links)), *chain.from_iterable(laid))
    names = _force_name(first, known[first]), _force_name(second, known[second])
    lines = _line(plan, first, chained.start), _line(plan, second, chained.end)
    closed = polygon.close(plan, chained, names, lines)
    one, two, three = list(accumulate(map(len, laid)))[:3]
    corners, parts = chained.corners, {lead: len(known[lead].parts) for lead in group.leads}
    met, end, why = closed.corner, corners[three], because("closing")
    begun = plan.board.join(names[0], met, chained.start, why)
    ended = plan.board.join(names[1], chained.end, met, why)
    return closed, {
        first: _LeadSides((met, corners[one]), (met, corners[parts[first]]), begun),
        third: _LeadSides((corners[two], end), (corners[three - 1 - parts[third]], end), about.found),
        second: _LeadSides((end, met), (corners[-1 - parts[second]], met), ended),
    }


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


def _reactions(
    plan: ForcePlan, group: Triad, lead: TriadLead, part: Mark | None, sides: _LeadSides
) -> tuple[Support, Support]:
    """Close the lead's forces by that of the basis link on it; keep this and its outer reaction."""
    name, whole = f"R_{indices(group.basis, lead.link)}", sides.along
    pressed = plan.board.join(name, *sides.all[::-1], because("closes", link=lead.link))
    if part is not None:
        whole = plan.board.join(_name(lead), *sides.outer, because("both_parts"))
    parts = () if part is None else (part, sides.along)
    loads, couples = plan.acting(lead.link)
    pair, within = (lead.host, lead.link), (group.basis, lead.link)
    if isinstance(lead.outer, Slide):
        inner = polygon.support(plan, within, lead.pin, pressed)
        loaded, _ = polygon.on_taker(inner)
        return polygon.support(plan, pair, lead.outer, whole, (), [*loads, *loaded], couples), inner
    hung = polygon.support(plan, pair, lead.outer, whole, parts)
    if isinstance(lead.inner, str):
        return hung, polygon.support(plan, within, lead.inner, pressed)
    loaded, _ = polygon.on_taker(hung)
    return hung, polygon.support(plan, within, lead.inner, pressed, (), [*loads, *loaded], couples)
