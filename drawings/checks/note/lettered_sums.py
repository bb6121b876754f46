"""The vector equations of groups in letters by the structure, what is known of each term (уравнения групп)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.checks.note.motion_legs import Leg, legs
from drawings.report.formula import Formula
from plans.linkage.study import LinkageStudy
from plans.model.dyad import Dyad
from plans.model.order import ACCELERATIONS, VELOCITIES, Order
from plans.words.words import word

FULLY, BY_WAY, UNKNOWN = 2, 1, 0  # lines under a vector
PARTS = {True: ("n", "t"), False: ("k", "r")}  # of an acceleration, of a leg that turns and of one along which is slid


class LetteredSums(NamedTuple):
    """The equations of the groups of a linkage."""

    study: LinkageStudy
    formula: Formula

    def lines(self) -> Iterator[str]:
        """Give the lines that are due before any number."""
        yield self._say("underlines")
        for group in self.study.groups:
            assert isinstance(group, Dyad)  # equations are of two-lead groups alone
            own = legs(group, self.study.mechanism)
            yield self._say("of_group", group=group.label, joints=group.kind)
            for order in (VELOCITIES, ACCELERATIONS):
                known = BY_WAY if any(leg.guided for leg in own) else UNKNOWN
                yield from (self._sum(leg, order, known) for leg in own if not leg.guided)
            yield self._say("directions", directions="; ".join(map(self._way, own)))

    def _say(self, key: str, **parts: str) -> str:
        return word(self.study.language, f"report.{key}", **parts).strip()

    def _sum(self, leg: Leg, order: Order, known: int) -> str:
        """Write a point's rate as that of its base, fully known, and its parts over it."""
        symbol, vector = order.point.symbol, self.formula.vector
        base = f"{symbol}_{{{leg.base.letters}}}"
        point = vector(f"{symbol}_{{{leg.point.letters}}}", known)
        terms = [vector(base, FULLY), *self._parts(leg, order)]
        still = rf",\quad {self.formula.letter(base)} = 0" if leg.fixed else ""
        return f"$${point} = {' + '.join(terms)}{still}$$"

    def _parts(self, leg: Leg, order: Order) -> Sequence[str]:
        vector, relative = self.formula.vector, f"_{{{leg.relative}}}"
        if order is VELOCITIES:
            return [vector(f"v{relative}", BY_WAY)]
        known, unknown = PARTS[leg.slide is None]
        return [vector(f"a^{known}{relative}", FULLY), vector(f"a^{unknown}{relative}", BY_WAY)]

    def _way(self, leg: Leg) -> str:
        """Say along what the parts of a leg go: a turning one's velocity is square to its arm."""
        vector, line = self.formula.vector, self.formula.line
        slip = vector(f"v_{{{leg.point.letters if leg.guided else leg.relative}}}")
        if leg.slide is None:
            normal = vector(f"a^n_{{{leg.relative}}}")
            return rf"${slip} \perp {line(leg.arm)}$, ${normal} \parallel {line(leg.arm)}$"
        if leg.guided:
            return word(self.study.language, "report.along", vector=f"${slip}$")
        if not leg.slide.label:
            return word(self.study.language, "report.along_link", vector=f"${slip}$", link=leg.link)
        return rf"${slip} \parallel {line(leg.slide.label)}$"
