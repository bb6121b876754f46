"""A force of the force plan, and a group cut out of the mechanism with all forces on it (силовой расчёт)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from copy import copy
from typing import NamedTuple

import numpy as np

from geometry.board import Board, Mark
from geometry.tracing import remade
from plans.linkage.plan import Plan
from plans.model.dyad import Assur
from plans.model.kinetostatics import Loading
from plans.model.machine import Body, Machine
from plans.model.mechanism import FRAME, Slide
from plans.words.words import because


class ForcePlan:
    """The forces on the links of one plan of accelerations, on a board of their own; every polygon starts at 0."""

    def __init__(self, accelerations: Plan, machine: Machine, loading: Loading) -> None:
        self.board = Board("forces")
        self.accelerations, self.machine = accelerations, machine
        self.positions, self.velocities = accelerations.below
        self.mechanism = accelerations.mechanism
        self.pole = self.board.given("0", 0j, because("polygon_start"))
        self.loads: dict[int, list[Load]] = {link: [] for link in self.mechanism.links}
        self.couples: dict[int, list[Couple]] = {link: [] for link in self.mechanism.links}
        self.given: list[Mark] = []  # the loads, in the order of the loading: they change with the position
        self.cuts: list[CutGroup] = []
        self.push: Mark | None = None  # of a gear the direction in which its teeth press: by the moment asked of them
        self.drive: Mark | None = None  # force by which the crank is driven; None: a moment drives it
        self.driven: Mark | None = None  # where it acts
        self.balancing = self.pole  # moment about the shaft, once it is found
        self.shaft = self.pole  # of a slide that is pushed along the centre of a wheel that would roll on it
        self._places: dict[tuple[str, int], Mark] = {}
        for _, body in sorted(machine.bodies.items()):
            self.loads[body.link] += self._body(body)
            self.couples[body.link] += self._turning(body)
        self._load(loading)

    def _body(self, body: Body) -> Iterator[Load]:
        """Give a link its inertia force, against the acceleration of its mass centre, and its weight (M5.1)."""
        link, acceleration = body.link, self.centre(self.accelerations, body)
        if body.mass == 0:
            return
        at = self.centre(self.positions, body)
        if acceleration is not self.accelerations.pole:
            name = f"Φ_{link}"
            force = self.board.turn(name, acceleration, -body.mass, because("inertia_force"))
            yield Load(name, link, at, force, INERTIA)
        if self.machine.gravity:
            name = f"G_{link}"
            force = self.board.given(name, body.mass * self.machine.gravity, because("weight"))
            yield Load(name, link, at, force, WEIGHT)

    def _turning(self, body: Body) -> Iterator[Couple]:
        """Give a link its inertia couple, against its angular acceleration (M5.1)."""
        reading = self.accelerations.readings.get(body.link)
        turning = None if reading is None else reading.turning.step.size  # of the crank: i epsilon, or a row of them
        still = body.link == self.mechanism.drive.link and not np.any(turning)
        if body.inertia and reading is not None and not still:
            name, why = f"M^Φ_{body.link}", because("inertia_moment")
            yield Couple(name, body.link, self.board.couple(name, *reading, -body.inertia, why), INERTIA)

    def centre(self, plan: Plan, body: Body) -> Mark:
        """Give the image of a link's mass centre on a plan: a named point of the link where it lies there."""
        key = plan.board.subject, body.link
        if key not in self._places:
            points = self.mechanism.links[body.link].points
            named = next((name for name, place in points.items() if place == body.centre), None)
            letter = f"S{body.link}"
            drawn = plan.point(named) if named else plan.place(body.link, body.centre, plan.letter(letter))
            self._places[key] = drawn
        return self._places[key]

    def image(self, load: Load) -> Mark:
        """Give the image of the point of a weight, an inertia force or a load on the velocity plan."""
        if load.kind == LOAD:
            return self.velocities.point(load.point)
        return self.centre(self.velocities, self.machine.bodies[load.link])

    def _load(self, loading: Loading) -> None:
        for load in loading.forces:
            mark = self.board.given(load.name, load.force, because("load"))
            self.given.append(mark)
            if load.link != FRAME:
                at = self.positions.point(load.point)
                self.loads[load.link].append(Load(load.name, load.link, at, mark, LOAD, load.point))
        for twist in loading.moments:
            mark = self.board.given(twist.name, twist.moment, because("load"))
            self.given.append(mark)
            self.couples[twist.link].append(Couple(twist.name, twist.link, mark, LOAD))

    def redraw(self, boards: Mapping[str, Board], made: Mapping[Mark, Mark], below: Sequence[Plan]) -> ForcePlan:
        """Give this plan as it is on other boards, whose marks are named by those of this one."""
        other = copy(self)
        drawn = {name: value for name, value in vars(self).items() if name not in ("machine", "mechanism")}
        vars(other).update({name: remade(value, made, boards) for name, value in drawn.items()})
        other.positions, other.velocities, other.accelerations = below
        return other

    def acting(self, *links: int) -> tuple[list[Load], list[Couple]]:
        """List the known forces and couples on some links."""
        loads = [load for link in links for load in self.loads[link]]
        return loads, [couple for link in links for couple in self.couples[link]]

    def hand_over(self, support: Support) -> None:
        """Load the link that gives a reaction with its opposite."""
        if support.giver == FRAME:
            return
        index, board = indices(support.taker, support.giver), self.board
        name, why = f"R_{index}", because("opposite_of", force=f"R_{indices(support.giver, support.taker)}")
        force = board.turn(name, support.force, -1.0, why)
        self.loads[support.giver].append(Load(name, support.giver, support.at, force, REACTION))
        if support.moment is not None:
            moment = board.turn(f"M_{index}", support.moment, -1.0, why)
            self.couples[support.giver].append(Couple(f"M_{index}", support.giver, moment, REACTION))


WEIGHT, INERTIA, LOAD, REACTION = "weight", "inertia", "load", "reaction"
KNOWN, PART, CLOSING = "known", "part", "closing"


class Load(NamedTuple):
    """A known force on a link: its letters, its point on the plan of positions, its vector on the plan of forces."""

    name: str
    link: int
    at: Mark
    force: Mark
    kind: str  # weight, inertia, load, or the reaction of a group that was cut off before
    point: str = ""  # of a load the letter of its point


class Couple(NamedTuple):
    """A known moment on a link."""

    name: str
    link: int
    moment: Mark
    kind: str


class MomentEquation(NamedTuple):
    """An equation of moments about a point: loads and couples in it, and the force along a line that it gives."""

    about: Mark
    loads: tuple[Load, ...]
    couples: tuple[Couple, ...]
    line: Mark | None  # None: the moment itself is found
    found: Mark


class Support(NamedTuple):
    """A reaction as it was found: the force of one link on another, its parts, and of a sliding pair its moment.

    `at` is the hinge, or the slider's named point, about which the moment is told; no moment: it is zero.
    """

    giver: int
    taker: int
    at: Mark
    force: Mark
    parts: tuple[Mark, ...]  # tangential and normal to the lead, or along and square to the slot
    slide: Slide | None
    moment: Mark | None
    point: str  # the letter of the hinge, or of the slider's point
    holding: MomentEquation | None = None  # that gives the moment


class PolygonSide(NamedTuple):
    """A side of a force polygon: a known force, a part found by moments, or one that closes the polygon."""

    name: str
    start: Mark
    end: Mark
    kind: str


class CutGroup(NamedTuple):
    """A group, or the primary link, with its known forces, its reactions, its equations and its polygon in order."""

    group: Assur | None
    links: tuple[int, ...]
    loads: tuple[Load, ...]
    couples: tuple[Couple, ...]
    supports: tuple[Support, ...]  # outer reactions on the group's links
    inner: tuple[Support, ...]  # of its links on each other
    equations: tuple[MomentEquation, ...]
    sides: tuple[PolygonSide, ...]

    @property
    def reactions(self) -> tuple[Support, ...]:
        """All reactions that the cut gives: the outer ones and the inner ones."""
        return *self.supports, *self.inner

    def holds(self, equation: MomentEquation) -> bool:
        """Tell whether an equation gives the moment of a sliding pair, so that reactions of the group stand in it."""
        return self.group is not None and equation.line is None

    def sum_of(self, equation: MomentEquation) -> str:
        """Name the links of a sum of moments where the cut has several sums: (4,5)."""
        links = sorted({load.link for load in equation.loads} | {couple.link for couple in equation.couples})
        several = len(self.equations) > 1 or self.holds(equation)
        return f"({','.join(map(str, links))})" if several and links else ""

    @property
    def label(self) -> str:
        """The links of the group: "4-5"."""
        return "-".join(map(str, self.links))


def indices(giver: int, taker: int) -> str:
    """Write the two links of a reaction as its index.

    >>> indices(3, 4), indices(9, 10)
    ('34', '9,10')
    """
    return f"{giver},{taker}" if max(giver, taker) > 9 else f"{giver}{taker}"
