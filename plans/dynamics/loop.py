"""Wittenbauer's loop: energy over inertia, with the tangents of the least and the greatest speed (M4.9, figure 6.5)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from geometry.board import Board, Mark
from plans.model.dynamics import CONSTRUCTION, Cycle, Flywheel, Task, Touch
from plans.model.edge_names import edge_names
from plans.model.motion import Floats
from plans.words.words import because

LOOP = "loop"
SAME = 1e-12  # of the height of the loop: points whose heights differ by less are on one line
LEAST, GREATEST = "ψ_min", "ψ_max"


class Tangent(NamedTuple):
    """A tangent of the loop: its direction, the point that it touches, and what it cuts off the axis of energy."""

    direction: Mark
    touch: Mark
    line: Mark
    cut: Mark  # l of the least speed, k of the greatest
    place: int  # of the point among the edges of the strips


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
    least = _tangent(board, points, axis, (LEAST, "l"), low, _support(low * varying - surplus))
    greatest = _tangent(board, points, axis, (GREATEST, "k"), high, _support(surplus - high * varying))
    origin = board.meet("O", least.line, greatest.line, why=because("machine_origin"))
    both = least, greatest
    touches = [
        Touch(float(cycle.turned[one.place]), float(varying[one.place]), float(surplus[one.place])) for one in both
    ]
    cuts = [complex(one.cut.point).imag for one in both]
    found = Flywheel(
        CONSTRUCTION, (low, high), (touches[0], touches[1]), (cuts[0], cuts[1]), float(cycle.inertia[0]), task.present
    )
    return Loop(board, points, axis, both, origin, found)


def _support(beyond: Floats) -> int:
    """Give the point that a ruler touches first; of several on one line, the first of the turn."""
    return int(np.argmax(beyond >= beyond.max() - SAME * np.ptp(beyond)))


def _tangent(
    board: Board, points: tuple[Mark, ...], axis: Mark, names: tuple[str, str], slope: float, index: int
) -> Tangent:
    angle, letter = names
    direction = board.given(angle, complex(1.0, slope), because("tangent_angle"))
    line = board.parallel(f"τ({angle})", points[index], direction, because("ruler"))
    cut = board.meet(letter, axis, line, why=because("cut_off"))
    return Tangent(direction, points[index], line, cut, index)
