"""The force of a cylinder that turns the crank: its power is that of all other forces (усилие гидроцилиндра).

It acts between the cylinder and its rod along the line of their hinges; the crank then needs no moment of its own.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from plans.forces.primary import DRIVING
from plans.linkage.primaries.ram import triangle
from plans.model.kinetostatics import Applied, Loading
from plans.model.machine import Body, Machine
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Complexes, Floats, Motion


def driven(mechanism: Mechanism, machine: Machine, motion: Motion, loads: Loading) -> Loading:
    """Add to loads the force of the cylinder that drives a mechanism over a motion of order 2, where one does."""
    if mechanism.drive.ram is None:
        return loads
    along, _ = _growth(mechanism, motion)
    force = np.asarray(push(mechanism, machine, motion, loads) * along)
    ends = zip(_ends(mechanism), (force, 0.0 - force), (DRIVING, DRIVING.replace("_", "′_")), strict=True)
    told = (Applied(name, *end, one, useful=False) for end, one, name in ends if end[0] != FRAME)
    return loads._replace(forces=(*loads.forces, *told))


def push(mechanism: Mechanism, machine: Machine, motion: Motion, loads: Loading) -> Floats:
    """Give the force N with which a cylinder pushes its ends apart, (N,), under other loads; below zero it pulls."""
    _, growth = _growth(mechanism, motion)
    with np.errstate(invalid="ignore", divide="ignore"):  # a gap is NaN
        return np.asarray(-_power(mechanism, machine, motion, loads) / growth)


def _growth(mechanism: Mechanism, motion: Motion) -> tuple[Complexes, Floats]:
    """Give the unit direction from the cylinder's fixed point to the crank's, and how fast they part, m/s."""
    corner = triangle(mechanism)
    moved = motion.points[corner.ram.point]
    along = (moved.r - corner.fixed) / np.abs(moved.r - corner.fixed)
    return along, (np.conj(along) * moved.v).real


def _ends(mechanism: Mechanism) -> Iterator[tuple[int, str, complex]]:
    """Give the links that a cylinder pushes apart, each with its point: rod or crank, cylinder or frame."""
    ram, links = mechanism.drive.ram, mechanism.links
    assert ram is not None  # one drives
    sliding = {number for slide in mechanism.slides for number in (slide.slider, slide.owner)}
    for point, spare in ((ram.point, mechanism.drive.link), (ram.fixed, FRAME)):
        own = [number for number in mechanism.hinges.get(point, ()) if number in sliding and number != spare]
        link = own[0] if own else spare
        yield link, point, links[link].points[point]


def _power(mechanism: Mechanism, machine: Machine, motion: Motion, loads: Loading) -> Floats:
    """Give the power W of loads, weights, inertia forces and moments over the positions, (N,)."""
    total = np.zeros(len(motion.phi))
    for load in loads.forces:
        if load.link != FRAME:
            total += (np.conj(load.force) * _rates(mechanism, motion, load.link, load.at)[0]).real
    for twist in loads.moments:
        total += twist.moment * motion.links[twist.link].omega
    return total + sum((_borne(mechanism, machine, motion, body) for body in machine.bodies.values()), 0.0 * total)


def _borne(mechanism: Mechanism, machine: Machine, motion: Motion, body: Body) -> Floats:
    """Give the power W of the weight and the inertia of a link."""
    v, a = _rates(mechanism, motion, body.link, body.centre)
    turned = motion.links[body.link]
    force = body.mass * (machine.gravity - a)
    return np.asarray((np.conj(force) * v).real - body.inertia * turned.epsilon * turned.omega)


def _rates(mechanism: Mechanism, motion: Motion, link: int, own: complex) -> tuple[Complexes, Complexes]:
    """Give the velocity and the acceleration of a point of a link by its place in the link's own frame."""
    name, first = next(iter(mechanism.links[link].points.items()))
    turned, point = motion.links[link], motion.points[name]
    arm = (own - first) * np.exp(1j * turned.angle)
    return point.v + 1j * turned.omega * arm, point.a + (1j * turned.epsilon - turned.omega**2) * arm
