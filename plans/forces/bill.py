"""All that acts on the links of a group by analysis alone: forces at their places, couples (перечень сил группы)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from plans.analytic.points import acceleration, placed
from plans.forces.cut import indices
from plans.forces.drive import BALANCING, DRIVING
from plans.forces.dyads import GROUP_FORCES
from plans.forces.polygon import Split
from plans.linkage.special_points import special_places
from plans.model.dyad import Assur, Pair, pair
from plans.model.kinetostatics import Kinetostatics, Loading, Reaction
from plans.model.machine import GEAR, Machine
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import Motion


@dataclass(frozen=True)
class LoadedPosition:
    """A machine in one position by the analysis: its motion, its loads, the forces in its pairs."""

    mechanism: Mechanism
    machine: Machine
    groups: Sequence[Assur]
    motion: Motion
    loading: Loading
    forces: Kinetostatics
    k: int

    def place(self, point: str) -> complex:
        """Place a named point, or the special point of a triad, m."""
        if point in self.motion.points:
            return complex(self.motion.points[point].r[self.k])
        return complex(special_places(self.motion, self.groups)[point][self.k])

    @property
    def named(self) -> list[str]:
        """The letters of all points, and of special points."""
        return [*self.motion.points, *special_places(self.motion, self.groups)]

    def on(self, link: int, spot: complex) -> complex:
        """Place a spot of a link, m."""
        return spot if link == FRAME else complex(placed(self.mechanism, self.motion, link, spot)[self.k])

    def middle(self, link: int) -> complex:
        """Place the mass centre of a link, or else the middle of its points, m."""
        body = self.machine.bodies.get(link)
        spots = self.mechanism.links[link].points.values()
        return self.on(link, sum(spots) / len(spots) if body is None else body.centre)

    def speed(self, link: int, place: complex) -> complex:
        """Give the velocity of a place on a link, m/s."""
        point = self.motion.points[next(iter(self.mechanism.links[link].points))]
        turned = 1j * float(self.motion.links[link].omega[self.k]) * (place - complex(point.r[self.k]))
        return complex(point.v[self.k]) + turned

    def couples(self, link: int) -> Iterator[tuple[str, float]]:
        """Give the moments of inertia and of loads on a link, N*m, by their letters."""
        body = self.machine.bodies.get(link)
        if body is not None:
            yield f"M^Φ_{link}", -body.inertia * float(self.motion.links[link].epsilon[self.k])
        yield from ((load.name, float(load.moment[self.k])) for load in self.loading.moments if load.link == link)

    def reaction(self, bond: Pair) -> tuple[Reaction, complex, float]:
        """Give the reaction of a pair over the positions, and here the force N and the moment N*m on its taker."""
        reaction = self.forces.reactions[pair(*bond).key]
        sign = 1.0 if reaction.giver == bond.giver else -1.0
        moment = 0.0 if reaction.moment is None else float(reaction.moment[self.k])
        return reaction, sign * complex(reaction.force[self.k]), sign * moment


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

    `along` is the unit direction of a sliding pair; `whole` acts where the reaction is told, m, and `foot` is the place
    nearest to it on the line of a sliding pair.
    """

    whole: ActingForce
    parts: tuple[ActingForce, ...]
    along: complex | None
    moment: float
    foot: complex

    @property
    def couple(self) -> str:
        """The name of its moment."""
        return self.whole.name.replace("R", "M", 1)

    @property
    def arm(self) -> float:
        """How far along the guide it acts, m; infinite where but a moment is left."""
        across = 0.0 if self.along is None else (self.along.conjugate() * self.whole.value).imag
        return self.moment / across if across else math.copysign(math.inf, self.moment)


@dataclass(frozen=True)
class ForceBill:
    """The forces on a group, or with None on the primary link, in one position."""

    position: LoadedPosition
    group: Assur | None

    @property
    def links(self) -> tuple[int, ...]:
        """The links of the group."""
        return (self.position.mechanism.drive.link,) if self.group is None else self.group.links

    @cached_property
    def known(self) -> tuple[ActingForce, ...]:
        """Weights, inertia forces and loads on the links, and the forces of the groups that hang on them."""
        handed = {link: [self._bearing(bond).whole for bond in self._hung(link)] for link in self.links}
        return tuple(force for link in self.links for force in (*self._given(link), *handed[link]))

    @cached_property
    def couples(self) -> tuple[ActingCouple, ...]:
        """Moments of inertia and loads on the links, those of the groups that hang on them, and the balancing one."""
        return tuple(couple for link in self.links for couple in self._couples(link))

    @cached_property
    def bearings(self) -> tuple[Bearing, ...]:
        """The reactions on the links from outside."""
        if self.group is None:
            drive = self.position.mechanism.drive
            return (self._bearing(Pair(FRAME, drive.link, drive.guide or drive.pivot)),)
        return tuple(self._bearing(bond) for bond in self.group.outer_pairs)

    @cached_property
    def inner(self) -> tuple[Bearing, ...]:
        """The reactions of the links on each other, each on the link that takes it."""
        return () if self.group is None else tuple(self._bearing(bond) for bond in self.group.inner_pairs)

    @cached_property
    def driving(self) -> tuple[ActingForce, ...]:
        """The force that drives the primary link, if a force does."""
        position, drive = self.position, self.position.mechanism.drive
        balancing, k = position.forces.balancing, position.k
        if self.group is not None or balancing.force is None:
            return ()
        point = drive.end if drive.pushed or position.machine.transmission.kind != GEAR else ""
        place = position.place(point) if balancing.r is None else complex(balancing.r[k])
        return (ActingForce(DRIVING, drive.link, place, complex(balancing.force[k]), point),)

    @property
    def sides(self) -> Mapping[str, complex]:
        """Every force that the polygon of the group must show, N: of the inner reactions those on the first link."""
        inner = (opposite(bearing.whole) for bearing in self.inner)
        shown = (*self.known, *self.driving, *(bearing.whole for bearing in self.bearings), *inner)
        return {force.name: force.value for force in shown}

    @property
    def parts(self) -> Mapping[str, complex]:
        """The parts of the outer reactions, N, which the polygon shows where a link has moments."""
        return {part.name: part.value for bearing in self.bearings for part in bearing.parts}

    @cached_property
    def forces(self) -> Mapping[str, ActingForce]:
        """Every force that may be told of the group, by its letters."""
        bearings = [force for bearing in self.bearings for force in (bearing.whole, *bearing.parts)]
        inner = [force for bearing in self.inner for force in (bearing.whole, opposite(bearing.whole))]
        return {force.name: force for force in (*self.known, *self.driving, *bearings, *inner)}

    @cached_property
    def moments(self) -> Mapping[str, float]:
        """Every moment N*m that may be told of the group, by its letters."""
        found = {couple.name: couple.moment for couple in self.couples}
        found |= {bearing.couple: bearing.moment for bearing in (*self.bearings, *self.inner)}
        turned = ((opposite(bearing.whole).name, bearing.moment) for bearing in self.inner)
        return found | {name.replace("R", "M", 1): -moment for name, moment in turned}

    def _given(self, link: int) -> Iterator[ActingForce]:
        """Give the weight, the inertia force and the loads of a link."""
        position, machine, k = self.position, self.position.machine, self.position.k
        body = machine.bodies.get(link)
        if body is not None:
            centre = position.on(link, body.centre)
            bent = complex(acceleration(position.mechanism, position.motion, link, body.centre)[k])
            yield ActingForce(f"G_{link}", link, centre, body.mass * machine.gravity)
            yield ActingForce(f"Φ_{link}", link, centre, -body.mass * bent)
        for load in position.loading.forces:
            if load.link == link:
                yield ActingForce(load.name, link, position.on(link, load.at), complex(load.force[k]), load.point)

    def _hung(self, link: int) -> Iterator[Pair]:
        """Give the pairs of the groups that hang on a link, as they act on it."""
        bonds = (bond for group in self.position.groups if group is not self.group for bond in group.outer_pairs)
        return (Pair(taker, host, joint) for host, taker, joint in bonds if host == link)

    def _couples(self, link: int) -> Iterator[ActingCouple]:
        position, drive, balancing = self.position, self.position.mechanism.drive, self.position.forces.balancing
        middle = position.middle(link)
        yield from (ActingCouple(name, link, moment, middle) for name, moment in position.couples(link))
        for bearing in map(self._bearing, self._hung(link)):
            yield ActingCouple(bearing.couple, link, bearing.moment, bearing.whole.at)
        if self.group is None and balancing.force is None and drive.ram is None:
            yield ActingCouple(BALANCING, link, float(balancing.moment[position.k]), position.place(drive.pivot))

    def _bearing(self, bond: Pair) -> Bearing:
        """Give the force of a pair's giver on its taker, with what belongs to it."""
        reaction, value, moment = self.position.reaction(bond)
        hinge = complex(reaction.r[self.position.k])
        whole = ActingForce(f"R_{indices(bond.giver, bond.taker)}", bond.taker, hinge, value, reaction.point)
        if isinstance(bond.joint, str) or reaction.along is None:
            return Bearing(whole, tuple(self._parts(bond, whole)), None, moment, hinge)
        along = complex(reaction.along[self.position.k])
        through = self.position.on(bond.joint.slider, bond.joint.on_slider.through)
        foot = through + along * ((hinge - through) * along.conjugate()).real
        return Bearing(whole, (), along, moment, foot)

    def _parts(self, bond: Pair, whole: ActingForce) -> Iterator[ActingForce]:
        """Give the parts of a hinge's outer reaction: along the lead or the slot, and square to it."""
        splits = () if self.group is None else GROUP_FORCES[self.group.kind].splits(self.group)
        for split in (split for split in splits if split.pair == bond):
            along = self._direction(split)
            part = along * (along.conjugate() * whole.value).real
            for letter, value in zip(split.letters, (part, whole.value - part), strict=True):
                yield whole._replace(name=whole.name.replace("R", f"R^{letter}", 1), value=value)

    def _direction(self, split: Split) -> complex:
        """Give the unit direction that a hinge's reaction is taken apart by."""
        if isinstance(split.along, Pair):
            reaction, _, _ = self.position.reaction(split.along)
            assert reaction.along is not None  # a sliding pair has a direction
            return complex(reaction.along[self.position.k])
        start, tip = map(self.position.place, split.along)
        return (tip - start) / abs(tip - start)


def opposite(force: ActingForce) -> ActingForce:
    """Give a reaction as the other link takes it."""
    head, index = force.name.split("_")
    giver, taker = index.split(",") if "," in index else tuple(index)
    return force._replace(name=f"{head}_{indices(int(taker), int(giver))}", value=-force.value)
