"""The equations of balancing with numbers put in: main points (8.7), similar contours (8.8), (8.9) (уравнения)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

from drawings.lettering.balance_letters import lowered
from drawings.page.drafting import Drafting
from drawings.report.rotor_notes import ANGLE
from plans.balance.stems import Stem, Tree
from plans.balance.weights import line_of
from plans.model.machine import Body
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import NOTHING

NO_BREAK = "\N{NO-BREAK SPACE}"
EQUALS = f"{NO_BREAK}= "  # a long equation may be broken behind it


class Moment(NamedTuple):
    """A term of m*h: the letters of the masses with their sum kg, and the letter of their arm with its vector m."""

    masses: tuple[str, ...]
    mass: float
    letter: str
    arm: complex

    @property
    def letters(self) -> str:
        """The term in letters."""
        return f"{bracketed(self.masses)}·{self.letter}"


class Loop(NamedTuple):
    """A link of the one closed contour of a mechanism, with the letter and the vector m of its length."""

    link: int
    letter: str
    length: complex


class Equations(NamedTuple):
    """The equations of a mechanism with its masses, with so many digits."""

    mechanism: Mechanism
    tree: Tree
    bodies: Mapping[int, Body]
    drafting: Drafting
    digits: int = 5

    @property
    def mass(self) -> float:
        """The mass kg of all moving links."""
        return sum(one.mass for one in self.bodies.values())

    @property
    def reach(self) -> float:
        """The size of the mechanism, m: the longest distance of a point of the frame or of a moving link's own two."""
        rows = (tuple(link.points.values()) for link in self.mechanism.links.values())
        return max((abs(one - row[0]) for row in rows for one in row), default=0.0)

    def main_points(self, vectors: Mapping[int, complex]) -> Iterator[str]:
        """Write the vector of each link's main point, m, by its masses (8.7); of a link that has no masses none."""
        for stem in self.tree.stems:
            moments = list(self._moments(stem))
            if moments:
                yield self._main_point(stem, moments, vectors[stem.link])

    def _main_point(self, stem: Stem, moments: Sequence[Moment], vector: complex) -> str:
        along = line_of(self.mechanism, stem.link, stem.begin)
        arms = [one.arm / along for one in moments]
        parts = [lowered(f"h_{stem.link}"), f"{bracketed([one.letters for one in moments])}/m"]
        if all(map(straight, arms)):  # else they are added as vectors
            told = [self._term(one.mass, arm.real) for one, arm in zip(moments, arms, strict=True)]
            parts.append(f"{bracketed(told)}/{self._number(self.mass)}")
        size = sum(one.mass * abs(one.arm) for one in moments) / self.mass
        return EQUALS.join([*parts, f"{self.vector(vector / along, size)}{NO_BREAK}{self.drafting.word('m')}"])

    def _term(self, mass: float, arm: float) -> str:
        return f"{'−' if arm < 0 else ''}{self._number(mass)}·{self._number(abs(arm))}"

    def _moments(self, stem: Stem) -> Iterator[Moment]:
        """Give the own mass of a link at its centre, then the masses behind each point on which others begin."""
        own = self.bodies.get(stem.link)
        if own is not None and own.mass and own.centre != stem.origin:
            letter = f"l_{{{stem.begin}S{stem.link}}}"
            yield Moment((f"m_{{{stem.link}}}",), own.mass, letter, own.centre - stem.origin)
        for point, links, at in self._borne(stem):
            mass = sum(self.bodies[link].mass for link in links)
            if mass and at != stem.origin:
                letters = tuple(f"m_{{{link}}}" for link in links)
                yield Moment(letters, mass, f"l_{{{stem.begin}{point}}}", at - stem.origin)

    def _borne(self, stem: Stem) -> Iterator[tuple[str, list[int], complex]]:
        """Give the points of a link on which others begin, with all links that have masses behind each."""
        followers = self.tree.followers[stem.link]
        for point in dict.fromkeys(one.begin for one in followers):
            here = [one for one in followers if one.begin == point]
            links = [link for one in here for link in self.tree.behind(one.link)]
            yield point, sorted(link for link in links if link in self.bodies), here[0].at

    @property
    def contour(self) -> tuple[Loop, ...]:
        """The links of a mechanism of one contour whose main points it is held to; of any other none."""
        stems = self.tree.stems
        chain = all(one.parent == before for one, before in zip(stems, (FRAME, *(s.link for s in stems)), strict=False))
        if len(stems) != 3 or not chain or any(one.slide is not None for one in stems):
            return ()
        loops = [Loop(one.link, one.begin + other.begin, other.at - one.origin) for one, other in pairwise(stems)]
        return (*loops, *self._closing(stems[-1]))

    def _closing(self, stem: Stem) -> Iterator[Loop]:
        """Give the last link with its hinge on the frame; a slider's contour ends before it."""
        fixed = self.mechanism.links[FRAME].points
        for point, place in self.mechanism.links[stem.link].points.items():
            if point in fixed:
                yield Loop(stem.link, stem.begin + point, place - stem.origin)

    def similar(self, vectors: Mapping[int, complex]) -> str | None:
        """Write that the contour of main points is similar to that of the links (8.8), (8.9), if it is so."""
        loops = self.contour
        ratios = [vectors[one.link] / one.length for one in loops]
        most = max(map(abs, ratios), default=0.0)
        if most <= NOTHING or any(abs(one - ratios[0]) > NOTHING * most for one in ratios):
            return None
        letters = [f"{lowered(f'h_{one.link}')}/l_{{{one.letter}}}" for one in loops]
        numbers = [f"{self._share(vectors[one.link], one.length)}/{self._number(abs(one.length))}" for one in loops]
        number = "(8.8)" if len(loops) == len(self.tree.stems) else "(8.9)"
        told = EQUALS.join([*letters, *numbers, "κ", self.vector(ratios[0], abs(ratios[0]))])
        return self.drafting.word("alike", number=number, told=told)

    def _share(self, vector: complex, length: complex) -> str:
        return self.vector(vector * abs(length) / length, abs(vector))

    def vector(self, value: complex, size: float) -> str:
        """Write a vector counted from a line of its link: along it a number, else size and direction."""
        if abs(value) <= NOTHING * size:
            return "0"
        if straight(value):
            return self._number(value.real)
        return f"{self._number(abs(value))}{ANGLE}{self._number(math.degrees(cmath.phase(value)))}°"

    def _number(self, value: float) -> str:
        return self.drafting.number(value, self.digits)


def straight(value: complex) -> bool:
    """Tell whether a vector lies along the line that it is counted from."""
    return abs(value.imag) <= NOTHING * abs(value)


def bracketed(terms: Sequence[str]) -> str:
    """Write a sum of terms, each with its own sign; in brackets if there are several.

    >>> bracketed(["2·0.04", "−4·0.1"]), bracketed(["2·0.04"])
    ('(2·0.04 − 4·0.1)', '2·0.04')
    """
    first, *rest = terms
    told = first + "".join(f" − {one[1:]}" if one.startswith("−") else f" + {one}" for one in rest)
    return f"({told})" if rest else told
