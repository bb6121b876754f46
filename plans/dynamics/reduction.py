"""Loads and masses reduced to the crank by Zhukovsky's lever (приведение сил и масс, M4.2, M4.4).

The crank turns at one radian a second: the velocity plan then shows what each point moves for a radian of the crank.
On that plan, turned into a lever, loads and weights have the reduced moment, the momenta of all masses the reduced
inertia, and mass times acceleration half of its slope.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from copy import copy
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from geometry.board import Board, Mark
from geometry.calculus import Derivative, derivative_by_tangents
from geometry.precision import errors
from plans.forces.cut import INERTIA, LOAD, WEIGHT, Couple, ForcePlan, Load
from plans.forces.lever import Lever, lever
from plans.forces.loading import loading
from plans.forces.statics import Statics
from plans.linkage.motion_plans import accelerations, velocities
from plans.linkage.primary import CrankPositions
from plans.linkage.study import LinkageStudy
from plans.linkage.sweep import Sweep, at_angles
from plans.model.dynamics import CONSTRUCTION, Cycle, Reduced, Speeds, Touch, settled
from plans.model.mechanism import Mechanism
from plans.model.motion import VELOCITIES, Floats
from plans.words.calculus import REASONS
from plans.words.words import because

SPEEDS = "speeds"
ROUNDS = 60  # of halving an interval: more than a double has digits


@dataclass(frozen=True)
class SpeedCurve:
    """Angular velocity over the turn, and its derivative by tangents with the pole distance."""

    speeds: Speeds
    derivative: Derivative

    @property
    def board(self) -> Board:
        """The board that it is drawn on."""
        return self.derivative.board


def speed_curve(
    cycle: Cycle, slope: Floats, inertia: float, energy: float, touches: Iterable[Touch] = ()
) -> SpeedCurve:
    """Read the speed off the energy-mass diagram, whose rays have the slope omega2/2, and its slope by tangents.

    A tangent at either side of each edge has the slope epsilon/omega, with J epsilon = M - omega2 J'/2: `slope`
    (n + 1,) is J', kg*m2. `inertia` kg*m2 and `energy` J are those of the whole machine at position 0. It is slowest
    and fastest at an edge, or where the loop is touched between two.
    """
    omega = omegas(cycle, inertia, energy)
    both = np.stack([omega[:-1], omega[1:]], axis=1)
    inertias, slopes = (np.stack([row[:-1], row[1:]], axis=1) for row in (inertia + cycle.varying, slope))
    tangents = (cycle.driving + cycle.moments - both**2 * slopes / 2) / (inertias * both)
    places = np.stack([cycle.turned[:-1], cycle.turned[1:]], axis=1)
    x, y, steep = (row.ravel() for row in (places, both, tangents))
    derivative = derivative_by_tangents(Board(SPEEDS), "ω", x, y, steep, why=REASONS)
    reached = [*omega.tolist(), *(touch.omega(inertia, energy) for touch in touches)]
    extremes = min(reached), max(reached)
    growth = settled(both * derivative.values.reshape(-1, 2), extremes[1] ** 2)
    speeds = Speeds(CONSTRUCTION, cycle.turned, omega, growth, extremes, inertia, energy)
    return SpeedCurve(speeds, derivative)


def omegas(cycle: Cycle, inertia: float, energy: float) -> Floats:
    """Give the angular velocity at the edges of the strips, rad/s (6.12); NaN where the machine has no energy left."""
    ratio = 2 * (energy + cycle.surplus) / (inertia + cycle.varying)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(np.sqrt(ratio))


def natural(cycle: Cycle, inertia: float, speed: float) -> float | None:
    """Give the energy J at position 0 with which the machine keeps its mean speed; None where it would stop.

    The mean of the least and the greatest speed grows with that energy.
    """
    least = float(np.max(-cycle.surplus))
    high = least + float(np.ptp(cycle.surplus)) + speed**2 * (inertia + float(np.max(cycle.varying)))
    if _mean(cycle, inertia, least) > speed:
        return None
    low = least
    for _ in range(ROUNDS):
        middle = (low + high) / 2
        low, high = (middle, high) if _mean(cycle, inertia, middle) < speed else (low, middle)
    return (low + high) / 2


def _mean(cycle: Cycle, inertia: float, energy: float) -> float:
    omega = omegas(cycle, inertia, energy)
    return float(np.nanmin(omega) + np.nanmax(omega)) / 2


class Reducing:
    """The lever at some crank positions, whatever is not reached: what hangs on it, and what it has about its pole."""

    def __init__(self, reduction: Reduction, turn: CrankPositions) -> None:
        self.reduction, self.turn = reduction, turn

    @cached_property
    @np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
    def plan(self) -> ForcePlan:
        """The forces at these positions, on the plans of a crank that turns at one radian a second."""
        sweep, statics = self.reduction.sweep, self.reduction.statics
        groups = self.reduction.study.groups
        speeds = velocities(sweep.positions(self.turn), groups)
        acting = loading(statics.machine, sweep.motion(self.turn, 2), statics.strokes)
        return ForcePlan(accelerations(speeds, groups), statics.machine, acting)

    @cached_property
    def forces(self) -> Lever | None:
        """The lever with loads, weights, and mass times acceleration with the sign of an inertia force."""
        return _hung(self.plan)

    @cached_property
    @np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
    def momenta(self) -> Lever | None:
        """The lever with the momenta of all masses."""
        return _hung(_with_momenta(self.plan))

    @property
    def acting(self) -> tuple[Mark, ...]:
        """The moments of loads and weights about the pole."""
        return tuple(_moments(self.forces, self._names(LOAD, WEIGHT)))

    @property
    def moved(self) -> tuple[Mark, ...]:
        """The moments of momenta about the pole."""
        return tuple(mark for _, mark in self.momenta.moments) if self.momenta else ()

    @property
    def hindering(self) -> tuple[Mark, ...]:
        """The moments of inertia forces about the pole."""
        return tuple(_moments(self.forces, self._names(INERTIA)))

    def _names(self, *kinds: str) -> frozenset[str]:
        acting: list[Load | Couple] = [load for row in self.plan.loads.values() for load in row]
        acting += [load for row in self.plan.couples.values() for load in row]
        return frozenset(load.name for load in acting if load.kind in kinds)

    @property
    def moment(self) -> Floats:
        """The reduced moment of loads and weights, N*m, positive in the sense of rotation."""
        return self._total(self.acting)

    @property
    def weight(self) -> Floats:
        """The part of it that the weights have, N*m."""
        return self._total(_moments(self.forces, self._names(WEIGHT)))

    @property
    def inertia(self) -> Floats:
        """The reduced inertia of the linkage, kg*m2."""
        return self._total(self.moved)

    @property
    def slope(self) -> Floats:
        """The derivative of the reduced inertia by the angle turned, kg*m2."""
        return -2 * self._total(self.hindering)

    @property
    def size(self) -> float:
        """The largest sum of the moments of loads and weights, each taken positive, N*m."""
        sizes = sum((np.abs(np.asarray(mark.point)) for mark in self.acting), np.zeros(len(self.turn)))
        return float(np.nanmax(sizes, initial=0.0))

    def _total(self, moments: Iterable[Mark]) -> Floats:
        return sum((np.asarray(mark.point).real for mark in moments), np.zeros(len(self.turn)))

    def off(self, moments: tuple[Mark, ...]) -> Floats:
        """Bound how far rounding can have moved the sum of some moments."""
        bounds = errors(*moments) if moments else {}
        return sum((bounds[mark].place for mark in moments), np.zeros(len(self.turn)))


class Reduction:
    """The reduction of a scene's machine to its crank, at any of its positions."""

    def __init__(self, study: LinkageStudy, statics: Statics) -> None:
        self.study, self.statics = study, statics

    @cached_property
    def sweep(self) -> Sweep:
        """The mechanism at one radian a second."""
        return self.study.sweep.over(unit(self.study.mechanism, self.study.sense))

    @property
    def start(self) -> float:
        """The crank angle of position 0, rad."""
        return float(self.study.turn.phi[0])

    def at(self, turned: Floats) -> Reducing:
        """Hang everything on the lever at some angles turned since position 0, rad."""
        return Reducing(self, at_angles(self.start + self.study.sense * turned))

    @cached_property
    def own(self) -> Reducing:
        """The lever at the positions of the scene."""
        return Reducing(self, self.study.turn)

    @cached_property
    def reduced(self) -> Reduced:
        """Reduced moment and inertia at the positions of the scene."""
        gaps = self.study.motion(VELOCITIES.number).gaps
        gone = np.zeros(len(self.study.turn), dtype=bool)
        gone[[gap.position for gap in gaps]] = True
        rows = (self.own.moment, self.own.inertia, self.own.slope)
        moment, inertia, slope = (np.where(gone, np.nan, row) for row in rows)
        return Reduced(CONSTRUCTION, self.study.turn.phi, moment, inertia, slope, gaps)


def unit(mechanism: Mechanism, sense: int) -> Mechanism:
    """Give the mechanism with a crank that turns steadily at one radian a second."""
    return replace(mechanism, drive=mechanism.drive._replace(omega=float(sense), epsilon=0.0))


@np.errstate(invalid="ignore", divide="ignore")  # a gap is NaN inside, and is named outside
def _hung(plan: ForcePlan) -> Lever | None:
    return lever(plan)


def _with_momenta(plan: ForcePlan) -> ForcePlan:
    """Give each link its momentum at the mass centre, and its moment of momentum, in place of its forces."""
    other = copy(plan)
    other.loads = {link: list(_momentum(plan, link)) for link in plan.loads}
    other.couples = {link: list(_spin(plan, link)) for link in plan.couples}
    return other


def _momentum(plan: ForcePlan, link: int) -> Iterator[Load]:
    body = plan.machine.bodies.get(link)
    if body is None or not body.mass:
        return
    speed = plan.centre(plan.velocities, body)
    if speed is not plan.velocities.pole:
        mark = plan.board.turn(f"Q_{link}", speed, body.mass, because("momentum"))
        yield Load(f"Q_{link}", link, plan.centre(plan.positions, body), mark, INERTIA)


def _spin(plan: ForcePlan, link: int) -> Iterator[Couple]:
    body, reading = plan.machine.bodies.get(link), plan.velocities.readings.get(link)
    if body is not None and body.inertia and reading is not None:
        mark = plan.board.couple(f"K_{link}", *reading, body.inertia, because("moment_of_momentum"))
        yield Couple(f"K_{link}", link, mark, INERTIA)


def _moments(hung: Lever | None, names: frozenset[str]) -> Iterator[Mark]:
    return (mark for name, mark in (hung.moments if hung else ()) if name in names)
