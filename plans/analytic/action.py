"""How the drive acts on the crank: by a moment, or by a force along a line of action (линия действия)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from plans.analytic.constraints import TURN, Constraints, X, Y
from plans.analytic.points import place
from plans.model.kinetostatics import Balancing
from plans.model.machine import FORCE, GEAR, Transmission
from plans.model.mechanism import FRAME, Drive, Mechanism
from plans.model.motion import Complexes, Floats


class Multipliers(NamedTuple):
    """Poses (N, links, 3), and the multiplier of the drive's equation at them, N*m."""

    poses: Floats
    drive: Floats


class Action(NamedTuple):
    """A line of action over the positions: a point of it, m, its unit direction, and the shaft's place."""

    r: Complexes
    along: Complexes
    shaft: Complexes


def action(transmission: Transmission, mechanism: Mechanism, constraints: Constraints, poses: Floats) -> Action | None:
    """Give the line of action of a crank driven by force; None where a moment drives it, and of a slide."""
    drive, own = mechanism.drive, mechanism.links[mechanism.drive.link].points
    if drive.guide is not None:
        return None
    shaft = place(constraints, poses, drive.link, own[drive.pivot])
    if transmission.kind == FORCE:
        end = place(constraints, poses, drive.link, own[drive.end])
        return Action(end, 1j * (end - shaft) / np.abs(end - shaft), shaft)
    if transmission.kind == GEAR:
        towards, along = _mesh(transmission, drive)
        return Action(shaft + transmission.radius * towards, np.full(len(poses), along), shaft)
    return None


def _mesh(gear: Transmission, drive: Drive) -> tuple[complex, complex]:
    """Give the directions from the shaft to the pitch point, and of the teeth's push there (figure 6.17).

    The push turns the wheel on, and is turned from the pitch tangent by the pressure angle towards the shaft.
    """
    sense = -1.0 if drive.omega < 0.0 else 1.0
    towards = np.exp(1j * gear.at)
    return complex(towards), complex(1j * towards * sense * np.exp(1j * sense * gear.pressure))


def unit_force(constraints: Constraints, poses: Floats, line: Action) -> Floats:
    """Give the generalised force of a unit force along the line on the crank, in place of the drive's equation."""
    row = np.zeros((len(poses), len(constraints.numbers), 3))
    x, y, _ = poses[:, constraints.crank].T
    arm = line.r / constraints.size - (x + 1j * y)
    row[:, constraints.crank, X], row[:, constraints.crank, Y] = line.along.real, line.along.imag
    row[:, constraints.crank, TURN] = (arm.conj() * line.along).imag
    return row[:, 1:].reshape(len(poses), -1)


def balancing(mechanism: Mechanism, constraints: Constraints, line: Action | None, forces: Multipliers) -> Balancing:
    """Read the drive's multiplier, N*m: the moment itself, or the force times `size`; of a slide times its unit."""
    poses, multiplier = forces
    if mechanism.drive.guide is not None:
        return _pushed(mechanism.drive, mechanism, constraints, poses, multiplier)
    if line is None:
        return Balancing(multiplier)
    force = multiplier / constraints.size * line.along
    return Balancing((np.conj(line.r - line.shaft) * force).imag, force, line.r)


def _pushed(
    drive: Drive, mechanism: Mechanism, constraints: Constraints, poses: Floats, multiplier: Floats
) -> Balancing:
    """Give the force along its guide with which a slide is pushed, at the foot of its named point on the line."""
    assert drive.guide is not None  # it is pushed along
    along = drive.guide.way(FRAME).direction
    own, line = mechanism.links[drive.link].points[drive.end], drive.guide.on_slider
    foot = line.through + line.direction * ((own - line.through) / line.direction).real
    r = place(constraints, poses, drive.link, foot)
    return Balancing(multiplier, np.asarray(multiplier / drive.unit * along), r)
