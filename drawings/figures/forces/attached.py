"""What hangs on a cut's links beside forces: springs, friction circles (пружины, круги трения)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.forces.cut_links import CutLinks
from geometry.board import at
from plans.forces.cut import Cut
from plans.forces.force import ForcePlan
from plans.model.machine import Spring
from plans.model.mechanism import FRAME

FAR = 2.5  # sizes of a cut's links: of a longer spring only so much is drawn, else it would hide the links


class ShownSpring(NamedTuple):
    """A spring at a point of a cut: the force by its name, both ends m, the letter of the far one.

    One that is not drawn whole has no far end; `fixed` is one that is held by the frame.
    """

    name: str
    start: complex
    end: complex
    letter: str
    fixed: bool


class FrictionCircle(NamedTuple):
    """The friction circle of a hinge: its letter, and the radius f*r, m."""

    point: str
    radius: float


def springs(plan: ForcePlan, cut: Cut, links: CutLinks, column: int) -> Iterator[ShownSpring]:
    """Give the springs that act on a cut, each once."""
    places = {load.name: at(load.at.point, column) for load in cut.loads}
    for one in plan.machine.springs:
        for name, far in _ends(one):
            if name in places:
                yield _shown(plan, one, name, places[name], far, links)
                break


def _ends(one: Spring) -> Iterator[tuple[str, int]]:
    """Give the force at each moving end of a spring, with the other end."""
    moving = [k for k in (0, 1) if one.links[k] != FRAME]
    return ((one.name + ("′" if k != moving[0] else ""), 1 - k) for k in moving)


def _shown(plan: ForcePlan, one: Spring, name: str, start: complex, far: int, links: CutLinks) -> ShownSpring:
    end = at(plan.positions.point(one.points[far]).point, links.shown)
    most = FAR * links.size
    if abs(end - start) > most:
        return ShownSpring(name, start, start + (end - start) / abs(end - start) * most, "", False)
    return ShownSpring(name, start, end, one.points[far], one.links[far] == FRAME)


def circles(plan: ForcePlan, cut: Cut) -> Iterator[FrictionCircle]:
    """Give the friction circles of a cut's hinges."""
    for key, one in plan.machine.friction.items():
        radius = one.coefficient * one.radius
        links = {int(link) for link in key.split("-")}
        if radius > 0 and links & set(cut.links):
            yield from (FrictionCircle(name, radius) for name in _hinges(plan, links))


def _hinges(plan: ForcePlan, links: set[int]) -> list[str]:
    """Give the hinge that two links share."""
    first, other = (plan.mechanism.links[link].points for link in links)
    return [name for name in first if name in other and name in plan.mechanism.hinges]
