"""Instant centres of one position by Aronhold and Kennedy: three links have their three centres in one line (M3.2).

Those of pairs are known: a hinge, or at infinity, square to a slide. Any other lies where two lines of centres meet, or
at infinity along them where they are parallel.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations
from typing import NamedTuple, cast

import numpy as np

from geometry.board import Board, Mark, at
from geometry.meet import Vectors, cross
from plans.linkage import leads
from plans.linkage.plan import Plan
from plans.model.mechanism import Mechanism
from plans.words.words import because

CENTRES = "centres"
SHARP = 0.1  # sine: while there are sharper meetings, blunter ones wait
PARALLEL = 1e-9  # sine: lines that meet at a smaller angle are parallel but for roundings
ONE_PLACE = 1e-9  # of the mechanism's size: nearer points are one, and have no line

Pair = tuple[int, int]


class InstantCentre(NamedTuple):
    """A centre of two links: its place m, or at infinity the direction to it; and the links over which it was found.

    A centre of a pair is found over none.
    """

    pair: Pair
    mark: Mark
    infinite: bool = False
    over: tuple[int, ...] = ()

    @property
    def place(self) -> complex:
        """Its place m, or the direction to it."""
        return at(self.mark.point, 0)


class CentreLine(NamedTuple):
    """The line of the centres that two links have with a third; of two at infinity there is none to be drawn."""

    over: int
    ends: tuple[InstantCentre, ...]  # both; the first is not at infinity, if either is not
    along: complex  # its unit direction; 0: it lies at infinity


def pairs(links: Iterable[int]) -> list[Pair]:
    """List all pairs of links."""
    return list(combinations(sorted(links), 2))


def letter(pair: Pair) -> str:
    """Letter a centre.

    >>> letter((0, 2)), letter((9, 10))
    ('P_02', 'P_9,10')
    """
    return f"P_{pair[0]}{pair[1]}" if pair[1] < 10 else f"P_{pair[0]},{pair[1]}"


def hinge_of(mechanism: Mechanism, pair: Pair) -> str | None:
    """Give the hinge that joins two links, if one does."""
    return next((point for point, links in mechanism.hinges.items() if {*pair} <= {*links}), None)


class Kennedy:
    """The centres of a position as they are found; what two lines that are one leave open is not among them."""

    def __init__(self, plan: Plan, like: Kennedy | None = None) -> None:
        """Find them; over many positions at once `like` those of one, over the same links."""
        self.plan, self.board = plan, Board(CENTRES)
        self.found: dict[Pair, InstantCentre] = {centre.pair: centre for centre in self._known()}
        for centre in like.found.values() if like else ():
            if centre.over:
                one, two = (CentreLine(link, self._ends(centre.pair, link), 1) for link in centre.over)
                self._draw(centre.pair, one, two, centre.infinite)
        if like is not None:
            return
        places = [at(mark.point, 0) for mark in plan.letters.values()]
        self.size = max(abs(place - other) for place in places for other in places)
        every = pairs(plan.mechanism.links)
        while any(self._find(pair, least) for least in (SHARP, 0.0) for pair in every if pair not in self.found):
            pass

    def of(self, first: int, second: int) -> InstantCentre | None:
        """Give the centre of two links, if it is found."""
        return self.found.get((min(first, second), max(first, second)))

    def _known(self) -> Iterator[InstantCentre]:
        """Give the centres of the pairs: of a hinge of several links each two have one."""
        mechanism = self.plan.mechanism
        for point, links in mechanism.hinges.items():
            for pair in pairs(links):
                why = because("hinge_centre", point=point, first=pair[0], second=pair[1])
                yield InstantCentre(pair, self.board.transfer(letter(pair), self.plan.point(point), why))
        for slide in mechanism.slides:
            pair = min(slide.slider, slide.owner), max(slide.slider, slide.owner)
            along = leads.direction(self.plan, slide, slide.owner)
            yield InstantCentre(pair, self.board.turn(letter(pair), along, 1j, because("slide_centre")), True)

    def _find(self, pair: Pair, least: float) -> bool:
        """Find a centre if two lines of others tell it sharply enough; tell whether they do."""
        loci = [locus for link in self.plan.mechanism.links if (locus := self._locus(pair, link)) is not None]
        drawn = [locus for locus in loci if locus.along]
        twos = list(combinations(drawn, 2))
        sharp = [abs(float(cross(one.along, two.along))) for one, two in twos]
        if sharp and max(sharp) > max(least, PARALLEL):
            self._draw(pair, *twos[int(np.argmax(sharp))])
        elif not least and len(loci) > 1 and drawn and (len(loci) > len(drawn) or self._apart(drawn)):
            self._draw(pair, drawn[0], next(locus for locus in loci if locus is not drawn[0]), infinite=True)
        return pair in self.found

    def _draw(self, pair: Pair, first: CentreLine, second: CentreLine, infinite: bool = False) -> None:
        """Draw a centre where two lines meet, or at infinity along the first."""
        why = because("kennedy_parallel" if infinite else "kennedy", first=first.over, second=second.over)
        if infinite:
            along = self._along(first)
            mark = self.board.turn(letter(pair), along, 1.0 / cast(Vectors, np.abs(along.point)), why)
        else:
            mark = self.board.meet(letter(pair), self._line(first), self._line(second), why=why)
        self.found[pair] = InstantCentre(pair, mark, infinite, (first.over, second.over))

    def _apart(self, drawn: list[CentreLine]) -> bool:
        """Tell whether parallel lines are more than one line."""
        starts = [locus.ends[0].place - drawn[0].ends[0].place for locus in drawn]
        return any(abs(float(cross(drawn[0].along, start))) > ONE_PLACE * self.size for start in starts)

    def _along(self, locus: CentreLine) -> Mark:
        first, second = (end.mark for end in locus.ends)
        return second if locus.ends[1].infinite else self.board.join(f"{first.name}{second.name}", first, second)

    def _line(self, locus: CentreLine) -> Mark:
        first, second = (end.mark for end in locus.ends)
        return self.board.parallel(f"{first.name}{second.name}", first, self._along(locus), because("centres_in_line"))

    def _ends(self, pair: Pair, link: int) -> tuple[InstantCentre, ...]:
        """Give the centres of two links with a third, as far as they are known, those at infinity last."""
        ends = (end for one in pair if (end := self.of(one, link)) is not None)
        return tuple(sorted(ends, key=lambda end: end.infinite))

    def _locus(self, pair: Pair, link: int) -> CentreLine | None:
        """Give the line of the centres of two links with a third, if both are known and apart."""
        ends = () if link in pair else self._ends(pair, link)
        if len(ends) < 2:
            return None
        first, second = ends
        if first.infinite:
            return CentreLine(link, (first, second), 0j)
        way = second.place if second.infinite else second.place - first.place
        if not second.infinite and abs(way) <= ONE_PLACE * self.size:
            return None
        return CentreLine(link, (first, second), way / abs(way))
