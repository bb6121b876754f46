"""All that acts on the links of a group by analysis alone: forces at their places, couples (перечень сил группы)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import NamedTuple

from plans.analytic.points import placed
from plans.checks.force_expected import ExpectedForces
from plans.forces.cut import indices
from plans.forces.primary import BALANCING, DRIVING
from plans.model.group import Group, Pair
from plans.model.kinetostatics import Reaction, pair
from plans.model.machine import GEAR
from plans.model.mechanism import FRAME, Slide
from plans.model.motion import Complexes


class ActingForce(NamedTuple):
    """A force N on a link at a place m; `point` is the letter there, if the force acts at a named point."""

    name: str
    link: int
    at: complex
    value: complex
    point: str = ""


class ActingCouple(NamedTuple):
    """A moment N*m on a link."""

    name: str
    link: int
    moment: float
    at: complex


class Bearing(NamedTuple):
    """A reaction on a group from outside: whole, its parts if it may be shown in parts, and of a guide its moment.

    `along` is the unit direction of a sliding pair; `hinge` is where the reaction is told, m, and `foot` the place
    nearest to it on the line of a sliding pair.
    """

    name: str
    link: int
    hinge: complex
    value: complex
    parts: tuple[ActingForce, ...]
    along: complex | None
    moment: float
    point: str
    foot: complex

    @property
    def whole(self) -> ActingForce:
        """The reaction as one force where it is told."""
        return ActingForce(self.name, self.link, self.hinge, self.value, self.point)

    @property
    def couple(self) -> str:
        """The name of its moment."""
        return self.name.replace("R", "M", 1)

    @property
    def arm(self) -> float:
        """How far along the guide it acts, m; infinite where but a moment is left."""
        across = 0.0 if self.along is None else (self.along.conjugate() * self.value).imag
        return self.moment / across if across else math.copysign(math.inf, self.moment)


class ForceBill:
    """The forces on a group, or with None on the primary link, in one position."""

    def __init__(self, expected: ExpectedForces, groups: Sequence[Group], group: Group | None) -> None:
        self.expected, self.groups, self.group = expected, groups, group
        self.links = (expected.mechanism.drive.link,) if group is None else group.links

    @cached_property
    def known(self) -> tuple[ActingForce, ...]:
        """Weights, inertia forces and loads on the links, and the forces of the groups that hang on them."""
        return tuple(one for link in self.links for one in (*self._own(link), *self._handed(link)))

    @cached_property
    def couples(self) -> tuple[ActingCouple, ...]:
        """Moments of inertia and loads on the links, those of the groups that hang on them, and the balancing one."""
        return tuple(one for link in self.links for one in self._couples(link))

    @cached_property
    def bearings(self) -> tuple[Bearing, ...]:
        """The reactions on the links from outside."""
        if self.group is None:
            drive = self.expected.mechanism.drive
            return (self._bearing(Pair(FRAME, drive.link, drive.guide or drive.pivot)),)
        return tuple(self._bearing(one) for one in self.group.outer_pairs)

    @cached_property
    def inner(self) -> tuple[Bearing, ...]:
        """The reactions of the links on each other, each on the link that takes it."""
        return () if self.group is None else tuple(self._bearing(one) for one in self.group.inner_pairs)

    @cached_property
    def driving(self) -> ActingForce | None:
        """The force that drives the primary link, if a force does."""
        told, drive, k = self.expected.found.balancing, self.expected.mechanism.drive, self.expected.k
        if self.group is not None or told.force is None:
            return None
        point = drive.end if drive.pushed or self.expected.machine.transmission.kind != GEAR else ""
        place = self.place(point) if told.r is None else complex(told.r[k])
        return ActingForce(DRIVING, drive.link, place, complex(told.force[k]), point)

    def place(self, name: str) -> complex:
        """Place a named point, m."""
        return complex(self.expected.motion.points[name].r[self.expected.k])

    def on(self, link: int, own: complex) -> complex:
        """Place a spot of a link, m."""
        if link == FRAME:
            return own
        return complex(placed(self.expected.mechanism, self.expected.motion, link, own)[self.expected.k])

    def middle(self, link: int) -> complex:
        """Place the mass centre of a link, or else the middle of its points, m."""
        body = self.expected.machine.bodies.get(link)
        spots = self.expected.mechanism.links[link].points.values()
        return self.on(link, sum(spots) / len(spots) if body is None else body.centre)

    def speed(self, link: int, place: complex) -> complex:
        """Give the velocity of a place on a link, m/s."""
        name = next(iter(self.expected.mechanism.links[link].points))
        point, k = self.expected.motion.points[name], self.expected.k
        turned = 1j * float(self.expected.motion.links[link].omega[k]) * (place - complex(point.r[k]))
        return complex(point.v[k]) + turned

    def _own(self, link: int) -> Iterator[ActingForce]:
        expected, body = self.expected, self.expected.machine.bodies.get(link)
        if body is not None:
            centre = self.on(link, body.centre)
            yield ActingForce(f"G_{link}", link, centre, body.mass * expected.machine.gravity)
            yield ActingForce(f"Φ_{link}", link, centre, -body.mass * expected.acceleration(body))
        for load in (one for one in expected.loading.forces if one.link == link):
            yield ActingForce(load.name, link, self.on(link, load.at), complex(load.force[expected.k]), load.point)

    def _handed(self, link: int) -> Iterator[ActingForce]:
        for one in self._hung(link):
            yield self._bearing(one).whole

    def _hung(self, link: int) -> Iterator[Pair]:
        """Give the pairs of the groups that hang on a link, as they act on it."""
        pairs = (one for group in self.groups if group is not self.group for one in group.outer_pairs)
        return (Pair(taker, host, joint) for host, taker, joint in pairs if host == link)

    def _couples(self, link: int) -> Iterator[ActingCouple]:
        expected, k = self.expected, self.expected.k
        middle, body = self.middle(link), expected.machine.bodies.get(link)
        if body is not None:
            moment = -body.inertia * float(expected.motion.links[link].epsilon[k])
            yield ActingCouple(f"M^Φ_{link}", link, moment, middle)
        for twist in (one for one in expected.loading.moments if one.link == link):
            yield ActingCouple(twist.name, link, float(twist.moment[k]), middle)
        for one in (self._bearing(told) for told in self._hung(link)):
            yield ActingCouple(one.couple, link, one.moment, one.hinge)
        drive, balancing = expected.mechanism.drive, expected.found.balancing
        if self.group is None and balancing.force is None and drive.ram is None:
            yield ActingCouple(BALANCING, link, float(balancing.moment[k]), self.place(drive.pivot))

    def _bearing(self, told: Pair) -> Bearing:
        """Give the force of a pair's giver on its taker, with what belongs to it."""
        one, name = self._reaction(told), f"R_{indices(told.giver, told.taker)}"
        value, hinge = self.expected.reaction(*told), complex(one.r[self.expected.k])
        sign = 1.0 if one.giver == told.giver else -1.0
        moment = 0.0 if one.moment is None else sign * float(one.moment[self.expected.k])
        way: Complexes | None = one.along if isinstance(told.joint, Slide) else None
        along = None if way is None else complex(way[self.expected.k])
        parts = tuple(self._parts(told, hinge))
        foot = hinge if along is None else self._foot(told, hinge, along)
        return Bearing(name, told.taker, hinge, value, parts, along, moment, one.point, foot)

    def _foot(self, told: Pair, hinge: complex, along: complex) -> complex:
        """Give the place nearest to a slider's point on the line of its pair."""
        assert isinstance(told.joint, Slide)  # only a sliding pair has a line
        through = self.on(told.joint.slider, told.joint.on_slider.through)
        return through + along * ((hinge - through) * along.conjugate()).real

    def _reaction(self, told: Pair) -> Reaction:
        return self.expected.found.reactions[pair(*told).key]

    def _parts(self, told: Pair, hinge: complex) -> Iterator[ActingForce]:
        index = f"_{indices(told.giver, told.taker)}"
        own = self.expected.parts(self.group) if self.group is not None and isinstance(told.joint, str) else {}
        for name, value in own.items():
            if name.endswith(index):
                yield ActingForce(name, told.taker, hinge, value, told.point)
