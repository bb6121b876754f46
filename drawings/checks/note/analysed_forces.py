"""The forces, moments and places of a force plan by analysis alone: what a note is held to (по расчёту)."""

from __future__ import annotations

import cmath
from functools import cached_property

from drawings.figures.forces.leverage import Leverage
from drawings.note.cut_equations import ForceValues
from geometry.board import Mark
from plans.checks.force_comparison import ForceComparison
from plans.checks.force_expected import ExpectedForces
from plans.forces.cut import LOAD, Side, indices
from plans.forces.force import ForcePlan
from plans.forces.primary import BALANCING
from plans.forces.statics import Statics


class AnalysedForces(ForceValues):
    """What the analysis finds of the forces, moments and places in one position, by their names on the force plan."""

    def __init__(self, plan: ForcePlan, column: int, statics: Statics, comparison: ForceComparison) -> None:
        super().__init__(plan, column)
        solved, study = comparison.motion.analysis, statics.study
        self.groups, self.motion = study.groups, solved
        self.expected = ExpectedForces(
            study.mechanism, statics.machine, solved, statics.loading(solved), comparison.analysis, column
        )

    @property
    def rate(self) -> float:
        """The angular velocity of the crank, rad/s."""
        return self._omega(self.plan.mechanism.drive.link)

    def force(self, name: str, mark: Mark) -> complex:
        """Give a force, N."""
        return self._forces[name]

    def side(self, side: Side) -> complex:
        """Give a side of a polygon, N."""
        return self._forces[side.name]

    def moment(self, name: str, mark: Mark) -> float:
        """Give a moment, N*m."""
        return self._moments[name]

    def power(self, name: str, mark: Mark) -> float:
        """Give the power of a force or of a couple, W."""
        for load in (load for own in self.plan.loads.values() for load in own if load.name == name):
            velocity = self._rates(load.link)[1] if load.kind != LOAD else self._velocity(load.point)
            return (velocity.conjugate() * self._forces[name]).real
        link = next(one.link for own in self.plan.couples.values() for one in own if one.name == name)
        return self._moments[name] * self._omega(link)

    def arm(self, arm: Leverage) -> float:
        """Give the arm of a force about the point of its equation, m."""
        force, pivot = self._forces[arm.name], self._place(arm.about)
        place = self._places.get(arm.name, arm.at)
        return abs(((place - pivot).conjugate() * force / abs(force)).imag)

    @cached_property
    def _forces(self) -> dict[str, complex]:
        """Give every force and every part of one by its name."""
        known: dict[str, complex] = {}
        for cut in self.plan.cuts:
            known |= self.expected.polygon(self.groups, cut.group) | self.expected.parts(cut.group)
        return known

    @cached_property
    def _moments(self) -> dict[str, float]:
        """Give every moment by its name: of inertia, of loads, of sliding pairs, and the balancing one."""
        k, found = self.column, self.expected.found
        told = {twist.name: float(twist.moment[k]) for twist in self.expected.loading.moments}
        for link, body in self.plan.machine.bodies.items():
            told[f"M^Φ_{link}"] = -body.inertia * float(self.motion.links[link].epsilon[k])
        for one in found.reactions.values():
            if one.moment is not None:
                told[f"M_{indices(one.giver, one.taker)}"] = float(one.moment[k])
                told[f"M_{indices(one.taker, one.giver)}"] = -float(one.moment[k])
        return {**told, BALANCING: float(found.balancing.moment[k])}

    @cached_property
    def _places(self) -> dict[str, complex]:
        """Give where forces act that act at points of links: loads, weights and inertia forces, reactions."""
        letters = {mark: name for name, mark in self.plan.positions.letters.items()}
        places: dict[str, complex] = {}
        for load in (load for own in self.plan.loads.values() for load in own):
            if load.at in letters:
                places[load.name] = self._place(letters[load.at])
            elif load.link in self.plan.machine.bodies:
                places[load.name] = self._rates(load.link)[0]
        for one in (one for cut in self.plan.cuts for one in cut.reactions):
            if one.at in letters:
                places |= {mark.name: self._place(letters[one.at]) for mark in (one.force, *one.parts)}
        return places

    def _rates(self, link: int) -> tuple[complex, complex]:
        """Give the place and the velocity of a link's mass centre."""
        body, k = self.plan.machine.bodies[link], self.column
        name, own = next(iter(self.plan.mechanism.links[link].points.items()))
        reach = cmath.rect(1.0, float(self.motion.links[link].angle[k])) * (body.centre - own)
        return self._place(name) + reach, self._velocity(name) + 1j * self._omega(link) * reach

    def _place(self, name: str) -> complex:
        return complex(self.motion.points[name].r[self.column])

    def _velocity(self, name: str) -> complex:
        return complex(self.motion.points[name].v[self.column])

    def _omega(self, link: int) -> float:
        return float(self.motion.links[link].omega[self.column])
