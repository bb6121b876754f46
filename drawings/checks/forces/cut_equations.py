"""The self-check of the equations beside a cut: every term, sign, arm, line and value (проверка уравнений группы)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import NamedTuple

from drawings.checks.forces.scheme_forces import Floor
from drawings.checks.forces.written_equations import WrittenEquations, WrittenMoments, WrittenTerm
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong
from drawings.lettering.words import word
from plans.checks.force_bill import ActingForce, Bearing, ForceBill
from plans.words.words import message

DIGITS = 5  # of a number in an equation
MM = 1000.0  # of a metre: arms are told in mm
FULL, DIRECTION, UNKNOWN = 2, 1, 0  # lines under a force that is known, of known direction, unknown


class Turning(NamedTuple):
    """A force or a couple in an equation of moments: its moment N*m, its size N, and how far it acts, m."""

    moment: float
    size: float = 0.0
    far: float = 0.0


class CutEquationsCheck:
    """The passage beside one cut, and the bill of its forces."""

    def __init__(self, label: str, written: WrittenEquations, bill: ForceBill, floor: Floor) -> None:
        self.label, self.written, self.bill, self.floor = label, written, bill, floor

    def faults(self) -> Iterator[Wrong]:
        """Hold statements, equations of moments, the equation of forces; name what is missing."""
        yield from self._statements()
        told = {term.force for one in self.written.moments for term in one.terms}
        yield from (self._missing(name) for name in self._solved if self._letter(name) not in told)
        for one in self.written.moments:
            yield from self._moments(one)
        yield from self._forces()

    @cached_property
    def order(self) -> tuple[str, ...]:
        """The forces in the order of their equation, by name."""
        names = {self._letter(name): name for name in self._forces_by_name}
        return tuple(names.get(one.letter, one.letter) for one in self.written.forces)

    def _letter(self, name: str) -> str:
        return read(self.floor.letter(name))

    def _missing(self, name: str) -> Wrong:
        return message("wrong.missing_equation", name=name, cut=self.label)

    def _wrong(self, text: str) -> Wrong:
        return message("wrong.equation", text=text, cut=self.label)

    @cached_property
    def _forces_by_name(self) -> dict[str, ActingForce]:
        """Every force that may be told of the cut."""
        bill, driving = self.bill, [] if self.bill.driving is None else [self.bill.driving]
        bearings = [part for one in bill.bearings for part in (one.whole, *one.parts)]
        inner = [force for one in bill.inner for force in (one.whole, _opposite(one))]
        return {one.name: one for one in (*bill.known, *driving, *bearings, *inner)}

    @cached_property
    def _moments_by_name(self) -> dict[str, float]:
        found = {one.name: one.moment for one in self.bill.couples}
        found |= {one.couple: one.moment for one in (*self.bill.bearings, *self.bill.inner)}
        return found | {_opposite(one).name.replace("R", "M", 1): -one.moment for one in self.bill.inner}

    def _statements(self) -> Iterator[Wrong]:
        """Hold what is told of forces and moments, and that what is given and what is found is told."""
        newton, turned = word(self.floor.language, "N"), word(self.floor.language, "N*m")
        sizes = {self._letter(name): abs(one.value) for name, one in self._forces_by_name.items()}
        moments = {self._letter(name): value for name, value in self._moments_by_name.items()}
        for one in self.written.statements:
            true, unit, none = sizes.get(one.name), newton, self.floor.force
            if true is None:
                true, unit, none = moments.get(one.name), turned, self.floor.moment
            if true is not None and not (one.unit == unit and reads(one.value, true, none + half(abs(true)))):
                yield self._wrong(f"{one.name} = {one.value} {one.unit}")
        told = {one.name for one in self.written.statements}
        armed = [one for one in self.written.statements if one.name not in sizes and one.name not in moments]
        if armed and armed[-1].unit != word(self.floor.language, "mm"):
            yield self._wrong(f"{armed[-1].name} = {armed[-1].value} {armed[-1].unit}")
        for names in self._due():
            if not any(self._letter(name) in told for name in names):
                yield self._missing(names[0])

    def _due(self) -> Iterator[tuple[str, ...]]:
        """Give what must be told, each with the names that it may have."""
        bill, floor = self.bill, self.floor
        yield from ((one.name,) for one in bill.known if one.name[0] != "R" and abs(one.value) > floor.force)
        yield from ((one.name,) for one in bill.couples if one.name[1:2] == "^" and abs(one.moment) > floor.moment)
        yield from ((one.name,) for one in bill.bearings)
        yield from ((one.name, _opposite(one).name) for one in bill.inner)
        for one in (*bill.bearings, *bill.inner):
            if abs(one.moment) > floor.moment:
                yield one.couple, _opposite(one).name.replace("R", "M", 1)

    @property
    def _solved(self) -> Iterator[str]:
        """Give what is found by moments, if it is any."""
        drive, written = self.bill.expected.mechanism.drive, {one.letter for one in self.written.forces}
        for one in self.bill.bearings:
            yield from (part.name for part in one.parts if "^t" in part.name and self._seen(part, written))
        if self.bill.group is not None and self.bill.group.kind == "RPR":
            stone = self.bill.bearings[0]
            split = stone.whole
            if any(self._letter(part.name) in written for part in stone.parts):  # also where the slot's part is alone
                split = next(part for part in stone.parts if "^n" in part.name)
            yield from [split.name] if abs(split.value) > self.floor.force else []
        if self.bill.group is None and drive.guide is None and drive.ram is None:
            names = [] if self.bill.driving is None else [(self.bill.driving.name, abs(self.bill.driving.value))]
            own = [(one.name, abs(one.moment)) for one in self.bill.couples if one.name == "M_bal"]
            yield from (name for name, size in names if size > self.floor.force)
            yield from (name for name, size in own if size > self.floor.moment)

    def _seen(self, part: ActingForce, written: set[str]) -> bool:
        return abs(part.value) > self.floor.force and self._letter(part.name) in written

    def _moments(self, one: WrittenMoments) -> Iterator[Wrong]:
        """Hold an equation of moments by all links of the cut or by one of them, whichever it is of."""
        about = next((name for name in self.bill.expected.motion.points if _plain(name) == one.about), None)
        if about is None:
            yield self._wrong(f"ΣM{one.about}")
            return
        several: tuple[tuple[int, ...], ...] = () if one.link is not None else (self.bill.links,)
        links: list[tuple[int, ...]] = [(link,) for link in self.bill.links if one.link in (None, link)]
        tries = [
            list(self._held(one, self.bill.place(about), own)) for own in (*several, *(links or [self.bill.links]))
        ]
        yield from min(tries, key=len)

    def _held(self, one: WrittenMoments, about: complex, links: tuple[int, ...]) -> Iterator[Wrong]:
        due = self._turnings(about, links, {term.force for term in one.terms})
        arms = {told.name: told.value for told in self.written.statements}
        for term in one.terms:
            turning = due.pop(term.force, None)
            if turning is None or not self._true(term, turning, arms):
                yield self._wrong(f"{term.force}·{term.arm}" if term.arm else term.force)
        for name, turning in due.items():
            if abs(turning.moment) > self.floor.moment + self.floor.force * turning.far:
                yield message("wrong.missing_equation", name=name, cut=self.label)

    def _turnings(self, about: complex, links: tuple[int, ...], written: set[str]) -> dict[str, Turning]:
        """Give the moments about a point of all that acts on some links from outside of them."""
        bill, found = self.bill, dict[str, Turning]()
        driving = [] if bill.driving is None else [bill.driving]
        forces = [one for one in (*bill.known, *driving) if one.link in links]
        couples = [(one.name, one.moment) for one in bill.couples if one.link in links]
        for one in (one for one in bill.bearings if one.link in links):
            split = any(self._letter(part.name) in written for part in one.parts)
            forces += one.parts if split else (one.whole,)
            couples += [(one.couple, one.moment)] if one.along is not None else []
        for one in bill.inner if len(links) == 1 else ():
            forces.append(one.whole if one.link in links else _opposite(one))
        for name, moment in couples:
            found[self._letter(name)] = Turning(moment)
        for force in forces:
            arm = force.at - about
            found[self._letter(force.name)] = Turning((arm.conjugate() * force.value).imag, abs(force.value), abs(arm))
        return found

    def _true(self, term: WrittenTerm, due: Turning, arms: Mapping[str, str]) -> bool:
        """Tell whether a term has the sign and the arm of its moment; an unknown couple stands with a plus."""
        small = abs(due.moment) <= self.floor.moment + self.floor.force * due.far
        if not term.arm:
            return due.size == 0 and (small or self._unknown(term) or term.sign == math.copysign(1, due.moment))
        length = abs(due.moment) / due.size if due.size else 0.0
        slack = MM * due.far * self.floor.force / due.size if due.size else math.inf
        told = reads(arms.get(term.arm, ""), MM * length, slack + half(MM * length))
        return told and (small or term.sign == math.copysign(1, due.moment)) and due.size > 0

    def _unknown(self, term: WrittenTerm) -> bool:
        return term.force == self._letter("M_bal") and term.sign > 0

    def _forces(self) -> Iterator[Wrong]:
        """Hold the equation of forces: every force once, with a plus, a bar, and the lines of what is known of it."""
        told = [one.letter for one in self.written.forces]
        sides = self._sides(set(told))
        closers = self._closers(set(told))
        for one in self.written.forces:
            under = FULL if one.letter not in closers else DIRECTION if len(closers) > 1 else UNKNOWN
            right = one.sign > 0 and one.barred and one.lines == under and told.count(one.letter) == 1
            if one.letter not in sides or not right:
                yield self._wrong(one.letter)
        seen = [name for name, value in sides.items() if abs(value) > self.floor.force]
        if len(seen) > 1:
            yield from (self._missing(name) for name in seen if name not in told)

    def _sides(self, told: set[str]) -> dict[str, complex]:
        """Give the sides of the polygon by their letters, of a reaction its parts where the equation has them."""
        driving = [] if self.bill.driving is None else [self.bill.driving]
        found = [*self.bill.known, *driving]
        for one in self.bill.bearings:
            split = any(self._letter(part.name) in told for part in one.parts)
            found += one.parts if split else (one.whole,)
        return {self._letter(one.name): one.value for one in found}

    def _closers(self, told: set[str]) -> set[str]:
        """Give the forces that the polygon gives: of a hinge the part along its lead, of a guide its reaction."""
        bill, drive = self.bill, self.bill.expected.mechanism.drive
        bearings = bill.bearings
        if bill.group is not None and bill.group.kind == "RPR":
            bearings = bearings[1:]
        found = set()
        for one in bearings:
            part = (part.name for part in one.parts if "^n" in part.name and self._letter(part.name) in told)
            found.add(self._letter(next(part, one.name)))
        return found | ({self._letter(bill.driving.name)} if drive.guide and bill.driving is not None else set())


def half(size: float) -> float:
    """Give the half of the last digit of a number that has more digits before its point than are written."""
    return 0.5 * 10.0 ** (math.floor(math.log10(size)) + 1 - DIGITS) if size >= 10.0**DIGITS else 0.0


def _plain(name: str) -> str:
    return name.replace("_", "")


def _opposite(one: Bearing) -> ActingForce:
    """Give the reaction of the same pair on the other link."""
    letter, _, index = one.name.partition("_")
    giver, taker = index.split(",") if "," in index else (index[: len(index) // 2], index[len(index) // 2 :])
    turned = f"{taker},{giver}" if "," in index else f"{taker}{giver}"
    return ActingForce(f"{letter}_{turned}", int(giver), one.hinge, -one.value, one.point)
