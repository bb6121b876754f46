"""What must stand on Zhukovsky's lever by the analysis: images, forces, arms, its equation (рычаг Жуковского)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import permutations, product
from typing import NamedTuple

import numpy as np

from drawings.checks.expected import Expected
from drawings.forces.due_acting import ABOUT, REACTION, ExpectedForces
from drawings.lettering.words import letter, with_index
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Key, Kind, Text
from drawings.symbols.figure import plain_name
from plans.forces.bill import ActingForce, LoadedPosition
from plans.forces.drive import BALANCING, DRIVING
from plans.model.machine import GEAR
from plans.model.mechanism import FRAME, Mechanism
from plans.model.motion import NOTHING

LEVER, DETAIL, EQUATION = "lever", "detail-lever", "equations-lever"
DIGITS, ARM_DIGITS = 5, 4
TURNED = 1e-9  # rad: of an arrow on paper, by its coordinates alone
QUARTER = -1j


def lever(acting: ExpectedForces, scales: Mapping[str, float], sheets: Sequence[frozenset[Key]]) -> Iterator[Expected]:
    """Give what must stand on the lever of a position, where there is one; without its equation arms are told."""
    if LEVER in scales:
        figures = [{key[1] for key in keys} for keys in sheets]
        alone = any(f"{EQUATION}-{acting.k}" in shown and LEVER not in shown for shown in figures)
        names = {key[2] for keys in sheets for key in keys if key[0] is Kind.POINT and key[1] == LEVER}
        stated = {key[2] for keys in sheets for key in keys if key[1] in (LEVER, DETAIL, f"{EQUATION}-{acting.k}")}
        mu = scales[LEVER]
        sheet = _DrawnLever(acting, mu, 1.0 if alone else mu, frozenset(names), frozenset(stated))
        yield from (*sheet.equation(), *sheet.letters())
        enlarged = {(*key[:1], *key[2:]) for keys in sheets for key in keys if key[1] == DETAIL}
        for row in (*sheet.points(), *sheet.directions(), *sheet.arms()):
            there = (row.kind, row.name, row.position) in enlarged
            yield row._replace(may_lack=row.may_lack or there)
            yield from [row._replace(figure=DETAIL)] if there else ()


class _Hung(NamedTuple):
    """A force on the lever, or a couple of two: N, at an image m/s; its power W."""

    name: str
    letter: str  # in the equation
    value: complex
    at: complex
    power: float
    start: complex = 0j  # of a couple the image of its other force

    @property
    def paired(self) -> bool:
        """Whether it is a couple."""
        return "/" in self.name

    @property
    def length(self) -> float:
        """How long its arm is, m/s."""
        return abs(self.power / self.value)


@dataclass(frozen=True)
class _DrawnLever:
    """The lever of one position at a scale, what a unit of its arms is in the equation, and the images it shows."""

    acting: ExpectedForces
    mu: float
    unit: float
    names: frozenset[str]
    stated: frozenset[str]  # all that it and its equation state, by name

    @property
    def position(self) -> LoadedPosition:
        return self.acting.position

    @property
    def mechanism(self) -> Mechanism:
        return self.position.mechanism

    @cached_property
    def images(self) -> dict[str, complex]:
        """The images of points, m/s, by their names: the velocities, turned."""
        position, velocities = self.position, self.acting.statics.study.drafts().velocities
        letters, points = velocities.written, position.motion.points
        found = {velocities.point(name).name: QUARTER * complex(point.v[position.k]) for name, point in points.items()}
        for link, body in position.machine.bodies.items():
            if body.centre not in self.mechanism.links[link].points.values():  # else it has the point's letter
                found.setdefault(letters.small(f"S{link}"), self._image(link, position.on(link, body.centre)))
        for name, link in product(points, self.mechanism.links):
            if link != FRAME:
                found.setdefault(letters.under(name, link), self._image(link, position.place(name)))
        if position.machine.transmission.kind == GEAR:
            found.setdefault("w", self.hung[0].at)
        beside = complex(math.nan, math.nan)  # of places on guides that run past the points: no force acts there
        return found | {name: beside for name in self.names if name not in found}

    def _image(self, link: int, place: complex) -> complex:
        return QUARTER * self.position.speed(link, place)

    def points(self) -> Iterator[Expected]:
        """Give the images: those of the points of the links must stand."""
        velocities = self.acting.statics.study.drafts().velocities
        moving = {velocities.point(name).name for name in self.position.motion.points} - {velocities.pole.name}
        for name, place in self.images.items():
            off = math.inf if math.isnan(place.real) else self.acting.fast
            yield Expected(Kind.POINT, LEVER, name, place, off, self.acting.k, may_lack=name not in moving)

    @cached_property
    def hung(self) -> list[_Hung]:
        """All that hangs on the lever, what balances it first, then by links: inertia, weight, loads, then couples."""
        bills = {link: bill for bill in self.acting.bills.values() for link in bill.links}
        # Of each link what acts beside reactions: inertia, weight, loads
        own = [(one, k) for k in sorted(bills) for one in bills[k].known if one.link == k]
        own.sort(key=lambda pair: (pair[1], pair[0].name != f"Φ_{pair[1]}", pair[0].name != f"G_{pair[1]}"))
        forces = [force for force, _ in own if not REACTION.match(force.name)]
        found = [self._force(force) for force in (self._balancing(), *forces)]
        return [*found, *(couple for link in sorted(bills) for couple in self._couples(link))]

    def _force(self, force: ActingForce) -> _Hung:
        at = self._image(force.link, force.at)
        power = (at.conjugate() * force.value).imag
        return _Hung(self.acting.name(force.name), self.acting.letter(force.name), force.value, at, power)

    def _balancing(self) -> ActingForce:
        """Give what balances the lever: what drives by a force, else the force at the crank's end."""
        position, drive = self.position, self.mechanism.drive
        driving = self.acting.bills[str(drive.link)].driving
        if driving:
            return driving[0]
        end = position.place(drive.end)
        moment = 0.0 if drive.ram is not None else float(position.forces.balancing.moment[position.k])
        return ActingForce(DRIVING, drive.link, end, 1j * moment / (end - position.place(drive.pivot)).conjugate())

    def _couples(self, link: int) -> Iterator[_Hung]:
        position = self.position
        spin = float(position.motion.links[link].omega[position.k])
        for name, moment in position.couples(link):
            head = f"{self.acting.name(name)}/"
            lines = {stated.removeprefix(head) for stated in self.stated if stated.startswith(head)}
            for start, end in (ends for ends in permutations(position.named, 2) if "".join(ends) in lines):
                run = position.place(end) - position.place(start)
                if run:
                    bearer = self._bearer(link, start, end)
                    far, near = (self._image(bearer, position.place(point)) for point in (end, start))
                    line, force = f"{start}{end}", 1j * moment / run.conjugate()
                    alone = f"−{head}{line}" not in self.stated
                    if alone and abs(far) <= ABOUT * NOTHING * abs(near):  # at the pole nothing is drawn: the other is
                        force, far, near = -force, near, far
                    written = f"{self.acting.letter(name)}/l_{{{line}}}"
                    yield _Hung(f"{head}{line}", written, force, far, moment * spin, near)

    def _bearer(self, link: int, start: str, end: str) -> int:
        """Find the link that bears a couple on a line: of all that turn alike one with both points."""
        alike = [link]
        for turning in alike:  # it grows on the way
            pairs = ({slide.slider, slide.owner} for slide in self.mechanism.slides)
            alike += [other for pair in pairs if turning in pair for other in pair - {FRAME, *alike}]
        points = {turning: self.mechanism.links[turning].points for turning in alike}
        return max(alike, key=lambda turning: (start in points[turning], end in points[turning]))

    def directions(self) -> Iterator[Expected]:
        """Give the directions of the forces; the second of a couple is the first turned round."""
        none = self.acting.none[0]
        for hung in self.hung:
            size = abs(hung.value)
            lost = hung.paired or size <= none or abs(hung.at) <= ABOUT * NOTHING * self._fastest
            allowed = math.inf if size <= none else TURNED + self.acting.slack / size
            way = hung.value / size if size else 0j
            row = Expected(Kind.DIRECTION, LEVER, hung.name, way, allowed, self.acting.k, lost)
            yield row
            yield from (row._replace(name=f"−{hung.name}", value=-way),) if hung.paired else ()

    @cached_property
    def terms(self) -> tuple[tuple[str, _Hung], ...]:
        """The forces that have a moment about the pole and an arm of their own, by its letter, in their order."""
        found, number = list[tuple[str, _Hung]](), 0
        for hung in self._single:
            if abs(hung.power) > self._none and abs(abs(hung.at) - hung.length) > NOTHING * hung.length:
                balancing = hung is self.hung[0]
                number += not balancing
                index = "bal" if balancing else str(number)
                found.append((letter(self.acting.statics.study.language, f"h′_{{{index}}}"), hung))
        return tuple(found)

    @property
    def _single(self) -> list[_Hung]:
        """The forces without the couples."""
        return [hung for hung in self.hung if not hung.paired]

    @cached_property
    def _none(self) -> float:
        """The power W below which a force may have none."""
        forces = self._single
        return NOTHING * max(abs(force.value) for force in forces) * max(abs(force.at) for force in forces)

    @cached_property
    def _doubtful(self) -> bool:
        """Whether rounding may decide which forces have arms, so how these are numbered."""
        none = any(self._none / ABOUT < abs(force.power) < self._none * ABOUT for force in self._single)
        armed = (force for force in self._single if abs(force.power) > self._none)
        off = [abs(abs(force.at) / force.length - 1) for force in armed]
        return none or any(NOTHING / ABOUT < share < NOTHING * ABOUT for share in off)

    def _off(self, hung: _Hung) -> float:
        return self.acting.fast + abs(hung.at) * self.acting.slack / abs(hung.value)

    def arms(self) -> Iterator[Expected]:
        """Give the arms that are drawn: from the pole, square to the force."""
        for mark, hung in self.terms:
            size, off = abs(hung.value), self._off(hung)
            foot = -1j * hung.value / size * hung.power / size
            lost, allowed = self._doubtful or hung.length <= SEEN * self.mu + off, math.inf if self._doubtful else off
            yield Expected(Kind.VECTOR, LEVER, plain_name(mark), foot, allowed, self.acting.k, lost, letter=mark)

    def equation(self) -> Iterator[Expected]:
        """Give the numbers of the lever's equation: forces, arms in mm as drawn, the balancing moment."""
        row = Expected(Kind.PHRASE, f"{EQUATION}-{self.acting.k}", "", 0.0, digits=DIGITS, may_lack=True)
        for hung in self.hung:
            yield row._replace(name=hung.letter, value=abs(hung.value), allowed=self.acting.none[0])
        for mark, hung in self.terms:
            off = math.inf if self._doubtful else self._off(hung) / self.unit
            yield row._replace(name=mark, value=hung.length / self.unit, allowed=off, digits=ARM_DIGITS)
        lines = (ends for ends in permutations(self.images, 2) if "".join(map(with_index, ends)) in self.stated)
        for start, end in lines:
            size = abs(self.images[end] - self.images[start]) / self.unit
            off = math.inf if math.isnan(size) else 2 * self.acting.fast / self.unit
            yield row._replace(name=with_index(start) + with_index(end), value=size, allowed=off, digits=ARM_DIGITS)
        moment = float(self.position.forces.balancing.moment[self.acting.k])
        yield row._replace(name=self.acting.letter(BALANCING), value=moment, allowed=self.acting.none[1])

    def letters(self) -> Iterator[Expected]:
        """Give the terms of the equation in letters; where images coincide any of them may letter an arm."""
        marks = {hung.name: mark for mark, hung in self.terms}
        turning = [hung for hung in self.hung if abs(hung.power) > self._none]
        for hung in turning:
            ends = [self._shown(hung.at), self._shown(hung.start) if hung.paired else "p"]
            text = Text(0j, f"{hung.letter}·{marks.get(hung.name, ''.join(reversed(ends)))}").plain
            signed = text if hung is turning[0] and hung.power > 0 else f"{'+' if hung.power > 0 else '−'} {text}"
            allowed = math.inf if self._doubtful or (hung.name not in marks and not all(ends)) else 0.0
            yield Expected(Kind.LETTER, f"{EQUATION}-{self.acting.k}", hung.letter, signed, allowed, may_lack=True)

    @cached_property
    def _fastest(self) -> float:
        return float(np.nanmax([abs(image) for image in self.images.values()]))

    def _shown(self, place: complex) -> str:
        near = ABOUT * NOTHING * self._fastest
        if abs(place) <= near:
            return "p"
        here = [name for name in self.names if abs(self.images[name] - place) <= near]
        return with_index(here[0]) if len(here) == 1 else ""
