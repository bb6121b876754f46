"""The machine with its counterweights on: mass, mass centre and inertia of links with them (figure 8.8)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from plans.balance.main_points import EMPTY
from plans.model.balance.linkage import Counterweight
from plans.model.machine import Body, Machine


def loaded(machine: Machine, counterweights: Iterable[Counterweight]) -> Machine:
    """Put the counterweights that are needed on the links of a machine."""
    bodies = dict(machine.bodies)
    for one in counterweights:
        if one.needed:
            bodies[one.link] = _with(bodies.get(one.link, EMPTY._replace(link=one.link)), one)
    return replace(machine, bodies=dict(sorted(bodies.items())))


def _with(body: Body, one: Counterweight) -> Body:
    """Join a counterweight to a link: the new centre divides their distance, and inertia counts about it (Steiner)."""
    mass = body.mass + one.mass
    apart = one.centre - body.centre
    centre = (body.mass * body.centre + one.mass * one.centre) / mass  # of a heavy one on a light link nothing is lost
    inertia = body.inertia + one.inertia + abs(apart) ** 2 * (body.mass * one.mass / mass)
    return Body(body.link, mass, inertia, centre)
