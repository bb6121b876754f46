"""What a loading scheme shows, in true units: links, forces, moments, arms, and how the crank is driven."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from drawings.forces.acting import CutLinks, SchemeForces, acting, cut_links
from drawings.forces.lever_layout import Leverage, leverages
from geometry.board import at
from plans.forces.cut import INERTIA, WEIGHT, Cut, ForcePlan
from plans.forces.primary import action
from plans.model.machine import COUPLING, GEAR, Spring
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


WHOLE = 2.0  # cranks: of a larger wheel only a part of the pitch circle is drawn


class Wheel(NamedTuple):
    """The wheel that drives the crank: shaft, pitch radius m, direction of the pitch point rad and of the force."""

    centre: complex
    radius: float
    at: float
    action: complex
    whole: bool


@dataclass(frozen=True)
class Scheme:
    """The loading scheme of a cut in one position."""

    plan: ForcePlan
    cut: Cut
    column: int
    links: CutLinks
    acting: SchemeForces
    arms: tuple[Leverage, ...]
    wheel: Wheel | None
    springs: tuple[ShownSpring, ...] = ()
    circles: tuple[FrictionCircle, ...] = ()

    @property
    def coupled(self) -> bool:
        """Whether a coupling drives what is cut."""
        return self.cut.group is None and self.plan.machine.transmission.kind == COUPLING

    @property
    def dimensioned(self) -> list[Leverage]:
        """The arms that are drawn: one of each letter."""
        return list({arm.letter: arm for arm in reversed(self.arms) if arm.dimensioned}.values())[::-1]

    @cached_property
    def named(self) -> dict[str, complex]:
        """The points that bear letters: those of the links, and those at which other forces act."""
        others = {force.spot: force.at for force in self.acting.forces if force.spot}
        others |= {one.letter: one.end for one in self.springs if one.letter}
        return self.links.points | {name: place for name, place in others.items() if name not in self.links.points}

    @cached_property
    def centres(self) -> set[str]:
        """The letters of the mass centres that forces act at."""
        loads = (load for load in self.cut.loads if load.kind in (WEIGHT, INERTIA))
        return {self.links.name(load.at.name, at(load.at.point, self.column)) for load in loads}

    @property
    def points(self) -> list[complex]:
        """All true points that the figure must hold."""
        return [*self.solid, *(one.end for one in self.springs)]

    @property
    def solid(self) -> list[complex]:
        """The true points of all but the springs, by which the links are seen."""
        away = {one.letter for one in self.springs} - self.links.points.keys()
        places = [*(place for name, place in self.named.items() if name not in away), *self.links.slots]
        places += [arm.foot for arm in self.dimensioned]
        places += [force.at for force in self.acting.forces]
        places += self.links.feet
        if self.wheel is not None:
            wheel = self.wheel
            turns = (1, 1j, -1, -1j) if wheel.whole else ()
            places += [wheel.centre + wheel.radius * turn for turn in turns]
        return places


def scheme(plan: ForcePlan, cut: Cut, column: int) -> Scheme:
    """Gather what the loading scheme of a cut shows in one position."""
    links = cut_links(plan, cut, column)
    wheel = _wheel(plan, links) if cut.group is None else None
    loads, arms = acting(plan, cut, links, column), leverages(plan, cut, column)
    held = tuple(springs(plan, cut, links, column))
    return Scheme(plan, cut, column, links, loads, arms, wheel, held, tuple(circles(plan, cut)))


def _wheel(plan: ForcePlan, links: CutLinks) -> Wheel | None:
    how, drive = plan.machine.transmission, plan.mechanism.drive
    if how.kind != GEAR:
        return None
    shaft = links.spot(drive.pivot, links.shown)
    crank = abs(links.spot(drive.end, links.shown) - shaft)
    along = action(how, drive.omega)
    return Wheel(shaft, how.radius, how.at, along / abs(along), how.radius <= WHOLE * crank)
