"""Links and joints of a structure as they are drawn: whole, or those of one group alone (звенья и пары схемы)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from drawings.kinds.outlines import Poses, is_centre
from plans.model.mechanism import FRAME, Link, Mechanism, Slide, Way
from plans.model.structure import CONTACT, SLIDING, TURNING, AssurGroup, Joint, Structure
from plans.structure.study import StructureStudy


@dataclass(frozen=True, eq=False, repr=False)
class ShownLinks:
    """Some links of a structure in its shown position, each measured in the frame; no mass centre is among them."""

    mechanism: Mechanism
    links: list[int]
    joints: tuple[Joint, ...]

    shown = 0

    @cached_property
    def numbered(self) -> Poses:
        """The one pose."""
        places = {name: spot for link in self.mechanism.links.values() for name, spot in link.points.items()}
        points = {name: np.array([spot]) for name, spot in places.items()}
        turns = {number: np.array([1 + 0j]) for number in self.mechanism.links}
        return Poses(self.mechanism.links, points, turns)

    @property
    def points(self) -> list[complex]:
        """All places that a figure of them must hold, m."""
        spots = [complex(spot[0]) for spot in self.numbered.points.values()]
        rims = [(centre.at, abs(centre.at - joint.at)) for joint in self.joints for centre in joint.centres]
        round_ = [middle + radius * way for middle, radius in rims for way in (1, 1j, -1, -1j)]
        return [*spots, *round_, *(joint.at for joint in self.joints if joint.nature != TURNING)]

    @property
    def reach(self) -> float:
        """Their size, m."""
        return max(abs(spot - other) for spot in self.points for other in self.points)

    @property
    def masses(self) -> Mapping[str, tuple[int, complex]]:
        """No mass centre is shown."""
        return {}

    @property
    def travels(self) -> Mapping[Slide, tuple[float, float]]:
        """How far blocks come: one position is shown."""
        return dict.fromkeys(self.mechanism.slides, (0.0, 0.0))

    def spot(self, name: str, position: int) -> complex:
        """Give a point's place."""
        return complex(self.numbered.points[name][position])


def whole(study: StructureStudy, structure: Structure, fixed: str = "") -> ShownLinks:
    """Show all links of a structure, as they are or replaced; also a fixed point that places are measured from."""
    found = _shown(study, structure, structure.joints, structure.links)
    held = found.mechanism.links[FRAME].points
    extra = {name: place for name, place in study.pose.points.items() if name == fixed and name not in held}
    links = {**found.mechanism.links, FRAME: Link(FRAME, {**held, **extra})}
    return replace(found, mechanism=replace(found.mechanism, links=links))


def primary(study: StructureStudy, link: int) -> ShownLinks:
    """Show a primary link on the frame."""
    joints = (joint for joint in study.plain.joints if {FRAME, link} <= {*joint.links} and joint.nature != CONTACT)
    return _shown(study, study.plain, [joint._replace(links=(FRAME, link)) for joint in joints], (link,))


def group(study: StructureStudy, shown: AssurGroup, known: Iterable[int]) -> ShownLinks:
    """Show a group by itself; it hangs on links that are known, which are not shown."""
    return _shown(study, study.plain, [_cut(joint, {*shown.links}, {*known}) for joint in shown.joints], shown.links)


def _cut(joint: Joint, links: set[int], known: set[int]) -> Joint:
    """Let a joint with known links be one with the frame; others hang on it later."""
    own = tuple(link for link in joint.links if link in links)
    return joint._replace(links=own if known.isdisjoint(joint.links) else (FRAME, *own))


def _shown(study: StructureStudy, structure: Structure, joints: Iterable[Joint], links: Sequence[int]) -> ShownLinks:
    kept = tuple(joints)
    points = {FRAME: dict[str, complex](), **{link: dict(_own(study, structure, link)) for link in links}}
    for joint in (joint for joint in kept if joint.nature == TURNING):
        for link in joint.links:
            points[link][joint.letter] = joint.at
    slides = tuple(_slide(joint, points) for joint in kept if joint.nature == SLIDING)
    shapes = {link: Link(link, spots) for link, spots in points.items()}
    return ShownLinks(replace(study.mechanism, links=shapes, slides=slides, sketch={}), list(links), kept)


def _own(study: StructureStudy, structure: Structure, link: int) -> Iterator[tuple[str, complex]]:
    """Give the points of a link, those too that it has for others than are shown."""
    known = study.mechanism.links.get(link)
    names = (name for name in (known.points if known else ()) if not is_centre(name))
    yield from ((name, study.pose.points[name]) for name in names)
    hung = (joint for joint in structure.joints if joint.nature == TURNING and link in joint.links)
    yield from ((joint.letter, joint.at) for joint in hung)


def _slide(joint: Joint, points: Mapping[int, dict[str, complex]]) -> Slide:
    """Give a slide: the link that has its letter's point slides on the other."""
    first, other = joint.links
    slider, owner = (first, other) if first != FRAME and joint.letter in points[first] else (other, first)
    points[slider].setdefault(joint.letter, joint.at)
    way = Way(joint.at, joint.along)
    return Slide(slider, owner, way, way, joint.letter, "")
