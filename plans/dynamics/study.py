"""The study of a machine's motion: reduction, works, loop, speeds, each made once, when asked for (динамика машины)."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from geometry.errors import ConstructionError
from plans.dynamics.cycle import SteadyStrips, WorkDiagram, methods, rim_of
from plans.dynamics.form import DRIVE, DynamicsForm, DynamicsTable, motor_of, run_task
from plans.dynamics.loop import Loop, loop
from plans.dynamics.reading import task_of
from plans.dynamics.reduction import Reduction, SpeedCurve, natural, speed_curve
from plans.dynamics.run import run
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy, obstruction
from plans.model.dynamics import CONSTRUCTION, ROUNDED, TURN, Cycle, Flywheel, Methods, Reduced, Speeds, Task, Wheel
from plans.model.motion import Floats
from plans.model.motor import Motor
from plans.model.run import Account, MachineRun, ReducedLink, RunTask
from plans.study import Study
from plans.words.words import message, placed


@dataclass(frozen=True)
class Ordinates:
    """Places rad from 0 to a whole turn, and a quantity there; at each strip's two ends it may have its own value."""

    places: Sequence[float]  # n + 1
    begins: Sequence[float]  # n: at the beginning of each strip
    ends: Sequence[float]  # n: at its end

    def strip(self, turned: float) -> tuple[int, float, float]:
        """Give the strip of an angle, the share of it that lies behind, and its breadth rad."""
        place = turned % TURN
        k = min(bisect_right(self.places, place) - 1, len(self.begins) - 1)
        breadth = self.places[k + 1] - self.places[k]
        return k, (place - self.places[k]) / breadth, breadth

    def straight(self, turned: float) -> float:
        """Give the quantity on a straight line in each strip; on an edge, by the strip beyond."""
        k, share, _ = self.strip(turned)
        return self.begins[k] + (self.ends[k] - self.begins[k]) * share


@dataclass(frozen=True)
class CubicCurve:
    """A quantity through its ordinates and slopes, a cubic in each strip (Hermite): value and slope belong together."""

    ordinates: Ordinates
    slopes: Ordinates

    def value(self, turned: float) -> float:
        """Give the quantity."""
        k, x, breadth = self.ordinates.strip(turned)
        y, rise, first, last = self._strip(k, breadth)
        return y + x * (first + x * (3 * rise - 2 * first - last + x * (first + last - 2 * rise)))

    def slope(self, turned: float) -> float:
        """Give its derivative by the angle."""
        k, x, breadth = self.ordinates.strip(turned)
        _, rise, first, last = self._strip(k, breadth)
        return (first + x * (2 * (3 * rise - 2 * first - last) + 3 * x * (first + last - 2 * rise))) / breadth

    def _strip(self, k: int, breadth: float) -> tuple[float, float, float, float]:
        """Give the beginning of a strip, the rise in it, and the slopes at its ends for its whole breadth."""
        y, end = self.ordinates.begins[k], self.ordinates.ends[k]
        return y, end - y, self.slopes.begins[k] * breadth, self.slopes.ends[k] * breadth


def curve(places: Floats, values: Floats, slopes: Floats) -> CubicCurve:
    """Put a curve through values (n + 1,) with slopes (n + 1,) at places from 0 to a whole turn."""
    at = places.tolist()
    both = [Ordinates(at, row[:-1].tolist(), row[1:].tolist()) for row in (values, slopes)]
    return CubicCurve(*both)


def reduced_link(works: WorkDiagram, constant: float) -> ReducedLink:
    """Read the reduced link off the graphs of a steady turn; `constant`: inertia kg*m2 of shafts and flywheel."""
    cycle = works.cycle
    inertia = curve(cycle.turned, cycle.inertia + constant, works.edge.slope)
    of_loads, of_weights = (
        Ordinates(cycle.turned.tolist(), *row.T.tolist()).straight for row in (works.loads, cycle.moments - works.loads)
    )
    return ReducedLink(inertia.value, inertia.slope, of_loads, of_weights, tuple(cycle.breaks.tolist()))


REDUCTION, WORKS, FLYWHEEL, SPEEDS, RUN = "reduction", "works", "flywheel", "speeds", "run"


class NoCycle(ConstructionError):  # noqa: N818  (the exception tree's own word)
    """A steady motion was asked of a machine whose crank cannot turn fully."""


class NoInertia(ConstructionError):  # noqa: N818  (the exception tree's own word)
    """A run was asked of a machine that has no inertia in some position."""


class DynamicsStudy:
    """A machine and its motion by construction."""

    def __init__(self, linkage: LinkageStudy, statics: Statics) -> None:
        self.linkage, self.statics = linkage, statics
        self.made: dict[str, None] = {}

    def construct(self, plans: Collection[str]) -> None:
        """Make what is asked for."""
        asked = {REDUCTION: "reduced", WORKS: "works", FLYWHEEL: "loop", SPEEDS: "curve", RUN: "run"}
        for plan, name in asked.items():
            if plan in plans and (plan == REDUCTION or self.steady or self.task.delta is not None):
                getattr(self, name)

    @cached_property
    def task(self) -> Task:
        """What is asked of the motion."""
        return task_of(self.linkage.scene)

    @cached_property
    def reduction(self) -> Reduction:
        """The reduction to the crank, at any position."""
        return Reduction(self.linkage, self.statics)

    @cached_property
    def reduced(self) -> Reduced:
        """Reduced moment and inertia at the positions of the scene."""
        self.made.setdefault(REDUCTION)
        return self.reduction.reduced

    @property
    def steady(self) -> bool:
        """Whether a steady turn is asked for, and the crank can turn fully."""
        return not self._form.reduction and not self.linkage.barriers and self.linkage.assembly.phi is not None

    @property
    def account(self) -> Account:
        """All that is found by construction; the reduction alone where the crank cannot turn fully."""
        if not self.steady and self.task.delta is None:
            return Account(CONSTRUCTION, self.reduced)
        return Account(CONSTRUCTION, self.reduced, self.cycle, self.flywheel, self.speeds, self.before, self.run)

    @cached_property
    def turn(self) -> SteadyStrips:
        """The steady turn in strips."""
        study = self.linkage
        if not self.steady:
            line, _ = study.scene.place(("dynamics",))
            why = message("dynamics.no_cycle", why=obstruction(study.sweep))
            raise NoCycle(placed(f"{study.scene.file}:{line}", why))
        return SteadyStrips(self.reduction, self.task.divisions)

    @cached_property
    def works(self) -> WorkDiagram:
        """The works of the steady turn."""
        self.made.setdefault(WORKS)
        return self.turn.works

    @property
    def cycle(self) -> Cycle:
        """The account of the steady turn."""
        return self.works.cycle

    @cached_property
    def loop(self) -> Loop | None:
        """Wittenbauer's loop with its tangents; None where no fluctuation is asked for."""
        if self.task.delta is None:
            return None
        self.made.setdefault(FLYWHEEL)
        return loop(self.cycle, self.task)

    @property
    def flywheel(self) -> Flywheel | None:
        """The flywheel; None where no fluctuation is asked for."""
        return self.loop.flywheel if self.loop else None

    @cached_property
    def methods(self) -> Methods | None:
        """J0 by other methods from the points of the loop; None where no fluctuation is asked for."""
        return methods(self.cycle, self.task)

    @cached_property
    def wheel(self) -> Wheel | None:
        """The rim of the flywheel; None where no flywheel is needed."""
        return rim_of(self.flywheel.inertia, self.task.rim) if self.flywheel else None

    @property
    def bare(self) -> float:
        """The inertia kg*m2 of the machine at position 0 without a flywheel."""
        return self.cycle.own + self.task.present

    @cached_property
    def curve(self) -> SpeedCurve | None:
        """The motion with the flywheel, or of a machine that needs none; None where no fluctuation is asked for."""
        wheel = self.flywheel
        if wheel is None:
            return None
        if wheel.needed <= 0:
            return self.unaided
        self.made.setdefault(SPEEDS)
        return speed_curve(self.cycle, self.works.edge.slope, wheel.whole, wheel.energy, wheel.touches)

    @cached_property
    def unaided(self) -> SpeedCurve | None:
        """The motion without a flywheel; None where the machine would stop."""
        self.made.setdefault(SPEEDS)
        lightest = self.bare + float(self.cycle.varying.min())
        energy = natural(self.cycle, self.bare, self.task.speed) if lightest > 0 else None
        return None if energy is None else speed_curve(self.cycle, self.works.edge.slope, self.bare, energy)

    @cached_property
    def motor(self) -> Motor | None:
        """The motor; None where the scene gives no law of its moment."""
        return motor_of(self._form.motor)

    @cached_property
    def run(self) -> MachineRun | None:
        """The run from rest by the table; None without a motor."""
        if self.motor is None:
            return None
        self.made.setdefault(RUN)
        self._check_inertia()
        return run(reduced_link(self.works, self.constant), self.motor, self.run_task)

    def _check_inertia(self) -> None:
        """See that something has inertia in every position: else the motor has nothing to speed up there."""
        masses = self.cycle.inertia + self.constant
        if masses.min() <= ROUNDED * masses.max():
            scene, angle = self.linkage.scene, f"{np.degrees(self.cycle.turned[int(masses.argmin())]):.4g}"
            line, column = scene.place(("dynamics", "motor"))
            raise NoInertia(placed(f"{scene.file}:{line}:{column}", message("dynamics.no_inertia", angle=angle)))

    @property
    def constant(self) -> float:
        """The constant inertia kg*m2 beside the linkage: shafts, and the flywheel where one is found."""
        return self.task.present + (self.flywheel.inertia if self.flywheel else 0.0)

    @property
    def run_task(self) -> RunTask:
        """What is asked of the run."""
        return run_task(self._form.run, self.task.speed)

    @property
    def _form(self) -> DynamicsTable:
        return self.linkage.scene.of(DynamicsForm).dynamics

    @property
    def speeds(self) -> Speeds | None:
        """The achieved motion."""
        return self.curve.speeds if self.curve else None

    @property
    def before(self) -> Speeds | None:
        """The motion without a flywheel."""
        return self.unaided.speeds if self.unaided else None


def study_of(study: Study) -> DynamicsStudy:
    """Make the study of a scene's motion; the pace of the drive does not enter it."""
    if study.scene.of(DynamicsForm).drive.speed_from == DRIVE:
        return DynamicsStudy(study.of(LinkageStudy), study.of(Statics))
    linkage = LinkageStudy(study.scene, study.plans)
    return DynamicsStudy(linkage, Statics(linkage))


def driving_of(study: Study) -> float | None:
    """Give the constant moment N*m that drives a machine over a steady turn; None where loads drive it, or none is."""
    machine = study.of(DynamicsStudy)
    return machine.cycle.driving if machine.steady and machine.cycle.driving > 0 else None
