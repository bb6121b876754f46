"""Equilibrium of a force plan: sums of forces and moments on links, groups and the whole, power, energy (проверка).

Every sum is taken anew from the reactions as they are told, the loads, the masses and the motion of the same road, with
what rounding allows it: the bounds of the reactions carried from step to step, and a rounding of every term.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from geometry.meet import EPS, cross, dot
from geometry.precision import OWN
from plans.forces.loading import carried
from plans.linkage.quantities import largest_of
from plans.model.dyad import Assur
from plans.model.kinetostatics import Kinetostatics, Loading
from plans.model.machine import Body, Machine
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Floats, Motion
from plans.quantity import Quantity


class LinkForce(NamedTuple):
    """A force N on a link at r m, with how far rounding can have moved it; a couple N*m is a force of none."""

    link: int
    r: Any
    force: Any
    couple: Any
    off: Any  # of the force, N
    off_couple: Any  # N*m


# How far rounding can have moved a force N and a moment N*m over the positions: the reaction of each pair by its key
# "3-4", the inertia of each link by its number "3", and what drives the crank by BALANCING.
Bounds = Mapping[str, tuple[Floats, Floats]]
BALANCING = "balancing"


def acting(
    mechanism: Mechanism, machine: Machine, motion: Motion, loading: Loading, forces: Kinetostatics, bounds: Bounds
) -> list[LinkForce]:
    """List everything that acts on the moving links: inertia, weights, loads, reactions, and what drives the crank."""
    zero = np.zeros(len(motion.phi))
    found = [_body(mechanism, machine, motion, body, bounds[str(body.link)]) for body in machine.bodies.values()]
    for load in loading.forces:
        if load.link != FRAME:
            r, off = motion.points[load.point].r, EPS * abs(load.force)
            found.append(LinkForce(load.link, r, load.force, zero, off, zero))
    for twist in loading.moments:
        found.append(LinkForce(twist.link, 0j * zero, 0j * zero, twist.moment, zero, EPS * abs(twist.moment)))
    for key, reaction in forces.reactions.items():
        moment = zero if reaction.moment is None else reaction.moment
        off, off_moment = bounds[key]
        found.append(LinkForce(reaction.taker, reaction.r, reaction.force, moment, off, off_moment))
        found.append(LinkForce(reaction.giver, reaction.r, -reaction.force, -moment, off, off_moment))
    return [force for force in (*found, _drive(mechanism, forces, bounds[BALANCING])) if force.link != FRAME]


def _body(
    mechanism: Mechanism, machine: Machine, motion: Motion, body: Body, bound: tuple[Floats, Floats]
) -> LinkForce:
    """Give inertia and weight of a link; where it is and how it moves follow from one of its points and its turning."""
    first = motion.points[next(iter(mechanism.links[body.link].points))].a
    r, _, bent = carried(mechanism, motion, body.link, body.centre)
    force = body.mass * (machine.gravity - bent)
    # Taken here from a point and the turning of the link, on the plan from the image of the mass centre: twice a bound.
    rounded = OWN * EPS * (np.abs(body.mass * machine.gravity) + body.mass * (np.abs(first) + np.abs(bent - first)))
    couple = -body.inertia * motion.links[body.link].epsilon
    return LinkForce(body.link, r, force, couple, 2 * bound[0] + rounded, 2 * bound[1])


def _drive(mechanism: Mechanism, forces: Kinetostatics, bound: tuple[Floats, Floats]) -> LinkForce:
    balancing, link = forces.balancing, mechanism.drive.link
    zero = 0.0 * balancing.moment
    if balancing.force is None or balancing.r is None:
        return LinkForce(link, 0j * zero, 0j * zero, balancing.moment, zero, bound[1])
    return LinkForce(link, balancing.r, balancing.force, zero, bound[0], zero)


def balance(
    name: str, parts: Sequence[LinkForce], places: Floats, most: tuple[float, float] | None = None
) -> tuple[Quantity, Quantity]:
    """Sum forces and moments about the shaft; `own` is the bound m of the places.

    `most` are the largest force N and moment N*m of the machine: on a link that nothing loads rounding alone is left.
    """
    force = np.sum([part.force for part in parts], axis=0)
    moment = np.sum([cross(part.r, part.force) + part.couple for part in parts], axis=0)
    sizes, arms = np.array([np.abs(part.force) for part in parts]), np.array([np.abs(part.r) for part in parts])
    off = np.array([part.off for part in parts])
    slack = off.sum(axis=0) + len(parts) * EPS * sizes.max(axis=0)
    turned = np.array([part.off_couple + EPS * np.abs(part.couple) for part in parts]).sum(axis=0)
    lever = (arms * off).sum(axis=0) + (sizes * places).sum(axis=0) + len(parts) * EPS * (arms * sizes).sum(axis=0)
    most = largest(parts) if most is None else most
    forces = Quantity.vanishing(f"ΣF {name}", "N", np.abs(force), slack, most[0])
    return forces, Quantity.vanishing(f"ΣM {name}", "N*m", np.abs(moment), turned + lever, most[1])


def largest(parts: Sequence[LinkForce]) -> tuple[float, float]:
    """Give the largest force N and the largest moment N*m about the shaft that act anywhere, over all positions."""
    moments = [np.abs(part.r) * np.abs(part.force) + np.abs(part.couple) for part in parts]
    return largest_of([np.abs(part.force) for part in parts]), largest_of(moments)


def balances(mechanism: Mechanism, groups: Sequence[Assur], parts: Sequence[LinkForce], off: Floats) -> list[Quantity]:
    """Check each link, each group and the whole; reactions within a group and within the whole cancel."""
    links = sorted(set(mechanism.links) - {FRAME})
    bodies = [(str(link), [link]) for link in links]
    bodies += [("-".join(map(str, group.links)), [*group.links]) for group in groups]
    bodies, most = [*bodies, ("whole", links)], largest(parts)
    found = (balance(name, [part for part in parts if part.link in body], off, most) for name, body in bodies)
    return [quantity for both in found for quantity in both]


def power(mechanism: Mechanism, motion: Motion, parts: Sequence[LinkForce], slack: Floats, turning: Floats) -> Quantity:
    """Sum the power W of all that acts on the moving links: reactions of ideal pairs have none (M5.8).

    `slack` m/s and `turning` rad/s are the bounds of the velocities.
    """
    terms, bounds = [], []
    for part in parts:
        turned, name = motion.links[part.link], next(iter(mechanism.links[part.link].points))
        point = motion.points[name]
        v = point.v + 1j * turned.omega * (part.r - point.r)
        terms.append(dot(part.force, v) + part.couple * turned.omega)
        given = np.abs(v) * part.off + np.abs(turned.omega) * part.off_couple
        bounds.append(given + np.abs(part.force) * slack + np.abs(part.couple) * turning)
    sizes = np.array([np.abs(term) for term in terms])
    allowed = np.sum(bounds, axis=0) + len(terms) * EPS * sizes.sum(axis=0)
    fastest = [np.abs(point.v) for point in motion.points.values()]
    most = max(largest_of([sizes]), largest(parts)[0] * largest_of(fastest))
    return Quantity.vanishing("power", "W", np.abs(np.sum(terms, axis=0)), allowed, most)
