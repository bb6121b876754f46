"""What acts on the links of a cut in one position: forces at their points, moments, the reactions that were found."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from drawings.figures.forces.cut_links import CutLinks
from drawings.figures.forces.force_kinds import KNOWN, PRESSING, UNKNOWN
from drawings.figures.forces.leverage import largest
from drawings.symbols.polygon import ShownVector
from geometry.board import at
from plans.forces.cut import REACTION, Cut, Support
from plans.forces.force import ForcePlan
from plans.forces.primary import BALANCING, DRIVING
from plans.model.kinetostatics import NOTHING
from plans.model.mechanism import Slide

FAR = 0.5  # of the size of the cut's links: a guide's reaction further off is drawn at the slider, beside its moment


class ShownMoment(NamedTuple):
    """A moment on a link about a place m, +1 counter-clockwise, -1 clockwise."""

    name: str
    at: complex
    sense: int
    unknown: bool = False


class Shift(NamedTuple):
    """How far from its slider's point a guide's reaction acts: two places on the guide's line m, and its value N."""

    name: str
    start: complex
    end: complex
    value: complex


class SchemeForces(NamedTuple):
    """All forces and moments on the links of a cut, and the distances along guides at which reactions act."""

    forces: tuple[ShownVector, ...]
    moments: tuple[ShownMoment, ...]
    shifts: tuple[Shift, ...]


def acting(plan: ForcePlan, cut: Cut, links: CutLinks, column: int) -> SchemeForces:
    """List what acts on a cut in one position; what is zero there is left out."""
    least = NOTHING * largest(plan, column)
    forces = list[ShownVector]()
    for load in cut.loads:
        place = at(load.at.point, column)
        letter = links.name(load.at.name, place)
        forces.append(ShownVector(load.name, KNOWN, place, at(load.force.point, column), letter))
    moments = list(_couples(plan, cut, links, column))
    shifts: list[Shift] = []
    for support in cut.supports:
        if support.slide is None:
            forces += _hinge(support, column)
        else:
            pressed = _guide(support, links, column, least)
            forces.append(pressed[0])
            moments += pressed[1]
            shifts += pressed[2]
    if cut.group is None:
        forces += _driving(plan, column)
    kept = tuple(force for force in forces if abs(force.value) > least)
    return SchemeForces(kept, tuple(moments), tuple(shifts))


def _couples(plan: ForcePlan, cut: Cut, links: CutLinks, column: int) -> Iterator[ShownMoment]:
    """Give the known moments at the mass centres of their links, and those of pairs at their points."""
    handed = {load.name.replace("R", "M", 1): load for load in cut.loads if load.kind == REACTION}
    for couple in cut.couples:
        size = at(couple.moment.point, column).real
        if abs(size) > NOTHING * largest(plan, column) * links.reach:
            body = plan.machine.bodies.get(couple.link)
            middle = links.middle(couple.link) if body is None else links.of(couple.link, body.centre)
            place = at(handed[couple.name].at.point, column) if couple.name in handed else middle
            yield ShownMoment(couple.name, place, 1 if size > 0 else -1)
    if cut.group is None and plan.drive is None and plan.mechanism.drive.ram is None:
        size = at(plan.balancing.point, column).real
        shaft = at(plan.positions.point(plan.mechanism.drive.pivot).point, column)
        yield ShownMoment(BALANCING, shaft, 1 if size > 0 else -1, unknown=True)


def _hinge(support: Support, column: int) -> Iterator[ShownVector]:
    """Give the reaction of a hinge by its parts, or whole where it has none."""
    place = at(support.at.point, column)
    for one in support.parts or (support.force,):
        yield ShownVector(one.name, UNKNOWN, place, at(one.point, column), support.at.name)


def _guide(
    support: Support, links: CutLinks, column: int, least: float
) -> tuple[ShownVector, list[ShownMoment], list[Shift]]:  # fmt: skip
    """Give the reaction of a guide where it acts; one that acts far off, at the slider's point with its moment."""
    assert support.slide is not None
    value, point = at(support.force.point, column), at(support.at.point, column)
    place, along = _line(support.slide, links)
    foot = place + along * ((point - place) * along.conjugate()).real
    turning = 0.0 if support.moment is None else at(support.moment.point, column).real
    across = (along.conjugate() * value).imag
    force = ShownVector(support.force.name, PRESSING, foot, value)
    arm = turning / across if abs(across) > least else 0.0
    if abs(turning) <= least * links.reach:
        return force, [], []
    if abs(across) <= least or abs(arm) > FAR * links.size:
        name = support.force.name.replace("R", "M", 1)
        return force, [ShownMoment(name, foot, 1 if turning > 0 else -1, unknown=True)], []
    end = foot + along * arm
    return force._replace(at=end), [], [Shift(support.force.name.replace("R", "x", 1), foot, end, value)]


def _line(slide: Slide, links: CutLinks) -> tuple[complex, complex]:
    """Give a place on a slide's line, and its unit direction, both as the cut's own link has them."""
    link = slide.slider if slide.slider in links.links else slide.owner
    way, pose = slide.way(link), links.numbered
    return links.of(link, way.through), complex(pose.turns[link][links.shown] * way.direction)


def _driving(plan: ForcePlan, column: int) -> Iterator[ShownVector]:
    """Give the force that drives the crank, if one does."""
    if plan.drive is not None and plan.driven is not None:
        spot = plan.driven.name if plan.driven.name in plan.positions.letters else ""
        place = at(plan.driven.point, column)
        yield ShownVector(DRIVING, UNKNOWN, place, at(plan.drive.point, column), spot)
