"""The links of a cut at their place, their hosts taken away: hinges are left open, sliders without their guides."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from drawings.figures.linkage.outlines import offset_foot
from drawings.figures.linkage.poses import Poses, poses
from plans.forces.cut import INERTIA, WEIGHT, Cut
from plans.forces.force import ForcePlan
from plans.model.kinetostatics import NOTHING
from plans.model.mechanism import FRAME, Link, Mechanism, Slide, Way

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
        places = {name: self.spot(name, self.shown) for name in sorted(self.numbered.points)}
        return places | {name: self.of(*mass) for name, mass in self.masses.items()}

    @cached_property
    def size(self) -> float:
        """How large the cut is: the greatest distance of its points, or how far a lone one is off, m."""
        spots = [*self.points.values(), *self.slots]
        return max(abs(one - other) for one in spots for other in spots) or self.reach

    @cached_property
    def slots(self) -> list[complex]:
        """The shown ends of slots, m: a slot reaches as far as its stone."""
        ends = [
            (slide.owner, slide.on_owner.through + along * slide.on_owner.direction)
            for slide, travel in self.travels.items()
            if slide.owner in self.links
            for along in travel
        ]
        return [self.of(link, end) for link, end in ends]

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
        held = (slide for slide in self.mechanism.slides if slide.owner == FRAME)
        return [complex(self.numbered.blocks(one)[self.shown]) for one in held if offset_foot(self, one) is not None]

    def middle(self, link: int) -> complex:
        """Give the middle of a link's points, m."""
        spots = self.mechanism.links[link].points.values()
        return sum(self.of(link, spot) for spot in spots) / len(spots)


def cut_links(plan: ForcePlan, cut: Cut, column: int) -> CutLinks:
    """Take the links of a cut out of the mechanism in one position."""
    whole = plan.mechanism
    all_poses = poses(whole, plan.positions, _count(plan, column))
    own = {link: whole.links[link] for link in cut.links}
    places = {name: complex(all_poses.points[name][column]) for link in own.values() for name in link.points}
    pins = _inner(own)
    still = {name: places[name] for name in places if name in whole.links[FRAME].points} if cut.group is None else {}
    away = {name: place for name, place in places.items() if name in whole.hinges and name not in (*pins, *still)}
    slides = [_held(slide, all_poses, column) if slide.owner not in own else slide for slide in whole.slides
              if slide.slider in own]  # fmt: skip
    links = {FRAME: Link(FRAME, still), **({AWAY: Link(AWAY, away)} if away else {}), **own}
    turns = {link: all_poses.turns.get(link, all_poses.turns[FRAME]) for link in links}
    kept = Poses(links, {name: all_poses.points[name] for name in places}, turns)
    travels = {slide: _travel(all_poses, slide) for slide in whole.slides if slide.owner in own}
    reduced = replace(whole, links=links, slides=tuple(slides))
    return CutLinks(reduced, list(cut.links), kept, column, _masses(plan, cut), travels)


def _count(plan: ForcePlan, column: int) -> int:
    """Give the number of positions of the plan: as many as the shown one asks for, where nothing moves."""
    sizes = [np.size(mark.point) for mark in plan.positions.letters.values()]
    return max([*sizes, column + 1])


def _inner(own: Mapping[int, Link]) -> set[str]:
    """Give the points that two links of the cut share."""
    first, *others = own.values()
    return {name for other in others for name in other.points if name in first.points}


def _held(slide: Slide, all_poses: Poses, column: int) -> Slide:
    """Hold a slide's line where the link that was taken away has it."""
    through = complex(all_poses.of(slide.owner, slide.on_owner.through)[column])
    return replace(slide, owner=FRAME, on_owner=Way(through, complex(all_poses.line(slide)[column])))


def _travel(all_poses: Poses, slide: Slide) -> tuple[float, float]:
    along = [float(place) for place in all_poses.along(slide) if not math.isnan(place)]
    return min(along), max(along)


def _masses(plan: ForcePlan, cut: Cut) -> dict[str, tuple[int, complex]]:
    """Give the mass centres that forces act at and no point of their link names."""
    masses = {}
    for link in sorted({load.link for load in cut.loads if load.kind in (WEIGHT, INERTIA)}):
        centre = plan.machine.bodies[link].centre
        points = plan.mechanism.links[link].points
        if centre not in points.values():
            masses[f"S{link}'" if f"S{link}" in points else f"S{link}"] = link, centre
    return masses
