"""The force of a cylinder that turns the crank: its power is that of all other forces (усилие гидроцилиндра).

It acts between the cylinder and its rod along the line of their hinges; the crank then needs no moment of its own.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt

from plans.forces.primary import DRIVING
from plans.linkage.ram import apart
from plans.model.kinetostatics import Applied, Balancing, Kinetostatics, Loading, Reaction
from plans.model.machine import Body, Machine
from plans.model.mechanism import FRAME, Mechanism, Ram
from plans.model.motion import Complexes, Floats, Motion


def joined(parts: Sequence[Kinetostatics]) -> Kinetostatics:
    """Put the forces over parts of the positions together."""
    if len(parts) == 1:
        return parts[0]
    reactions = {}
    for key, first in parts[0].reactions.items():
        told = [part.reactions[key] for part in parts]
        rows = (_together([getattr(one, name) for one in told]) for name in ("r", "force", "moment", "along"))
        reactions[key] = Reaction(first.giver, first.taker, first.point, *rows)
    balancing = Balancing(*(_together(rows) for rows in zip(*(part.balancing for part in parts), strict=True)))
    return Kinetostatics(parts[0].by, np.concatenate([part.phi for part in parts]), reactions, balancing, ())


def without(forces: Kinetostatics, gone: npt.NDArray[np.bool_]) -> Kinetostatics:
    """Leave no force at some positions."""

    def kept(row: Any) -> Any:
        return None if row is None else np.where(gone, np.nan, row)

    reactions = {
        key: one._replace(force=kept(one.force), moment=kept(one.moment)) for key, one in forces.reactions.items()
    }
    told = forces.balancing
    balancing = Balancing(kept(told.moment), kept(told.force), told.r)
    return replace(forces, reactions=reactions, balancing=balancing)


def _together(rows: Sequence[Any]) -> Any:
    return None if rows[0] is None else np.concatenate(rows)


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
    """Give the unit direction from the cylinder's foot to its point, and how fast they part, m/s."""
    span, *rates = (apart(mechanism, motion, order) for order in range(3))
    along = span / np.abs(span)
    return along, (np.conj(along) * _way(mechanism, motion, (rates[0], rates[1]))).real


def _way(mechanism: Mechanism, motion: Motion, rates: tuple[Any, Any]) -> Any:
    """Give the rates by which powers are told: of first order, and where all rests those of second, as those begin."""
    ends = motion.points[mechanism.drive.end]
    return np.where(ends.v == 0, rates[1], rates[0])


def _ends(mechanism: Mechanism) -> Iterator[tuple[int, str, complex]]:
    """Give the links that a cylinder pushes apart, each with its point: rod or its link, cylinder or its link."""
    ram, links = mechanism.drive.ram, mechanism.links
    assert ram is not None  # one drives
    base, moved = ram.links or (FRAME, mechanism.drive.link)
    cylinder, rod = next(_drawn(mechanism, ram), (base, moved))
    yield rod, ram.point, links[rod].points[ram.point]
    yield cylinder, ram.foot, links[cylinder].points[ram.foot]


def _drawn(mechanism: Mechanism, ram: Ram) -> Iterator[tuple[int, int]]:
    """Give cylinder and rod where the scene has them as links: of two that slide in each other the ends of both."""
    for slide in mechanism.slides:
        for base, moved in ((slide.slider, slide.owner), (slide.owner, slide.slider)):
            if ram.foot in mechanism.links[base].points and ram.point in mechanism.links[moved].points:
                yield base, moved


def _power(mechanism: Mechanism, machine: Machine, motion: Motion, loads: Loading) -> Floats:
    """Give the power W, where all rests its rate W/s, of loads, weights, inertia forces and moments, (N,)."""
    total = np.zeros(len(motion.phi))
    for load in loads.forces:
        if load.link != FRAME:
            rates = _rates(mechanism, motion, load.link, load.at)
            total += (np.conj(load.force) * _way(mechanism, motion, rates)).real
    for twist in loads.moments:
        turned = motion.links[twist.link]
        total += twist.moment * _way(mechanism, motion, (turned.omega, turned.epsilon))
    return total + sum((_borne(mechanism, machine, motion, body) for body in machine.bodies.values()), 0.0 * total)


def _borne(mechanism: Mechanism, machine: Machine, motion: Motion, body: Body) -> Floats:
    """Give the power W of the weight and the inertia of a link."""
    v, a = _rates(mechanism, motion, body.link, body.centre)
    turned = motion.links[body.link]
    force = body.mass * (machine.gravity - a)
    way, turning = (_way(mechanism, motion, pair) for pair in ((v, a), (turned.omega, turned.epsilon)))
    return np.asarray((np.conj(force) * way).real - body.inertia * turned.epsilon * turning)


def _rates(mechanism: Mechanism, motion: Motion, link: int, own: complex) -> tuple[Complexes, Complexes]:
    """Give the velocity and the acceleration of a point of a link by its place in the link's own frame."""
    name, first = next(iter(mechanism.links[link].points.items()))
    turned, point = motion.links[link], motion.points[name]
    arm = (own - first) * np.exp(1j * turned.angle)
    return point.v + 1j * turned.omega * arm, point.a + (1j * turned.epsilon - turned.omega**2) * arm
