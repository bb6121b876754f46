"""Friction by both roads: powers, efficiency, wear, jams; what a force plan by hand may be out in (сравнение)."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from plans.forces.cut import indices
from plans.forces.friction import rate
from plans.forces.statics import Statics
from plans.linkage.quantities import MotionComparison, cap, largest_of, with_analysis
from plans.model.kinetostatics import Friction, Kinetostatics, Loading, Reaction
from plans.model.machine import Rubbing
from plans.model.mechanism import Mechanism
from plans.model.motion import VELOCITIES, Floats
from plans.quantity import Comparison, Quantity

FRICTION = "friction"  # the plan of the findings
ORDER = 3  # powers rest on reactions


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN on both roads
def compare_friction(
    statics: Statics, motion: MotionComparison, forces: Comparison, theirs: Friction
) -> tuple[Friction, tuple[Quantity, ...]]:
    """Give friction by construction, and compare it with that of the analysis, over forces that are compared."""
    study, ours = statics.study, statics.friction
    assert ours is not None  # the machine has friction
    both = _ComparedFriction(statics, motion, forces, (ours, theirs))
    powers = both.powers(statics.loading(motion.construction))
    found = *cap(study, [*powers, *both.locking()]), *both.efficiency(), *both.wear(), *both.jams()
    return ours, found


class _ComparedFriction:
    """What friction takes by both roads, with what the differences of reactions and rates allow of it."""

    def __init__(
        self, statics: Statics, motion: MotionComparison, forces: Comparison, both: tuple[Friction, Friction]
    ) -> None:
        self.mechanism: Mechanism = statics.study.mechanism
        self.machine, self.motion, self.compared = statics.machine, motion, forces
        self.forces: Kinetostatics = forces.construction
        self.ours, self.theirs = both
        self.known = np.isfinite(self.ours.lost + self.theirs.lost)
        named = {finding.name: finding for finding in forces.of("forces")}
        self.named: Callable[[str], Quantity | None] = named.get
        self.slow = self._off("ω_")  # rad/s that any link's rate may differ by
        self.slip = self._off("v_") + self.slow * self.forces.size  # m/s that of any point of a link may
        reactions = self.forces.reactions
        rates = {key: rate(self.mechanism, motion.construction, reactions[key]) for key in self.ours.powers}
        self.rates = {key: np.abs(row) for key, row in rates.items()}
        self.largest = max((self._largest(key) for key in self.rates), default=0.0)

    def _off(self, symbol: str) -> Floats:
        bounds = [velocity.allowed for velocity in self.motion.of(VELOCITIES.plan) if velocity.name.startswith(symbol)]
        rows = [np.broadcast_to(row, len(self.ours.phi)) for row in bounds]
        return np.max(rows, axis=0) if rows else np.zeros(len(self.ours.phi))

    def _off_rate(self, reaction: Reaction) -> Floats:
        return 2.0 * (self.slow if reaction.along is None else self.slip)

    def _arm(self, reaction: Reaction, rubs: Rubbing) -> float:
        """Give what friction takes of the machine's largest force at the most: N of a slide, N*m of a journal."""
        if reaction.along is None:
            return rubs.radius
        return 1.0 + (2.0 * self.forces.size / rubs.length if rubs.length else 0.0)

    def _fast(self, key: str) -> float:
        """Give the largest rate of the machine that a pair may have: rad/s, or of a slide m/s."""
        symbol = "ω_" if self.forces.reactions[key].along is None else "v_"
        fastest = [velocity.largest for velocity in self.motion.of(VELOCITIES.plan) if velocity.name.startswith(symbol)]
        return max([*fastest, largest_of([self.rates[key]])])

    def _largest(self, key: str) -> float:
        """Give the power W of a pair that bears the machine's largest force at its largest rate."""
        rubs = self.machine.friction[key]
        arm = rubs.coefficient * self._arm(self.forces.reactions[key], rubs)
        return arm * self.forces.largest * self._fast(key)

    def _pressed(self, key: str) -> Floats:
        """Give by how much what presses in a pair may differ: N of a slide, N*m of a journal."""
        reaction, rubs = self.forces.reactions[key], self.machine.friction[key]
        force, moment = (self.named(f"{letter}_{indices(reaction.giver, reaction.taker)}") for letter in "RM")
        assert force is not None  # every reaction was compared
        if reaction.along is None:
            return rubs.radius * force.allowed
        return np.asarray(force.allowed + (2.0 * moment.allowed / rubs.length if moment and rubs.length else 0.0))

    def _lost(self, key: str) -> Floats:
        """Give by how much the power W lost in a pair may differ: its pressure's error by its rate, and the reverse."""
        rubs, steady = self.machine.friction[key], self._off_rate(self.forces.reactions[key])
        pressed = np.where(self.rates[key] > 0, self.ours.powers[key] / self.rates[key], 0.0)
        off = rubs.coefficient * self._pressed(key) * self.rates[key] + pressed * steady
        return with_analysis(off, ORDER, self.motion.kappa, self.largest)

    def _used(self, loads: Loading) -> Floats:
        forces = sum((np.abs(load.force) for load in loads.forces if load.useful), np.zeros(len(self.ours.phi)))
        moments = sum((np.abs(twist.moment) for twist in loads.moments if twist.useful), np.zeros(len(self.ours.phi)))
        largest = max(self.largest, largest_of([self.ours.useful]))
        return with_analysis(forces * self.slip + moments * self.slow, ORDER, self.motion.kappa, largest)

    def finding(self, named: tuple[str, str], pair: tuple[Floats, Floats], allowed: Floats, largest: float) -> Quantity:
        """Put one quantity by both roads beside each other, where both have forces."""
        count = len(pair[0])
        ours, theirs = (np.where(self.known, row, np.nan) if count == len(self.known) else row for row in pair)
        return Quantity.of((FRICTION, *named), (ours, theirs), allowed, largest)

    def powers(self, loads: Loading) -> Iterator[Quantity]:
        """Compare the powers lost in the pairs, and those that the useful loads take."""
        for key, ours in self.ours.powers.items():
            pair = ours, self.theirs.powers[key]
            yield self.finding((f"N_{_index(key)}", "W"), pair, self._lost(key), self.largest)
        self.off_used, used = self._used(loads), (self.ours.useful, self.theirs.useful)
        yield self.finding(("N_us", "W"), used, self.off_used, max(self.largest, largest_of([self.ours.useful])))

    def locking(self) -> Iterator[Quantity]:
        """Compare friction over driving force, and the power that drives, of the pairs that a group moves.

        The construction's share is that of its ray, over the part of the ray that drives: kappa once.
        """
        for key, ours in self.ours.locking.items():
            largest = max(largest_of([ours]), self.machine.friction[key].coefficient)
            allowed = with_analysis(np.zeros(len(ours)), ORDER, self.motion.kappa, largest)
            yield self.finding((f"locking {_index(key)}", "1"), (ours, self.theirs.locking[key]), allowed, largest)
            yield self._driving(key)

    def _driving(self, key: str) -> Quantity:
        reaction, rubs = self.forces.reactions[key], self.machine.friction[key]
        arm = (self.forces.size if reaction.along is None else 1.0) * (1.0 + self.ours.locking[key])
        forces = (finding.allowed for finding in self.compared.of("forces") if finding.unit == "N")
        most = max(forces, key=lambda allowed: float(np.nanmax(allowed, initial=0.0)))
        largest = largest_of([arm * self.forces.largest]) * self._fast(key) + self._largest(key)
        turning = self._pressed(key) * rubs.coefficient
        off = (arm * most + turning) * self.rates[key] + arm * self.forces.largest * self._off_rate(reaction)
        allowed = with_analysis(off, ORDER, self.motion.kappa, largest)
        pair = self.ours.driving[key], self.theirs.driving[key]
        return self.finding((f"driving {_index(key)}", "W"), pair, allowed, largest)

    def efficiency(self) -> Iterator[Quantity]:
        """Compare the efficiencies where the power is more than what its own roundings allow, if a load is useful."""
        if np.isnan([*self.ours.efficiency, *self.theirs.efficiency]).all():
            return
        lost = sum((self._lost(key) for key in self.ours.powers), np.zeros(len(self.ours.phi)))
        off, whole = lost + self.off_used, self.ours.useful + self.ours.lost
        judged = np.where(whole > off, self.theirs.efficiency, self.ours.efficiency)
        yield self.finding(("η", "1"), (self.ours.efficiency, judged), np.asarray(off / whole), 1.0)
        if np.nansum(whole) > np.nansum(off) and not self.ours.cycle is self.theirs.cycle is None:
            cycles = np.array([self.ours.cycle], dtype=float), np.array([self.theirs.cycle], dtype=float)
            yield self.finding(("η cycle", "1"), cycles, np.array([np.nansum(off) / np.nansum(whole)]), 1.0)

    def wear(self) -> Iterator[Quantity]:
        """Compare the shares of the pairs in the work of friction, where that is more than its own roundings allow."""
        total = float(np.nansum(self.ours.lost))
        lost = {key: float(np.nansum(self._lost(key))) for key in self.ours.powers}
        if total <= sum(lost.values()):
            return
        for key in self.ours.wear:
            pair = np.array([self.ours.wear[key]]), np.array([self.theirs.wear.get(key, np.nan)])
            allowed = np.array([(lost[key] + self.ours.wear[key] * sum(lost.values())) / total])
            yield self.finding((f"wear {_index(key)}", "1"), pair, allowed, 1.0)

    def jams(self) -> Iterator[Quantity]:
        """Compare where pairs jam: one road alone may only where the ratio is 1, or the power 0, to its rounding."""
        named = {finding.name: finding for finding in self.locking()}
        for key, ratio in self.ours.locking.items():
            edge = np.abs(ratio - 1.0) <= named[f"locking {_index(key)}"].allowed
            edge |= np.abs(self.ours.driving[key]) <= named[f"driving {_index(key)}"].allowed
            pair = _jammed(self.ours, key), _jammed(self.theirs, key)
            yield self.finding((f"jam {_index(key)}", "1"), pair, np.where(edge, 1.0, 0.0), 1.0)


def _jammed(found: Friction, key: str) -> Floats:
    """Give 1 in the positions in which a pair jams, else 0."""
    rows = np.zeros(len(found.phi))
    rows[[jam.position for jam in found.jams if jam.pair == key]] = 1.0
    return rows


def _index(key: str) -> str:
    giver, taker = map(int, key.split("-"))
    return indices(giver, taker)
