"""A rotor by both roads: sums, corrections, reactions, what must vanish; as numbers; by hand (сравнение)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from geometry.hand_error import SlippingHand, slopes
from geometry.steps import Span
from plans.analytic import rotor as analysis
from plans.analytic.rotor import balance, moment
from plans.checks.by_hand import MOST_SIDES, SLIP, Slipping, Told, errors_by_hand
from plans.checks.comparison import Comparison, Finding
from plans.model.rotor import (
    ANALYSIS,
    EPS,
    MILLIMETRES,
    ROUNDING,
    Balance,
    Correction,
    Resultant,
    Rotor,
    grade_of,
    letters,
    permissible,
)
from plans.rotor.balancing import COUPLES, UNBALANCES, unbalance_letters
from plans.rotor.study import BEARINGS, REACTIONS, RotorStudy

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


@dataclass(frozen=True)
class RotorNumbers:
    """What balances a rotor, by one road, and which of it is told."""

    title: str
    rotor: Rotor
    balance: Balance
    plans: frozenset[str]

    @property
    def flawed(self) -> bool:
        """Whether something has no numbers: every rotor can be balanced."""
        return False

    def plain(self) -> dict[str, Any]:
        """Give the numbers as plain data."""
        data: dict[str, Any] = {}
        if COUPLES in self.plans:
            data["couple"] = _vector(self.balance.couple)
        if UNBALANCES in self.plans:
            data["unbalance"] = _vector(self.balance.unbalance)
            data["corrections"] = {one.plane.name: _correction(one) for one in self.balance.corrections}
            data |= self._quality()
        if REACTIONS in self.plans and self.balance.before:
            data["reactions"] = {"before": _reactions(self.balance.before), "after": _reactions(self.balance.after)}
        return {"scene": self.title, "by": self.balance.by, "rotor": data}

    def _quality(self) -> dict[str, Any]:
        """Give e*omega m/s before the correction, its grade, and the unbalance kg*m that the asked grade permits."""
        rotor, before = self.rotor, self.rotor.quality(*self.balance.sizes)
        if before is None or rotor.mass is None or rotor.speed is None:
            return {}
        grade = grade_of(before)
        data: dict[str, Any] = {"before": before / MILLIMETRES, "grade": letters(grade) if grade else None}
        if rotor.grade is not None:
            data["permissible"] = permissible(rotor.grade, rotor.mass, rotor.speed)
        return {"quality": data}


def numbers(study: Study, by: str) -> RotorNumbers:
    """Balance the rotor of a scene by a road."""
    rotor = study["rotor"]
    borne = REACTIONS in study.plans
    found = analysis.balance(rotor.rotor, borne) if by == ANALYSIS else _constructed(rotor, borne)
    return RotorNumbers(study.scene.heading(), rotor.rotor, found, study.plans)


def _constructed(rotor: RotorStudy, borne: bool) -> Balance:
    return rotor.balance if borne else rotor.corrected


def _correction(one: Correction) -> dict[str, Any]:
    return {"moment": _vector(one.moment), "mass": one.mass, "radius": one.radius, "place": float(one.plane.place)}


def _reactions(found: tuple[Resultant, ...]) -> dict[str, Any]:
    return {name: _vector(one) for name, one in zip(BEARINGS, found, strict=True)}


def _vector(one: Resultant) -> dict[str, Any]:
    """Give a vector by its components, size and direction; one that vanishes has none."""
    value = 0j if one.vanishes else one.value + 0.0
    angle = None if one.angle is None else math.radians(one.angle)
    return {"vector": [value.real, value.imag], "size": one.size, "angle": angle}


def rotor_by_hand(
    rotor: RotorStudy, scales: Mapping[str, float], by: Slipping = slopes
) -> dict[tuple[str, int], float]:
    """Give what a hand may be out in the polygons that a sheet shows, by the names of the findings.

    `scales` are those of the figures, kg*m2 or kg*m a mm: "couples", "unbalances". Static moments and arms are known;
    what no figure shows, such as the reactions of bearings, is not drawn and has no error.
    """
    rows = {plan: np.array([scales[plan]]) for plan in (COUPLES, UNBALANCES) if plan in scales}
    read = {name: told for plan, name, told in _read(rotor) if plan in rows}
    found = errors_by_hand(read, SlippingHand(SLIP, rows), by)
    return {(name, 0): float(error[0]) for name, error in found.items()}


def _read(rotor: RotorStudy) -> Iterator[tuple[str, str, Told]]:
    """Give which polygon shows what: its closing vector, and of forces where the last of the masses ends."""
    drawing, planes = rotor.drawing, rotor.rotor.planes
    moments, forces = drawing.moments, drawing.forces
    if max(len(moments.sides), len(forces.sides)) > MOST_SIDES:
        return
    if rotor.rotor.dynamic:
        yield COUPLES, "ΣmDh", moments.closing
        yield COUPLES, unbalance_letters(planes[0].name), drawing.corrections[0].mark
    given = {one.mark for one in drawing.masses}
    ends = [side.end for side in forces.sides if side.vector in given]
    if ends:
        yield UNBALANCES, "ΣmD", Span(forces.board["0"], ends[-1])
    yield UNBALANCES, unbalance_letters(planes[-1].name), forces.closing
