"""A counterweight by its static moment, and the tree of links that hang on each other (противовес, дерево звеньев)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from plans.balance.sums import SumTerm
from plans.model.balance.linkage import EPS, ROUNDING, BalanceTask, Counterweight, Site
from plans.model.dyad import Assur, Dyad
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.scene.faults import SceneError
from plans.scene.scene import Scene

NEEDED, FREE, CARRIED, NO_MASS = "needs_counterweight", "slides_on_frame", "slides_on_link", "rod_without_mass"
NEGATIVE, OFF, IDLE = "negative_counterweight", "counterweight_off_line", "idle_counterweight"
NO_SHARE = "no_reciprocating"
AIMED = (FREE, CARRIED, NO_SHARE)  # kinds that the aim is at fault for


class Unmade(Exception):  # noqa: N818  (it says what was done)
    """A balance that cannot be: the kind of fault, the link whose counterweight it is about, its key and details."""

    def __init__(self, kind: str, at: int | None = None, key: str = "on", **details: object) -> None:
        super().__init__(kind)
        self.kind, self.at, self.key, self.details = kind, at, key, details

    def fault(self, scene: Scene, task: BalanceTask) -> SceneError:
        """Say it at the key of the scene that is to be changed."""
        index = next((k for k, place in enumerate(task.places) if place.link == self.at), None)
        if index is not None:
            return SceneError([scene.fault(("balance", "counterweights", index, self.key), self.kind, **self.details)])
        key = "aim" if self.kind in AIMED else "counterweights"
        path = ("balance", key) if scene.has(("balance", key)) else ("balance",)
        return SceneError([scene.fault(path, self.kind, **self.details)])


def begins(mechanism: Mechanism, groups: Sequence[Assur]) -> Mapping[int, str]:
    """Give by link the point that its counterweight counts from: toward the frame, in its group the outer hinge.

    A link without one, guided as a slider is, turns nothing against its mass and carries none.
    """
    found = {mechanism.drive.link: mechanism.drive.pivot}
    for group in groups:
        assert isinstance(group, Dyad)  # the only groups that a mechanism is broken into
        found |= {link: joint for link, joint in zip(group.links, group.outer, strict=True) if isinstance(joint, str)}
    return found


def weight_of(mechanism: Mechanism, place: Site, begin: str, need: SumTerm) -> Counterweight:
    """Give the counterweight of a static moment kg*m in its link's frame about the point that it counts from."""
    origin = mechanism.links[place.link].points[begin]
    mass = _mass(place, need, begin, line_of(mechanism, place.link, begin))
    return Counterweight(place, begin, origin, need.value + 0, mass)  # of a zero no -0


def line_of(mechanism: Mechanism, link: int, begin: str) -> complex:
    """Give the unit direction of a link's line in its own frame: from where it begins to the first of its other points.

    A link of one point, such as a block, has its own +x axis.
    """
    points = mechanism.links[link].points
    ways = (place - points[begin] for point, place in points.items() if place != points[begin])
    way = next(ways, 1 + 0j)
    return way / abs(way)


def _mass(place: Site, need: SumTerm, begin: str, along: complex) -> float:
    if place.mass is not None:
        return place.mass
    if place.radius is not None:
        return abs(need.value) / place.radius
    return _sector(place, abs(need.value)) if place.at is None else _on_line(place, place.at, need, begin, along)


def _on_line(place: Site, at: float, need: SumTerm, begin: str, along: complex) -> float:
    """Find the mass at a place on the link's line, on which the static moment must lie."""
    across, way = (need.value / along).imag, (need.value / along).real
    if abs(across) > ROUNDING * EPS * need.size:
        angle = math.degrees(math.atan2(across, way))
        raise Unmade(OFF, place.link, "at", angle=f"{angle:.4g}", radius=f"{abs(at):.6g}")
    if way / at < 0:
        mass, other = f"{abs(way / at):.6g}", f"{-at:.6g}"
        raise Unmade(NEGATIVE, place.link, "at", mass=mass, point=begin, other=other)
    return way / at


def _sector(place: Site, moment: float) -> float:
    """Find the mass of a sector with its apex where the link begins: m*r = 2/3 density thickness sin(half angle) R3."""
    solid = place.density * place.thickness
    outer = math.cbrt(1.5 * moment / (solid * math.sin(place.half_angle)))
    return solid * place.half_angle * outer**2


class Stem(NamedTuple):
    """Where a link begins: the letter of the point, its place in the link, and its place in the link that it follows.

    Of one that begins at a slide the two places are two points of the guide, apart by the variable vector.
    """

    link: int
    parent: int
    begin: str
    origin: complex  # m, in the link's own frame
    at: complex  # m, in the parent's own frame; of the frame from the datum
    slide: Slide | None = None


@dataclass(frozen=True)
class Tree:
    """The stems of all moving links, each after the one that it follows."""

    stems: tuple[Stem, ...]

    @cached_property
    def followers(self) -> Mapping[int, tuple[Stem, ...]]:
        """The stems that begin on each link, the frame among them."""
        parents = (FRAME, *(stem.link for stem in self.stems))
        return {link: tuple(stem for stem in self.stems if stem.parent == link) for link in parents}

    @property
    def variable(self) -> tuple[Stem, ...]:
        """The stems whose vectors along guides are variable."""
        return tuple(stem for stem in self.stems if stem.slide is not None)

    @property
    def rooted(self) -> tuple[Stem, ...]:
        """The stems that begin at hinges of the frame, or where its guides do."""
        return tuple(stem for stem in self.stems if stem.parent == FRAME)

    def behind(self, link: int) -> Iterator[int]:
        """Give a link and all that follow it."""
        yield link
        for stem in self.followers[link]:
            yield from self.behind(stem.link)


def tree_of(mechanism: Mechanism) -> Tree:
    """Grow the tree of a mechanism's moving links."""
    stems: dict[int, Stem] = {}
    drive = mechanism.drive
    _grow(mechanism, stems, _hinged(mechanism, drive.link, FRAME, drive.pivot))
    while left := [link for link in sorted(mechanism.links) if link != FRAME and link not in stems]:
        _grow(mechanism, stems, _root(mechanism, stems, left))
    return Tree(tuple(stems.values()))


def _grow(mechanism: Mechanism, stems: dict[int, Stem], root: Stem) -> None:
    """Put down a root and all that hangs on it by hinges, breadth first."""
    stems[root.link] = root
    waiting = [root.link]
    while waiting:
        parent = waiting.pop(0)
        for point in mechanism.links[parent].points:
            for link in mechanism.hinges.get(point, ()):
                if link != FRAME and link not in stems:
                    stems[link] = _hinged(mechanism, link, parent, point)
                    waiting.append(link)


def _hinged(mechanism: Mechanism, link: int, parent: int, point: str) -> Stem:
    origin, at = (mechanism.links[body].points[point] for body in (link, parent))
    return Stem(link, parent, point, origin, at)


def _root(mechanism: Mechanism, stems: Mapping[int, Stem], left: Sequence[int]) -> Stem:
    """Give the next root: a link hinged on the frame, or else one that slides on what is there already."""
    fixed = mechanism.links[FRAME].points
    for link in left:
        point = next((point for point in mechanism.links[link].points if point in fixed), None)
        if point is not None:
            return _hinged(mechanism, link, FRAME, point)
    return next(_sliding(mechanism, stems, left))


def _sliding(mechanism: Mechanism, stems: Mapping[int, Stem], left: Sequence[int]) -> Iterator[Stem]:
    """Give the links that slide on the frame, then those that slide on others that are there."""
    for parent in (FRAME, *stems):
        for slide in mechanism.slides:
            for link, other in ((slide.slider, slide.owner), (slide.owner, slide.slider)):
                if other == parent and link in left:
                    yield Stem(link, parent, slide.point, slide.way(link).through, slide.way(parent).through, slide)
