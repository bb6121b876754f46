"""A machine's motion by both roads: reduction, works, loop, speeds; and the true error of the method (сравнение).

The chords of the construction are held against the same chords by the analysis's own ordinates, so that nothing but
rounding parts them; what the chords themselves leave out is told beside, against the exact turn, and is not judged.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from geometry.board import Mark
from geometry.meet import EPS
from geometry.strips import Departure, departure
from plans.analytic.dynamics.flywheel import (
    Exact,
    book_slopes,
    exact,
    exact_cycle,
    flywheel,
    flywheel_of_points,
    methods,
    reduced_link,
    sampled_cycle,
    wheel,
)
from plans.analytic.dynamics.reduction import ExactReduction as Reducing
from plans.analytic.dynamics.reduction import reduced
from plans.analytic.dynamics.speeds import (
    Stall,
    Swing,
    with_flywheel,
    with_flywheel_of_points,
    without_flywheel,
    without_flywheel_of_points,
)
from plans.dynamics.study import FLYWHEEL, REDUCTION, SPEEDS, WORKS, DynamicsStudy
from plans.forces.loading import OutputStroke, loading
from plans.gears.form import geared
from plans.gears.quantities import GearsComparison
from plans.gears.study import GearsStudy
from plans.linkage.quantities import ANALYSIS, MotionComparison
from plans.model.dynamics import Cycle, Flywheel, Methods, Speeds
from plans.model.machine import Track
from plans.model.motion import Floats
from plans.model.run import Account, MachineRun
from plans.quantity import Comparison, Quantity
from plans.study import Study

ORDER = 2  # the reduction rests on velocities, its slope on accelerations: rounding is magnified once more for each
SAME = 1e-7  # rad: a break is known to half the digits of an angle, by a notch or by a root
# Of the largest moment: what a straight line through two ordinates beside an edge leaves out, or rounds, there.
BESIDE = 2.0**-32


class Reductions(NamedTuple):
    """The reduction at the positions of the scene by both roads."""

    study: DynamicsStudy
    motion: MotionComparison
    theirs: Account

    def findings(self) -> Iterator[Quantity]:
        """Compare reduced moment, inertia and its slope."""
        ours, lever = self.study.reduced, self.study.reduction.own
        pairs = (
            ("M_red", "N*m", "moment", lever.acting, 1),
            ("J_red", "kg*m2", "inertia", lever.moved, 1),
            ("dJ/dφ", "kg*m2", "slope", lever.hindering, ORDER),
        )
        for name, unit, part, marks, order in pairs:
            values = getattr(ours, part), getattr(self.theirs.reduced, part)
            largest = _gross(marks)
            off = lever.off(marks) * (2 if part == "slope" else 1)
            allowed = off + ANALYSIS * EPS * self.motion.kappa ** (order + 1) * largest
            yield Quantity.of((REDUCTION, name, unit), values, allowed, largest)


def _gross(marks: Iterable[Mark]) -> float:
    """Give the largest sum of moments by their sizes: they may cancel each other."""
    sizes = sum((np.abs(np.asarray(mark.point)) for mark in marks), np.zeros(1))
    return float(np.nanmax(sizes, initial=0.0))


class Chords:
    """The works, the loop and the speeds by both roads on the same strips, with what rounding allows them."""

    def __init__(self, study: DynamicsStudy, cycle: Cycle, theirs: Account, turn: Exact) -> None:
        assert theirs.cycle is not None  # it was made of this one
        self.study, self.ours, self.theirs, self.turn = study, cycle, theirs.cycle, turn
        self.wheels, self.account = (study.flywheel, theirs.flywheel), theirs
        works = study.works
        self.size, self.bent = _gross(works.middle.acting), works.bent.ravel()
        self.mean = works.middle.off(works.middle.acting) + turn.noise * self.size
        self.mass = works.edge.off(works.edge.moved) + turn.noise * _gross(works.edge.moved)
        areas = np.cumsum(np.diff(cycle.turned) * self.mean)
        self.work = works.curve.slacks + np.concatenate(([0.0], areas))

    def findings(self) -> Iterator[Quantity]:
        """Compare all that is drawn over the turn."""
        ours, theirs = self.ours, self.theirs
        yield self._breaks()
        yield Quantity.of((WORKS, "M_red", "N*m"), (ours.means, theirs.means), self.mean)
        sides = ours.moments.ravel(), theirs.moments.ravel()
        yield Quantity.of((WORKS, "M_red±", "N*m"), sides, np.repeat(self.mean, 2) + BESIDE * self.size + self.bent)
        yield Quantity.of((WORKS, "J_red", "kg*m2"), (ours.inertia, theirs.inertia), self.mass)
        yield Quantity.of((WORKS, "A", "J"), (ours.work, theirs.work), self.work)
        yield Quantity.of((WORKS, "ΔT", "J"), (ours.surplus, theirs.surplus), self._surplus, _largest(ours.work))
        yield self._settled()
        for when, names in (("speeds", ("ω", "ε")), ("before", ("ω_0", "ε_0"))):
            yield from self._speeds(names, getattr(self.study, when), getattr(self.account, when))
        if self.wheels[0] is not None and self.wheels[1] is not None:
            yield from self._flywheel(self.wheels[0], self.wheels[1])
            yield from self._methods(self.wheels[0])
            yield from self._rim(self.wheels[1])

    @property
    def _surplus(self) -> Floats:
        return np.asarray(self.work + self.work[-1] + 4 * EPS * _largest(self.ours.work))

    def _breaks(self) -> Quantity:
        """Compare where the moment jumps or bends, of each road the nearest of the other; position 0 is always one."""
        ours, theirs = (np.append(0.0, road.breaks) for road in (self.ours, self.turn))
        pairs = [(place, _nearest(place, theirs)) for place in ours]
        pairs += [(_nearest(place, ours), place) for place in theirs]
        both = np.array(pairs, dtype=np.float64).reshape(-1, 2).T
        return Quantity.of((WORKS, "φ", "rad"), (both[0], both[1]), np.full(both.shape[1], SAME), 2 * np.pi)

    def _settled(self) -> Quantity:
        """See that the exact turn is exact."""
        allowed = self.turn.noise if self.turn.settled else 0.0
        return Quantity.of((WORKS, "M_red, J_red exact", ""), (self.turn.error, 0.0), allowed, 1.0)

    def _flywheel(self, ours: Flywheel, theirs: Flywheel) -> Iterator[Quantity]:
        steep, mass = ours.slopes[1], 2 * float(self.mass.max())
        cut = float(self._surplus.max()) + steep * mass
        largest = max(map(abs, (*ours.cuts, *theirs.cuts, _largest(self.ours.work))))
        for name, ours_cut, other in zip(("o1l", "o1k"), ours.cuts, theirs.cuts, strict=True):
            yield Quantity.of((FLYWHEEL, name, "J"), (ours_cut, other), cut + 4 * EPS * largest, largest)
        whole = self._whole(ours)
        yield Quantity.of((FLYWHEEL, "J_0", "kg*m2"), (ours.whole, theirs.whole), whole, abs(ours.whole))
        energy = steep * whole + cut
        yield Quantity.of((FLYWHEEL, "T_0", "J"), (ours.energy, theirs.energy), energy, abs(ours.energy))

    def _methods(self, ours: Flywheel) -> Iterator[Quantity]:
        """Compare J0 by the other methods, from the points of the same loop."""
        task, methods = self.study.task, self.study.methods
        if methods is None or task.delta is None:
            return
        mean, even = task.speed**2 / 2, task.speed**2 * task.delta
        level = flywheel_of_points(self.theirs, task, (mean, mean)).cuts
        gutyar = flywheel_of_points(self.theirs, task).cuts
        book = flywheel_of_points(self.theirs, task, book_slopes(task))
        allowed, largest = 2 * self._whole(ours), abs(ours.whole)
        pairs = {
            "book": (methods.book, book.whole),
            "mertsalov": (methods.mertsalov, (level[1] - level[0]) / even),
            "gutyar": (methods.gutyar, (gutyar[1] - gutyar[0]) / even),
        }
        for name, (drawn, other) in pairs.items():
            yield Quantity.of((FLYWHEEL, f"J_0 {name}", "kg*m2"), (drawn, other), allowed, largest)

    def _rim(self, theirs: Flywheel) -> Iterator[Quantity]:
        """Compare mass and section of the rim."""
        drawn, other = self.study.wheel, wheel(theirs.inertia, self.study.task.rim)
        if drawn is None or other is None or self.wheels[0] is None:
            return
        share = self._whole(self.wheels[0]) / theirs.inertia + 16 * EPS
        for name, unit in (("inertia", "kg*m2"), ("mass", "kg"), ("thickness", "m"), ("breadth", "m")):
            size = abs(getattr(other, name))
            yield Quantity.of((FLYWHEEL, name, unit), (getattr(drawn, name), getattr(other, name)), share * size, size)

    def _whole(self, ours: Flywheel) -> float:
        """Give how far rounding can have moved J0: both segments over the difference of the slopes."""
        low, high = ours.slopes
        cut = float(self._surplus.max()) + 2 * high * float(self.mass.max())
        far = max(map(abs, (*ours.cuts, _largest(self.ours.work))))
        return 2 * (cut + 4 * EPS * far) / (high - low) + 8 * EPS * high / (high - low) * abs(ours.whole)

    def _speeds(self, names: tuple[str, str], ours: Speeds | None, theirs: Speeds | None) -> Iterator[Quantity]:
        """Compare a motion; one road alone that lets the machine stop is infinitely off."""
        speeds = ours or theirs
        if speeds is None:
            return
        masses = np.maximum(speeds.inertia + self.ours.varying, 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            off = self._energy(speeds) / (masses * speeds.omega)
        pair = [np.full_like(speeds.omega, np.nan) if road is None else road.omega for road in (ours, theirs)]
        yield Quantity.of((SPEEDS, names[0], "rad/s"), (pair[0], pair[1]), np.asarray(off))
        if ours is not None and theirs is not None:
            grown = self._growth(speeds, off, masses)
            values = ours.epsilon.ravel(), theirs.epsilon.ravel()
            yield Quantity.of((SPEEDS, names[1], "rad/s2"), values, np.repeat(grown, 2)[1:-1])

    def _energy(self, speeds: Speeds) -> Floats:
        """Give how far rounding can have moved the energy of the machine at each edge, J."""
        steep = speeds.extremes[1] ** 2
        wheel = self.wheels[0]
        whole = 0.0
        if wheel is not None and wheel.needed > 0 and speeds.inertia == wheel.whole:
            whole = self._whole(wheel) * (wheel.slopes[1] - wheel.slopes[0])
        cut = 4 * float(self._surplus.max()) + 4 * steep * float(self.mass.max())
        return np.asarray(whole + cut + 16 * EPS * abs(speeds.energy) + 0 * speeds.omega)

    def _growth(self, speeds: Speeds, off: Floats, masses: Floats) -> Floats:
        """Give how far rounding can have moved the acceleration at each edge, rad/s2."""
        slope, bend = self.study.works.edge.slope, 2 * self.study.works.edge.off(self.study.works.edge.hindering)
        bend = bend + self.turn.noise * _largest(slope)
        beside = BESIDE * self.size + float(self.bent.max())
        moved = float(self.mean.max()) + beside + speeds.omega * off * np.abs(slope) + speeds.omega**2 * bend
        largest = np.maximum(np.abs(speeds.epsilon).max(), 0.0)
        return np.asarray((moved + largest * self.mass) / masses)


def _nearest(value: float, places: Floats) -> float:
    """Give the nearest of some angles of a turn, on the same side of its end."""
    apart = np.angle(np.exp(1j * (places - value)))
    return float(value + apart[np.argmin(np.abs(apart))])


def _largest(values: Floats) -> float:
    return float(np.abs(values).max(initial=0.0))


@dataclass(frozen=True)
class DynamicsComparison(Comparison):
    """A machine's motion by both roads, over its positions by both; `exact` is the turn without the chords' error."""

    construction: Account
    analysis: Account
    findings: tuple[Quantity, ...]
    motion: MotionComparison = field(kw_only=True)
    exact: Account
    turn: Exact | None = None  # the exact turn at any angle; None where the crank cannot turn fully
    after: Swing | Stall | None = None  # the exact motion with the flywheel
    before: Swing | Stall | None = None  # and without one
    methods: Methods | None = None  # J0 by other methods, exact

    @property
    def error(self) -> Departure | None:
        """The true error of the chords in J0, as a share of it; None where no fluctuation is asked for."""
        drawn, true = self.construction.flywheel, self.exact.flywheel
        return None if drawn is None or true is None else departure([drawn.whole], [true.whole])


def comparison_of(study: Study) -> DynamicsComparison:
    """Compare a scene's machine, and what the train before its crank gives it."""
    found = compare_dynamics(study.of(DynamicsStudy), study.of(MotionComparison))
    return replace(found, findings=(*found.findings, *_of_train(study))) if geared(study.scene) else found


def _of_train(study: Study) -> Iterator[Quantity]:
    """Give ratio, reduced inertia and driving moment of the train before the crank, by Kutzbach's plan and exactly."""
    made, findings = study.of(GearsStudy), study.of(GearsComparison).findings
    driving, driven = made.train.drives[0][0], made.train.output
    names = made.ratio_name, f"ω_{driven}", f"J_red,{driven}", f"M_{driving}"
    yield from (one._replace(plan=REDUCTION) for name in names for one in findings if one.name == name)


def compare_dynamics(study: DynamicsStudy, motion: MotionComparison) -> DynamicsComparison:
    """Compare the motion of a machine whose positions are compared."""
    road, strokes = reducing_of(study, motion)
    theirs = Account("analysis", reduced(road, study.linkage.turn.phi))
    both = Reductions(study, motion, theirs)
    ours = study.account
    if ours.cycle is None:
        return DynamicsComparison(ours, theirs, tuple(both.findings()), theirs, motion=motion)
    turn = exact(road, strokes)
    sampled = _sampled(study, theirs, turn, ours.cycle)
    true, after, before = _exact(study, theirs, turn, ours.cycle)
    chords = Chords(study, ours.cycle, sampled, turn)
    found = (*both.findings(), *chords.findings())
    others = methods(turn, study.task)
    return DynamicsComparison(ours, sampled, found, true, turn, after, before, others, motion=motion)


def reducing_of(study: DynamicsStudy, motion: MotionComparison) -> tuple[Reducing, dict[Track, OutputStroke]]:
    """Give the reduction of a machine by analysis, and the strokes that its loads count."""
    strokes = study.statics.over(motion.road.extremes)
    machine, start = study.statics.machine, float(study.linkage.turn.phi[0])
    return Reducing(motion.road, machine, lambda found: loading(machine, found, strokes), start), strokes


def _sampled(study: DynamicsStudy, theirs: Account, turn: Exact, cycle: Cycle) -> Account:
    """Do what the construction does, with the ordinates of the analysis."""
    task, sampled = study.task, sampled_cycle(turn, cycle.turned)
    found, slope = flywheel_of_points(sampled, task) if task.delta else None, turn.slope(cycle.turned)
    speeds = with_flywheel_of_points(sampled, slope, task, found) if found else None
    before = without_flywheel_of_points(sampled, slope, task)
    return replace(theirs, cycle=sampled, flywheel=found, speeds=speeds, before=before)


def _exact(
    study: DynamicsStudy, theirs: Account, turn: Exact, cycle: Cycle
) -> tuple[Account, Swing | Stall | None, Swing | Stall]:
    """Account for the turn without any error but rounding."""
    task = study.task
    found = flywheel(turn, task) if task.delta else None
    before = without_flywheel(turn, task)
    after = with_flywheel(turn, task, found) if found else None
    speeds = [motion.speeds(cycle.turned) if isinstance(motion, Swing) else None for motion in (after, before)]
    true = replace(theirs, cycle=exact_cycle(turn, cycle.turned), flywheel=found, speeds=speeds[0], before=speeds[1])
    if study.motor is not None:
        true = replace(true, run=_run(study, turn))
    return true, after, before


def _run(study: DynamicsStudy, turn: Exact) -> MachineRun:
    """Find the run of the machine with the flywheel that was constructed."""
    from plans.analytic.dynamics.run import run  # noqa: PLC0415  (only a scene with a motor pays for the solver)

    assert study.motor is not None  # asked before
    return run(reduced_link(turn, study.constant), study.motor, study.run_task)
