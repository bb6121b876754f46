"""What must be told of vectors of main points: (8.7) with its numbers, similar contours (8.8), (8.9) (ожидание)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

from drawings.checks.balance.balance_expected import Expected
from drawings.checks.balance_words.sentences import TURNS, number
from drawings.checks.precise import KNOWN
from drawings.figures.balance.scheme import AFTER, BEFORE
from plans.balance.weights import line_of
from plans.model.kinetostatics import NOTHING
from plans.model.mechanism import FRAME

EQUALS = " = "
ANGLE = "\N{NO-BREAK SPACE}∠\N{NO-BREAK SPACE}"


class Borne(NamedTuple):
    """Masses that act on a link in one place: the letter of its arm, the arm m, and kg by links."""

    letter: str
    arm: complex
    masses: Mapping[int, float]

    @property
    def mass(self) -> float:
        """Their sum, kg."""
        return math.fsum(self.masses.values())


class MainPoints:
    """The sentences on main points by the analysis, with so many digits."""

    def __init__(self, expected: Expected, digits: int) -> None:
        self.expected, self.digits = expected, digits
        self.stems = {one.link: one for one in expected.own.tree.stems}
        self.bodies = {one.link: one for one in expected.solid(BEFORE)}
        self.mass = math.fsum(one.mass for one in self.bodies.values())

    @cached_property
    def reach(self) -> float:
        """The size of the mechanism, m: the farthest that a point of a link lies from the first of its own."""
        links = self.expected.mechanism.links.values()
        return max(abs(one - next(iter(own.points.values()))) for own in links for one in own.points.values())

    def number(self, value: float, size: float = 0.0) -> str:
        """Put in a number, which may be out as the largest of its kind is rounded."""
        return number(value, KNOWN * max(abs(value), size), self.digits)

    def vector(self, value: complex, size: float) -> str:
        """Put in a vector counted from a line of its link; what is nothing beside a size is 0."""
        if abs(value) <= NOTHING * size:
            return "0"
        if straight(value):
            return self.number(value.real, size)
        turned = math.degrees(cmath.phase(value))
        slack = math.degrees(KNOWN * size / abs(value))
        return f"{self.number(abs(value), size)}{ANGLE}{number(turned, slack, self.digits, TURNS)}°"

    def path(self, link: int) -> list[int]:
        """List a link and those that bear it, down to the frame."""
        found = []
        while link != FRAME:
            found.append(link)
            link = self.stems[link].parent
        return found

    def share(self, link: int) -> float:
        """Give the share of the whole mass that hangs on a link, its own with it."""
        return math.fsum(one.mass for one in self.bodies.values() if link in self.path(one.link)) / self.mass

    def told(self) -> Iterator[str]:
        """Give the equations of all links, the constant vector, the variable ones."""
        word = self.expected.drafting.word
        lines = [self._equation(link) for link in self.stems if any(True for _ in self._borne(link))]
        yield from [word("main points", told=lines[0]), *lines[1:]] if lines else []
        constant = sum((self.share(one.link) * one.at for one in self.stems.values() if one.parent == FRAME), 0j)
        if abs(constant) > NOTHING * self.reach:
            x, y = (self.number(part, abs(constant)) for part in (constant.real, constant.imag))
            yield word("constant main point", letter="h_{0}", x=x, y=y)
        for one in self.stems.values():
            share = 0.0 if one.slide is None else self.share(one.link)
            if share:
                yield word("variable main point", link=one.link, share=self.number(share))

    def _borne(self, link: int) -> Iterator[Borne]:
        """Give what acts on a link: its own mass, then at each of its points all masses that hang there."""
        stem, own = self.stems[link], self.bodies.get(link)
        if own is not None and own.mass and own.centre != stem.origin:
            yield Borne(f"l_{{{stem.begin}S{link}}}", own.centre - stem.origin, {link: own.mass})
        hung: dict[str, tuple[complex, dict[int, float]]] = {}
        for one in (one for one in self.stems.values() if one.parent == link):
            behind = {key: body.mass for key, body in self.bodies.items() if one.link in self.path(key)}
            hung.setdefault(one.begin, (one.at - stem.origin, {}))[1].update(behind)
        for point, (arm, masses) in hung.items():
            if arm and any(masses.values()):
                yield Borne(f"l_{{{stem.begin}{point}}}", arm, dict(sorted(masses.items())))

    def _equation(self, link: int) -> str:
        """Give (8.7) of a link in letters, in numbers where all lies along it, and what it comes to."""
        along, terms = self.along(link), list(self._borne(link))
        letters = [f"{_sum([f'm_{{{k}}}' for k in one.masses])}·{one.letter}" for one in terms]
        parts = [f"h_{{{link}}}", f"{_sum(letters)}/m"]
        if all(straight(one.arm / along) for one in terms):
            signed = [("−" if (one.arm / along).real < 0 else "") + self._product(one) for one in terms]
            parts.append(f"{_sum(signed)}/{self.number(self.mass)}")
        value = sum(one.mass * one.arm for one in terms) / self.mass / along
        size = math.fsum(one.mass * abs(one.arm) for one in terms) / self.mass
        return EQUALS.join([*parts, f"{self.vector(value, size)} {self.expected.drafting.word('m')}"])

    def _product(self, one: Borne) -> str:
        return f"{self.number(one.mass)}·{self.number(abs(one.arm))}"

    def along(self, link: int) -> complex:
        """Give the line of a link from where it begins, as a direction in its own frame."""
        return line_of(self.expected.mechanism, link, self.stems[link].begin)

    def after(self) -> str:
        """Tell what the counterweights make of the vectors: contours that are similar, or each vector."""
        vectors, none = self.expected.vectors(AFTER), []
        found = self._similar(vectors)
        if found is not None:
            return found
        told = []
        for link, value in vectors.items():
            if abs(value) <= NOTHING * self.reach:
                none.append(f"h_{{{link}}}")
            else:
                vector = self.vector(value / self.along(link), self.reach)
                told.append(f"h_{{{link}}} = {vector} {self.expected.drafting.word('m')}")
        return ",  ".join([*told, *([EQUALS.join([*none, "0"])] if none else [])])

    def _similar(self, vectors: Mapping[int, complex]) -> str | None:
        """Tell that main points and links make similar contours, where all ratios are one."""
        sides = dict(self._contour())
        ratios = {link: vectors[link] / side for link, (_, side) in sides.items()}
        most = max(map(abs, ratios.values()), default=0.0)
        first = next(iter(ratios.values()), 0j)
        if most <= NOTHING or any(abs(one - first) > NOTHING * most for one in ratios.values()):
            return None
        letters = [f"h_{{{link}}}/l_{{{letter}}}" for link, (letter, _) in sides.items()]
        numbers = [self._ratio(ratios[link], abs(side)) for link, (_, side) in sides.items()]
        told = EQUALS.join([*letters, *numbers, "κ", self.vector(first, abs(first))])
        which = "(8.8)" if len(sides) == len(self.stems) else "(8.9)"
        return self.expected.drafting.word("alike", number=which, told=told)

    def _ratio(self, ratio: complex, length: float) -> str:
        return f"{self.vector(ratio * length, abs(ratio) * length)}/{self.number(length)}"

    def _contour(self) -> Iterator[tuple[int, tuple[str, complex]]]:
        """Give the links of one closed chain of three with the letters and vectors of their lengths."""
        links, stems = list(self.stems), list(self.stems.values())
        hung = [one.parent for one in stems] == [FRAME, *links[:-1]]
        if len(links) != 3 or not hung or any(one.slide is not None for one in stems):
            return
        for one, other in pairwise(stems):
            yield one.link, (f"{one.begin}{other.begin}", other.at - one.origin)
        last, fixed = stems[-1], self.expected.mechanism.links[FRAME].points
        for point, place in self.expected.mechanism.links[last.link].points.items():
            if point in fixed:
                yield last.link, (f"{last.begin}{point}", place - last.origin)


def straight(value: complex) -> bool:
    """Tell whether a vector lies along the line that it is counted from."""
    return abs(value.imag) <= NOTHING * abs(value)


def _sum(terms: list[str]) -> str:
    """Write a sum, in brackets if it has several terms."""
    told = " + ".join(terms).replace("+ −", "− ")
    return f"({told})" if len(terms) > 1 else told
