"""A rotor by both roads: sums, corrections, reactions, what must vanish; as numbers (сравнение)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from geometry.board import Span
from plans.analytic.rotor import balance, moment
from plans.model.rotor import (
    ANALYSIS,
    EPS,
    MILLIMETRES,
    ROUNDING,
    Correction,
    Resultant,
    Rotor,
    RotorBalance,
    grade_of,
    letters,
    permissible,
)
from plans.quantity import MOST_SIDES, Comparison, Numbers, Quantity, Shown
from plans.rotor.balancing import COUPLES, UNBALANCES, unbalance_letters
from plans.rotor.study import BEARINGS, REACTIONS, RotorStudy
from plans.study import Study


def compare_rotor(study: RotorStudy) -> Comparison:
    """Balance a rotor by analysis too, and put every quantity beside that of the construction."""
    ours, theirs = study.balance, balance(study.rotor)
    both = _ComparedRotor(study, ours, theirs)
    return Comparison(ours, theirs, (*both.sums(), *both.corrections(), *both.reactions(), *both.left()))


class _ComparedRotor(NamedTuple):
    """A rotor balanced by both roads."""

    study: RotorStudy
    ours: RotorBalance
    theirs: RotorBalance

    @property
    def rotor(self) -> Rotor:
        """The rotor."""
        return self.study.rotor

    def sums(self) -> Iterator[Quantity]:
        """Compare what is unbalanced."""
        largest = max(mass.moment * abs(self.rotor.arm(mass.place)) for mass in self.rotor.masses)
        couple = self.study.drawing.moments.closing if self.rotor.dynamic else None
        yield self._finding((COUPLES, "ΣmDh", "kg*m2"), self.ours.couple, self.theirs.couple, largest, couple)
        named = UNBALANCES, "ΣmD", "kg*m"
        yield self._finding(named, self.ours.unbalance, self.theirs.unbalance, self._largest_mass, self._end)

    @property
    def _end(self) -> Span | None:
        """Give where the last of the masses ends on the polygon of forces."""
        drawing = self.study.drawing
        given = {placed.mark for placed in drawing.masses}
        ends = [side.end for side in drawing.forces.sides if side.vector in given]
        return Span(drawing.forces.board["0"], ends[-1]) if ends else None

    def corrections(self) -> Iterator[Quantity]:
        """Compare the counterweights."""
        largest = max(self._largest_mass, *(abs(correction.moment.value) for correction in self.ours.corrections))
        pairs = zip(self.ours.corrections, self.theirs.corrections, self.study.drawing.corrections, strict=True)
        for correction, other, drawn in pairs:
            named = UNBALANCES, unbalance_letters(correction.plane.name), "kg*m"
            yield self._finding(named, correction.moment, other.moment, largest, drawn.mark)

    def reactions(self) -> Iterator[Quantity]:
        """Compare what the bearings bear, before and after."""
        found = (*self.ours.before, *self.ours.after)
        marks = [mark for each in self.study.reactions for mark in each.marks]
        largest = max((abs(resultant.value) for resultant in found), default=0.0)
        for resultant, other, mark in zip(found, (*self.theirs.before, *self.theirs.after), marks, strict=True):
            yield self._finding((REACTIONS, mark.name, "N"), resultant, other, largest, mark)

    def left(self) -> Iterator[Quantity]:
        """Sum all static moments and, of a rotor with two planes, their moments about the first: both must vanish."""
        corrections = self.ours.corrections
        slack = sum(correction.moment.slack for correction in corrections)
        acting = [(moment(mass), mass.place) for mass in self.rotor.masses]
        acting += [(found, weight.plane.place) for found, weight in zip(self.ours.moments, corrections, strict=True)]
        yield _vanishing("ΣmD", "kg*m", [load for load, _ in acting], slack)
        if self.rotor.dynamic:
            first, last = (plane.place for plane in self.rotor.planes)
            moments = [load * float(place - first) for load, place in acting]
            yield _vanishing("ΣmDh", "kg*m2", moments, slack * abs(float(last - first)))

    @property
    def _largest_mass(self) -> float:
        """The largest static moment kg*m that is to be balanced."""
        return max(mass.moment for mass in self.rotor.masses)

    def _finding(
        self, named: tuple[str, str, str], resultant: Resultant, other: Resultant, largest: float, shown: Shown | None
    ) -> Quantity:
        drawing = self.study.drawing
        few = max(len(drawing.moments.sides), len(drawing.forces.sides)) <= MOST_SIDES
        pair = resultant.value, other.value
        return Quantity.of(named, pair, max(resultant.slack, other.slack), largest, shown if few else None)


def _vanishing(name: str, unit: str, terms: Sequence[complex], slack: float) -> Quantity:
    total = math.hypot(math.fsum(term.real for term in terms), math.fsum(term.imag for term in terms))
    sizes = [abs(term) for term in terms]
    return Quantity.vanishing(name, unit, total, ROUNDING * EPS * math.fsum(sizes) + slack, max(sizes))


def numbers(study: Study, by: str) -> Numbers:
    """Balance the rotor of a scene by a road: every rotor can be balanced."""
    rotor = study.of(RotorStudy)
    borne = REACTIONS in study.plans
    found = balance(rotor.rotor, borne) if by == ANALYSIS else (rotor.balance if borne else rotor.corrected)
    data: dict[str, Any] = {}
    if COUPLES in study.plans:
        data["couple"] = _vector(found.couple)
    if UNBALANCES in study.plans:
        data["unbalance"] = _vector(found.unbalance)
        data["corrections"] = {correction.plane.name: _correction(correction) for correction in found.corrections}
        data |= _quality(rotor.rotor, found)
    if borne and found.before:
        data["reactions"] = {"before": _reactions(found.before), "after": _reactions(found.after)}
    return Numbers({"scene": study.scene.heading(), "by": found.by, "rotor": data})


def _quality(rotor: Rotor, found: RotorBalance) -> dict[str, Any]:
    """Give e*omega m/s before the correction, its grade, and the unbalance kg*m that the asked grade permits."""
    before = rotor.quality(*found.sizes)
    if before is None or rotor.mass is None or rotor.speed is None:
        return {}
    grade = grade_of(before)
    data: dict[str, Any] = {"before": before / MILLIMETRES, "grade": letters(grade) if grade else None}
    if rotor.grade is not None:
        data["permissible"] = permissible(rotor.grade, rotor.mass, rotor.speed)
    return {"quality": data}


def _correction(body: Correction) -> dict[str, Any]:
    return {"moment": _vector(body.moment), "mass": body.mass, "radius": body.radius, "place": float(body.plane.place)}


def _reactions(found: tuple[Resultant, ...]) -> dict[str, Any]:
    return {name: _vector(resultant) for name, resultant in zip(BEARINGS, found, strict=True)}


def _vector(resultant: Resultant) -> dict[str, Any]:
    """Give a vector by its components, size and direction; one that vanishes has none."""
    value = 0j if resultant.vanishes else resultant.value + 0.0
    angle = None if resultant.angle is None else math.radians(resultant.angle)
    return {"vector": [value.real, value.imag], "size": resultant.size, "angle": angle}
