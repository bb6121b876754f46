"""The balancing moment from the energy balance: masses and velocities alone, no acceleration (уравнение энергии).

M omega = d(T + V)/dt - P of the loads, with T = J omega^2/2; so M = J' omega^2/2 + J epsilon + V' - M_red. The slopes
of the reduced inertia J and of the weights' potential V are differences of positions solved afresh around each one.
It is the only balance that sees a wrong inertia force: the others use that force on either side.
"""

from __future__ import annotations

from math import comb
from typing import NamedTuple

import numpy as np

from plans.analytic.closure import EPS, close, transfer
from plans.analytic.kinematics import Analysis
from plans.analytic.points import Constraints
from plans.analytic.positions import blocks
from plans.analytic.power import potential, reduced_inertia, reduced_moment, transfers
from plans.analytic.turn import TRUST
from plans.model.kinetostatics import Loading
from plans.model.machine import Machine
from plans.model.motion import Floats, Motion

# A central difference of order 8, over positions 1 to 4 steps away, misses by step^8 f9/630 and magnifies roundings by
# 2.1/step: the ninth root of eps makes both eps^(8/9) = 1e-14 where the crank angle in rad is the measure in which the
# mechanism changes. Where it changes faster, the differences of lower orders tell, and a shorter step is tried.
STEPS = EPS ** (1.0 / 9.0) / np.array((1.0, 4.0, 16.0))
ENOUGH = EPS ** (1.0 / 3.0)  # of the energy: five digits of a slope show any wrong mass; no shorter step is needed
CONVERGING = 0.01  # where the orders differ by more than this share, what they leave out is anybody's guess
ORDERS = np.array(
    (
        (4 / 5, -1 / 5, 4 / 105, -1 / 280),  # of order 8
        (3 / 4, -3 / 20, 1 / 60, 0.0),  # of order 6
        (2 / 3, -1 / 12, 0.0, 0.0),  # of order 4
    )
)
RINGS = ORDERS.shape[1]
GROWTH = 2.0 * float(np.abs(ORDERS[0]).sum())  # over the step: by how much a difference magnifies roundings
ROUNDINGS = 8.0  # a Newton step or a linear solution at rest leaves a few roundings of the largest term of each row


class EnergyBalance(NamedTuple):
    """The balancing moment N*m from the energy balance, and by how much that may be off.

    Where a position around cannot be assembled, too near a dead centre, the moment is NaN and its allowance infinite:
    not judged.
    """

    moment: Floats
    allowed: Floats


def energy_balance(road: Analysis, machine: Machine, motion: Motion, loading: Loading) -> EnergyBalance:
    """Balance the drive by energy at all positions of either road's motion; its accelerations are not looked at."""
    constraints, rates, poses = road.constraints, road.rates(motion.phi), road.poses(motion)
    first = transfers(constraints, poses)
    inertia = reduced_inertia(constraints, machine, poses, first)
    loads = reduced_moment(road, motion, loading, first)
    plain, magnified = _rounding(road, machine, motion, loading, first)
    slope, allowed = np.full(len(poses), np.nan), np.full(len(poses), np.inf)
    poor = np.flatnonzero(np.isfinite(loads))
    for step in STEPS:
        if not poor.size:
            break
        around = _around(constraints, poses[poor], first[poor], step)
        energy, size = _energy(constraints, machine, rates.part(poor).omega, around)
        found, doubt = _slope(energy, size, plain[poor] + magnified[poor] / step, step)
        better = doubt < allowed[poor]
        slope[poor[better]], allowed[poor[better]] = found[better], doubt[better]
        poor = poor[~(allowed[poor] <= ENOUGH * size)]
    return EnergyBalance(slope + inertia * rates.epsilon - loads, allowed)


def _energy(constraints: Constraints, machine: Machine, omega: Floats | float, around: Floats) -> tuple[Floats, Floats]:
    """Give kinetic and potential energy J at the speeds omega, (rings, 2, N), and the largest size of both together."""
    kinetic = omega**2 / 2.0 * reduced_inertia(constraints, machine, around, _rates(constraints, around))
    raised = potential(constraints, machine, around)
    return kinetic + raised, (kinetic + np.abs(raised)).max(axis=(0, 1))


def _slope(energy: Floats, size: Floats, rounding: Floats, step: float) -> tuple[Floats, Floats]:
    """Differentiate the energy by the crank angle; give the slope, and by how much it may be off."""
    slopes = ORDERS @ (energy[:, 0] - energy[:, 1]) / step
    # Two differences, for one of them may vanish by chance.
    doubt = np.abs(np.diff(slopes, axis=0)).sum(axis=0)
    converging = doubt <= CONVERGING * (np.abs(slopes[0]) + size) + rounding
    return slopes[0], np.where(converging, doubt + rounding, np.inf)


def _around(constraints: Constraints, poses: Floats, first: Floats, step: float) -> Floats:
    """Solve the positions 1 to 4 steps on and back, (rings, 2, N, links, 3); NaN where they cannot be assembled.

    Each ring is guessed from those within it, by the polynomial through them.
    """
    drive = constraints.drive.coordinate(constraints.place(poses))
    rings = [np.stack((poses, poses))]
    for ring in range(1, RINGS + 1):
        guess = np.stack((poses + step * first, poses - step * first)) if ring == 1 else _guess(rings)
        rings.append(_closed(constraints, guess, poses, np.stack((drive + ring * step, drive - ring * step))))
    return np.array(rings[1:])


def _guess(rings: list[Floats]) -> Floats:
    """Carry the polynomial through all rings so far on to the next, on either side."""
    ring = len(rings)
    guess = np.zeros_like(rings[0])
    for step in range(1, 2 * ring):
        within = rings[ring - step] if step <= ring else rings[step - ring][::-1]
        guess += (-1) ** (step + 1) * comb(2 * ring - 1, step) * within
    return guess


def _closed(constraints: Constraints, guess: Floats, centre: Floats, phi: Floats) -> Floats:
    """Close the guessed poses of a ring; what moves far from its guess, or folds over, is another assembly."""
    closed, flat = np.full_like(guess, np.nan), guess.reshape(-1, *guess.shape[2:])
    centres, side = np.concatenate((centre, centre)), np.tile(_side(constraints, centre), 2)
    sound = np.flatnonzero(np.isfinite(flat).all(axis=(1, 2)))
    for block in blocks(len(sound)):
        here = sound[block]
        poses, reached = close(constraints, flat[here], phi.ravel()[here])
        moved = np.abs(poses - centres[here]).max(axis=(1, 2))
        reached &= np.abs(poses - flat[here]).max(axis=(1, 2)) <= TRUST * moved
        reached &= _side(constraints, poses) == side[here]
        closed.reshape(flat.shape)[here[reached]] = poses[reached]
    return closed


def _side(constraints: Constraints, poses: Floats) -> Floats:
    """Tell assemblies that meet at a singular position apart, by the sign of the Jacobian's determinant."""
    return np.asarray(np.sign(np.linalg.det(constraints.jacobian(constraints.place(poses)))))


def _rates(constraints: Constraints, poses: Floats) -> Floats:
    """Give the first transfer functions of the rings' poses."""
    flat = poses.reshape(-1, *poses.shape[-2:])
    rates = np.full_like(flat, np.nan)
    known = np.flatnonzero(np.isfinite(flat).all(axis=(1, 2)))
    for block in blocks(len(known)):
        rates[known[block]] = transfer(constraints, flat[known[block]], 1)[0]
    return rates.reshape(poses.shape)


def _rounding(
    road: Analysis, machine: Machine, motion: Motion, loading: Loading, first: Floats
) -> tuple[Floats, Floats]:
    """Bound the roundings, and those that a difference magnifies: places are known to kappa, rates to its square."""
    size, rates, kappa = road.constraints.size, road.rates(motion.phi), road.conditions(motion)
    peak = np.abs(first).max(axis=(1, 2))  # the largest rate, lengths in units of `size`
    far = 1.0 + np.abs(road.poses(motion)).max(axis=(1, 2))
    raised, inertia, borne = np.zeros(len(kappa)), np.zeros(len(kappa)), np.zeros(len(kappa))
    for body in machine.bodies.values():
        reach = size + abs(body.centre)
        inertia += 2.0 * (body.mass * reach**2 + body.inertia) * peak**2
        raised += body.mass * abs(machine.gravity) * reach * far
    for load in loading.forces:
        borne += np.abs(load.force) * (size + abs(load.at)) * peak
    for twist in loading.moments:
        borne += np.abs(twist.moment) * peak
    unit = ROUNDINGS * EPS * kappa
    magnified = kappa * rates.omega**2 / 2.0 * inertia + raised
    return unit * kappa * (np.abs(rates.epsilon) * inertia + borne), GROWTH * unit * magnified
