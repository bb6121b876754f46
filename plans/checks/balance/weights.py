"""The counterweights by both roads: static moments, masses, centres, and what stays at sliders (сравнение)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from plans.analytic.balance.counterweights import Found, counterweights, shared, sought, uncertain
from plans.analytic.balance.states import Course
from plans.balance.study import COUNTERWEIGHTS, BalanceStudy
from plans.checks.comparison import Finding
from plans.model.balance.linkage import EPS, NONE, ROUNDING, SHARE, Balance, Counterweight


class Weights:
    """What rounding allows the counterweights of a study."""

    def __init__(self, study: BalanceStudy, course: Course) -> None:
        self.study, self.mechanism = study, course.mechanism
        self.found = Found((), {}, {}, {})
        if study.task.aim != NONE:
            wanted = sought(course.mechanism, study.linkage.groups, study.task)
            self.found = counterweights(course.mechanism, course.machine, wanted)

    def slack(self, link: int) -> float:
        """Give how far the static moment kg*m of a link's counterweight may be off, by both roads."""
        need = self.study.substitution.needs.get(link)
        own = ROUNDING * EPS * need.size if need else 0.0
        return own + self.found.slack.get(link, 0.0) + (self._given if link == self.mechanism.drive.link else 0.0)

    def loose(self, point: str) -> float:
        """Give how far a mass kg that stays at a point may be off."""
        term = self.study.substitution.left.get(point)
        return self.found.loose.get(point, 0.0) + (ROUNDING * EPS * term.size if term else 0.0)

    @property
    def whole(self) -> float:
        """Give how far all static moments together may be off, kg*m."""
        return sum(map(self._off, self.study.balance.counterweights))

    def _off(self, one: Counterweight) -> float:
        """Give how far one of them may be off: its mass, too, and its centre told from the zero of the link's frame."""
        slack = self.slack(one.link)
        told = one.mass * (abs(one.centre) + abs(one.origin) - abs(one.centre - one.origin))
        return slack + abs(one.centre) * uncertain(one, slack) + 2 * EPS * told

    @property
    def _given(self) -> float:
        """How far what a share of the reciprocating mass gives the crank may be off, kg*m."""
        if self.study.task.aim != SHARE:
            return 0.0
        return abs(shared(self.mechanism, {point: self.loose(point) for point in self.found.left}))

    def findings(self, ours: Balance, theirs: Balance) -> Iterator[Finding]:
        """Compare every counterweight, and every mass that stays."""
        for one, other in zip(ours.counterweights, theirs.counterweights, strict=True):
            yield from self._of(one, other)
        largest = max((abs(mass) for mass in ours.left.values()), default=0.0)
        for point in dict.fromkeys((*ours.left, *theirs.left)):
            pair = ours.left.get(point, 0j), theirs.left.get(point, 0j)
            yield _finding(f"m_{point}", "kg", pair, self.loose(point), largest)

    def _of(self, one: Counterweight, other: Counterweight) -> Iterator[Finding]:
        slack, link = self.slack(one.link), one.link
        yield _finding(f"U_{link}", "kg*m", (one.moment, other.moment), slack, max(abs(one.moment), slack))
        off = 2 * EPS * one.mass + uncertain(one, slack)
        yield _finding(f"m_cw{link}", "kg", (one.mass, other.mass), off, one.mass)
        if one.needed and other.needed:
            place = slack / one.mass + one.distance * (4 * EPS + uncertain(one, slack) / one.mass)
            yield _finding(f"r_cw{link}", "m", (one.centre, other.centre), place, abs(one.centre) + one.distance)


def _finding(name: str, unit: str, pair: tuple[Any, Any], allowed: float, largest: float) -> Finding:
    values = np.array([pair[0]]), np.array([pair[1]])
    return Finding(COUNTERWEIGHTS, name, unit, *values, np.abs(values[0] - values[1]), np.array([allowed]), largest)
