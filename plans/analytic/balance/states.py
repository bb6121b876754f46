"""A machine before or after balancing: its mass centre, and its forces with each counterweight as a body (силы)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from plans.analytic.balance.mass_centre import bodies, mass_centre
from plans.analytic.kinematics import Analysis
from plans.analytic.kinetostatics import kinetostatics
from plans.analytic.points import acceleration
from plans.model.balance.linkage import Counterweight, State
from plans.model.group import Pair
from plans.model.kinetostatics import Applied, Kinetostatics, Loading, Twist
from plans.model.machine import Machine
from plans.model.mechanism import Mechanism
from plans.model.motion import Motion


@dataclass(frozen=True)
class Course:
    """A mechanism with its machine and pairs over the scene's positions and a turn, with the loads over the turn."""

    road: Analysis
    machine: Machine
    pairs: tuple[Pair, ...]
    motion: Motion  # over the scene's positions
    turn: Motion  # over even positions of a turn
    loading: Loading

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism."""
        return self.road.mechanism

    def forces(self, added: Sequence[Counterweight] = ()) -> Kinetostatics:
        """Find the forces over the turn with counterweights."""
        own, theirs = self.loading, inertia(self.mechanism, self.machine, added, self.turn)
        whole = Loading(own.forces + theirs.forces, own.moments + theirs.moments)
        return kinetostatics(self.road, self.machine, self.turn, whole, self.pairs)

    def twisted(self) -> Kinetostatics:
        """Find the forces over the turn that a moment of 1 N*m on the crank calls for, by itself."""
        still = replace(self.machine, bodies={})
        twist = Twist("M", self.mechanism.drive.link, np.ones(len(self.turn.phi)))
        return kinetostatics(self.road, still, self.turn, Loading((), (twist,)), self.pairs)


def inertia(mechanism: Mechanism, machine: Machine, added: Sequence[Counterweight], motion: Motion) -> Loading:
    """Give weight and inertia of counterweights as loads: m (g - a) at the centre, -J epsilon."""
    forces, moments = [], []
    for one in (weight for weight in added if weight.needed):
        name, a = f"S{one.link}'", acceleration(mechanism, motion, one.link, one.centre)
        forces.append(Applied(name, one.link, name, one.centre, one.mass * (machine.gravity - a)))
        moments.append(Twist(name, one.link, -one.inertia * motion.links[one.link].epsilon))
    return Loading(tuple(forces), tuple(moments))


def state(course: Course, added: Sequence[Counterweight] = ()) -> State:
    """Find mass centre and forces with some counterweights, or before there are any."""
    solid, mechanism = bodies(course.machine, added), course.mechanism
    centre = mass_centre(mechanism, solid, course.motion)
    around = centre if course.turn is course.motion else mass_centre(mechanism, solid, course.turn)
    return State(centre, around, course.forces(added), course.road.conditions(course.turn))
