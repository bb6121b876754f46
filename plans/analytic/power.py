"""Inertia and power of moving links, and the balancing moment from the energy balance (уравнение энергии).

M omega = d(T + V)/dt - P of the loads, with T = J omega^2/2; so M = J' omega^2/2 + J epsilon + V' - M_red. The slopes
of the reduced inertia J and of the weights' potential V are differences of positions solved afresh around each one.
It is the only balance that sees a wrong inertia force: the others use that force on either side.
"""

from __future__ import annotations

from math import comb
from typing import NamedTuple

import numpy as np

from plans.analytic.closure import EPS, as_poses, close, inverses, transfer
from plans.analytic.kinematics import Analysis
from plans.analytic.points import TURN, Constraints, acceleration, place, speed
from plans.analytic.positions import blocks
from plans.analytic.turn import TRUST
from plans.model.kinetostatics import Applied, Loading, Twist
from plans.model.machine import Machine
from plans.model.mechanism import Mechanism
from plans.model.motion import Floats, Motion


def borne(mechanism: Mechanism, machine: Machine, motion: Motion) -> Loading:
    """Give weights and inertia forces at the mass centres, and inertia moments: m (g - a_S), -J epsilon (M5.1)."""
    forces, moments = [], []
    for link, body in machine.bodies.items():
        force = body.mass * (machine.gravity - acceleration(mechanism, motion, link, body.centre))
        forces.append(Applied(f"S{link}", link, f"S{link}", body.centre, force))
        moments.append(Twist(f"M{link}", link, -body.inertia * motion.links[link].epsilon))
    return Loading(tuple(forces), tuple(moments))


def reduced_inertia(constraints: Constraints, machine: Machine, poses: Floats, first: Floats) -> Floats:
    """Reduce all masses to the crank, kg*m2: sum (m |dS/dphi|^2 + J (dphi_i/dphi)^2) (приведённый момент, M4.2)."""
    total = np.zeros(poses.shape[:-2])
    for link, body in machine.bodies.items():
        total += body.mass * np.abs(speed(constraints, poses, first, link, body.centre)) ** 2
        total += body.inertia * first[..., constraints.numbers.index(link), TURN] ** 2
    return total


def potential(constraints: Constraints, machine: Machine, poses: Floats) -> Floats:
    """Give the potential energy of the weights, J, counted from the datum."""
    total = np.zeros(poses.shape[:-2])
    for link, body in machine.bodies.items():
        total -= body.mass * (machine.gravity.conjugate() * place(constraints, poses, link, body.centre)).real
    return total


def balancing_moment(road: Analysis, machine: Machine, motion: Motion, loading: Loading) -> Floats:
    """Find the drive's moment N*m: with it, loads, weights and inertia forces have no power together (M5.8)."""
    first = transfers(road.constraints, road.poses(motion))
    masses = borne(road.mechanism, machine, motion)
    return -sum((reduced_moment(road, motion, loads, first) for loads in (loading, masses)), np.zeros(len(first)))


def reduced_moment(road: Analysis, motion: Motion, loading: Loading, first: Floats | None = None) -> Floats:
    """Reduce loads to the crank, N*m: sum (F . dr/dphi + M dphi_i/dphi); a drive at rest has it all the same (M4.4)."""
    constraints, poses = road.constraints, road.poses(motion)
    first = transfers(constraints, poses) if first is None else first
    total = np.zeros(len(poses))
    for load in loading.forces:
        total += (load.force.conj() * speed(constraints, poses, first, load.link, load.at)).real
    for twist in loading.moments:
        total += twist.moment * first[:, constraints.numbers.index(twist.link), TURN]
    total[np.isnan(first[:, 0, 0])] = np.nan
    total[[gap.position for gap in motion.gaps]] = np.nan
    return total


def transfers(constraints: Constraints, poses: Floats) -> Floats:
    """Give the first transfer functions of all poses; NaN where there is no pose, or the Jacobian has no inverse."""
    first = np.full_like(poses, np.nan)
    known = np.flatnonzero(np.isfinite(poses).all(axis=(1, 2)))
    for block in blocks(len(known)):
        here = known[block]
        jacobian = constraints.jacobian(constraints.place(poses[here]))
        inverse = inverses(jacobian)[:, :, -1]  # the drive is the last equation
        regular = inverse.any(axis=1)
        first[here[regular]] = as_poses(inverse[regular])
    return first


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
    flat = around.reshape(-1, *around.shape[-2:])
    rates = np.full_like(flat, np.nan)
    known = np.flatnonzero(np.isfinite(flat).all(axis=(1, 2)))
    for block in blocks(len(known)):
        rates[known[block]] = transfer(constraints, flat[known[block]], 1)[0]
    kinetic = omega**2 / 2.0 * reduced_inertia(constraints, machine, around, rates.reshape(around.shape))
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
