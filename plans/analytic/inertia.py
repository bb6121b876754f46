"""Weights and inertia: what masses add to the loads, and their reduction to the crank (силы инерции)."""

from __future__ import annotations

import numpy as np

from plans.analytic.points import TURN, Constraints, acceleration, place, speed
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
