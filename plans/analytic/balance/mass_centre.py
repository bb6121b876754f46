"""Mass centre and main points of a linkage by coordinates (центр масс, главные точки)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Protocol

import numpy as np

from plans.analytic.points import acceleration, placed
from plans.model.balance.linkage import ANALYSIS, Counterweight, MassCentre
from plans.model.machine import Body, Machine
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Motion


def bodies(machine: Machine, counterweights: Sequence[Counterweight] = ()) -> list[Body]:
    """List what has mass: the links, then the counterweights that are needed."""
    needed = (weight for weight in counterweights if weight.needed)
    added = [Body(weight.link, weight.mass, weight.inertia, weight.centre) for weight in needed]
    return [*machine.bodies.values(), *added]


def mass_centre(mechanism: Mechanism, solid: Sequence[Body], motion: Motion) -> MassCentre:
    """Sum m*r_S, m*a_S and the moments of the inertia forces about the datum over all bodies."""
    statics, forces = np.zeros((2, len(motion.phi)), dtype=np.complex128)
    moment = np.zeros(len(motion.phi))
    for body in solid:
        r = placed(mechanism, motion, body.link, body.centre)
        inertia = -body.mass * acceleration(mechanism, motion, body.link, body.centre)
        statics, forces = statics + body.mass * r, forces + inertia
        moment += (r.conj() * inertia).imag - body.inertia * motion.links[body.link].epsilon
    mass = sum(body.mass for body in solid)
    return MassCentre(ANALYSIS, motion.phi, mass, statics / mass, -forces / mass, moment)


def sizes(mechanism: Mechanism, solid: Sequence[Body], motion: Motion) -> tuple[float, float, float]:
    """Give the largest sums of sizes over a motion: of m*r_S kg*m, of inertia forces N, of their moments N*m."""
    rows = np.zeros((3, len(motion.phi)))
    for body in solid:
        r = np.abs(placed(mechanism, motion, body.link, body.centre))
        force = body.mass * np.abs(acceleration(mechanism, motion, body.link, body.centre))
        turning = body.inertia * np.abs(motion.links[body.link].epsilon)
        rows += np.array([body.mass * r, force, r * force + turning])
    most = np.fmax.reduce(rows, axis=1, initial=0.0)
    return float(most[0]), float(most[1]), float(most[2])


class Begun(Protocol):
    """Where a link begins: its place in the link's own frame, and in that of the link which it follows."""

    @property
    def link(self) -> int: ...  # noqa: D102
    @property
    def parent(self) -> int: ...  # noqa: D102
    @property
    def origin(self) -> complex: ...  # noqa: D102
    @property
    def at(self) -> complex: ...  # noqa: D102


def vectors(solid: Sequence[Body], begun: Iterable[Begun]) -> dict[int, complex]:
    """Give the vector h of each link in its own frame, m."""
    stems = {stem.link: stem for stem in begun}
    terms: dict[int, list[complex]] = {link: [] for link in stems}
    for body in solid:
        for link, arm in _path(stems, body):
            terms[link].append(body.mass * arm)
    whole = sum(body.mass for body in solid)
    return {link: complex(np.sum(values)) / whole for link, values in terms.items()}


def _path(stems: Mapping[int, Begun], body: Body) -> Iterator[tuple[int, complex]]:
    """Give the links from a mass down to the frame, each with the vector through it."""
    link, place = body.link, body.centre
    while link != FRAME:
        yield link, place - stems[link].origin
        link, place = stems[link].parent, stems[link].at
