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
from drawings.forces.due_acting import ABOUT, REACTION, Acting, unbraced
from drawings.lettering.vector_letters import with_index
from drawings.lettering.words import letter
from drawings.paper.limits import SEEN
from drawings.paper.statement import Key, Kind
from drawings.paper.strokes import Text
from plans.forces.bill import ActingForce
from plans.forces.primary import BALANCING, DRIVING
from plans.model.machine import GEAR
from plans.model.mechanism import FRAME
from plans.model.motion import NOTHING

LEVER, EQUATION = "lever", "equations-lever"
DIGITS, ARM_DIGITS = 5, 4
TURNED = 1e-9  # rad: of an arrow on paper, by its coordinates alone
QUARTER = -1j


def lever(acting: Acting, scales: Mapping[str, float], sheets: Sequence[frozenset[Key]]) -> Iterator[Expected]:
    """Give what must stand on the lever of a position, where there is one, by what its sheets state.

    Beside its equation on a sheet without it the arms are told in true units.
    """
    if LEVER in scales:
        figures = [{key[1] for key in keys} for keys in sheets]
        alone = any(f"{EQUATION}-{acting.k}" in own and LEVER not in own for own in figures)
        names = {key[2] for keys in sheets for key in keys if key[0] is Kind.POINT and key[1] == LEVER}
        said = {key[2] for keys in sheets for key in keys if key[1] in (LEVER, f"{EQUATION}-{acting.k}")}
        own = _Lever(acting, scales[LEVER], 1.0 if alone else scales[LEVER], frozenset(names), frozenset(said))
        yield from own.points()
        yield from own.forces()
        yield from (*own.equation(), *own.letters())


class _Hung(NamedTuple):
    """A force on the lever, or a couple of two: N, at an image m/s; its power W."""

    name: str
    letter: str  # in the equation
    value: complex
    at: complex
    power: float
    start: complex = 0j  # of a couple the image of its other force

    @property
    def length(self) -> float:
        """How long its arm is, m/s."""
        return abs(self.power / self.value)


@dataclass(frozen=True)
class _Lever:
    """The lever of one position at a scale, what a unit of its arms is in the equation, and the images it shows."""

    acting: Acting
    mu: float
    unit: float
    names: frozenset[str]
    said: frozenset[str]  # all that it and its equation state, by name

    @cached_property
    def images(self) -> dict[str, complex]:
        """The images of points, m/s, by their names: the velocities, turned."""
        study, motion, k = self.acting.statics.study, self.acting.comparison.motion.analysis, self.acting.k
        velocities, bill = study.drafts().velocities, next(iter(self.acting.bills.values()))
        letters, links = velocities.written, [link for link in study.mechanism.links if link != FRAME]
        found = {velocities.point(name).name: QUARTER * complex(one.v[k]) for name, one in motion.points.items()}
        for link, body in self.acting.statics.machine.bodies.items():
            found.setdefault(letters.small(f"S{link}"), QUARTER * bill.speed(link, bill.on(link, body.centre)))
        for name, link in product(motion.points, links):
            found.setdefault(letters.under(name, link), QUARTER * bill.speed(link, bill.place(name)))
        if self.acting.statics.machine.transmission.kind == GEAR:
            found.setdefault("w", self.hung[0].at)
        beside = complex(math.nan, math.nan)  # of places on guides that run past the points: no force acts there
        return found | {name: beside for name in self.names if name not in found}

    def points(self) -> Iterator[Expected]:
        """Give the images: those of the points of the links must stand."""
        study = self.acting.statics.study
        velocities, points = study.drafts().velocities, self.acting.comparison.motion.analysis.points
        moving = {velocities.point(name).name for name in points} - {velocities.pole.name}
        for name, place in self.images.items():
            off = math.inf if math.isnan(place.real) else self.acting.fast
            yield Expected(Kind.POINT, LEVER, name, place, off, self.acting.k, may_lack=name not in moving)

    @cached_property
    def hung(self) -> list[_Hung]:
        """All that hangs on the lever, what balances it first, then by links: inertia, weight, loads, then couples."""
        bills = {link: bill for bill in self.acting.bills.values() for link in bill.links}
        forces = [one for link in sorted(bills) for one in _own(bills[link].known, link)]
        own = [self._force(one) for one in (*self._balancing(), *forces)]
        return [*own, *(one for link in sorted(bills) for one in self._couples(link))]

    def _force(self, one: ActingForce) -> _Hung:
        at = QUARTER * self.acting.bills[str(self.acting.statics.study.mechanism.drive.link)].speed(one.link, one.at)
        power = (at.conjugate() * one.value).imag
        return _Hung(self.acting.name(one.name), self.acting.letter(one.name), one.value, at, power)

    def _balancing(self) -> Iterator[ActingForce]:
        """Give what balances the lever: what drives by a force, else the force at the crank's end."""
        drive = self.acting.statics.study.mechanism.drive
        bill = self.acting.bills[str(drive.link)]
        if bill.driving is not None:
            yield bill.driving
            return
        crank, k = bill.place(drive.end) - bill.place(drive.pivot), self.acting.k
        moment = 0.0 if drive.ram is not None else float(self.acting.comparison.analysis.balancing.moment[k])
        yield ActingForce(DRIVING, drive.link, bill.place(drive.end), 1j * moment / crank.conjugate())

    def _couples(self, link: int) -> Iterator[_Hung]:
        """Give the couples of a link as two forces at any two points: the sheet chooses which."""
        known, k, bill = self.acting.expected, self.acting.k, next(iter(self.acting.bills.values()))
        body, spin = known.machine.bodies.get(link), float(known.motion.links[link].omega[k])
        told = [] if body is None else [(f"M^Φ_{link}", -body.inertia * float(known.motion.links[link].epsilon[k]))]
        told += [(one.name, float(one.moment[k])) for one in known.loading.moments if one.link == link]
        for name, moment in told:
            lines = {one.partition("/")[2] for one in self.said if one.startswith(f"{self.acting.name(name)}/")}
            for start, end in (ends for ends in permutations(known.motion.points, 2) if "".join(ends) in lines):
                run = bill.place(end) - bill.place(start)
                if run:
                    bearer = self._bearer(link, start, end)
                    far, near = (QUARTER * bill.speed(bearer, bill.place(point)) for point in (end, start))
                    line, force = f"{start}{end}", 1j * moment / run.conjugate()
                    written = f"{self.acting.letter(name)}/l_{{{line}}}"
                    alone = f"−{self.acting.name(name)}/{line}" not in self.said
                    if alone and abs(far) <= ABOUT * NOTHING * abs(near):  # at the pole nothing is drawn: the other is
                        force, far, near = -force, near, far
                    yield _Hung(f"{self.acting.name(name)}/{line}", written, force, far, moment * spin, near)

    def _bearer(self, link: int, start: str, end: str) -> int:
        """Find the link that bears a couple on a line: of all that turn alike one that has both points, or the first.

        Links that slide in one another turn alike, as a rod does with the stone that it slides through.
        """
        mechanism, alike = self.acting.statics.study.mechanism, [link]
        for turning in alike:  # it grows on the way
            pairs = ({slide.slider, slide.owner} for slide in mechanism.slides)
            alike += [other for pair in pairs if turning in pair for other in pair - {FRAME, *alike}]
        owned = [mechanism.links[turning].points for turning in alike]
        return alike[max(range(len(alike)), key=lambda k: (start in owned[k], end in owned[k]))]

    def forces(self) -> Iterator[Expected]:
        """Give the directions of the forces, and the arms."""
        none = self.acting.none[0]
        for one in self.hung:
            size, paired = abs(one.value), "/" in one.name
            lost = paired or size <= none or abs(one.at) <= ABOUT * NOTHING * self._fastest
            allowed = math.inf if size <= none else TURNED + self.acting.slack / size
            way = one.value / size if size else 0j
            row = Expected(Kind.DIRECTION, LEVER, one.name, way, allowed, self.acting.k, lost)
            yield row
            yield from (row._replace(name=f"−{one.name}", value=-way),) if paired else ()
        yield from self._arms()

    @cached_property
    def terms(self) -> tuple[tuple[str, _Hung], ...]:
        """The forces that have a moment about the pole and an arm of their own, by its letter, in their order."""
        found, number = list[tuple[str, _Hung]](), 0
        for one in (one for one in self.hung if "/" not in one.name):
            if abs(one.power) > self._none and abs(abs(one.at) - one.length) > NOTHING * one.length:
                balancing = one is self.hung[0]
                number += not balancing
                index = "bal" if balancing else str(number)
                found.append((letter(self.acting.statics.study.language, f"h′_{{{index}}}"), one))
        return tuple(found)

    @cached_property
    def _none(self) -> float:
        forces = [one for one in self.hung if "/" not in one.name]
        return NOTHING * max(abs(one.value) for one in forces) * max(abs(one.at) for one in forces)

    @cached_property
    def _doubtful(self) -> bool:
        """Whether rounding may decide which forces have arms, so how these are numbered."""
        own = [one for one in self.hung if "/" not in one.name]
        none = any(self._none / ABOUT < abs(one.power) < self._none * ABOUT for one in own)
        known = (one for one in own if abs(one.power) > self._none)
        off = [abs(abs(one.at) / one.length - 1) for one in known]
        return none or any(NOTHING / ABOUT < one < NOTHING * ABOUT for one in off)

    def _off(self, one: _Hung) -> float:
        """Give how far off an arm may be, m/s."""
        return self.acting.fast + abs(one.at) * self.acting.slack / abs(one.value)

    def _arms(self) -> Iterator[Expected]:
        """Give the arms that are drawn: from the pole, square to the force."""
        for mark, one in self.terms:
            foot, off = -1j * one.value / abs(one.value) * one.power / abs(one.value), self._off(one)
            lost, allowed = self._doubtful or one.length <= SEEN * self.mu + off, math.inf if self._doubtful else off
            yield Expected(Kind.VECTOR, LEVER, unbraced(mark), foot, allowed, self.acting.k, lost, letter=mark)

    def equation(self) -> Iterator[Expected]:
        """Give the numbers of the lever's equation: forces, arms in mm as drawn, the balancing moment."""
        row = Expected(Kind.PHRASE, f"{EQUATION}-{self.acting.k}", "", 0.0, digits=DIGITS, may_lack=True)
        for one in self.hung:
            yield row._replace(name=one.letter, value=abs(one.value), allowed=self.acting.none[0])
        for mark, one in self.terms:
            off = math.inf if self._doubtful else self._off(one) / self.unit
            yield row._replace(name=mark, value=one.length / self.unit, allowed=off, digits=ARM_DIGITS)
        lines = (ends for ends in permutations(self.images, 2) if "".join(map(with_index, ends)) in self.said)
        for start, end in lines:
            size = abs(self.images[end] - self.images[start]) / self.unit
            off = math.inf if math.isnan(size) else 2 * self.acting.fast / self.unit
            yield row._replace(name=with_index(start) + with_index(end), value=size, allowed=off, digits=ARM_DIGITS)
        moment = float(self.acting.comparison.analysis.balancing.moment[self.acting.k])
        yield row._replace(name=self.acting.letter(BALANCING), value=moment, allowed=self.acting.none[1])

    def letters(self) -> Iterator[Expected]:
        """Give the terms of the equation in letters; where images coincide any of them may letter an arm."""
        marks = {one.name: mark for mark, one in self.terms}
        told = [one for one in self.hung if abs(one.power) > self._none]
        for one in told:
            ends = [self._shown(one.at), *([self._shown(one.start)] if "/" in one.name else ["p"])]
            arm = marks.get(one.name, "".join(reversed(ends)))
            sign = "+ " if one.power > 0 else "− "
            text = Text(0j, f"{one.letter}·{arm}").plain
            allowed = math.inf if self._doubtful or (one.name not in marks and not all(ends)) else 0.0
            row = Expected(Kind.LETTER, f"{EQUATION}-{self.acting.k}", one.letter, sign + text, allowed, may_lack=True)
            yield row._replace(value=text) if one is told[0] and one.power > 0 else row

    @cached_property
    def _fastest(self) -> float:
        return float(np.nanmax([abs(one) for one in self.images.values()]))

    def _shown(self, place: complex) -> str:
        """Give the letter of the one image at a place; none where there are several, or none."""
        near = ABOUT * NOTHING * self._fastest
        if abs(place) <= near:
            return "p"
        here = [name for name in self.names if abs(self.images[name] - place) <= near]
        return with_index(here[0]) if len(here) == 1 else ""


def _own(known: tuple[ActingForce, ...], link: int) -> Iterator[ActingForce]:
    """Give what acts on a link beside reactions: inertia, weight, loads."""
    own = [one for one in known if one.link == link and not REACTION.match(one.name)]
    yield from sorted(own, key=lambda one: (one.name != f"Φ_{link}", one.name != f"G_{link}"))
