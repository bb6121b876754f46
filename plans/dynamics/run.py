"""The run of a machine by the book's table (разбег, установившееся движение, выбег табличным методом; table 6.1)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from plans.dynamics.loop import ANGLE, ROWS, ROWS_MOST, STOP, Acting, Ends, RunPart, RunRow, by_acceleration, by_energy
from plans.model.dynamics import CONSTRUCTION, TURN
from plans.model.motor import Motor
from plans.model.run import (
    PLACES,
    RUN_DOWN,
    RUN_UP,
    STALLED,
    STEADY,
    TOO_MANY_ROWS,
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
    Works,
    bears,
    goal_of,
    stiffness_of,
)

TABLE = "table"
# A step is at most this part of the time in which a change of speed dies away e-fold where the motor is steepest: the
# table is then off by about an eighth of such a change while it dies away, and does not swing, as it would from 1 on.
PART = 0.25

STRIPS = 360  # of a turn, for the mean resistance: fine enough not to be told from the exact one


def run(link: ReducedLink, motor: Motor, task: RunTask) -> MachineRun:
    """Make the table of a machine's run from rest."""
    return _TableOfRun(link, motor, task).run


def step_of(link: ReducedLink, motor: Motor, task: RunTask) -> float:
    """Give the step s of the table: as asked, or a strip of a turn at full speed, less where the motor is stiff."""
    if task.step is not None:
        return task.step
    period = TURN / (motor.speed(0.0) or task.speed)
    decays = stiffness_of(link, motor, TURN / period)
    return min(period / PLACES, PART * period / decays) if decays else period / PLACES


def mean_resistance(link: ReducedLink) -> float:
    """Give the mean moment N*m over a turn with which the resistance hinders the motion, by ordinates at middles."""
    acting = Acting(link, None, loaded=True)
    edges = [k * TURN / STRIPS for k in range(STRIPS + 1)]
    return sum(acting.works(RunRow(0.0, low, 0.0, 0.0), high).useful for low, high in pairwise(edges)) / TURN


@dataclass
class _TableOfRun:
    """A table in the making: parts are added to it stage by stage, until one fails."""

    link: ReducedLink
    motor: Motor
    task: RunTask
    rows: list[RunRow] = field(default_factory=list)
    stages: list[Stage] = field(default_factory=list)
    steady: SteadyTurn | None = None
    failure: Failure | None = None

    @property
    def step(self) -> float:
        """The step s."""
        return step_of(self.link, self.motor, self.task)

    @property
    def run(self) -> MachineRun:
        """The run with all its stages."""
        if self._runs_up() and self._goes_on() and self.task.brake is not None:
            self._runs_down(self.task.brake)
        t, turned, omega, epsilon = np.array(self.rows, dtype=float).T
        stages, method = tuple(self.stages), self._method
        return MachineRun(CONSTRUCTION, t, turned, omega, epsilon, stages, self.steady, method, self.failure)

    @property
    def _method(self) -> Method:
        decays = stiffness_of(self.link, self.motor, self.motor.speed(0.0) or self.task.speed)
        return Method(TABLE, decays, step=self.step)

    def _runs_up(self) -> bool:
        acting = Acting(self.link, self.motor, self.task.loaded)
        start = acting.row(0.0, 0.0, 0.0)
        resisting = mean_resistance(self.link) if self.task.loaded else 0.0
        goal = goal_of(self.motor, self.task, resisting)
        if goal is None or start.epsilon <= 0:
            self.rows.append(start)
            at_start = self.motor.moment(0.0) - start.epsilon * self.link.inertia(0.0)  # of loads and weights
            return self._fails(RUN_UP, TOO_WEAK, max(resisting, at_start))
        part = by_acceleration(acting, start, self.step, Ends(TURNS_MOST * TURN, self._left, goal))
        self._append(RUN_UP, acting, [part])
        return self._ended(RUN_UP, part, goal)

    def _goes_on(self) -> bool:
        """Go on with the loaded motion to the end of its turn, then over the whole turns that are asked for."""
        acting = Acting(self.link, self.motor, loaded=True)
        row = acting.row(*self.rows[-1][:3])
        first = math.ceil(row.turned / TURN) * TURN
        parts: list[RunPart] = []
        for k in range(self.task.turns + 1):
            used = sum(len(part.rows) for part in parts)
            parts.append(by_energy(acting, row, self.step, Ends(first + k * TURN, self._left - used)))
            row = parts[-1].rows[-1]
            if parts[-1].reason != ANGLE:
                break
        self._append(STEADY, acting, parts)
        resisting = mean_resistance(self.link)
        if parts[-1].reason == ANGLE and not bears(self.motor, resisting):
            return self._fails(STEADY, TOO_WEAK, resisting)
        self.steady = _turn(parts[-1]) if parts[-1].reason == ANGLE else None
        return self.steady is not None or self._ended(STEADY, parts[-1], resisting)

    def _runs_down(self, brake: float) -> None:
        acting = Acting(self.link, None, brake=brake)
        row = acting.row(*self.rows[-1][:3])
        part = by_acceleration(acting, row, self.step, Ends(row.turned + TURNS_MOST * TURN, self._left))
        self._append(RUN_DOWN, acting, [part])
        if part.reason != STOP:
            self._ended(RUN_DOWN, part, 0.0)

    @property
    def _left(self) -> int:
        """The rows that may still be added."""
        return ROWS_MOST - len(self.rows)

    def _append(self, name: str, acting: Acting, parts: Sequence[RunPart]) -> None:
        """Add a stage made of some parts; the row that two of them share is added once."""
        rows = [*parts[0].rows, *(row for part in parts[1:] for row in part.rows[1:])]
        first, works = len(self.rows), Works()
        for part in parts:
            works = works.joined(part.works)
        self.rows += rows
        energies = (acting.energy(rows[0]), acting.energy(rows[-1]))
        self.stages.append(Stage(name, first, len(self.rows) - 1, works, energies))

    def _ended(self, stage: str, part: RunPart, limit: float) -> bool:
        """See how a part has ended: whether the run goes on, and if not, why."""
        if part.reason == ROWS:
            return self._fails(stage, TOO_MANY_ROWS, ROWS_MOST)
        failed = {STOP: STALLED, ANGLE: UNSETTLED}.get(part.reason)
        return failed is None or self._fails(stage, failed, limit)

    def _fails(self, stage: str, reason: str, limit: float) -> bool:
        self.failure = Failure(stage, reason, self.rows[-1].turned, self.rows[-1].omega, limit)
        return False


def _turn(part: RunPart) -> SteadyTurn:
    """Take the account of a turn."""
    first, last = part.rows[0], part.rows[-1]
    speeds = [row.omega for row in part.rows]
    return SteadyTurn(first.omega, (min(speeds), max(speeds)), last.t - first.t, last.omega - first.omega, part.works)
