"""Statics of a group: what its kinds have in common: moments, chains, closing (силовой расчёт)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from geometry.board import Mark
from plans.forces.cut import (
    CLOSING,
    KNOWN,
    PART,
    REACTION,
    Couple,
    CutGroup,
    ForcePlan,
    Load,
    MomentEquation,
    PolygonSide,
    Support,
    indices,
)
from plans.linkage import leads
from plans.model.dyad import Assur, Dyad, Pair
from plans.model.mechanism import Slide
from plans.words.words import because


class Split(NamedTuple):
    """An outer reaction that a polygon may show in two parts: along a line and square to it, with their letters.

    The line is that through two points, or that of a sliding pair.
    """

    pair: Pair
    along: tuple[str, str] | Pair
    letters: str


class ForceChain(NamedTuple):
    """Known forces laid off one after another from the start of a polygon: its corners, its sides between them."""

    corners: tuple[Mark, ...]
    sides: tuple[PolygonSide, ...]

    @property
    def start(self) -> Mark:
        """Where the chain begins."""
        return self.corners[0]

    @property
    def end(self) -> Mark:
        """Where the chain ends."""
        return self.corners[-1]


def chain(plan: ForcePlan, label: str, *forces: tuple[str, Mark, str]) -> ForceChain:
    """Lay forces off one after another; each is its name, its vector, and what it is in the polygon."""
    corners, sides = [plan.pole], []
    for number, (name, vector, kind) in enumerate(forces, 1):
        corners.append(plan.board.lay_off(f"{label}:{number}", corners[-1], vector, name))
        sides.append(PolygonSide(name, corners[-2], corners[-1], kind))
    return ForceChain(tuple(corners), tuple(sides))


def known_sides(loads: Sequence[Load]) -> list[tuple[str, Mark, str]]:
    """Give loads as the links of a chain."""
    return [(load.name, load.force, KNOWN) for load in loads]


def moments(plan: ForcePlan, about: Mark, loads: Sequence[Load], couples: Sequence[Couple]) -> list[Mark]:
    """Take the moments about a point of all forces that have an arm, and of all couples."""
    arms = [load for load in loads if load.at is not about]
    why = because("moment")
    taken = [plan.board.moment(f"{about.name}({load.name})", about, load.at, load.force, why) for load in arms]
    return [*taken, *(couple.moment for couple in couples)]


def tangential(plan: ForcePlan, dyad: Dyad, end: int) -> MomentEquation | None:
    """Find the part of an outer hinge's reaction square to a dyad's lead."""
    return tangential_part(plan, (dyad.hosts[end], dyad.links[end]), (dyad.hinge(end), dyad.pin))


def tangential_part(plan: ForcePlan, pair: tuple[int, int], hinges: tuple[str, str]) -> MomentEquation | None:
    """Find the part of an outer hinge's reaction square to its lead, by moments about the inner hinge (M5.2).

    None where nothing on the lead has a moment: its reaction runs along it.
    """
    link, index = pair[1], indices(*pair)
    base, (loads, couples) = plan.positions, plan.acting(link)
    at, about, arm = *map(base.point, hinges), base.arm(link)
    terms = moments(plan, about, loads, couples)
    if not terms:
        return None
    line = base.board.square(f"⊥{arm.name}", at, arm, because("square_tangential", line=arm.name))
    found = plan.board.balance(f"R^t_{index}", about, line, *terms, why=because("moments", point=about.name, link=link))
    return MomentEquation(about, tuple(load for load in loads if load.at is not about), tuple(couples), line, found)


def along_slot(plan: ForcePlan, dyad: Dyad) -> Mark | None:
    """Find the part of the outer reaction of a dyad's stone along its slot."""
    return slot_part(plan, (dyad.hosts[0], dyad.links[0]), dyad.slide())


def slot_part(plan: ForcePlan, pair: tuple[int, int], slide: Slide) -> Mark | None:
    """Find the part of a stone's outer reaction along the slot: the opposite of what its forces have there (M5.4).

    None where no force acts on the stone.
    """
    loads, _ = plan.acting(pair[1])
    if not loads:
        return None
    board, slot = plan.board, direction_on(plan, leads.direction(plan.positions, slide, slide.owner))
    stone = chain(plan, f"stone {pair[1]}", *known_sides(loads))
    through = board.parallel(f"∥{slot.name}", stone.end, slot, because("slot_cannot"))
    across = board.square(f"⊥{slot.name}", stone.start, slot, because("slot_square"))
    corner = board.meet(f"stone {pair[1]}", through, across, why=because("the_slot_presses"))
    return board.join(f"R^u_{indices(*pair)}", stone.end, corner, because("slot_part"))


def slot_of(plan: ForcePlan, dyad: Dyad) -> Mark:
    """Carry the direction of a group's inner slide to the plan of forces."""
    slide = dyad.slide()
    return direction_on(plan, leads.direction(plan.positions, slide, slide.owner))


def guide_of(plan: ForcePlan, dyad: Dyad, end: int) -> Mark:
    """Carry the direction of a group's outer slide to the plan of forces."""
    return direction_on(plan, leads.direction(plan.positions, dyad.slide(end), dyad.hosts[end]))


def lead_of(plan: ForcePlan, dyad: Dyad, end: int) -> Mark:
    """Carry the direction of a lead to the plan of forces."""
    return direction_on(plan, plan.positions.arm(dyad.links[end]))


def direction_on(plan: ForcePlan, direction: Mark) -> Mark:
    """Carry a direction from the plan of positions with the set square; once carried it is used again."""
    board = plan.board
    if direction.name in board and board[direction.name].step.inputs == (direction,):
        return board[direction.name]
    return board.transfer(direction.name, direction, because("transfer", plan=direction.subject))


class Closed(NamedTuple):
    """A polygon closed by two reactions of known direction: its chain, its last corner, its sides in order."""

    chain: ForceChain
    corner: Mark
    polygon: tuple[PolygonSide, ...]


def name_of(dyad: Dyad, end: int) -> str:
    """Name an outer reaction of a group: the force of the host on the link."""
    return f"R_{indices(dyad.hosts[end], dyad.links[end])}"


def normal_name(dyad: Dyad, end: int, part: Mark | None) -> str:
    """Name the closing part of an outer hinge's reaction: the whole one where it has no other part."""
    return name_of(dyad, end) if part is None else name_of(dyad, end).replace("R", "R^n", 1)


def lay_out(plan: ForcePlan, dyad: Dyad, *first: Mark | None, last: Mark | None = None) -> tuple[ForceChain, Mark]:
    """Lay off a group's forces, link after link, between the parts found before; give the corner between the links."""
    before = [(part.name, part, PART) for part in first if part is not None]
    after = [] if last is None else [(last.name, last, PART)]
    near, far = (known_sides(plan.acting(link)[0]) for link in dyad.links)
    found = chain(plan, "-".join(map(str, dyad.links)), *before, *near, *far, *after)
    return found, found.corners[len(before) + len(near)]


def close(plan: ForcePlan, chained: ForceChain, names: tuple[str, str], lines: tuple[Mark, Mark]) -> Closed:
    """Close a chain by the two lines drawn through its start and its end."""
    corner = plan.board.meet(f"{names[0]} {names[1]}", *lines, why=because("close_polygon"))
    ends = PolygonSide(names[0], corner, chained.start, CLOSING), PolygonSide(names[1], chained.end, corner, CLOSING)
    return Closed(chained, corner, (ends[0], *chained.sides, ends[1]))


def hinge_reaction(plan: ForcePlan, dyad: Dyad, end: int, found: Closed, part: Mark | None) -> Support:
    """Read an outer hinge's reaction off a closed polygon: its closing part, and the whole of it (book figure 6.15)."""
    pair, corners = (dyad.hosts[end], dyad.links[end]), found.chain.corners
    ends = (found.corner, corners[0]) if end == 0 else (corners[-1], found.corner)
    closing = plan.board.join(normal_name(dyad, end, part), *ends, because("closing"))
    if part is None:
        return support(plan, pair, dyad.hinge(end), closing)
    whole = (found.corner, corners[1]) if end == 0 else (corners[-2], found.corner)
    force = plan.board.join(name_of(dyad, end), *whole, because("both_parts"))
    return support(plan, pair, dyad.hinge(end), force, (part, closing))


def guide_reaction(plan: ForcePlan, dyad: Dyad, end: int, found: Closed, inner: Support) -> Support:
    """Read the reaction of an outer guide off a closed polygon; moments give where it acts (book figure 6.15)."""
    pair, corners = (dyad.hosts[end], dyad.links[end]), found.chain.corners
    ends = (found.corner, corners[0]) if end == 0 else (corners[-1], found.corner)
    force = plan.board.join(name_of(dyad, end), *ends, because("closing"))
    loads, couples = plan.acting(dyad.links[end])
    loaded, holding = on_taker(inner) if end == 0 else opposite(plan, inner)
    return support(plan, pair, dyad.slide(end), force, (), [*loads, *loaded], [*couples, *holding])


def across_slot(plan: ForcePlan, dyad: Dyad, part: Mark | None) -> MomentEquation | None:
    """Find the stone's outer reaction square to the slot by moments of the whole group about the pivot (M5.4)."""
    base, slide = plan.positions, dyad.slide()
    about, at = base.point(dyad.hinge(1)), base.point(dyad.hinge(0))
    loads, couples = plan.acting(*dyad.links)
    along = [] if part is None else [Load(part.name, dyad.links[0], at, part, PART)]
    terms = moments(plan, about, [*along, *loads], couples)
    if not terms:
        return None
    slot = leads.direction(base, slide, slide.owner)
    line = base.board.square(f"⊥{slot.name}", at, slot, because("slot_presses"))
    name, why = normal_name(dyad, 0, part), because("group_moments", point=about.name)
    found = plan.board.balance(name, about, line, *terms, why=why)
    armed = tuple(load for load in (*along, *loads) if load.at is not about)
    return MomentEquation(about, armed, tuple(couples), line, found)


def stone_reaction(
    plan: ForcePlan, dyad: Dyad, chained: ForceChain, across: MomentEquation | None, part: Mark | None
) -> Support:
    """Give the reaction on a stone's pin: its two parts together, or the one that there is (book figure 6.16)."""
    pair = dyad.hosts[0], dyad.links[0]
    parts = [mark for mark in (part, across and across.found) if mark is not None]
    if len(parts) == 1 and part is None:
        return support(plan, pair, dyad.hinge(0), parts[0])
    force = plan.board.join(name_of(dyad, 0), chained.start, chained.corners[len(parts)], because("both_parts"))
    return support(plan, pair, dyad.hinge(0), force, parts)


def slot_reaction(plan: ForcePlan, dyad: Dyad, force: Mark, outer: Support) -> Support:
    """Keep the pressure of a slotted link on its stone, with where it acts by the moments on the stone (M5.4)."""
    loads, couples = plan.acting(dyad.links[0])
    loaded, _ = on_taker(outer)
    return support(plan, dyad.links[::-1], dyad.slide(), force, (), [*loads, *loaded], couples)


def cut_at(plan: ForcePlan, dyad: Dyad, corner: Mark, inner: Mark) -> Mark:
    """Read the inner reaction, of the second link on the first, off a polygon: it closes the first link's forces."""
    return plan.board.join(f"R_{indices(*dyad.links[::-1])}", inner, corner, because("closes", link=dyad.links[0]))


def cut(
    plan: ForcePlan, group: Assur, supports: Sequence[Support], inner: Sequence[Support],
    equations: Sequence[MomentEquation | None], sides: Sequence[PolygonSide],
) -> CutGroup:  # fmt: skip
    """Put the group together as it was cut out."""
    loads, couples = plan.acting(*group.links)
    holding = (reaction.holding for reaction in (*supports, *inner))
    kept = tuple(equation for equation in (*equations, *holding) if equation is not None)
    return CutGroup(group, group.links, tuple(loads), tuple(couples), tuple(supports), tuple(inner), kept, tuple(sides))


def support(
    plan: ForcePlan, pair: tuple[int, int], joint: str | Slide, force: Mark, parts: Sequence[Mark] = (),
    others: Sequence[Load] = (), couples: Sequence[Couple] = (),
) -> Support:  # fmt: skip
    """Keep the reaction of one link on another; of a sliding pair with the moment that holds the taker's others."""
    if isinstance(joint, str):
        return Support(*pair, plan.positions.point(joint), force, tuple(parts), None, None, joint)
    at = plan.positions.point(joint.point)
    terms = moments(plan, at, others, couples)
    name, why = f"M_{indices(*pair)}", because("moments", point=at.name, link=pair[1])
    if not terms:
        return Support(*pair, at, force, tuple(parts), joint, None, joint.point)
    moment, armed = plan.board.close(name, *terms, why=why), tuple(load for load in others if load.at is not at)
    holding = MomentEquation(at, armed, tuple(couples), None, moment)
    return Support(*pair, at, force, tuple(parts), joint, moment, joint.point, holding)


def on_taker(reaction: Support) -> tuple[list[Load], list[Couple]]:
    """Give a reaction as a load on the link that takes it."""
    index = indices(reaction.giver, reaction.taker)
    couples = [] if reaction.moment is None else [Couple(f"M_{index}", reaction.taker, reaction.moment, REACTION)]
    return [Load(f"R_{index}", reaction.taker, reaction.at, reaction.force, REACTION)], couples


def opposite(plan: ForcePlan, inner: Support) -> tuple[list[Load], list[Couple]]:
    """Give the opposite of a group's inner reaction as a load on the link that gives it."""
    index = indices(inner.taker, inner.giver)
    force = plan.board.turn(f"R_{index}", inner.force, -1.0, because("opposite"))
    loads = [Load(f"R_{index}", inner.giver, inner.at, force, REACTION)]
    if inner.moment is None:
        return loads, []
    moment = plan.board.turn(f"M_{index}", inner.moment, -1.0, because("opposite"))
    return loads, [Couple(f"M_{index}", inner.giver, moment, REACTION)]
