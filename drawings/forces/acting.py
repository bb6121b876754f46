"""What acts on the links of a cut in one position: forces at their points, moments, the reactions that were found."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.forces.arms import largest
from drawings.forces.letters import KNOWN, PRESSING, UNKNOWN
from drawings.kinds.outlines import Poses, offset_foot, places
from drawings.kinds.polygon import ShownVector
from drawings.linkage.skeleton import poses
from geometry.board import at
from plans.forces.cut import INERTIA, REACTION, WEIGHT, CutGroup, ForcePlan, Support
from plans.forces.drive import BALANCING, DRIVING
from plans.model.mechanism import FRAME, Link, Mechanism, Slide, Way
from plans.model.motion import NOTHING

AWAY = -1  # stands for the links that were taken away: an open hinge is one with them


@dataclass(frozen=True)
class CutLinks:
    """The links of a cut in all positions of its plan, one of them shown; what they hung on is held where it is."""

    mechanism: Mechanism
    links: list[int]
    numbered: Poses
    shown: int
    masses: Mapping[str, tuple[int, complex]]
    travels: Mapping[Slide, tuple[float, float]]

    def spot(self, name: str, position: int) -> complex:
        """Give a point's place."""
        return complex(self.numbered.points[name][position])

    def of(self, link: int, spot: complex) -> complex:
        """Give the shown place of a spot that is fixed in a link."""
        return complex(self.numbered.of(link, spot)[self.shown])

    @cached_property
    def reach(self) -> float:
        """How far the cut's points come from the drive's fixed hinge, m."""
        return max(abs(self.spot(name, self.shown)) for name in self.numbered.points)

    @cached_property
    def points(self) -> dict[str, complex]:
        """The shown places of the named points and the mass centres, m."""
        return places(self)

    @cached_property
    def size(self) -> float:
        """How large the cut is: the greatest distance of its points, or how far a lone one is off, m."""
        spots = [*self.points.values(), *self.slots]
        return max(abs(spot - other) for spot in spots for other in spots) or self.reach

    @cached_property
    def slots(self) -> list[complex]:
        """The shown ends of slots, m: a slot reaches as far as its stone."""
        ends = ((slide.owner, slide.on_owner, end) for slide, travel in self.travels.items() for end in travel)
        return [self.of(link, way.through + along * way.direction) for link, way, along in ends]

    def name(self, mark: str, place: complex) -> str:
        """Give the letter of a place: the mark's own, or that of the point that lies there."""
        here = [name for name, spot in self.points.items() if abs(spot - place) <= NOTHING * self.reach]
        return mark if mark in here else next(iter(here), mark)

    @property
    def guides(self) -> Iterator[tuple[complex, complex]]:
        """The pairs that slid on links taken away: place and unit direction of the common line."""
        for slide in self.mechanism.slides:
            if slide.owner == FRAME:
                yield complex(self.numbered.blocks(slide)[self.shown]), slide.on_owner.direction

    @property
    def feet(self) -> list[complex]:
        """The shown places of blocks that stand off their points, on guides beside these."""
        slides = [s for s in self.mechanism.slides if s.owner == FRAME and offset_foot(self, s) is not None]
        return [complex(self.numbered.blocks(slide)[self.shown]) for slide in slides]

    def middle(self, link: int) -> complex:
        """Give the middle of a link's points, m."""
        spots = self.mechanism.links[link].points.values()
        return sum(self.of(link, spot) for spot in spots) / len(spots)


def cut_links(plan: ForcePlan, cut: CutGroup, column: int) -> CutLinks:
    """Take the links of a cut out of the mechanism in one position."""
    whole = plan.mechanism
    # The number of positions of the plan: as many as the shown one asks for, where nothing moves
    sizes = [np.size(mark.point) for mark in plan.positions.letters.values()]
    all_poses = poses(whole, plan.positions, max([*sizes, column + 1]))
    cut_off = {link: whole.links[link] for link in cut.links}
    places = {name: complex(all_poses.points[name][column]) for link in cut_off.values() for name in link.points}
    first, *others = cut_off.values()
    pins = {name for other in others for name in other.points if name in first.points}
    still = {name: places[name] for name in places if name in whole.links[FRAME].points} if cut.group is None else {}
    away = {name: place for name, place in places.items() if name in whole.hinges and name not in (*pins, *still)}
    slides = [_held(slide, all_poses, column) if slide.owner not in cut_off else slide for slide in whole.slides
              if slide.slider in cut_off]  # fmt: skip
    links = {FRAME: Link(FRAME, still), **({AWAY: Link(AWAY, away)} if away else {}), **cut_off}
    turns = {link: all_poses.turns.get(link, all_poses.turns[FRAME]) for link in links}
    kept = Poses(links, {name: all_poses.points[name] for name in places}, turns)
    ways = {slide: all_poses.along(slide) for slide in whole.slides if slide.owner in cut_off}
    travels = {slide: (float(np.nanmin(way)), float(np.nanmax(way))) for slide, way in ways.items()}
    reduced = replace(whole, links=links, slides=tuple(slides))
    return CutLinks(reduced, list(cut.links), kept, column, _masses(plan, cut), travels)


def _held(slide: Slide, all_poses: Poses, column: int) -> Slide:
    through = complex(all_poses.of(slide.owner, slide.on_owner.through)[column])
    return slide._replace(owner=FRAME, on_owner=Way(through, complex(all_poses.line(slide)[column])))


def _masses(plan: ForcePlan, cut: CutGroup) -> dict[str, tuple[int, complex]]:
    """Give the mass centres that forces act at and no point of their link names."""
    masses = {}
    for link in sorted({load.link for load in cut.loads if load.kind in (WEIGHT, INERTIA)}):
        centre = plan.machine.bodies[link].centre
        points = plan.mechanism.links[link].points
        if centre not in points.values():
            masses[f"S{link}'" if f"S{link}" in points else f"S{link}"] = link, centre
    return masses


FAR = 0.5  # of the size of the cut's links: a guide's reaction further off is drawn at the slider, beside its moment


class ShownMoment(NamedTuple):
    """A moment on a link about a place m, +1 counter-clockwise, -1 clockwise."""

    name: str
    at: complex
    sense: int


class GuideShift(NamedTuple):
    """How far from its slider's point a guide's reaction acts: two places on the guide's line m, and its value N."""

    name: str
    start: complex
    end: complex
    value: complex


class SchemeForces(NamedTuple):
    """All forces and moments on the links of a cut, and the distances along guides at which reactions act."""

    forces: tuple[ShownVector, ...]
    moments: tuple[ShownMoment, ...]
    shifts: tuple[GuideShift, ...]


def acting(plan: ForcePlan, cut: CutGroup, links: CutLinks, column: int) -> SchemeForces:
    """List what acts on a cut in one position; what is zero there is left out."""
    least = NOTHING * largest(plan, column)
    forces = list[ShownVector]()
    for load in cut.loads:
        place = at(load.at.point, column)
        letter = links.name(load.at.name, place)
        forces.append(ShownVector(load.name, KNOWN, place, at(load.force.point, column), letter))
    moments = list(_couples(plan, cut, links, column))
    shifts: list[GuideShift] = []
    for support in cut.supports:
        if support.slide is None:
            # A hinge's by its parts, or whole where it has none
            place, name = at(support.at.point, column), support.at.name
            parts = support.parts or (support.force,)
            forces += (ShownVector(part.name, UNKNOWN, place, at(part.point, column), name) for part in parts)
        else:
            pressed = _guide(support, links, column, least)
            forces.append(pressed[0])
            moments += pressed[1]
            shifts += pressed[2]
    if cut.group is None:
        forces += _driving(plan, column)
    kept = tuple(force for force in forces if abs(force.value) > least)
    return SchemeForces(kept, tuple(moments), tuple(shifts))


def _couples(plan: ForcePlan, cut: CutGroup, links: CutLinks, column: int) -> Iterator[ShownMoment]:
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
        yield ShownMoment(BALANCING, shaft, 1 if size > 0 else -1)


def _guide(
    support: Support, links: CutLinks, column: int, least: float
) -> tuple[ShownVector, list[ShownMoment], list[GuideShift]]:  # fmt: skip
    """Give the reaction of a guide where it acts; one that acts far off, at the slider's point with its moment."""
    assert support.slide is not None
    value, point = at(support.force.point, column), at(support.at.point, column)
    # The guide's line is that of the cut's own link.
    link = support.slide.slider if support.slide.slider in links.links else support.slide.owner
    way, pose = support.slide.way(link), links.numbered
    place, along = links.of(link, way.through), complex(pose.turns[link][links.shown] * way.direction)
    foot = place + along * ((point - place) * along.conjugate()).real
    turning = 0.0 if support.moment is None else at(support.moment.point, column).real
    across = (along.conjugate() * value).imag
    force = ShownVector(support.force.name, PRESSING, foot, value)
    arm = turning / across if abs(across) > least else 0.0
    if abs(turning) <= least * links.reach:
        return force, [], []
    if abs(across) <= least or abs(arm) > FAR * links.size:
        name = support.force.name.replace("R", "M", 1)
        return force, [ShownMoment(name, foot, 1 if turning > 0 else -1)], []
    end = foot + along * arm
    return force._replace(at=end), [], [GuideShift(support.force.name.replace("R", "x", 1), foot, end, value)]


def _driving(plan: ForcePlan, column: int) -> Iterator[ShownVector]:
    if plan.drive is not None and plan.driven is not None:
        spot = plan.driven.name if plan.driven.name in plan.positions.letters else ""
        place = at(plan.driven.point, column)
        yield ShownVector(DRIVING, UNKNOWN, place, at(plan.drive.point, column), spot)
