"""A first position under construction, and the scene that is measured off it (первое положение)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import product
from math import degrees
from typing import NamedTuple

from plans.model.mechanism import FRAME

# The drive's fixed hinge and the crank's end are O and A; P, the pole's own letter, is a point like any other.
LETTERS = [letter + number for number, letter in product(["", "1", "2", "3", "4"], "OABCDEFGHKLMNPQRSTUVW")]


class Guide(NamedTuple):
    """A sliding pair: the slider and its point, the owner and two points of its line, or a line of the frame."""

    slider: int
    point: str
    owner: int
    line: tuple[str, str] | None
    through: complex = 0j
    way: complex = 1 + 0j


@dataclass
class Pose:
    """Links with their points, places of points, m, and the sliding pairs; the frame is link 0."""

    links: dict[int, list[str]] = field(default_factory=dict)
    turns: dict[int, complex] = field(default_factory=dict)  # of a link with one point: the direction of its +x
    places: dict[str, complex] = field(default_factory=dict)
    guides: list[Guide] = field(default_factory=list)
    by_lengths: set[tuple[int, str]] = field(default_factory=set)  # points of a link placed by two lengths
    kinds: list[str] = field(default_factory=list)  # of the dyads, in the order in which they were hung

    def link(self, turn: float) -> int:
        """Begin a link."""
        number = len(self.links)
        self.links[number] = []
        self.turns[number] = cmath.exp(1j * turn)
        return number

    def point(self, place: complex, *links: int) -> str:
        """Mark a point of some links: of two of them, a hinge. Places are whole tenths of a millimetre."""
        name = LETTERS[len(self.places)]
        self.places[name] = complex(round(place.real, 4), round(place.imag, 4))
        for link in links:
            self.links[link].append(name)
        return name

    def way(self, link: int) -> complex:
        """Give the direction of a link's +x axis: to its second point."""
        if link == FRAME:
            return 1 + 0j
        if len(self.links[link]) < 2:
            return self.turns[link]
        first, second = (self.places[name] for name in self.links[link][:2])
        return (second - first) / abs(second - first)

    def tables(self) -> Iterator[str]:
        """Write the tables of frame, links, lengths, points and slides."""
        yield "[mechanism.frame]"
        yield from (f"{name} = {_pair(self.places[name])}" for name in self.links[FRAME])
        yield "[mechanism.links]"
        yield from (f"{link} = {_list(names)}" for link, names in self.links.items() if link != FRAME)
        yield "[mechanism.lengths]"
        yield from (f"{key} = {length:.4f}" for key, length in self._lengths().items())
        yield "[mechanism.points]"
        yield from self._points()
        for guide in self.guides:
            yield from self._guide(guide)

    def _lengths(self) -> dict[str, float]:
        found = {}
        for link, names in self.links.items():
            pairs = [names[:2]] if len(names) > 1 else []
            pairs += [[base, name] for name in names[2:] for base in names[:2] if (link, name) in self.by_lengths]
            found |= {f"{a}{b}": abs(self.places[a] - self.places[b]) for a, b in pairs if link != FRAME}
        return found

    def _points(self) -> Iterator[str]:
        for link, names in self.links.items():
            for name in names[2:] if link != FRAME else ():
                if (link, name) not in self.by_lengths:
                    at = (self.places[name] - self.places[names[0]]) / self.way(link)
                    yield f"{name} = {{ on = {link}, at = {_pair(at)} }}"

    def _guide(self, guide: Guide) -> Iterator[str]:
        if guide.line is None:
            through, way = guide.through, guide.way
            along = f"{{ through = {_pair(through)}, angle = {degrees(cmath.phase(way)):.2f} }}"
        else:
            through, end = (self.places[name] for name in guide.line)
            way, along = (end - through) / abs(end - through), f'"{"".join(guide.line)}"'
        offset = ((self.places[guide.point] - through) / way).imag
        angle = degrees(cmath.phase(self.way(guide.slider) / way))
        yield from ("[[mechanism.slides]]", f"link = {guide.slider}", f'point = "{guide.point}"', f"along = {along}")
        yield f"offset = {offset:.4f}\nangle = {angle:.2f}"


def _pair(place: complex) -> str:
    return f"[{place.real:.4f}, {place.imag:.4f}]"


def _list(names: list[str]) -> str:
    return '"' + "".join(names) + '"'
