"""The forces of the five dyads, each by its own construction, and the table of them (силовой расчёт групп)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, Generic, NamedTuple, TypeVar

from plans.forces import polygon, triads
from plans.forces.cut import CLOSING, CutGroup, ForcePlan, PolygonSide
from plans.forces.polygon import Split
from plans.model.dyad import Dyad
from plans.words.words import because

Of = TypeVar("Of")  # what groups of the kind are, such as dyads


def rrr(plan: ForcePlan, dyad: Dyad) -> CutGroup:
    """Find the tangential parts by moments about B, then close the polygon along both leads (M5.2)."""
    board, (first, second) = plan.board, dyad.links
    equations = [polygon.tangential(plan, dyad, end) for end in (0, 1)]
    parts = [equation and equation.found for equation in equations]
    chain, inner = polygon.lay_out(plan, dyad, parts[0], last=parts[1])
    lines = []
    for end, start in enumerate((chain.start, chain.end)):
        lead = polygon.lead_of(plan, dyad, end)
        lines.append(board.parallel(f"∥{lead.name}", start, lead, because("along_normal", line=lead.name)))
    names = [polygon.normal_name(dyad, end, parts[end]) for end in (0, 1)]
    closed = polygon.close(plan, chain, (names[0], names[1]), (lines[0], lines[1]))
    supports = [polygon.hinge_reaction(plan, dyad, end, closed, parts[end]) for end in (0, 1)]
    pin = polygon.support(plan, (second, first), dyad.pin, polygon.cut_at(plan, dyad, closed.corner, inner))
    return polygon.cut(plan, dyad, supports, [pin], equations, closed.polygon)


def rrp(plan: ForcePlan, dyad: Dyad) -> CutGroup:
    """Find the tangential part by moments about B, then close along the rod and square to the guide (M5.3)."""
    board, (rod, slider) = plan.board, dyad.links
    equation = polygon.tangential(plan, dyad, 0)
    part = equation and equation.found
    chain, inner = polygon.lay_out(plan, dyad, part)
    lead, along = polygon.lead_of(plan, dyad, 0), polygon.guide_of(plan, dyad, 1)
    normal = board.parallel(f"∥{lead.name}", chain.start, lead, because("along_normal", line=lead.name))
    lines = normal, board.square(f"⊥{along.name}", chain.end, along, because("guide_presses"))
    names = polygon.normal_name(dyad, 0, part), polygon.name_of(dyad, 1)
    closed = polygon.close(plan, chain, names, lines)
    pin = polygon.support(plan, (slider, rod), dyad.pin, polygon.cut_at(plan, dyad, closed.corner, inner))
    supports = [polygon.hinge_reaction(plan, dyad, 0, closed, part), polygon.guide_reaction(plan, dyad, 1, closed, pin)]
    return polygon.cut(plan, dyad, supports, [pin], [equation], closed.polygon)


def rpr(plan: ForcePlan, dyad: Dyad) -> CutGroup:
    """Find the pin's part along the slot, then the one square to it by moments about C, and close in C (M5.4)."""
    part = polygon.along_slot(plan, dyad)
    across = polygon.across_slot(plan, dyad, part)
    chain, inner = polygon.lay_out(plan, dyad, part, across and across.found)
    name = polygon.name_of(dyad, 1)
    force = plan.board.join(name, chain.end, chain.start, because("closing"))
    pivot = polygon.support(plan, (dyad.hosts[1], dyad.links[1]), dyad.hinge(1), force)
    pin = polygon.stone_reaction(plan, dyad, chain, across, part)
    slotted = polygon.slot_reaction(plan, dyad, polygon.cut_at(plan, dyad, chain.start, inner), pin)
    sides = *chain.sides, PolygonSide(name, chain.end, chain.start, CLOSING)
    return polygon.cut(plan, dyad, [pin, pivot], [slotted], [across], sides)


def prp(plan: ForcePlan, dyad: Dyad) -> CutGroup:
    """Close the polygon of all forces square to both guides; the pin's moments give their moments (M5.5)."""
    chain, inner = polygon.lay_out(plan, dyad)
    guides = polygon.guide_of(plan, dyad, 0), polygon.guide_of(plan, dyad, 1)
    ends, why = zip(guides, (chain.start, chain.end), strict=True), because("guide_presses")
    lines = [plan.board.square(f"⊥{along.name}", start, along, why) for along, start in ends]
    names = polygon.name_of(dyad, 0), polygon.name_of(dyad, 1)
    closed = polygon.close(plan, chain, names, (lines[0], lines[1]))
    pin = polygon.support(plan, dyad.links[::-1], dyad.pin, polygon.cut_at(plan, dyad, closed.corner, inner))
    supports = [polygon.guide_reaction(plan, dyad, end, closed, pin) for end in (0, 1)]
    return polygon.cut(plan, dyad, supports, [pin], [], closed.polygon)


def rpp(plan: ForcePlan, dyad: Dyad) -> CutGroup:
    """Find the pin's part along the slot, then close square to the slot and square to the guide (M5.6)."""
    board = plan.board
    part = polygon.along_slot(plan, dyad)
    chain, inner = polygon.lay_out(plan, dyad, part)
    slot, along = polygon.slot_of(plan, dyad), polygon.guide_of(plan, dyad, 1)
    across = board.square(f"⊥{slot.name}", chain.start, slot, because("slot_presses"))
    lines = across, board.square(f"⊥{along.name}", chain.end, along, because("guide_presses"))
    names = polygon.normal_name(dyad, 0, part), polygon.name_of(dyad, 1)
    closed = polygon.close(plan, chain, names, lines)
    pin = polygon.hinge_reaction(plan, dyad, 0, closed, part)
    slotted = polygon.slot_reaction(plan, dyad, polygon.cut_at(plan, dyad, closed.corner, inner), pin)
    supports = [pin, polygon.guide_reaction(plan, dyad, 1, closed, slotted)]
    return polygon.cut(plan, dyad, supports, [slotted], [], closed.polygon)


def leads(dyad: Dyad) -> Iterator[Split]:
    """Split the reactions of outer hinges along the leads: normal and tangential parts."""
    for outer in dyad.outer_pairs:
        if isinstance(outer.joint, str):
            yield Split(outer, (outer.joint, dyad.pin), "nt")


def stone(dyad: Dyad) -> Iterator[Split]:
    """Split the reaction of a stone's hinge along the slot and square to it."""
    yield Split(dyad.outer_pairs[0], dyad.inner_pairs[0], "un")


class ForceKind(NamedTuple, Generic[Of]):
    """The forces of one kind of group: its construction, and which outer reactions that may show in parts."""

    cut: Callable[[ForcePlan, Of], CutGroup]
    splits: Callable[[Of], Iterable[Split]]


# A new kind of group has a row here, and one in plans/linkage/dyads.py.
GROUP_FORCES: Mapping[str, ForceKind[Any]] = {
    "RRR": ForceKind(rrr, leads),
    "RRP": ForceKind(rrp, leads),
    "RPR": ForceKind(rpr, stone),
    "PRP": ForceKind(prp, leads),
    "RPP": ForceKind(rpp, stone),
    "triad": ForceKind(triads.triad, triads.splits),
}
