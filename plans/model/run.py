"""The run of a machine from rest to rest (пуск, установившееся движение, выбег), whichever road found it.

The machine is its reduced link (звено приведения): one inertia and one moment at the crank's shaft over the angle
turned, rad from 0 at the position in which it starts. A moment that hinders the motion is negative.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

import numpy as np

from plans.model.dynamics import TURN, Cycle, Fluctuating, Flywheel, Reduced, Speeds
from plans.model.motion import Floats, Gap
from plans.model.motor import Motor
from plans.words.words import Message, message

OfTurn: TypeAlias = Callable[[float], float]  # of the angle turned rad, of period 2 pi
RUN_UP, STEADY, RUN_DOWN = "run_up", "steady", "run_down"
# Why a run ends before its time.
TOO_WEAK, STALLED, UNSETTLED, TOO_MANY_ROWS = "too_weak", "stalled", "unsettled", "too_many_rows"
SETTLED = 0.99  # of the speed that it tends to and never reaches: there a run-up has come to its end
LEFT = 0.01  # of the range of speeds in a turn: a turn that leaves less repeats itself
TUBE = 0.05  # of that range: a change that is no more has died away, as controls are judged (5 %-ная трубка)
TURNS_MOST = 500  # of one stage: a run-up that takes more has not settled


def _nothing(_: float) -> float:
    return 0.0


@dataclass(frozen=True)
class ReducedLink:
    """The machine reduced to the crank's shaft: inertia kg*m2 with its derivative, moments N*m, all of period 2 pi.

    The resistance is switched on when the motion has settled; weights act always. Between two of `breaks` all are
    smooth; at a break the resistance is asked for on either side of it, never on it.
    """

    inertia: OfTurn
    slope: OfTurn  # kg*m2: derivative of the inertia by the angle turned
    resistance: OfTurn = _nothing
    weight: OfTurn = _nothing
    breaks: tuple[float, ...] = ()  # rad, rising, in [0, 2 pi)

    def following(self, turned: float) -> float | None:
        """Give the first break beyond an angle; None where there are none.

        >>> ReducedLink(abs, abs, breaks=(1.0, 2.0)).following(2.0) == 1.0 + TURN
        True
        """
        first, past = turned // TURN, beyond(turned)
        # Whole turns are rounded: the break that is looked for may be in the turn after next.
        places = ((first + turn) * TURN + place for turn in range(3) for place in self.breaks)
        return next((place for place in places if place > past), None)


class RunTask(NamedTuple):
    """What is asked of a run: mean speed rad/s of the steady motion, turns of it, brake N*m, step s of the table."""

    speed: float
    turns: int = 5
    brake: float | None = None  # none: the machine is not stopped
    loaded: bool = False  # whether the resistance acts from the start
    step: float | None = None


class Works(NamedTuple):
    """Works over a stage, J: of the drive; taken by the resistance and by the brake, positive; of weights."""

    driving: float = 0.0
    useful: float = 0.0
    braking: float = 0.0
    weights: float = 0.0

    @property
    def gained(self) -> float:
        """What is left for the kinetic energy (6.1)."""
        return self.driving - self.useful - self.braking + self.weights

    def joined(self, other: Works) -> Works:
        """Add the works of another part of the stage."""
        return Works(*map(sum, zip(self, other, strict=True)))

    @property
    def efficiency(self) -> float | None:
        """The share of the drive's work that is used over a cycle (7.1, кпд); None where nothing drives."""
        return self.useful / self.driving if self.driving > 0 else None

    @property
    def loss(self) -> float | None:
        """The loss factor (коэффициент потерь)."""
        return None if self.efficiency is None else 1 - self.efficiency


class Stage(NamedTuple):
    """A stage of a run: its first and last row, its works, kinetic energy J at its ends (стадия движения)."""

    name: str
    first: int
    last: int
    works: Works
    energies: tuple[float, float]

    @property
    def closing(self) -> float:
        """By how much the account of energy does not close, J."""
        return self.energies[1] - self.energies[0] - self.works.gained


@dataclass(frozen=True)
class SteadyTurn(Fluctuating):
    """A turn of the motion that the machine settles to (цикл установившегося движения).

    `closing` is the change of speed rad/s from its beginning to its end: what is left of a change that dies away.
    """

    start: float  # rad/s: speed at its beginning, position 0
    extremes: tuple[float, float]  # rad/s: least and greatest
    period: float  # s
    closing: float
    works: Works

    @property
    def repeats(self) -> bool:
        """Whether it repeats itself: what is left of the change is lost in the range of its speeds."""
        return abs(self.closing) <= LEFT * (self.extremes[1] - self.extremes[0])


class Method(NamedTuple):
    """How the motion was found: by which method, to which step s or share of rounding.

    `stiffness` is how many times over a change of speed dies away, e-fold, in one turn at full speed.
    """

    name: str
    stiffness: float
    step: float | None = None  # s
    tolerance: float | None = None


class Failure(NamedTuple):
    """Where a run ends before its time: in which stage, why, at which angle rad and speed rad/s."""

    stage: str
    reason: str
    turned: float
    omega: float
    limit: float  # what could not be borne, reached or kept: N*m, rad/s or rows, as the reason says

    @property
    def message(self) -> Message:
        """Say on one line where the run ends, why, and what would help."""
        where = {"phi": f"{math.degrees(self.turned % TURN):.4g}", "turns": f"{self.turned // TURN:g}"}
        size = {"omega": f"{self.omega:.4g}", "limit": f"{self.limit:.5g}"}
        return message(f"run.{self.reason}", stage=message(f"run.{self.stage}"), **where, **size)


@dataclass(frozen=True)
class MachineRun:
    """A run by one road: rows (N,) of time s, angle turned rad, speed rad/s, acceleration rad/s2; its stages.

    The row in which a stage ends and that in which the next begins are of one instant: forces may jump there.
    """

    by: str
    t: Floats
    turned: Floats
    omega: Floats
    epsilon: Floats
    stages: tuple[Stage, ...]
    steady: SteadyTurn | None
    method: Method
    failure: Failure | None = None

    @property
    def gaps(self) -> tuple[Gap, ...]:
        """Where the run ends before its time, as a comparison asks for it: the row in which it does."""
        if self.failure is None:
            return ()
        why = self.failure
        stage = message(f"run.{why.stage}")
        return (Gap(len(self.t) - 1, why.turned % TURN, "run", why.reason, stage, 0.0, why.message),)

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """The gaps, as a comparison asks for them."""
        return self.gaps

    @property
    def drift(self) -> float:
        """By how much, rad/s, the speed changes over the last turn under load; 0 where that is not seen."""
        stage = self.stage(STEADY)
        if stage is None:
            return 0.0
        turned, omega = (row[stage.first : stage.last + 1] for row in (self.turned, self.omega))
        begun = float(turned[-1]) - TURN
        change = float(omega[-1] - np.interp(begun, turned, omega))
        return change if abs(change) > TUBE * float(np.ptp(omega[turned >= before(begun)])) else 0.0

    def stage(self, name: str) -> Stage | None:
        """Give a stage by its name; None where the run has none."""
        return next((stage for stage in self.stages if stage.name == name), None)

    def ends(self, name: str) -> tuple[float, float] | None:
        """Give the instants s at which a stage begins and ends."""
        found = self.stage(name)
        return None if found is None else (float(self.t[found.first]), float(self.t[found.last]))


def beyond(turned: float) -> float:
    """Give an angle that is surely on the far side of a break, in whatever turn it is."""
    return turned * (1 + SIDE) + SIDE


def before(turned: float) -> float:
    """Give an angle that is surely on the near side of a break, in whatever turn it is."""
    return turned * (1 - SIDE) - SIDE


SIDE = 4 * 2.0**-52  # of an angle: what rounding can do to it when whole turns are taken off


def goal_of(motor: Motor, task: RunTask, resisting: float) -> float | None:
    """Give the speed rad/s at which a run-up has come to its end; None where the motor cannot bear the resistance.

    `resisting` is the mean moment N*m that acts against the motion. A motor of constant moment runs up to the speed
    that is asked for; every other one to nearly the speed that it tends to.
    """
    if motor.steepness == 0:
        return task.speed
    found = motor.speed(resisting)
    return SETTLED * found if found is not None and found > 0 else None


def bears(motor: Motor, resisting: float) -> bool:
    """Tell whether a motor has a speed at which it bears a mean resistance N*m; one of constant moment has any."""
    found = motor.speed(resisting)
    return motor.steepness == 0 or (found is not None and found > 0)


def stiffness_of(link: ReducedLink, motor: Motor, speed: float) -> float:
    """Give how many times over, e-fold, the steepest law lets a change of speed die away in a turn at a speed."""
    least = min(link.inertia(k * TURN / PLACES) for k in range(PLACES))
    return motor.steepness / least * TURN / speed


PLACES = 24  # of a turn, at which the least inertia is looked for: for an estimate alone


@dataclass(frozen=True)
class Account:
    """All that one road finds of a machine's motion; None: not asked for, or told elsewhere why there is none."""

    by: str
    reduced: Reduced
    cycle: Cycle | None = None
    flywheel: Flywheel | None = None
    speeds: Speeds | None = None
    before: Speeds | None = None
    run: MachineRun | None = None

    @property
    def unanswered(self) -> tuple[Gap, ...]:
        """No gaps of its own: those of the reduction are the positions', which are compared with them."""
        return ()

    @property
    def gaps(self) -> tuple[Gap, ...]:
        """The gaps of the reduction."""
        return self.reduced.gaps
