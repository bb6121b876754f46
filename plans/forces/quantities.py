"""The forces by both roads: reactions, balancing moment, lever, sums that must vanish; as numbers (сравнение сил)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from geometry.board import Mark
from geometry.meet import EPS
from geometry.precision import errors
from plans.analytic.kinetostatics import kinetostatics
from plans.analytic.power import balancing_moment, energy_balance
from plans.forces.cut import INERTIA, indices
from plans.forces.drive import BALANCING as BALANCED
from plans.forces.drive import DRIVING, BalancingQuantity, balancing_quantity
from plans.forces.equilibrium import BALANCING, Bounds, acting, balances, power
from plans.forces.force_template import ForcePlans
from plans.forces.loading import OutputStroke
from plans.forces.statics import Statics
from plans.linkage.quantities import ANALYSIS, MotionComparison, MotionNumbers, cap, largest_of, with_analysis
from plans.linkage.ram import cylinder
from plans.model.kinetostatics import Friction, Kinetostatics, Loading, Reaction
from plans.model.machine import Track
from plans.model.motion import FORCES, ORDERS, Floats
from plans.quantity import Comparison, Numbers, Quantity, gap_numbers, pairs, plain
from plans.study import Study

ORDER = 3  # forces magnify the analysis's rounding once more than the accelerations that they rest on
ENERGY = "energy"  # by what a finding of the balancing moment is told that no road of its own finds


@dataclass(frozen=True)
class ForceComparison(Comparison):
    """The forces of a linkage by both roads, over its motion by both."""

    construction: Kinetostatics
    analysis: Kinetostatics
    findings: tuple[Quantity, ...]
    motion: MotionComparison = field(kw_only=True)
    friction: tuple[Friction, Friction] | None = None  # by construction and by analysis, where there are coefficients

    @property
    def exact(self) -> tuple[Quantity, ...]:
        """The findings of forces but for the energy's, which is found by differences of positions."""
        return tuple(quantity for quantity in self.of(FORCES) if not quantity.name.endswith(ENERGY))


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN on both roads
def compare_forces(statics: Statics, motion: MotionComparison) -> ForceComparison:
    """Compare the forces of a study whose motion is compared."""
    machine, study = statics.machine, statics.study
    found = statics.over(motion.road.extremes)
    loads = statics.loading_over(motion.analysis, found)
    theirs = kinetostatics(motion.road, machine, motion.analysis, loads, statics.pairs)
    known = ANALYSIS * EPS * motion.kappa ** (ORDER + 1) < 1.0
    ours, theirs = (replace(road, known=known) for road in (statics.forces, theirs))
    both = ForceFindings(statics, motion, ours, theirs)
    found_by_both = [*both.reactions(), *both.cylinder(found), *both.balancing(loads)]
    forces = *cap(study, found_by_both), both.energy(loads)
    compared = ForceComparison(ours, theirs, (*forces, *cap(study, [*both.sums()])), motion=motion)
    return _with_friction(statics, compared, loads) if machine.friction else compared


def _with_friction(statics: Statics, comparison: ForceComparison, loads: Loading) -> ForceComparison:
    """Add friction, where the scene gives coefficients."""
    from plans.analytic.friction import friction  # noqa: PLC0415  (only a scene with friction pays for it)
    from plans.forces.friction_quantities import compare_friction  # noqa: PLC0415

    motion = comparison.motion
    theirs = friction(motion.road, statics.machine, motion.analysis, loads, comparison.analysis, statics.pairs)
    ours, findings = compare_friction(statics, motion, comparison, theirs)
    return replace(comparison, findings=(*comparison.findings, *findings), friction=(ours, theirs))


class ForceFindings:
    """The forces of a study by both roads over a motion, with what rounding allows the construction."""

    def __init__(
        self,
        statics: Statics,
        motion: MotionComparison,
        ours: Kinetostatics,
        theirs: Kinetostatics,
        plans: ForcePlans | None = None,
        borne: float = 0.0,  # N: of inertia; where counterweights hold it on each link, reactions are its rounding
    ) -> None:
        self.statics, self.motion, self.ours, self.theirs = statics, motion, ours, theirs
        self.plans = plans or statics.drafts().plans
        self.largest = max(ours.largest, borne)
        places = np.array([point.r for point in motion.construction.points.values()])
        self.size = largest_of([np.abs(places)])  # m: the longest arm about the shaft
        every = (support for cut in self.plans.plan.cuts for support in cut.reactions)
        self.supports = {"-".join(map(str, sorted((one.giver, one.taker)))): one for one in every}
        found = ((support.force, support.moment) for support in self.supports.values())
        marks = [mark for both in found for mark in both if mark is not None]
        lever = [] if self.plans.lever is None else [self.plans.lever.moment]
        plan = self.plans.plan
        drive = [plan.balancing, *([plan.drive] if plan.drive is not None else []), *lever]
        self.errors = errors(*marks, *drive, *self._borne())

    def _borne(self) -> Iterator[Mark]:
        """Give the inertia forces and couples of all links."""
        plan = self.plans.plan
        for link in plan.loads:
            yield from (load.force for load in plan.loads[link] if load.kind == INERTIA)
            yield from (couple.moment for couple in plan.couples[link] if couple.kind == INERTIA)

    def off(self, mark: Mark | None) -> Floats:
        """Give how far rounding can have moved a mark, over the positions."""
        count = len(self.ours.phi)
        return np.zeros(count) if mark is None else np.broadcast_to(self.errors[mark].place, count)

    def finding(self, named: tuple[str, str], pair: tuple[Any, Any], off: Floats, largest: float) -> Quantity:
        """Put one quantity by both roads beside each other."""
        allowed = with_analysis(off, ORDER, self.motion.kappa, largest)
        return Quantity.of((FORCES, *named), pair, allowed, largest)

    def reactions(self) -> Iterator[Quantity]:
        """Compare the reactions, and the moments of the sliding pairs."""
        for key, ours in self.ours.reactions.items():
            theirs, support, index = self.theirs.reactions[key], self.supports[key], indices(ours.giver, ours.taker)
            yield self.finding((f"R_{index}", "N"), (ours.force, theirs.force), self.off(support.force), self.largest)
            if ours.moment is not None:
                pair = ours.moment, theirs.moment
                yield self.finding((f"M_{index}", "N*m"), pair, self.off(support.moment), self.largest * self.size)

    def balancing(self, loads: Loading) -> Iterator[Quantity]:
        """Compare what the drive gives: with the equilibrium and the power of the other road; the lever."""
        plan, hung_on, machine = self.plans.plan, self.plans.lever, self.statics.machine
        road, solved = self.motion.road, self.motion.analysis
        ours, theirs, off = self.ours.balancing, self.theirs.balancing, self.off(plan.balancing)
        largest = self._largest_moment
        if ours.force is not None and self._stated.name != DRIVING:
            yield self.finding((DRIVING, "N"), (ours.force, theirs.force), self.off(plan.drive), self.largest)
        yield self._whole(self._told_by("", (ours.moment, self._expected), off, largest))
        if hung_on is not None:
            hung = np.where(np.isnan(ours.moment), np.nan, np.asarray(hung_on.moment.point).real)
            resting = np.asarray(road.rates(self.ours.phi).omega) == 0  # a lever without arms balances nothing
            both = (np.where(resting, np.nan, row) for row in (hung, theirs.moment))
            yield self._told_by("lever", tuple(both), self.off(hung_on.moment), largest)
        powered = np.where(np.isnan(ours.moment), np.nan, balancing_moment(road, machine, solved, loads))
        yield self._told_by("power", (ours.moment, powered), off, largest)

    def _whole(self, quantity: Quantity) -> Quantity:
        """Hold the force itself of what a slide is pushed with, beside its moment over the drive's unit."""
        ours, theirs = self.ours.balancing.force, self.theirs.balancing.force
        if not self.statics.study.mechanism.drive.pushed or ours is None or theirs is None:
            return quantity
        return quantity._replace(difference=np.maximum(quantity.difference, np.abs(ours - theirs)))

    @property
    def _expected(self) -> Floats:
        """The moment N*m that the analysis gives the crank, (N,); none at all where a cylinder turns it.

        Either road is given the cylinder's force by one formula: what holds it is that nothing is left to balance.
        """
        moment = self.theirs.balancing.moment
        return moment if self.statics.study.mechanism.drive.ram is None else np.asarray(0.0 * moment)

    @property
    def _stated(self) -> BalancingQuantity:
        """What the balances are told in: a cylinder leaves the crank no moment but rounding."""
        drive = self.statics.study.mechanism.drive
        return balancing_quantity(drive) if drive.pushed else BalancingQuantity(BALANCED, "N*m")

    def cylinder(self, found: Mapping[Track, OutputStroke]) -> Iterator[Quantity]:
        """Compare the force of a cylinder that turns the crank, where one does: its power is that of all others."""
        statics, motion, drive = self.statics, self.motion, self.statics.study.mechanism.drive
        if drive.ram is None:
            return
        ours = statics.given(self.ours, motion.construction)
        theirs = statics.given(self.theirs, motion.analysis, found)
        arm = cylinder(statics.study.mechanism).lever(motion.analysis)
        off = self.off(self.plans.plan.balancing) / arm
        yield self.finding((DRIVING, "N"), (ours, theirs), off, max(self.largest, largest_of([np.abs(ours)])))

    def _told_by(self, how: str, pair: tuple[Any, ...], off: Floats, largest: float) -> Quantity:
        """Put what the drive gives beside what another balance gives, by their moments; of a slide their forces."""
        name, unit, share = self._stated
        both = share * pair[0], share * pair[1]
        return self.finding((f"{name} {how}".strip(), unit), both, share * off, share * largest)

    def energy(self, loads: Loading) -> Quantity:
        """Compare with the energy balance; how far its differences may be off is its own word, and is not capped."""
        plan, machine, ours = self.plans.plan, self.statics.machine, self.ours.balancing
        off, largest = self.off(plan.balancing), self._largest_moment
        stored = energy_balance(self.motion.road, machine, self.motion.analysis, loads)
        judged = np.where(np.isnan(stored.moment), ours.moment, stored.moment)  # NaN: not judged
        quantity = self._told_by(ENERGY, (ours.moment, judged), off, largest)
        more = self._stated.share * np.where(np.isfinite(stored.allowed), stored.allowed, 0.0)
        return quantity._replace(allowed=quantity.allowed + more)

    @property
    def _largest_moment(self) -> float:
        mechanism = self.statics.study.mechanism
        crank = mechanism.links[mechanism.drive.link].points.values()
        arm = mechanism.drive.unit if mechanism.drive.pushed else max(map(abs, crank))
        return max(largest_of([np.abs(self.ours.counted(self.ours.balancing.moment))]), self.largest * arm)

    def sums(self) -> Iterator[Quantity]:
        """Check the equilibrium of every link, group and the whole, and the power, by the construction alone."""
        study, machine = self.statics.study, self.statics.machine
        motion = self.motion.construction
        loads = self.statics.loading(motion)
        parts = acting(study.mechanism, machine, motion, loads, self.ours, self._bounds())
        yield from balances(study.mechanism, study.groups, parts, self._most(0, "r_"))
        yield power(study.mechanism, motion, parts, self._most(1, "v_"), self._most(1, "ω_"))

    def _most(self, order: int, symbol: str) -> Floats:
        """Give the largest difference that the plan of an order is allowed in its points, or its links' rates."""
        found = (quantity for quantity in self.motion.of(ORDERS[order].plan) if quantity.name.startswith(symbol))
        bounds = [np.broadcast_to(quantity.allowed, len(self.ours.phi)) for quantity in found]
        return np.asarray(np.max(bounds, axis=0))

    def _bounds(self) -> Bounds:
        plan = self.plans.plan
        found = {key: (self.off(support.force), self.off(support.moment)) for key, support in self.supports.items()}
        for link in plan.loads:
            forces = [self.off(load.force) for load in plan.loads[link] if load.kind == INERTIA]
            couples = [self.off(couple.moment) for couple in plan.couples[link] if couple.kind == INERTIA]
            found[str(link)] = (sum(forces, self.off(None)), sum(couples, self.off(None)))
        found[BALANCING] = (self.off(plan.drive), self.off(plan.balancing))
        return found


def numbers(study: Study, by: str) -> Numbers:
    """Find the forces of a scene by a road, over its motion by the same; their gaps stand for those of the motion."""
    statics = study.of(Statics)
    below = study.numbers("linkage", by)
    assert isinstance(below, MotionNumbers)
    rubs = "friction" in study.plans and (study.chosen or bool(statics.machine.friction))
    if by == "analysis":
        solved, friction = _analysed(statics, below, rubs)
    else:
        solved, friction = statics.forces, statics.losses if rubs else None
    written: dict[str, Any] = {"gaps": [gap_numbers(gap) for gap in solved.gaps]}
    if "forces" in study.plans:
        written |= described(solved, below.datum)
        if not statics.study.mechanism.drive.turns:  # of a drive over a stroke the force is told in place of a moment
            written["balancing"] = {"push": plain(statics.given(solved, below.motion))} | written["balancing"]
            written["balancing"].pop("moment")
    if friction is not None:
        written |= rubbed(friction)
    return Numbers(written, bool(solved.gaps) or (friction is not None and bool(friction.jams)))


def _analysed(statics: Statics, below: MotionNumbers, rubs: bool) -> tuple[Kinetostatics, Friction | None]:
    from plans.analytic.kinetostatics import kinetostatics  # noqa: PLC0415  (only the analysis pays for it)

    road, motion, machine = below.road, below.motion, statics.machine
    assert road is not None  # the motion was found by analysis too
    loads = statics.loading_over(motion, statics.over(road.extremes))
    solved = kinetostatics(road, machine, motion, loads, statics.pairs)
    if not rubs:
        return solved, None
    from plans.analytic.friction import friction  # noqa: PLC0415  (only friction pays for it)

    return solved, friction(road, machine, motion, loads, solved, statics.pairs)


def described(forces: Kinetostatics, datum: complex) -> dict[str, Any]:
    """Give the reaction of link a on link b under "a-b", and what the drive gives."""
    balancing = forces.balancing
    drive: dict[str, Any] = {"moment": plain(balancing.moment)}
    if balancing.force is not None and balancing.r is not None:
        drive |= {"force": pairs(balancing.force), "at": pairs(balancing.r + datum)}
    reactions = sorted(forces.reactions.items(), key=lambda item: (item[1].giver, item[1].taker))
    bonds = {key: _reaction(reaction, forces.arm(key), datum) for key, reaction in reactions}
    return {"reactions": bonds, "balancing": drive}


def _reaction(reaction: Reaction, arm: Any, datum: complex) -> dict[str, Any]:
    """Give a reaction where it is told; of a sliding pair its moment there, and the arm along the slide."""
    written: dict[str, Any] = {"point": reaction.point, "force": pairs(reaction.force), "at": pairs(reaction.r + datum)}
    if reaction.moment is not None:
        written |= {"moment": plain(reaction.moment), "arm": plain(arm)}
    return written


def rubbed(friction: Friction) -> dict[str, Any]:
    """Give what friction takes: power and share of wear of each pair, and the efficiency."""
    worn: Mapping[str, float] = friction.wear
    powers = {key: {"power": plain(power), "share": worn.get(key)} for key, power in friction.powers.items()}
    power = {"useful": plain(friction.useful), "lost": plain(friction.lost)}
    efficiency = {"instantaneous": plain(friction.efficiency), "cycle": friction.cycle, **power}
    jams = [{**jam._asdict(), "advice": str(jam.advice)} for jam in friction.jams]
    return {"friction": powers, "efficiency": efficiency, "jams": jams}
