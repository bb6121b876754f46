"""The run of a machine by the differential equation of its reduced link (разбег, установившееся движение, выбег).

The solver is chosen by the problem: an explicit one, or where the motor is so stiff that it would have to follow every
decay of a change of speed, an implicit one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from plans.analytic.dynamics.equation import (
    ANGLE,
    AT_REST,
    EXPLICIT,
    IMPLICIT,
    STIFF,
    STOP,
    Equation,
    Leg,
    LegEnds,
    RunState,
    Solver,
    size_of,
)
from plans.model.dynamics import ANALYSIS, TURN
from plans.model.motion import Floats
from plans.model.motor import Motor
from plans.model.run import (
    RUN_DOWN,
    RUN_UP,
    STALLED,
    STEADY,
    TOO_WEAK,
    TURNS_MOST,
    UNSETTLED,
    Failure,
    MachineRun,
    Method,
    ReducedLink,
    RunTask,
    Stage,
    SteadyTurn,
    bears,
    beyond,
    goal_of,
    stiffness_of,
)

SHOWN = 24  # rows of a turn at least, so that a curve can be drawn through them
NODES = 12  # of Gauss' rule between two breaks: a load's moment is far smoother than a polynomial of order 23
TRIALS = 12  # turns that are followed at most, to find the one that repeats itself
REPEATED = 1e-11  # change of the speed in a turn, in shares of it, at which the turn repeats itself


def run(link: ReducedLink, motor: Motor, task: RunTask) -> MachineRun:
    """Find the run of a machine from rest."""
    return _GrowingRun(link, motor, task).run


def chosen(link: ReducedLink, motor: Motor, speed: float) -> Solver:
    """Choose the solver by how stiff the motor is at a speed, with rows enough for a drawing."""
    name = IMPLICIT if stiffness_of(link, motor, speed) > STIFF else EXPLICIT
    return Solver(name, size_of(link, speed), TURN / speed / SHOWN)


class SteadySwing:
    """The motion of a machine in the turn that it settles to, with its motor, between the rows of its solution."""

    def __init__(self, link: ReducedLink, motor: Motor, start: float) -> None:
        self.link, self.motor = link, motor
        solver = chosen(link, motor, motor.speed(0.0) or start)
        rows = solver.leg(Equation(link, motor, loaded=True), _at(start), LegEnds(TURN)).rows
        self._turned, self._omega, self._slope = rows[:, 1], rows[:, 2], rows[:, 3] / rows[:, 2]

    def omega(self, turned: Floats) -> Floats:
        """Give the angular velocity of the crank, rad/s, at angles turned (N,): Hermite's cubic from row to row."""
        at = np.clip(np.searchsorted(self._turned, turned, "right"), 1, len(self._turned) - 1)
        step = self._turned[at] - self._turned[at - 1]
        part = (turned - self._turned[at - 1]) / step
        left, right = self._slope[at - 1] * step, self._slope[at] * step
        rise = self._omega[at] - self._omega[at - 1]
        bent = part * (1 - part) * ((left - rise) * (1 - part) + (rise - right) * part)
        return np.asarray(self._omega[at - 1] + part * rise + bent)

    def epsilon(self, turned: Floats) -> Floats:
        """Give its angular acceleration, rad/s2 (6.8); at a jump of the forces as it is beyond it."""
        equation = Equation(self.link, self.motor, loaded=True)
        places = zip(turned.tolist(), self.omega(turned).tolist(), strict=True)
        return np.array([equation.epsilon(beyond(place), omega) for place, omega in places])


def mean_resistance(link: ReducedLink) -> float:
    """Give the mean moment N*m over a turn with which the resistance hinders the motion."""
    edges = [0.0, *(place for place in link.breaks if place > 0.0), TURN]
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    work = 0.0
    for low, high in pairwise(edges):
        half = (high - low) / 2
        places = ((low + high) / 2 + half * nodes).tolist()
        work += half * float(np.dot(weights, [link.resistance(place) for place in places]))
    return -work / TURN


def kinetic(link: ReducedLink, state: RunState) -> float:
    """Give the kinetic energy J of the machine in a state."""
    return link.inertia(state.turned) * state.omega**2 / 2


@dataclass
class _GrowingRun:
    """A run in the making: legs are added to it stage by stage, until one fails."""

    link: ReducedLink
    motor: Motor
    task: RunTask
    legs: list[Leg] = field(default_factory=list)  # that make the rows
    stages: list[Stage] = field(default_factory=list)
    steady: SteadyTurn | None = None
    failure: Failure | None = None

    def __post_init__(self) -> None:
        free = self.motor.speed(0.0)
        self.equation = Equation(self.link, self.motor, self.task.loaded, base=free or 0.0)
        self.mean = mean_resistance(self.link)
        self.solver = chosen(self.link, self.motor, free or self.task.speed)

    @property
    def run(self) -> MachineRun:
        """The run with all its stages."""
        if self._runs_up() and self._goes_on() and self.task.brake is not None:
            self._runs_down(self.task.brake)
        t, turned, omega, epsilon = np.concatenate([leg.rows for leg in self.legs] or [np.zeros((1, 4))]).T
        stages = tuple(self.stages)
        return MachineRun(ANALYSIS, t, turned, omega, epsilon, stages, self.steady, self._method, self.failure)

    @property
    def _method(self) -> Method:
        return Method(
            self.solver.name,
            stiffness_of(self.link, self.motor, self.motor.speed(0.0) or self.task.speed),
            tolerance=self.solver.tolerance,
        )

    @property
    def _now(self) -> RunState:
        return self.legs[-1].end if self.legs else AT_REST

    def _runs_up(self) -> bool:
        resisting = self.mean if self.task.loaded else 0.0
        goal, start = goal_of(self.motor, self.task, resisting), self.equation.moments(beyond(0.0), 0.0)
        if goal is None or sum(start) <= 0:
            return self._fails(RUN_UP, TOO_WEAK, max(resisting, -sum(start[1:])))
        leg = self.solver.leg(self.equation, AT_REST, LegEnds(TURNS_MOST * TURN, goal))
        self._append(RUN_UP, AT_REST, [leg])
        if leg.reason == STOP:
            return self._fails(RUN_UP, STALLED, goal)
        return leg.reason != ANGLE or self._fails(RUN_UP, UNSETTLED, goal)

    def _goes_on(self) -> bool:
        """Follow the loaded motion to the end of its turn, then the whole turns that are asked for."""
        since, equation = self._now, replace(self.equation, loaded=True)
        legs: list[Leg] = []
        first = math.ceil(since.turned / TURN) * TURN
        for k in range(self.task.turns + 1):
            leg = self.solver.leg(equation, legs[-1].end if legs else since, LegEnds(first + k * TURN))
            legs.append(leg)
            if leg.reason == STOP:
                self._append(STEADY, since, legs)
                return self._fails(STEADY, STALLED, self.mean)
        self._append(STEADY, since, legs)
        if not bears(self.motor, self.mean):
            return self._fails(STEADY, TOO_WEAK, self.mean)
        self.steady = self._settled(equation, since if len(legs) == 1 else legs[-2].end, legs[-1])
        return True

    def _settled(self, equation: Equation, start: RunState, last: Leg) -> SteadyTurn:
        """Find the turn that repeats itself, by Aitken's rule on the speeds with which turns begin.

        A constant moment has no such turn, or any one is: then it is the last that was followed.
        """
        best = _turn(start, last)
        for _ in range(TRIALS if self.motor.steepness > 0 else 0):
            if abs(best.closing) <= REPEATED * best.start:
                break
            speeds = [best.start, best.start + best.closing]
            leg = self._trial(equation, speeds[1])
            if leg is None:
                break
            begun = _turn(_at(speeds[1]), leg)
            keeps = begun.closing / best.closing
            settled = speeds[1] + begun.closing / (1 - keeps) if keeps < 1 - REPEATED else 0.0
            leg = self._trial(equation, settled) if settled > 0 else None
            if leg is None:
                return begun
            best = _turn(_at(float(leg.rows[0, 2])), leg)
        return best

    def _trial(self, equation: Equation, omega: float) -> Leg | None:
        """Follow a turn that begins at a speed; None where the machine stops in it."""
        leg = self.solver.leg(equation, _at(omega), LegEnds(TURN))
        return leg if leg.reason == ANGLE else None

    def _runs_down(self, brake: float) -> None:
        since, equation = self._now, Equation(self.link, None, brake=brake)
        leg = self.solver.leg(equation, since, LegEnds(since.turned + TURNS_MOST * TURN))
        self._append(RUN_DOWN, since, [leg])
        if leg.reason == ANGLE:
            self._fails(RUN_DOWN, UNSETTLED, 0.0)

    def _append(self, name: str, since: RunState, legs: Sequence[Leg]) -> None:
        first = sum(len(leg.rows) for leg in self.legs)
        self.legs += legs
        end = self._now
        last = sum(len(leg.rows) for leg in self.legs) - 1
        energies = (kinetic(self.link, since), kinetic(self.link, end))
        self.stages.append(Stage(name, first, last, end.works(since), energies))

    def _fails(self, stage: str, reason: str, limit: float) -> bool:
        self.failure = Failure(stage, reason, self._now.turned, self._now.omega, limit)
        return False


def _at(omega: float) -> RunState:
    return RunState(0.0, np.array([0.0, omega, 0.0, 0.0, 0.0, 0.0]))


def _turn(start: RunState, leg: Leg) -> SteadyTurn:
    """Take the account of a turn: extremes of speed are where its acceleration vanishes, or at its rows."""
    speeds = np.concatenate([leg.turning, leg.rows[:, 2]])
    works = leg.end.works(start)
    change = leg.end.omega - start.omega
    return SteadyTurn(start.omega, (float(speeds.min()), float(speeds.max())), leg.end.t - start.t, change, works)
