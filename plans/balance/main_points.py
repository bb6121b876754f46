"""The main points of a mechanism: of each link the vector h, fixed in it, that its turning gives the mass centre (8.7).

m*h of a link is the sum of two kinds of static moments about its beginning: of its own mass at its mass centre, and of
the masses of all links that follow, at the point where they begin (метод главных точек).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import NamedTuple

from geometry.board import Board, Mark
from plans.balance.stems import Stem, Tree
from plans.balance.sums import Sums, Term
from plans.model.machine import Body
from plans.words.words import because

MAIN = "main_points"  # the board of the vectors h, m
EMPTY = Body(0, 0.0, 0.0, 0j)


class Share(NamedTuple):
    """A stem on the frame or at a slide, and the share of the whole mass that follows it."""

    stem: Stem
    share: float


class MainPoints:
    """The vectors h of all links, each in its own frame, with the masses that they are made of."""

    def __init__(self, tree: Tree, bodies: Mapping[int, Body]) -> None:
        self.tree, self.bodies, self.sums = tree, bodies, Sums()
        self.board = Board(MAIN)
        self._behind: dict[int, Term] = {}
        self.masses = {
            stem.link: self.sums.mass(f"m_{stem.link}", self.body(stem.link).mass, because("own_mass", link=stem.link))
            for stem in tree.stems
        }
        self.moments = {stem.link: self._moment(stem) for stem in reversed(tree.stems)}
        self.marks = {stem.link: self._vector(stem.link) for stem in tree.stems}

    def body(self, link: int) -> Body:
        """Give a link's mass; one that the scene gives none has none."""
        return self.bodies.get(link, EMPTY)

    @cached_property
    def mass(self) -> float:
        """The mass kg of all moving links."""
        return float(self.behind_all.value.real)

    @cached_property
    def behind_all(self) -> Term:
        """The mass of all moving links, laid off end to end."""
        return self.sums.total("m", self.masses.values(), self.sums.no_mass, because("all_links"))

    def behind(self, link: int) -> Term:
        """Give the mass of a link with all that follow it, summed once."""
        if link not in self._behind:
            links = list(self.tree.behind(link))
            name, terms = "m_" + "+".join(map(str, links)), [self.masses[one] for one in links]
            self._behind[link] = self.sums.total(name, terms, self.sums.no_mass, because("follow"))
        return self._behind[link]

    def _moment(self, stem: Stem) -> Term:
        """Sum the static moments about a link's beginning."""
        name, why = f"mh_{stem.link}", because("main_moment", link=stem.link, point=stem.begin)
        return self.sums.total(name, self._terms(stem), self.sums.no_moment, why)

    def _terms(self, stem: Stem) -> Iterator[Term]:
        link, sums = stem.link, self.sums
        own, centre = self.masses[link], f"S{link}"
        arm = sums.arm(f"{stem.begin}{centre}", stem.origin, self.body(link).centre, link)
        yield sums.moment(f"m_{link}·{arm.name}", own, arm, because("own_moment", link=link))
        for other in self.tree.followers[link]:
            mass = self.behind(other.link)
            arm = sums.arm(f"{stem.begin}{other.begin}", stem.origin, other.at, link)
            why = because("follower_moment", link=other.link, point=other.begin)
            yield sums.moment(f"{mass.mark.name}·{arm.name}", mass, arm, why)

    def _vector(self, link: int) -> Mark:
        return self.board.turn(f"h_{link}", self.moments[link].mark, 1 / self.mass, because("over_mass"))

    def line(self, link: int, span: complex) -> Mark:
        """Lay down a vector of a link in its own frame, to which its vector h is fixed."""
        return self.sums.arm(f"l_{link}", 0j, span, link)

    @property
    def vectors(self) -> dict[int, complex]:
        """The vector h of each link in its own frame, m; of one whose moments are rounding none."""
        return {link: 0j if self.moments[link].vanishes else complex(mark.point) for link, mark in self.marks.items()}

    @property
    def constant(self) -> complex:
        """What hinges and guides of the frame give the mass centre, m from the datum: the same in all positions."""
        return sum((one.share * one.stem.at for one in self._shares(self.tree.rooted)), 0j)

    @property
    def variables(self) -> tuple[Share, ...]:
        """The stems that begin at slides, with their shares: their vectors along guides are variable."""
        return tuple(self._shares(self.tree.variable))

    def _shares(self, stems: tuple[Stem, ...]) -> Iterator[Share]:
        return (Share(stem, float(self.behind(stem.link).value.real) / self.mass) for stem in stems)
