"""Stems: how the moving links hang on each other as a tree, from the crank's shaft on (дерево звеньев; (8.7)).

A link follows the one on which its stem begins: through hinges of moving links first, breadth first; else it begins at
its hinge on the frame; what no hinge reaches begins at a slide, and its vector along the guide is variable.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from plans.model.mechanism import FRAME, Mechanism, Slide


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
    origin, at = (mechanism.links[one].points[point] for one in (link, parent))
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
    known = (FRAME, *stems)
    for parent in known:
        for slide in mechanism.slides:
            for link, other in ((slide.slider, slide.owner), (slide.owner, slide.slider)):
                if other == parent and link in left:
                    yield Stem(link, parent, slide.point, slide.way(link).through, slide.way(parent).through, slide)
