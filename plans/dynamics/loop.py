"""Wittenbauer's loop with its tangents (M4.9, figure 6.5), and the steps of the table method (6.8, 6.9)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from geometry.board import Board, Mark
from plans.dynamics.touch import touched
from plans.model.dynamics import CONSTRUCTION, Cycle, Flywheel, Task, Touch, edge_names
from plans.model.motor import Motor
from plans.model.run import ReducedLink, Works, beyond
from plans.words.words import because

ANGLE, SPEED, STOP, ROWS = "angle", "speed", "stop", "rows"  # what a part of the table ends with
ROWS_MOST = 20_000  # of a table: beyond, its step is too short to be of use


class RunRow(NamedTuple):
    """A row of table 6.1: time s, angle turned rad, speed rad/s, acceleration rad/s2."""

    t: float
    turned: float
    omega: float
    epsilon: float


class RunPart(NamedTuple):
    """Some rows of the table, the works over them, and what it ended with."""

    rows: tuple[RunRow, ...]
    works: Works
    reason: str


class Ends(NamedTuple):
    """With what a part ends, whichever comes first: an angle rad, a speed rad/s above, a number of rows."""

    angle: float
    rows: int
    speed: float = math.inf


@dataclass(frozen=True)
class Acting:
    """What acts in a stage: the drive or none, the resistance or none, a brake N*m."""

    link: ReducedLink
    motor: Motor | None
    loaded: bool = False
    brake: float = 0.0

    def row(self, t: float, turned: float, omega: float) -> RunRow:
        """Make a row: its acceleration is that of the forces beyond it (6.8)."""
        here = beyond(turned)
        moment = self._drive(omega) - self.brake + self.link.weight(here)
        moment += self.link.resistance(here) if self.loaded else 0.0
        epsilon = (moment - omega**2 / 2 * self.link.slope(here)) / self.link.inertia(here)
        return RunRow(t, turned, omega, epsilon)

    def works(self, row: RunRow, turned: float) -> Works:
        """Give the works from a row to an angle: moments are those of the row's speed and of the middles of strips."""
        strips = list(self._strips(row.turned, turned))
        useful = sum(self.link.resistance((low + high) / 2) * (low - high) for low, high in strips)
        weights = sum(self.link.weight((low + high) / 2) * (high - low) for low, high in strips)
        path = turned - row.turned
        return Works(self._drive(row.omega) * path, useful if self.loaded else 0.0, self.brake * path, weights)

    def energy(self, row: RunRow) -> float:
        """Give the kinetic energy J of the machine in a row."""
        return self.link.inertia(row.turned) * row.omega**2 / 2

    def _drive(self, omega: float) -> float:
        return self.motor.moment(omega) if self.motor else 0.0

    def _strips(self, low: float, high: float) -> Iterator[tuple[float, float]]:
        """Part a path at the breaks within it: a resistance is taken on either side of them."""
        while (edge := self.link.following(low)) is not None and edge < high:
            yield low, edge
            low = edge
        yield low, high


def by_acceleration(acting: Acting, row: RunRow, step: float, ends: Ends) -> RunPart:
    """Go on from row to row by the acceleration at the beginning of each step (6.8); the last step is shortened."""
    rows, works, reason = [row], Works(), ""
    while not reason:
        row, reason = _accelerated(acting, row, step, ends)
        works = works.joined(acting.works(rows[-1], row.turned))
        rows.append(row)
        reason = reason or (ROWS if len(rows) >= ends.rows else "")
    return RunPart(tuple(rows), works, reason)


def _accelerated(acting: Acting, row: RunRow, step: float, ends: Ends) -> tuple[RunRow, str]:
    """Give the next row, or that at which the part ends before it."""
    limits = {"": step, **_within(row, ends)}
    reason = min(limits, key=lambda name: limits[name])
    dt = limits[reason]
    turned = row.turned + row.omega * dt + row.epsilon * dt**2 / 2
    omega = {SPEED: ends.speed, STOP: 0.0}.get(reason, row.omega + row.epsilon * dt)
    return acting.row(row.t + dt, ends.angle if reason == ANGLE else turned, omega), reason


def _within(row: RunRow, ends: Ends) -> dict[str, float]:
    """Give after what time each end is reached, if the acceleration stays as it is."""
    found = {ANGLE: _time(row, ends.angle - row.turned)}
    if row.epsilon > 0:
        found[SPEED] = (ends.speed - row.omega) / row.epsilon
    if row.epsilon < 0:
        found[STOP] = row.omega / -row.epsilon
    return found


def _time(row: RunRow, path: float) -> float:
    """Give the time for a path at a constant acceleration, infinite where the path is too long for it."""
    square = row.omega**2 + 2 * row.epsilon * path
    below = row.omega + math.sqrt(square) if square >= 0 else 0.0
    return 2 * path / below if below > 0 else math.inf


def by_energy(acting: Acting, row: RunRow, step: float, ends: Ends) -> RunPart:
    """Go on from row to row by the works over each step (6.9); the last step is shortened."""
    rows, works, reason = [row], Works(), ""
    kept = acting.energy(row)
    while not reason:
        row, reason, work = _carried(acting, row, step, ends.angle, kept)
        works, kept = works.joined(work), kept + work.gained
        rows.append(row)
        reason = reason or (ROWS if len(rows) >= ends.rows else "")
    return RunPart(tuple(rows), works, reason)


def _carried(acting: Acting, row: RunRow, step: float, end: float, kept: float) -> tuple[RunRow, str, Works]:
    """Give the next row and the works to it; where the machine stops before, the row in which it does."""
    limits = {"": step, **_within(row, Ends(end, 0))}
    reason = min(limits, key=lambda name: limits[name])
    dt = limits[reason]
    turned = end if reason == ANGLE else row.turned + row.omega * dt + row.epsilon * dt**2 / 2
    work = acting.works(row, turned)
    if reason != STOP and kept + work.gained <= 0:
        reason, path = STOP, kept / -work.gained * (turned - row.turned)
        turned, dt = row.turned + path, 2 * path / row.omega  # it slows down evenly
        work = acting.works(row, turned)
    left = 0.0 if reason == STOP else kept + work.gained
    omega = math.sqrt(2 * left / acting.link.inertia(turned))
    return acting.row(row.t + dt, turned, omega), reason, work


LOOP = "loop"
LEAST, GREATEST = "ψ_min", "ψ_max"


class Tangent(NamedTuple):
    """A tangent of the loop: its direction, the point that it touches, and what it cuts off the axis of energy."""

    direction: Mark
    touch: Mark
    line: Mark
    cut: Mark  # l of the least speed, k of the greatest


@dataclass(frozen=True)
class Loop:
    """The loop with its two tangents, which meet in the origin of the energy-mass diagram of the whole machine."""

    board: Board
    points: tuple[Mark, ...]
    axis: Mark
    tangents: tuple[Tangent, Tangent]
    origin: Mark
    flywheel: Flywheel


def slopes(speed: float, delta: float) -> tuple[float, float]:
    """Give tan psi of the least and of the greatest speed, J per kg*m2: omega2/2 (6.14, with delta2 kept).

    >>> slopes(10.0, 0.2)
    (40.5, 60.5)
    """
    return (speed * (1 - delta / 2)) ** 2 / 2, (speed * (1 + delta / 2)) ** 2 / 2


def loop(cycle: Cycle, task: Task) -> Loop:
    """Draw the loop of a cycle and push a ruler in either direction until it touches it (TANDIR)."""
    assert task.delta is not None  # asked before
    board, (low, high) = Board(LOOP), slopes(task.speed, task.delta)
    start = board.given("o_1", 0j, because("loop_origin"))
    axis = board.parallel("T", start, board.given("μ_T", 1j, because("energy_axis")), because("energy_axis"))
    varying, surplus, names = cycle.varying, cycle.surplus, edge_names(cycle.turned, task.divisions)
    points = tuple(
        board.given(name, complex(x, y), because("loop_point"))
        for name, x, y in zip(names, varying.tolist(), surplus.tolist(), strict=True)
    )
    touches = touched(cycle, low, -1), touched(cycle, high, 1)
    least = _tangent(board, _touch(board, points, cycle, touches[0], LEAST), axis, (LEAST, "l"), low)
    greatest = _tangent(board, _touch(board, points, cycle, touches[1], GREATEST), axis, (GREATEST, "k"), high)
    origin = board.meet("O", least.line, greatest.line, why=because("machine_origin"))
    cuts = complex(least.cut.point).imag, complex(greatest.cut.point).imag
    found = Flywheel(CONSTRUCTION, (low, high), touches, cuts, cycle.own, task.present)
    return Loop(board, points, axis, (least, greatest), origin, found)


def _touch(board: Board, points: tuple[Mark, ...], cycle: Cycle, touch: Touch, angle: str) -> Mark:
    """Give the point that is touched: one of an edge, or one of the curve between two."""
    edges = np.flatnonzero(cycle.turned == touch.turned)
    if edges.size:
        return points[int(edges[0])]
    return board.given(f"t({angle})", complex(touch.varying, touch.surplus), because("touched_between"))


def _tangent(board: Board, touch: Mark, axis: Mark, names: tuple[str, str], slope: float) -> Tangent:
    angle, letter = names
    direction = board.given(angle, complex(1.0, slope), because("tangent_angle"))
    line = board.parallel(f"τ({angle})", touch, direction, because("ruler"))
    cut = board.meet(letter, axis, line, why=because("cut_off"))
    return Tangent(direction, touch, line, cut)
