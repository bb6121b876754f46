"""Counterweights by linearly independent vectors: the mass centre's place may have none that vary (противовесы).

The static moments of all bodies, of the counterweights that are sought, of what may stay at sliders, and any multiple
of the loops are summed vector by vector; each sum but the constant one must be zero.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from plans.analytic.balance.mass_centre import bodies, mass_centre
from plans.analytic.kinematics import Analysis
from plans.analytic.kinetostatics import kinetostatics
from plans.analytic.points import acceleration
from plans.model.balance.linkage import EPS, FULL, PARTIAL, ROUNDING, SECTOR, BalanceTask, Counterweight, Site, State
from plans.model.dyad import Assur, Pair
from plans.model.kinetostatics import Applied, Kinetostatics, Loading, Twist
from plans.model.machine import Machine
from plans.model.mechanism import FRAME, Mechanism, Slide
from plans.model.motion import Complexes, Floats, Motion


class Turned(NamedTuple):
    """A link's direction: the link whose direction it has but for a fixed turn, and that turn as a unit vector."""

    leader: int
    by: complex


class Formal:
    """The links of a mechanism as rows of coefficients, m, and the rows of its loops."""

    def __init__(self, mechanism: Mechanism) -> None:
        self.mechanism = mechanism
        found: dict[int, Turned] = {}
        for leader in sorted(mechanism.links):
            if leader not in found:
                found[leader] = Turned(leader, 1 + 0j)
                _follow(mechanism, leader, found)
        self.turned = found
        leaders = sorted({turned.leader for turned in self.turned.values()} - {FRAME})
        self.columns = {link: k for k, link in enumerate((FRAME, *leaders))}
        self.size = len(self.columns) + len(mechanism.slides)
        self.origins = {FRAME: self._none()}
        self.loops = list(self._rows())

    def _none(self) -> Complexes:
        return np.zeros(self.size, dtype=np.complex128)

    def along(self, link: int, vector: complex) -> Complexes:
        """Give the row of a vector fixed in a link, of its own frame."""
        row, turned = self._none(), self.turned[link]
        row[self.columns[turned.leader]] = vector * turned.by
        return row

    def place(self, link: int, spot: complex) -> Complexes:
        """Give the row of a point of a link."""
        return np.asarray(self.origins[link] + self.along(link, spot))

    def of(self, point: str) -> Complexes:
        """Give the row of a point by its letter."""
        link = self.mechanism.link_of(point)
        return self.place(link, self.mechanism.links[link].points[point])

    def _rows(self) -> Iterator[Complexes]:
        """Lay the links out joint by joint from the frame; what closes a loop gives its row."""
        waiting = list(_joints(self.mechanism))
        while waiting:
            here = next(hinge for hinge in waiting if not self.origins.keys().isdisjoint(hinge[:2]))
            waiting.remove(here)
            first, second, joint = here
            apart = self._slid(joint) if isinstance(joint, Slide) else self._pinned(first, second, joint)
            if first in self.origins and second in self.origins:
                yield self.origins[first] - self.origins[second] - apart
            elif first in self.origins:
                self.origins[second] = self.origins[first] - apart
            else:
                self.origins[first] = self.origins[second] + apart

    def _pinned(self, first: int, second: int, point: str) -> Complexes:
        """Give how far the origin of a hinge's first link is from that of its second."""
        ours, theirs = (self.along(link, self.mechanism.links[link].points[point]) for link in (first, second))
        return np.asarray(theirs - ours)

    def _slid(self, slide: Slide) -> Complexes:
        """Give how far the origin of a slider is from that of its owner: along the line by what it slides."""
        row = self.along(slide.owner, slide.on_owner.through) - self.along(slide.slider, slide.on_slider.through)
        way = self.turned[slide.owner].by * slide.on_owner.direction
        row[len(self.columns) + self.mechanism.slides.index(slide)] = way / abs(way)
        return np.asarray(row)


def _joints(mechanism: Mechanism) -> Iterator[tuple[int, int, str | Slide]]:
    for point, links in mechanism.hinges.items():
        yield from ((links[0], link, point) for link in links[1:])
    yield from ((slide.slider, slide.owner, slide) for slide in mechanism.slides)


def _follow(mechanism: Mechanism, link: int, found: dict[int, Turned]) -> None:
    for slide in mechanism.slides:
        if link in (slide.slider, slide.owner):
            other = slide.owner if link == slide.slider else slide.slider
            if other not in found:
                way, its = slide.way(link).direction, slide.way(other).direction
                by = found[link].by * way / its
                found[other] = Turned(found[link].leader, by / abs(by))
                _follow(mechanism, other, found)


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
        loads, theirs = self.loading, inertia(self.mechanism, self.machine, added, self.turn)
        whole = Loading(loads.forces + theirs.forces, loads.moments + theirs.moments)
        return kinetostatics(self.road, self.machine, self.turn, whole, self.pairs)

    def twisted(self) -> Kinetostatics:
        """Find the forces over the turn that a moment of 1 N*m on the crank calls for, by itself."""
        still = replace(self.machine, bodies={})
        twist = Twist("M", self.mechanism.drive.link, np.ones(len(self.turn.phi)))
        return kinetostatics(self.road, still, self.turn, Loading((), (twist,)), self.pairs)


def inertia(mechanism: Mechanism, machine: Machine, added: Sequence[Counterweight], motion: Motion) -> Loading:
    """Give weight and inertia of counterweights as loads: m (g - a) at the centre, -J epsilon."""
    forces, moments = [], []
    for weight in (weight for weight in added if weight.needed):
        name, a = f"S{weight.link}'", acceleration(mechanism, motion, weight.link, weight.centre)
        forces.append(Applied(name, weight.link, name, weight.centre, weight.mass * (machine.gravity - a)))
        moments.append(Twist(name, weight.link, -weight.inertia * motion.links[weight.link].epsilon))
    return Loading(tuple(forces), tuple(moments))


def state(course: Course, added: Sequence[Counterweight] = ()) -> State:
    """Find mass centre and forces with some counterweights, or before there are any."""
    solid, mechanism = bodies(course.machine, added), course.mechanism
    centre = mass_centre(mechanism, solid, course.motion)
    around = centre if course.turn is course.motion else mass_centre(mechanism, solid, course.turn)
    return State(centre, around, course.forces(added), course.road.conditions(course.turn))


class Sought(NamedTuple):
    """Counterweights without static moments, in the scene's order; the links that need one; points that keep a mass."""

    blanks: tuple[Counterweight, ...]
    links: frozenset[int]
    left: tuple[str, ...]


def sought(mechanism: Mechanism, groups: Sequence[Assur], task: BalanceTask) -> Sought:
    """Tell what a task seeks: one counterweight of the crank and of each group, or the mass at a guide of the frame."""
    drive = mechanism.drive
    links, left = {drive.link} if task.place(drive.link) else set(), []
    rod = _rod(mechanism, groups, task)
    for group in groups:
        carrier = _carrier(group, task)
        if rod is not None and carrier != rod and _on_crank(mechanism, group):
            carrier = None  # one rod is enough
        if carrier is not None:
            links.add(carrier)
        if task.aim != FULL and (carrier is None or carrier == rod):
            left += _left(mechanism, group)
    return Sought(tuple(_blank(mechanism, groups, place) for place in task.places), frozenset(links), tuple(left))


def _rod(mechanism: Mechanism, groups: Sequence[Assur], task: BalanceTask) -> int | None:
    """Give the first rod on the crank that may carry where the crank may not: it balances the crank in part."""
    if task.aim != PARTIAL or task.place(mechanism.drive.link):
        return None
    rods = (group.links[0] for group in groups if _on_crank(mechanism, group))
    return next((link for link in rods if task.place(link)), None)


def _on_crank(mechanism: Mechanism, group: Assur) -> bool:
    """Tell whether a group is a rod on the crank with its slider on the frame."""
    return group.kind == "RRP" and [pair.giver for pair in group.outer_pairs] == [mechanism.drive.link, FRAME]


def _carrier(group: Assur, task: BalanceTask) -> int | None:
    """Choose the link of a group that carries: of two that may the one hinged to the frame, else the first."""
    hinged = [pair for pair in group.outer_pairs if isinstance(pair.joint, str) and task.place(pair.taker)]
    if group.kind == "RPP" or not hinged:  # all of that group slides: nothing on it turns
        return None
    return next((pair for pair in hinged if pair.giver == FRAME), hinged[0]).taker


def _left(mechanism: Mechanism, group: Assur) -> list[str]:
    """Give the point of a group that goes along a guide of the frame with the mass that is left."""
    guided = [pair for pair in group.outer_pairs if not isinstance(pair.joint, str) and pair.giver == FRAME]
    (inner,) = (pair.joint for pair in group.inner_pairs)
    if not guided:
        return []
    return [inner if isinstance(inner, str) else _point(mechanism, guided[0])]


def _point(mechanism: Mechanism, pair: Pair) -> str:
    """Give a point of a guided link: the one that slides, or of a link that bears its guide the first."""
    on = mechanism.links[pair.taker].points
    return pair.point if pair.point in on else next(iter(on))


def _blank(mechanism: Mechanism, groups: Sequence[Assur], place: Site) -> Counterweight:
    """Give a counterweight that has yet to be found, counted from the hinge of its link toward the frame."""
    begin = mechanism.drive.pivot
    if place.link != mechanism.drive.link:
        joint = {pair.taker: pair.joint for group in groups for pair in group.outer_pairs}[place.link]
        if not isinstance(joint, str):
            raise ValueError(place)  # a link that is guided and not hinged is refused before
        begin = joint
    return Counterweight(place, begin, mechanism.links[place.link].points[begin], 0j, 0.0)


REFINEMENTS = 2  # of a linear solution: what one leaves, the next finds to be rounding


@dataclass(frozen=True)
class FoundWeights:
    """Counterweights, kg of what stays at hinges by letter, and how far rounding can have moved either.

    `slack` is kg*m by link, `loose` kg by letter.
    """

    counterweights: tuple[Counterweight, ...]
    left: dict[str, complex]
    slack: dict[int, float]
    loose: dict[str, float]


def counterweights(mechanism: Mechanism, machine: Machine, wanted: Sought) -> FoundWeights:
    """Find the counterweights that are sought: they bring the mass centre to rest but for what moves along guides.

    A mass that follows from a static moment weighs on the links that bear the link: each round sets one more of them.
    """
    sums = Summed(mechanism, machine, wanted)
    found = FoundWeights(wanted.blanks, {}, {}, {})
    for _ in range(len(wanted.blanks) + 1):
        found = sums.solve(found)
    return found


def uncertain(weight: Counterweight, slack: float) -> float:
    """Give how far a mass kg is off that follows from a static moment which `slack` kg*m is off."""
    follows = weight.needed and weight.place.mass is None
    return slack * weight.mass / abs(weight.moment) if follows else 0.0


def mass_of(place: Site, moment: complex) -> float:
    """Give the mass kg that a static moment kg*m has at the place that is given."""
    if place.mass is not None:
        return place.mass
    arm = place.radius if place.at is None else place.at
    if arm is not None:
        return abs(moment / arm)
    if place.shape != SECTOR:
        raise ValueError(place)  # the reading of a scene asks for one of them
    # With its apex at the link's beginning, m*r = (2/3) density thickness sin(half angle) R^3.
    solid = place.density * place.thickness
    outer = math.cbrt(1.5 * abs(moment) / (solid * math.sin(place.half_angle)))
    return solid * place.half_angle * outer**2


def carrying(weight: Counterweight, moment: complex) -> Counterweight:
    """Give a counterweight another static moment kg*m, with the mass that follows."""
    return weight._replace(moment=moment, mass=mass_of(weight.place, moment) if moment else 0.0)


class Summed:
    """The static moments of a mechanism, vector by vector, and what may bring them to zero."""

    def __init__(self, mechanism: Mechanism, machine: Machine, wanted: Sought) -> None:
        self.formal, self.machine = Formal(mechanism), machine
        self.links, self.left = sorted(wanted.links), wanted.left
        formal = self.formal
        columns = [formal.along(link, 1 + 0j) for link in self.links]
        columns += [-formal.of(point) for point in self.left] + list(formal.loops)
        self.matrix = np.array(columns, dtype=np.complex128).reshape(-1, formal.size).T[1:]
        self.lengths = np.sqrt((np.abs(self.matrix) ** 2).sum(axis=0))
        self.inverse = np.linalg.pinv(self.matrix / self.lengths, rcond=EPS)
        self.blurred = np.zeros(len(self.lengths))
        self.blurred[: len(self.links)] = list(self._blurred(mechanism))

    def _blurred(self, mechanism: Mechanism) -> Iterator[float]:
        """Give the static moments kg*m by which mass centres are rounded, as the longest of the links is."""
        places = [np.array(list(link.points.values())) for link in mechanism.links.values() if link.number != FRAME]
        longest = max(float(np.abs(row[:, None] - row).max()) for row in places)
        bodies = (self.machine.bodies.get(link) for link in self.links)
        return (ROUNDING * EPS * body.mass * longest if body else 0.0 for body in bodies)

    def solve(self, known: FoundWeights) -> FoundWeights:
        """Find static moments and masses that stay, with the masses known so far where the links begin."""
        borne = [(body.mass, self.formal.place(body.link, body.centre)) for body in self.machine.bodies.values()]
        added = [
            (counterweight, self.formal.place(counterweight.link, counterweight.origin))
            for counterweight in known.counterweights
        ]
        borne += [(weight.mass, row) for weight, row in added]
        total = -np.sum([mass * row for mass, row in borne], axis=0)[1:]
        found = np.zeros(len(self.lengths), dtype=np.complex128)
        for _ in range(REFINEMENTS + 1):
            found = found + self.inverse @ (total - self.matrix @ found) / self.lengths
        sizes = ROUNDING * EPS * np.sum([mass * np.abs(row) for mass, row in borne], axis=0)
        off = [uncertain(weight, known.slack.get(weight.link, 0.0)) * np.abs(row) for weight, row in added]
        # How far rounding of the terms can have moved what is found, and what refinements leave of no term.
        terms = ROUNDING * EPS * (np.abs(self.matrix) @ np.abs(found)) + np.sum([sizes, *off], axis=0)[1:]
        left = (ROUNDING * EPS) ** REFINEMENTS * float(terms.max())
        return self._found(known, found, np.asarray((np.abs(self.inverse) @ terms + left) / self.lengths))

    def _found(self, known: FoundWeights, found: Complexes, slack: Floats) -> FoundWeights:
        """Tell what is found; what rounding alone has left is nothing."""
        count, values = len(self.links), np.where(np.abs(found) <= slack + self.blurred, 0, found).tolist()
        moments = dict(zip(self.links, values, strict=False))
        carried = tuple(carrying(weight, moments.get(weight.link, 0j)) for weight in known.counterweights)
        left = dict(zip(self.left, values[count:], strict=False))
        off = slack.tolist()
        slacks, loose = dict(zip(self.links, off, strict=False)), dict(zip(self.left, off[count:], strict=False))
        return FoundWeights(carried, left, slacks, loose)


def shared(mechanism: Mechanism, left: dict[str, complex]) -> complex:
    """Sum the static moment kg*m, in the crank's frame about its shaft, of masses at sliders whose rod hangs on it."""
    crank = mechanism.links[mechanism.drive.link]
    shaft = crank.points[mechanism.drive.pivot]
    hung = ((mass, _hung(mechanism, point)) for point, mass in left.items())
    return sum((mass * (crank.points[pin] - shaft) for mass, pin in hung if pin), 0j)


def _hung(mechanism: Mechanism, point: str) -> str | None:
    """Give the pin by which the rod of a slider's hinge hangs on the crank; None where it does not."""
    rods = [link for link in mechanism.hinges.get(point, ()) if link != FRAME]
    pins = [pin for pin, links in mechanism.hinges.items() if mechanism.drive.link in links and pin != point]
    return next((pin for pin in pins for rod in rods if rod in mechanism.hinges[pin]), None)
