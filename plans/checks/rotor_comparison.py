"""A rotor balanced by both roads: sums, corrections and reactions, and the sums that must vanish (сравнение)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from plans.analytic.rotor import balance, moment
from plans.checks.comparison import Comparison, Finding
from plans.model.rotor import EPS, ROUNDING, Balance, Resultant, Rotor
from plans.rotor.balancing import COUPLES, UNBALANCES
from plans.rotor.bearings import BEARINGS, REACTIONS
from plans.rotor.letters import unbalance_letters
from plans.rotor.study import RotorStudy

if TYPE_CHECKING:
    from plans.study import Study

EQUILIBRIUM = "equilibrium"


def compare_rotor(study: RotorStudy) -> Comparison:
    """Balance a rotor by analysis too, and put every quantity beside that of the construction."""
    ours, theirs = study.balance, balance(study.rotor)
    both = _Compared(study.rotor, ours, theirs)
    return Comparison(ours, theirs, (*both.sums(), *both.corrections(), *both.reactions(), *both.left()))


def comparison_of(study: Study) -> Comparison:
    """Compare both roads of a scene's rotor (row of the table of techniques)."""
    return compare_rotor(study["rotor"])


class _Compared(NamedTuple):
    """A rotor balanced by both roads."""

    rotor: Rotor
    ours: Balance
    theirs: Balance

    def sums(self) -> Iterator[Finding]:
        """Compare what is unbalanced."""
        yield _finding(COUPLES, "ΣmDh", "kg*m2", self.ours.couple, self.theirs.couple, self._largest_moment)
        yield _finding(UNBALANCES, "ΣmD", "kg*m", self.ours.unbalance, self.theirs.unbalance, self._largest_mass)

    def corrections(self) -> Iterator[Finding]:
        """Compare the counterweights."""
        for one, other in zip(self.ours.corrections, self.theirs.corrections, strict=True):
            name = unbalance_letters(one.plane.name)
            yield _finding(UNBALANCES, name, "kg*m", one.moment, other.moment, self._largest)

    def reactions(self) -> Iterator[Finding]:
        """Compare what the bearings bear, before and after."""
        found = (*self.ours.before, *self.ours.after)
        largest = max((abs(one.value) for one in found), default=0.0)
        names = (f"R_{bearing}{prime}" for prime in ("", "'") for bearing in BEARINGS)
        for name, one, other in zip(names, found, (*self.theirs.before, *self.theirs.after), strict=False):
            yield _finding(REACTIONS, name, "N", one, other, largest)

    def left(self) -> Iterator[Finding]:
        """Sum all static moments and, of a rotor with two planes, their moments about the first: both must vanish."""
        corrections = self.ours.corrections
        slack = sum(one.moment.slack for one in corrections)
        acting = [(moment(one), one.place) for one in self.rotor.masses]
        acting += [(found, one.plane.place) for found, one in zip(self.ours.moments, corrections, strict=True)]
        yield _vanishing("ΣmD", "kg*m", [one for one, _ in acting], slack)
        if self.rotor.dynamic:
            first, last = (plane.place for plane in self.rotor.planes)
            moments = [one * float(place - first) for one, place in acting]
            yield _vanishing("ΣmDh", "kg*m2", moments, slack * abs(float(last - first)))

    @property
    def _largest_mass(self) -> float:
        """The largest static moment kg*m that is to be balanced."""
        return max(one.moment for one in self.rotor.masses)

    @property
    def _largest(self) -> float:
        """The largest static moment kg*m of the polygon of forces."""
        return max(self._largest_mass, *(abs(one.moment.value) for one in self.ours.corrections))

    @property
    def _largest_moment(self) -> float:
        """The largest vector kg*m2 of the polygon of moments."""
        return max(one.moment * abs(self.rotor.arm(one.place)) for one in self.rotor.masses)


def _finding(plan: str, name: str, unit: str, one: Resultant, other: Resultant, largest: float) -> Finding:
    values = np.array([one.value]), np.array([other.value])
    allowed = np.array([max(one.slack, other.slack)])
    return Finding(plan, name, unit, *values, np.abs(values[0] - values[1]), allowed, largest)


def _vanishing(name: str, unit: str, terms: Sequence[complex], slack: float) -> Finding:
    total = math.hypot(math.fsum(one.real for one in terms), math.fsum(one.imag for one in terms))
    left, sizes = np.array([total]), [abs(one) for one in terms]
    allowed = np.array([ROUNDING * EPS * math.fsum(sizes) + slack])
    return Finding(EQUILIBRIUM, name, unit, left, 0.0 * left, left, allowed, max(sizes))
