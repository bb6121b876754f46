"""Inertia and power of moving links (инерция и мощность звеньев)."""

from __future__ import annotations

import numpy as np

from plans.analytic.closure import as_poses, inverses
from plans.analytic.kinematics import Analysis
from plans.analytic.points import TURN, Constraints, acceleration, place, speed
from plans.analytic.positions import blocks
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
