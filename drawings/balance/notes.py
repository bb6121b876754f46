"""Balancing in words: equations of static moments and of counterweights, what is balanced (уравновешивание словами)."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from drawings.lettering.words import FORCE, counterweight, lowered, with_index
from drawings.page.page import Drafting
from drawings.report.formula import BAR
from drawings.report.report import ANGLE
from plans.balance.weights import Stem, Tree, line_of
from plans.forces.cut import indices
from plans.forces.drive import BALANCING
from plans.model.balance.linkage import DISC, SHARE, Balance, Counterweight, Shares, State
from plans.model.machine import Body, Machine
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import NOTHING

NO_BREAK = "\N{NO-BREAK SPACE}"
EQUALS = f"{NO_BREAK}= "  # a long equation may be broken behind it


class MomentTerm(NamedTuple):
    """A term of m*h: the letters of the masses with their sum kg, and the letter of their arm with its vector m."""

    masses: tuple[str, ...]
    mass: float
    letter: str
    arm: complex

    @property
    def letters(self) -> str:
        """The term in letters."""
        return f"{bracketed(self.masses)}·{self.letter}"


class LinkVector(NamedTuple):
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
        return sum(body.mass for body in self.bodies.values())

    @property
    def reach(self) -> float:
        """The size of the mechanism, m: the longest distance of a point of the frame or of a moving link's own two."""
        rows = (tuple(link.points.values()) for link in self.mechanism.links.values())
        return max((abs(value - row[0]) for row in rows for value in row), default=0.0)

    def main_points(self, vectors: Mapping[int, complex]) -> Iterator[str]:
        """Write the vector of each link's main point, m, by its masses; of a link that has no masses none."""
        for stem in self.tree.stems:
            moments = list(self._moments(stem))
            if moments:
                yield self._main_point(stem, moments, vectors[stem.link])

    def _main_point(self, stem: Stem, moments: Sequence[MomentTerm], vector: complex) -> str:
        along = line_of(self.mechanism, stem.link, stem.begin)
        arms = [moment.arm / along for moment in moments]
        parts = [lowered(f"h_{stem.link}"), f"{bracketed([moment.letters for moment in moments])}/m"]
        if all(map(straight, arms)):
            terms = [self._term(moment.mass, arm.real) for moment, arm in zip(moments, arms, strict=True)]
            parts.append(f"{bracketed(terms)}/{self._number(self.mass)}")
        else:  # they are added as vectors
            parts = [re.sub(r"\b[hl](?=_)", rf"\g<0>{BAR}", part) for part in parts]
        size = sum(moment.mass * abs(moment.arm) for moment in moments) / self.mass
        return EQUALS.join([*parts, self.main_point(stem, vector, size)])

    def main_point(self, stem: Stem, vector: complex, size: float) -> str:
        """Write the vector of a main point, m; its direction is counted from the line of its link."""
        points = self.mechanism.links[stem.link].points
        long, _, turned = self.vector(vector / line_of(self.mechanism, stem.link, stem.begin), size).partition(ANGLE)
        end = next((name for name, place in points.items() if place != points[stem.begin]), None)
        line = f"{stem.begin}{end}" if end else f"x_{{{stem.link}}}"
        told = f"{long}{NO_BREAK}{self.drafting.word('m')}"
        return f"{told}{ANGLE}{self.drafting.word('angle from', angle=turned, line=line)}" if turned else told

    def _term(self, mass: float, arm: float) -> str:
        return f"{'−' if arm < 0 else ''}{self._number(mass)}·{self._number(abs(arm))}"

    def _moments(self, stem: Stem) -> Iterator[MomentTerm]:
        """Give the own mass of a link at its centre, then the masses behind each point on which others begin."""
        body = self.bodies.get(stem.link)
        if body is not None and body.mass and body.centre != stem.origin:
            letter = f"l_{{{stem.begin}S{stem.link}}}"
            yield MomentTerm((f"m_{{{stem.link}}}",), body.mass, letter, body.centre - stem.origin)
        for point, links, at in self._borne(stem):
            mass = sum(self.bodies[link].mass for link in links)
            if mass and at != stem.origin:
                letters = tuple(f"m_{{{link}}}" for link in links)
                yield MomentTerm(letters, mass, f"l_{{{stem.begin}{point}}}", at - stem.origin)

    def _borne(self, stem: Stem) -> Iterator[tuple[str, list[int], complex]]:
        """Give the points of a link on which others begin, with all links that have masses behind each."""
        followers = self.tree.followers[stem.link]
        for point in dict.fromkeys(follower.begin for follower in followers):
            here = [follower for follower in followers if follower.begin == point]
            links = [link for stem in here for link in self.tree.behind(stem.link)]
            yield point, sorted(link for link in links if link in self.bodies), here[0].at

    @property
    def contour(self) -> tuple[LinkVector, ...]:
        """The links of a mechanism of one contour whose main points it is held to; of any other none."""
        stems = self.tree.stems
        chain = all(stem.parent == host for stem, host in zip(stems, (FRAME, *(s.link for s in stems)), strict=False))
        if len(stems) != 3 or not chain or any(stem.slide is not None for stem in stems):
            return ()
        pairs = pairwise(stems)
        loops = (LinkVector(one.link, one.begin + other.begin, other.at - one.origin) for one, other in pairs)
        return (*loops, *self._closing(stems[-1]))

    def _closing(self, stem: Stem) -> Iterator[LinkVector]:
        """Give the last link with its hinge on the frame; a slider's contour ends before it."""
        fixed = self.mechanism.links[FRAME].points
        for point, place in self.mechanism.links[stem.link].points.items():
            if point in fixed:
                yield LinkVector(stem.link, stem.begin + point, place - stem.origin)

    def similar(self, vectors: Mapping[int, complex]) -> str | None:
        """Write that the contour of main points is similar to that of the links, if it is so."""
        loops = self.contour
        ratios = [vectors[loop.link] / loop.length for loop in loops]
        most = max(map(abs, ratios), default=0.0)
        if most <= NOTHING or any(abs(ratio - ratios[0]) > NOTHING * most for ratio in ratios):
            return None
        letters = [f"{lowered(f'h_{loop.link}')}/l_{{{loop.letter}}}" for loop in loops]
        numbers = [f"{self._share(vectors[loop.link], loop.length)}/{self._number(abs(loop.length))}" for loop in loops]
        line = EQUALS.join([*letters, *numbers, "κ", self.vector(ratios[0], abs(ratios[0]))])
        return self.drafting.word("alike", told=line)

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
    text = first + "".join(f" − {term[1:]}" if term.startswith("−") else f" + {term}" for term in rest)
    return f"({text})" if rest else text


ALIKE = 6  # digits to which ratios must differ for one to be the larger: both roads name the same pair then
CHANGED = "\N{NO-BREAK SPACE}→\N{NO-BREAK SPACE}"


class BalanceNotes(NamedTuple):
    """The notes on a balanced mechanism by one road, with so many digits; `vectors` are m in the links' frames."""

    mechanism: Mechanism
    tree: Tree
    machine: Machine  # without counterweights
    balance: Balance
    vectors: tuple[Mapping[int, complex], Mapping[int, complex] | None]  # of main points before and after
    drafting: Drafting
    digits: int = 5

    @property
    def all(self) -> tuple[str, ...]:
        """Main points, what is put on and what it makes of them, what is left, what it costs, which share is best."""
        lines = *self.main_points(), *self.counterweights(), *self.balanced()
        return *lines, *self.left(), *self.price(), *self.choice()

    @property
    def equations(self) -> Equations:
        """The equations with numbers put in."""
        return Equations(self.mechanism, self.tree, self.machine.bodies, self.drafting, self.digits)

    def main_points(self) -> Iterator[str]:
        """Write the vectors of main points, and say of which links vectors are variable."""
        for number, line in enumerate(self.equations.main_points(self.vectors[0])):
            yield line if number else self.drafting.word("main points", told=line)
        constant = sum((self._share(stem) * stem.at for stem in self.tree.rooted), 0j)
        if abs(constant) > NOTHING * self.equations.reach:
            x, y = (self._rounded(part, abs(constant)) for part in (constant.real, constant.imag))
            yield self.drafting.word("constant main point", letter=lowered("h_0"), x=x, y=y)
        for stem in self.tree.variable:
            share = self._share(stem)
            if share:
                yield self.drafting.word("variable main point", link=stem.link, share=self._number(share))

    def _share(self, stem: Stem) -> float:
        return sum(self._body(link).mass for link in self.tree.behind(stem.link)) / self.equations.mass

    def counterweights(self) -> Iterator[str]:
        """Say what static moment each link needs, and what it is balanced by."""
        if self.balance.still:
            yield self.drafting.word("balanced already")
            return
        yield from map(self._counterweight, self.balance.counterweights)

    def _counterweight(self, weight: Counterweight) -> str:
        letter = counterweight(weight.link, self.drafting.language)
        along = line_of(self.mechanism, weight.link, weight.begin)
        if not weight.needed:
            return self.drafting.word("nothing to put on", letters=letter, link=weight.link)
        body = self._body(weight.link)
        present, put_on = body.mass * (body.centre - weight.origin) / along, weight.moment / along
        line = self._needed(weight.link, weight.begin, present, put_on, letter)
        return f"{line};  {self._sized(weight, put_on, letter)}"

    def _needed(self, link: int, point: str, there: complex, put_on: complex, letter: str) -> str:
        """Say what the static moment of a link is and what it is to be, about the point that it counts from."""
        size = abs(there) + abs(put_on)
        whole, moment = (self.equations.vector(value, size) for value in (there + put_on, put_on))
        unit, present = self.drafting.word("kg*m"), self.equations.vector(there, size)
        parts = [f"{letter}·a_{{{link}}}"]
        if straight(there) and straight(put_on) and present != "0":
            parts.append(f"{whole} + {present[1:]}" if present.startswith("−") else f"{whole} − {present}")
        line = EQUALS.join([*parts, f"{moment} {unit}"])
        needed = self.drafting.word("needed moment", link=link, point=point, own=present, due=whole, unit=unit)
        return f"{needed};  {line}"

    def _sized(self, weight: Counterweight, put_on: complex, letter: str) -> str:
        """Give mass from place or place from mass; of a sector both, with its outer radius."""
        place, word = weight.place, self.drafting.word
        moment, mass = self.equations.vector(put_on, abs(put_on)), self._number(weight.mass)
        if place.mass is not None:
            way = self.equations.vector(put_on / weight.mass, weight.distance)
            return f"a_{{{weight.link}}} = {moment}/{mass} = {way} {word('m')}"
        if place.shape == DISC:
            return f"{letter} = {self._number(abs(put_on))}/{self._number(weight.distance)} = {mass} {word('kg')}"
        sizes = {"a": weight.distance, "R": weight.outer}
        lengths = (f"{size}_{{{weight.link}}} = {self._number(value)} {word('m')}" for size, value in sizes.items())
        return ",  ".join((f"{letter} = {mass} {word('kg')}", *lengths))

    def balanced(self) -> Iterator[str]:
        """Say what the counterweights make of the main points: similar contours, and where S rests."""
        after, vectors = self.balance.loaded, self.vectors[1]
        if after is None or vectors is None:
            return
        points = self.equations.similar(vectors) or ",  ".join(self._main_points_after(vectors))
        yield self.drafting.word("with counterweights", told=points)
        known = after.around.r[np.isfinite(after.around.r)]
        if len(known) > 1 and after.path <= NOTHING * self.equations.reach:
            at = complex(known[0])
            x, y = (self._rounded(part, self.equations.reach) for part in (at.real, at.imag))
            yield self.drafting.word("rests", x=x, y=y)

    def _main_points_after(self, vectors: Mapping[int, complex]) -> Iterator[str]:
        """Write the main points with counterweights on; those that vanish together."""
        reach, none = self.equations.reach, list[str]()
        for stem in self.tree.stems:
            vector, letter = vectors[stem.link], lowered(f"h_{stem.link}")
            text = self.equations.vector(vector / line_of(self.mechanism, stem.link, stem.begin), reach)
            if text != "0":
                yield f"{letter} = {self.equations.main_point(stem, vector, reach)}"
            else:
                none.append(letter)
        if none:
            yield EQUALS.join([*none, "0"])

    def left(self) -> Iterator[str]:
        """Say what masses are left at sliders, and what share of them the crank balances."""
        for point, mass in sorted(self.balance.left.items()):
            text = self.equations.vector(mass, self.equations.mass)
            if text == "0":
                continue
            if self.balance.task.aim == SHARE and self._hangs(point):
                share = self._number(self.balance.share)
                yield self.drafting.word("share of mass", mass=text, point=point, share=share)
            else:
                yield self.drafting.word("left at slider", mass=text, point=point)

    def _hangs(self, point: str) -> bool:
        """Tell whether the rod of a slider's hinge hangs on the crank."""
        hinges, crank = self.mechanism.hinges, self.mechanism.drive.link
        rods = {link for link in hinges.get(point, ()) if link != FRAME}
        return any(crank in links and not rods.isdisjoint(links) for pin, links in hinges.items() if pin != point)

    def price(self) -> Iterator[str]:
        """Say what is put on, and how the shaft's reaction, the one that grows most and the balancing moment change."""
        before, after = self.balance.before, self.balance.loaded
        if after is None:
            return
        newtons, moments = (self.drafting.word(unit) for unit in ("N", "N*m"))
        force, moment = np.maximum(before.forces.nothing, after.forces.nothing)
        lines = [f"{self._reaction(key)}: {self._change(*two, force)} {newtons}" for key, two in self._costly(after)]
        lines.append(f"{self.balancing}: {self._change(before.balancing, after.balancing, moment)} {moments}")
        masses = {"added": self._number(self.balance.added), "mass": self._number(self.equations.mass)}
        yield self.drafting.word("price", **masses, told=",  ".join(lines))

    def _costly(self, after: State) -> Iterator[tuple[str, tuple[float, float]]]:
        """Give the largest reactions before and after of the crank's shaft, and of the pair where they grow most."""
        was, now = self.balance.before.reactions, after.reactions
        least, rows = NOTHING * self.balance.before.forces.largest, self.balance.before.forces.reactions
        links = {FRAME, self.mechanism.drive.link}
        shaft = next((key for key, row in rows.items() if {row.giver, row.taker} == links), None)
        ratios = {key: round(now[key] / was[key], ALIKE) for key in rows if was[key] > least}
        most = max((key for key, ratio in ratios.items() if ratio > 1), key=lambda key: ratios[key], default=None)
        yield from ((key, (was[key], now[key])) for key in dict.fromkeys((shaft, most)) if key is not None)

    def _reaction(self, key: str) -> str:
        reaction = self.balance.before.forces.reactions[key]
        return self.reaction(reaction.giver, reaction.taker)

    def reaction(self, giver: int, taker: int) -> str:
        """Letter the reaction of a pair as the sheet does."""
        return self.drafting.letter(with_index(f"{self.drafting.reactions}_{indices(giver, taker)}"))

    @property
    def shaft(self) -> str:
        """The letter of the reaction of the frame on the crank."""
        return self.reaction(FRAME, self.mechanism.drive.link)

    @property
    def balancing(self) -> str:
        """The letter of the balancing moment."""
        return self.drafting.letter(with_index(BALANCING))

    def _change(self, was: float, now: float, least: float) -> str:
        return CHANGED.join("0" if value <= least else self._number(value) for value in (was, now))

    def choice(self) -> Iterator[str]:
        """Say with which shares the largest shaking force and the largest reaction of the shaft are least."""
        shares = self.balance.shares
        if shares is not None:
            yield self.drafting.word("best shares", **self._best(shares))

    def _best(self, found: Shares) -> dict[str, str]:
        force, reaction = found.least_force, found.least_reaction
        shares = {"share": force.share, "other": reaction.share}
        numbers = {name: self._rounded(value, 1.0) for name, value in shares.items()}
        bare = self.balance.before.reaction(self.mechanism.drive.link)
        sizes = {"force": force.force, "reaction": reaction.reaction, "bare": bare}
        numbers |= {name: self._rounded(value, self.balance.before.forces.largest) for name, value in sizes.items()}
        return {"main": FORCE, "letters": self.shaft, **numbers}

    def _body(self, link: int) -> Body:
        return self.machine.bodies.get(link, Body(link, 0.0, 0.0, 0j))

    def _rounded(self, value: float, size: float) -> str:
        return "0" if abs(value) <= NOTHING * size else self._number(value)

    def _number(self, value: float) -> str:
        return self.drafting.number(value, self.digits)
