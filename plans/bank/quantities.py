"""A bank by both roads: sums by order, compensators, where a sheet shows them; as numbers (сравнение)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from geometry.board import Board, Mark
from plans.analytic.balance.bank import BankMechanism, ExactLinkage, ExactSliderCrank, bank_balance
from plans.analytic.balance.mass_centre import bodies
from plans.balance.quantities import BalanceComparison, compare_balance
from plans.balance.study import BalanceStudy
from plans.bank.harmonics import COMPENSATORS, FORCE, HARMONICS, MOMENT, SINGLE, STATIC, couple_letters, letters
from plans.bank.study import BankStudy
from plans.forces.statics import Statics
from plans.linkage.quantities import MotionComparison, compare
from plans.linkage.study import LinkageStudy
from plans.model.balance.bank import ANALYSIS, BankBalance, Compensator, Harmonic
from plans.model.balance.linkage import Counterweight
from plans.model.motion import ACCELERATIONS, Complexes
from plans.quantity import EQUILIBRIUM, MOST_SIDES, Comparison, Numbers, Quantity, by_hand
from plans.rotor.balancing import polygon
from plans.study import Study

FIGURES = {FORCE: "order_forces", MOMENT: "order_moments"}  # on which each polygon stands, before its order
BACK = "-back"  # after the order of what turns against the crank
WHOLE, WHOLE_MOMENT, LEFT = "ΣF", "ΣM", "ΣF'"  # over the turn; what the compensators leave is primed


def compare_bank(study: BankStudy, mechanism: BankMechanism) -> Comparison:
    """Find the bank by analysis too, and put every quantity beside that of the construction."""
    ours, theirs = study.balance, bank_balance(study.task, mechanism)
    both = _ComparedBank(study, ours, theirs)
    findings = (*both.harmonics(), *both.compensators(), *both.whole(), *both.transforms(), *both.balanced())
    return Comparison(ours, theirs, findings)


def mechanism_of(study: Study, bank: BankStudy) -> BankMechanism:
    """Give the mechanism of a bank for the analysis: by its sizes, or the linkage with counterweights by analysis."""
    unit, speed = bank.task.unit, bank.task.speed
    if unit is not None:
        return ExactSliderCrank(unit, speed)
    motion = _motion(study)
    solid = bodies(study.of(Statics).machine, _counterweights(study, motion))
    return ExactLinkage(motion.road, solid, speed, study.of(LinkageStudy).turn.phi, bank.orders)


def _motion(study: Study) -> MotionComparison:
    """Compare the motion of the scene's linkage as far as its accelerations, whatever else is asked of it."""
    if ACCELERATIONS.plan in study.plans:
        found = study.of(MotionComparison)
        return found
    return compare(study.of(LinkageStudy), ACCELERATIONS.number)


def _counterweights(study: Study, motion: MotionComparison) -> tuple[Counterweight, ...]:
    """Give the counterweights of the scene's balance by analysis."""
    if not study.scene.has(("balance",)):
        return ()
    asked = "balance" in study.techniques and ACCELERATIONS.plan in study.plans
    compared = study.of(BalanceComparison) if asked else compare_balance(study.of(BalanceStudy), motion)
    found: tuple[Counterweight, ...] = compared.analysis.counterweights
    return found


class _ComparedBank(NamedTuple):
    """A bank by both roads."""

    study: BankStudy
    ours: BankBalance
    theirs: BankBalance

    @property
    def _single(self) -> float:
        """How far a harmonic of one mechanism can be out, by the conditions of its plans."""
        return self.study.single.bound

    @property
    def _bank(self) -> float:
        """How far a force of the bank can be out."""
        return self._single * len(self.ours.task.members)

    def harmonics(self) -> Iterator[Quantity]:
        """Compare every vector of every order."""
        largest, arm = _largest(self.ours.single), max(abs(float(member.place)) for member in self.ours.task.members)
        lever = self._single * math.fsum(abs(float(member.place)) for member in self.ours.task.members)
        rows = (
            (SINGLE, "N", self.ours.single, self.theirs.single, self._single, largest),
            (FORCE, "N", self.ours.forces, self.theirs.forces, self._bank, largest),
            (MOMENT, "N*m", self.ours.moments, self.theirs.moments, lever, arm * largest),
        )
        for kind, unit, ours, theirs, bound, most in rows:
            for order, harmonic in ours.items():
                allowed = harmonic.slack + theirs[order].slack + bound
                for signed, found, other in _pairs(order, harmonic, theirs[order]):
                    named = HARMONICS, letters(kind, signed), unit
                    yield Quantity.of(named, (found, other), allowed, most, self._shown(kind, signed))

    def _shown(self, kind: str, signed: int, times: float = -1.0) -> Mark | None:
        """Give what is read off the polygon of an order, so many times what closes it, on a board of its figure.

        The vector of one mechanism is known, and so is how it is turned; the members' vectors are laid off end to end.
        """
        if kind not in FIGURES:
            return None
        totals = self.study.drawing.forces if kind == FORCE else self.study.drawing.moments
        sides, figure = totals[signed].polygon.sides, f"{FIGURES[kind]}-{abs(signed)}"
        if len(sides) > MOST_SIDES:
            return None
        board = Board(figure if signed > 0 else f"{figure}{BACK}")
        vectors = [board.given(f"{kind}:{k}", side.vector.value) for k, side in enumerate(sides)]
        closed = polygon(board, board.given("0", 0j), f"-{kind}", vectors)
        return board.turn(kind, closed.closing, times)

    def compensators(self) -> Iterator[Quantity]:
        """Compare the masses of the compensators, with the directions in which they stand."""
        largest = max(
            (compensator.with_crank + compensator.against for compensator in self.ours.compensators), default=0.0
        )
        for compensator, other in zip(self.ours.compensators, self.theirs.compensators, strict=True):
            order, offset = compensator.asked.order, abs(compensator.asked.offset)
            force = self.ours.forces[order].slack + self.theirs.forces[order].slack + self._bank
            allowed = force / (order * self.ours.task.speed) ** 2
            for signed, found, theirs in zip((order, -order), _weights(compensator), _weights(other), strict=True):
                shown = self._shown(FORCE, signed, 1 / (signed * self.ours.task.speed) ** 2)
                named = COMPENSATORS, letters(STATIC, signed), "kg*m"
                yield Quantity.of(named, (found, theirs), allowed, largest, shown)
            residual = max(compensator.residual, other.residual)
            named, pair = (COMPENSATORS, f"{FORCE}·z,{order}", "N*m"), (compensator.residual, other.residual)
            yield Quantity.of(named, pair, 2 * force * offset, residual)
            if compensator.couple is not None and other.couple is not None:
                allowed *= 2 * offset / (compensator.asked.shafts or math.inf)
                couple, theirs = (_vector(each.couple or 0.0, each.couple_angle) for each in (compensator, other))
                named = COMPENSATORS, couple_letters(order), "kg*m"
                yield Quantity.of(named, (couple, theirs), allowed, compensator.couple)

    def whole(self) -> Iterator[Quantity]:
        """Compare the whole force and moment over the turn, before and after the compensators."""
        ours, theirs = self.ours, self.theirs
        force = ours.force_slack + theirs.force_slack
        left = ours.left_slack + theirs.left_slack + self._taken
        moment = ours.moment_slack + theirs.moment_slack
        shares = self.study.whole
        rows = (
            (WHOLE, "N", ours.force, theirs.force, force, shares.largest),
            (LEFT, "N", ours.left, theirs.left, left, shares.largest),
            (WHOLE_MOMENT, "N*m", ours.moment, theirs.moment, moment, shares.largest_moment),
        )
        for name, unit, found, other, allowed, largest in rows:
            yield Quantity.of((HARMONICS, name, unit), (found, other), allowed, largest)

    def transforms(self) -> Iterator[Quantity]:
        """See that the whole force and moment over the turn have the harmonics that the polygons gave them."""
        ours, most = self.ours, self.study.whole
        arms = math.fsum(abs(float(member.place)) for member in ours.task.members)
        rows = (
            (FORCE, "N", ours.force, ours.forces, ours.force_slack, len(ours.task.members), most.largest),
            (MOMENT, "N*m", ours.moment, ours.moments, ours.moment_slack, arms, most.largest_moment),
        )
        for kind, unit, whole, harmonics, slack, weight, largest in rows:
            row = _transform(whole)
            for order, harmonic in harmonics.items():
                allowed = slack + harmonic.slack + weight * (self._single + self._beyond(order))
                for signed, found, _ in _pairs(order, harmonic, harmonic):
                    named = EQUILIBRIUM, f"{letters(kind, signed)}(φ)", unit
                    yield Quantity.of(named, (found, row[signed]), allowed, largest)

    def balanced(self) -> Iterator[Quantity]:
        """See that the compensators leave nothing of their orders."""
        row, members = _transform(self.ours.left), len(self.ours.task.members)
        for compensator in self.ours.compensators:
            order = compensator.asked.order
            allowed = self.ours.left_slack + self._taken + self._bank + members * self._beyond(order)
            for signed in (order, -order):
                named = EQUILIBRIUM, f"{letters(FORCE, signed)}'", "N"
                yield Quantity.of(named, (0j, row[signed]), allowed, self.study.whole.largest)

    @property
    def _taken(self) -> float:
        """How far the forces of all compensators can be out by the conditions of the plans."""
        return 2 * self._bank * len(self.ours.compensators)

    def _beyond(self, order: int) -> float:
        """How much the orders beyond half the positions can add to one of one mechanism that they give."""
        return self.study.single.beyond(len(self.ours.phi) - 1, order)


NEAR_TOP = 0.9  # of the largest: two degrees hide less of a peak, but of orders that no mechanism has
HALVINGS = 40  # of two steps: to 1e-13 rad, where a peak is flat to rounding


def _transform(whole: Complexes) -> Complexes:
    """Give the vectors of all orders of a vector over the turn."""
    return np.asarray(np.fft.fft(whole[:-1]) / (len(whole) - 1))


def _largest(found: Mapping[int, Harmonic]) -> float:
    return max(max(abs(harmonic.ahead), abs(harmonic.back)) for harmonic in found.values())


def _pairs(order: int, harmonic: Harmonic, other: Harmonic) -> Iterator[tuple[int, complex, complex]]:
    yield order, harmonic.ahead, other.ahead
    yield -order, harmonic.back, other.back


def _weights(compensator: Compensator) -> tuple[complex, complex]:
    against = _vector(compensator.against, compensator.against_angle)
    return _vector(compensator.with_crank, compensator.with_angle), against


def _vector(size: float, angle: float | None) -> complex:
    return 0j if angle is None else size * complex(math.cos(angle), math.sin(angle))


def numbers(study: Study, by: str) -> Numbers:
    """Find the bank of a scene by a road: every bank has all numbers."""
    bank = study.of(BankStudy)
    found: BankBalance = study.comparison("bank").analysis if by == ANALYSIS else bank.balance
    data: dict[str, Any] = {}
    if HARMONICS in study.plans:
        rows = {"mechanism": found.single, "force": found.forces, "moment": found.moments}
        data["harmonics"] = {
            str(order): {name: _harmonic(row[order]) for name, row in rows.items()} for order in found.forces
        }
        force, moment = _peak(found.force, found.force_slack), _peak(found.moment, found.moment_slack)
        data["largest"] = {"force": force, "moment": moment}
    if COMPENSATORS in study.plans and found.compensators:
        data["compensators"] = [_compensator(compensator) for compensator in found.compensators]
        data["left"] = {"force": _peak(found.left, found.left_slack)}
    return Numbers({"scene": study.scene.heading(), "by": found.by, "bank": data})


def _harmonic(harmonic: Harmonic) -> dict[str, Any]:
    """Give a harmonic by its two vectors and the largest that it comes to; what vanishes is 0."""
    ahead, back = (0j if abs(value) <= harmonic.slack else value + 0.0 for value in (harmonic.ahead, harmonic.back))
    return {"with_crank": [ahead.real, ahead.imag], "against": [back.real, back.imag], "size": harmonic.size}


def _compensator(compensator: Compensator) -> dict[str, Any]:
    weights = {
        "with_crank": (compensator.with_crank, compensator.with_angle),
        "against": (compensator.against, compensator.against_angle),
    }
    masses = {name: _weight(size, angle, compensator.asked.mass) for name, (size, angle) in weights.items()}
    couple = None if compensator.couple is None else {"moment": compensator.couple, "angle": compensator.couple_angle}
    return {"order": compensator.asked.order, **masses, "residual": compensator.residual, "couple": couple}


def _weight(size: float, angle: float | None, mass: float | None) -> dict[str, Any]:
    return {"moment": size, "angle": angle, "mass": mass, "radius": size / mass if mass else None}


def _peak(values: Complexes, slack: float) -> float:
    """Give the largest size of a vector over the turn, between its places too; 0 where only rounding is left.

    Between them it is the sum of its harmonics, whose square rises before the largest and falls beyond.
    """
    sizes, count = np.abs(values[:-1]), len(values) - 1
    tops = (sizes >= np.roll(sizes, 1)) & (sizes >= np.roll(sizes, -1)) & (sizes >= NEAR_TOP * sizes.max())
    orders, shares = np.fft.fftfreq(count, 1 / count), _transform(values)
    low, high = (2 * np.pi / count * (np.flatnonzero(tops) + side) for side in (-1, 1))
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        terms = shares * np.exp(1j * np.outer(middle, orders))
        rising = (terms.sum(axis=1).conjugate() * (1j * orders * terms).sum(axis=1)).real > 0
        low, high = np.where(rising, middle, low), np.where(rising, high, middle)
    found = max(float(sizes.max()), *np.abs(terms.sum(axis=1)).tolist())
    return found if found > slack else 0.0


def bank_by_hand(findings: Iterable[Quantity], scales: Mapping[str, float]) -> dict[tuple[str, int], float]:
    """Give what a hand may be out in the polygons that a sheet shows, by the names of the findings.

    `scales` are those of the figures, N or N*m a mm: "order_forces-2-back". A mass of a compensator is read off what
    closes its polygon, over the square of its angular speed; what turns against the crank and has no figure, off the
    one whose mirror image its polygon is.
    """
    return by_hand(findings, {**{f"{name}{BACK}": mu for name, mu in scales.items()}, **scales})
