"""A rotor balanced by both roads: sums, corrections and reactions, and the sums that must vanish (сравнение)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

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
    told = *_sums(ours, theirs), *_corrections(ours, theirs), *_reactions(ours, theirs), *_left(study.rotor, ours)
    return Comparison(ours, theirs, told)


def comparison_of(study: Study) -> Comparison:
    """Compare both roads of a scene's rotor (row of the table of techniques)."""
    return compare_rotor(study["rotor"])


def _sums(ours: Balance, theirs: Balance) -> Iterator[Finding]:
    yield _finding(COUPLES, "ΣmDh", "kg*m2", ours.couple, theirs.couple)
    yield _finding(UNBALANCES, "ΣmD", "kg*m", ours.unbalance, theirs.unbalance)


def _corrections(ours: Balance, theirs: Balance) -> Iterator[Finding]:
    for one, other in zip(ours.corrections, theirs.corrections, strict=True):
        yield _finding(UNBALANCES, unbalance_letters(one.plane.name), "kg*m", one.moment, other.moment)


def _reactions(ours: Balance, theirs: Balance) -> Iterator[Finding]:
    for prime, mine, others in (("", ours.before, theirs.before), ("'", ours.after, theirs.after)):
        for bearing, one, other in zip(BEARINGS, mine, others, strict=False):
            yield _finding(REACTIONS, f"R_{bearing}{prime}", "N", one, other)


def _finding(plan: str, name: str, unit: str, one: Resultant, other: Resultant) -> Finding:
    # A polygon closes within its slack; what it is of is known from the slack, which is of the sum of its vectors.
    largest = max(one.slack, other.slack) / (ROUNDING * EPS)
    values = np.array([one.value]), np.array([other.value])
    allowed = np.array([max(one.slack, other.slack)])
    return Finding(plan, name, unit, *values, np.abs(values[0] - values[1]), allowed, largest)


def _left(rotor: Rotor, ours: Balance) -> Iterator[Finding]:
    """Sum all static moments and, of a rotor with two planes, their moments about the first: both must vanish."""
    slack = sum(one.moment.slack for one in ours.corrections)
    acting = [(moment(one), one.place) for one in rotor.masses]
    acting += [(found, one.plane.place) for found, one in zip(ours.moments, ours.corrections, strict=True)]
    yield _vanishing("ΣmD", "kg*m", [one for one, _ in acting], slack)
    if rotor.dynamic:
        first, last = (plane.place for plane in rotor.planes)
        moments = [one * float(place - first) for one, place in acting]
        yield _vanishing("ΣmDh about I", "kg*m2", moments, slack * abs(float(last - first)))


def _vanishing(name: str, unit: str, terms: Sequence[complex], slack: float) -> Finding:
    total = math.hypot(math.fsum(one.real for one in terms), math.fsum(one.imag for one in terms))
    left, largest = np.array([total]), math.fsum(map(abs, terms))
    allowed = np.array([ROUNDING * EPS * largest + slack])
    return Finding(EQUILIBRIUM, name, unit, left, 0.0 * left, left, allowed, largest)
