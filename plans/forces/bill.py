"""All that acts on the links of a group by analysis alone: forces at their places, couples (перечень сил группы)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import NamedTuple

from plans.analytic.points import placed
from plans.forces.cut import indices
from plans.forces.dyads import GROUP_FORCES, Split
from plans.forces.primary import BALANCING, DRIVING
from plans.model.dyad import Group, Joint, Pair, pair
from plans.model.kinetostatics import Kinetostatics, Loading, Reaction
from plans.model.machine import GEAR, Body, Machine
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.motion import Complexes, Motion


class ExpectedForces:
    """The forces of one position, from motion and reactions by analysis: weights, inertia, loads, and the parts."""

    def __init__(
        self, mechanism: Mechanism, machine: Machine, motion: Motion, loading: Loading, found: Kinetostatics, k: int
    ) -> None:
        self.mechanism, self.machine, self.motion, self.loading = mechanism, machine, motion, loading
        self.found, self.k = found, k

    def polygon(self, groups: Sequence[Group], group: Group | None) -> dict[str, complex]:
        """Give every force that the polygon of a group must show; None is the primary link."""
        links = (self.mechanism.drive.link,) if group is None else group.links
        told = {name: force for link in links for name, force in self._acting(link)}
        if group is None:
            outer = [Pair(FRAME, links[0], self.mechanism.drive.guide or self.mechanism.drive.pivot)]
            if self.found.balancing.force is not None:
                told[DRIVING] = complex(self.found.balancing.force[self.k])
        else:
            outer = [*group.outer_pairs, *(Pair(taker, giver, joint) for giver, taker, joint in group.inner_pairs)]
        outer += self._handed(groups, links)
        return told | {f"R_{indices(giver, taker)}": self.reaction(giver, taker, j) for giver, taker, j in outer}

    def parts(self, group: Group | None) -> dict[str, complex]:
        """Give the parts of a group's outer reactions, which its polygon shows where a link has moments.

        Of a hinge they are along the lead and square to it; of a stone's hinge along the slot and square to it.
        """
        if group is None:
            return {}
        return dict(part for split in GROUP_FORCES[group.kind].splits(group) for part in self._parts(split))

    def reaction(self, giver: int, taker: int, joint: Joint) -> complex:
        """Give the force of one link on another, N."""
        one = self.found.reactions[pair(giver, taker, joint).key]
        force = complex(one.force[self.k])
        return force if one.giver == giver else -force

    def image(self, name: str) -> complex:
        """Give the place of a named point's image on Zhukovsky's lever: its velocity, turned by a quarter."""
        return -1j * complex(self.motion.points[name].v[self.k])

    def _acting(self, link: int) -> Iterator[tuple[str, complex]]:
        """Give the weight, the inertia force and the loads of a link."""
        body = self.machine.bodies.get(link)
        if body is not None:
            yield f"G_{link}", body.mass * self.machine.gravity
            yield f"Φ_{link}", -body.mass * self.acceleration(body)
        for load in self.loading.forces:
            if load.link == link:
                yield load.name, complex(load.force[self.k])

    def _handed(self, groups: Sequence[Group], links: Sequence[int]) -> Iterator[Pair]:
        """Give the reactions of groups that hang on some links."""
        for group in groups:
            for host, link, joint in group.outer_pairs:
                if host in links:
                    yield Pair(link, host, joint)

    def acceleration(self, body: Body) -> complex:
        """Give the acceleration of a link's mass centre: that of a point of the link, and the turning about it."""
        name, place = next(iter(self.mechanism.links[body.link].points.items()))
        turning = self.motion.links[body.link]
        spin = complex(-(float(turning.omega[self.k]) ** 2), float(turning.epsilon[self.k]))
        turned = spin * cmath.rect(1.0, float(turning.angle[self.k]))
        return complex(self.motion.points[name].a[self.k]) + turned * (body.centre - place)

    def _parts(self, split: Split) -> Iterator[tuple[str, complex]]:
        host, link, joint = split.pair
        along, index = self._direction(split), indices(host, link)
        force = self.reaction(host, link, joint)
        part = along * (along.conjugate() * force).real
        yield f"R^{split.letters[0]}_{index}", part
        yield f"R^{split.letters[1]}_{index}", force - part

    def _direction(self, split: Split) -> complex:
        """Give the unit direction that a hinge's reaction is taken apart by."""
        if isinstance(split.along, Pair):
            slide = self.found.reactions[pair(*split.along).key]
            assert slide.along is not None  # a sliding pair has a direction
            return complex(slide.along[self.k])
        start, tip = (complex(self.motion.points[name].r[self.k]) for name in split.along)
        return (tip - start) / abs(tip - start)


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
