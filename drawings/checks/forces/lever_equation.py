"""The self-check of the lever's equation of moments: its terms, arms and numbers by powers alone (проверка рычага)."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from drawings.checks.reading import plain
from drawings.checks.wrong import Wrong, on
from drawings.figures.forces.force_letters import force_letter
from drawings.figures.forces.lever_equation import NAME
from drawings.figures.forces.lever_layout import PLAN
from drawings.figures.forces.lever_terms import ARM
from drawings.lettering.words import word
from drawings.measure.measure import Measured
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Group, Leaf, Text
from drawings.paper.walk import texts
from plans.checks.force_expected import ExpectedForces
from plans.forces.primary import BALANCING, DRIVING, balancing_quantity
from plans.model.kinetostatics import NOTHING
from plans.words.words import message

HEAD = "ΣMp:"
HALF = 0.5000001  # of the last digit written, with what rounding leaves
_ARM = re.compile(r"(?P<name>\S+) = (?P<value>[−\d.,]+?),?(?: (?P<unit>\S+))?")


class Due(NamedTuple):
    """What analysis finds of a force on the lever: its size N, its power W, and its line, without one of a couple."""

    size: float
    power: float
    along: complex = 0j


class Read(NamedTuple):
    """A term as written: its sign, what stands before the dot, and after it."""

    sign: int
    force: str
    arm: str


@dataclass(frozen=True)
class LeverCheck:
    """The equation beside a lever, and the arms drawn on it."""

    measured: Measured
    leaf: Leaf
    expected: ExpectedForces
    language: str
    slack: float  # N that the two roads may differ by

    def faults(self) -> Iterator[Wrong]:
        """Hold every term: its sign, its force and its arm, in letters and in numbers; then the arms drawn."""
        group = next((one for one in self.leaf.groups if one.name == NAME), None)
        if group is None:
            return
        letters, numbers = _equations(group)
        named = {one.force: one for one in letters}
        yield from (message("wrong.missing", name=name) for name in self._due if name not in named)
        told, mu = self._told(group)
        for k, one in enumerate(letters):
            known = self._due.get(one.force)
            figures = numbers[k] if k < len(numbers) and len(numbers) == len(letters) else None
            if known is None or figures is None or not self._holds(one, known, told.get(one.arm, ""), figures, mu):
                yield message("wrong.equation", text=f"{one.force}·{one.arm}", cut=PLAN)
        yield from self._given(told)
        yield from self._units(group)
        if self._drawn:
            yield from self._arms(named)

    def unequalled(self, leaves: Sequence[Leaf]) -> Iterator[Wrong]:
        """Name the equation that the lever of a sheet has on none of some sheets."""
        if self._drawn and self._due and not any(one.name == NAME for leaf in leaves for one in leaf.groups):
            yield message("wrong.missing", name=HEAD)

    @property
    def _drawn(self) -> bool:
        return any(one.plan == PLAN for one in self.measured.points)

    def _told(self, group: Group) -> tuple[dict[str, str], float]:
        """Read the arms that are told, and what a unit of theirs is: m/s."""
        found = [one for text in texts((group,)) if (one := _ARM.fullmatch(text.plain)) is not None]
        drawn = word(self.language, "mm") in {one["unit"] for one in found}
        scales = [one.scale for one in self.measured.points if one.plan == PLAN]
        return {one["name"]: one["value"] for one in found}, scales[0] if drawn and scales else 1.0

    def _given(self, told: Mapping[str, str]) -> Iterator[Wrong]:
        """Hold the force that balances the lever and its moment about the shaft, as they are told."""
        moment, k = self.expected.found.balancing.moment, self.expected.k
        longest = self.expected.found.size
        due = {self._letter(BALANCING): (float(moment[k]), self.slack * longest)} if self._by_moment else {}
        if self._letter(DRIVING) in self._due:
            due[self._letter(DRIVING)] = self._due[self._letter(DRIVING)].size, self.slack
        for name, (value, slack) in due.items():
            if name not in told or not _near(told[name], value, slack):
                yield message("wrong.equation", text=f"{name} = {told.get(name, '')}", cut=PLAN)

    def _units(self, group: Group) -> Iterator[Wrong]:
        """Hold the units of the force that balances the lever and of its moment."""
        due = {self._letter(DRIVING): word(self.language, "N"), self._letter(BALANCING): word(self.language, "N*m")}
        for one in (found for text in texts((group,)) if (found := _ARM.fullmatch(text.plain)) is not None):
            if one["name"] in due and (one["unit"] or "").rstrip(",") != due[one["name"]]:
                yield message("wrong.equation", text=one[0], cut=PLAN)

    def _holds(self, one: Read, due: Due, arm: str, figures: Read, mu: float) -> bool:
        size, same = due.size, one.sign == figures.sign == (1 if due.power > 0 else -1)
        return same and arm == figures.arm and _near(figures.force, size, self.slack) and self._long(arm, due, mu)

    def _long(self, arm: str, due: Due, mu: float) -> bool:
        """Tell whether an arm is as long as the power of its force says."""
        length = abs(due.power) / due.size / mu
        return bool(arm) and _near(arm, length, length * self.slack / due.size)

    def _arms(self, named: Mapping[str, Read]) -> Iterator[Wrong]:
        """Hold each arm that is drawn, and that each is drawn: square to its force, as long as its power says."""
        seen = {plain(one.name): one for one in self.measured.vectors if one.plan == PLAN}
        scale = next(one.scale for one in self.measured.points if one.plan == PLAN)
        for name, read in named.items():
            due = self._due.get(name)
            if due is None or not due.along or not read.arm.startswith(ARM):
                continue
            length, one = abs(due.power) / due.size, seen.get(read.arm)
            near = 2 * self.measured.quantum * scale + length * self.slack / due.size
            if one is None:
                if length > SEEN * scale + near:
                    yield on("missing_at", PLAN, name=read.arm, position=self.expected.k)
            elif not abs(one.value - 1j * due.along * -due.power / due.size) <= near:
                yield on("differs_at", PLAN, name=read.arm, position=self.expected.k)

    @cached_property
    def _due(self) -> dict[str, Due]:
        """Give what must stand in the equation, by its letters as they are read."""
        told = {self._letter(name): due for name, due in self._every()}
        speeds = (abs(complex(one.v[self.expected.k])) for one in self.expected.motion.points.values())
        # What is left of the greatest force at the greatest speed is no power, even where there are no others.
        greatest = max((due.size for due in told.values()), default=0.0) * max(speeds, default=0.0)
        return {name: due for name, due in told.items() if due.size > 0 and abs(due.power) > NOTHING * greatest}

    def _letter(self, name: str) -> str:
        head, slash, line = name.partition("/")
        return plain(Text(0j, force_letter(head, self.language)).plain) + (f"/l{line}" if slash else "")

    def _every(self) -> Iterator[tuple[str, Due]]:
        """Give the forces and couples of the machine, and what balances them."""
        known, k = self.expected, self.expected.k
        for link, body in sorted(known.machine.bodies.items()):
            speed = self._speed(link, body.centre)
            forces = {
                f"G_{link}": body.mass * known.machine.gravity,
                f"Φ_{link}": -body.mass * known.acceleration(body),
            }
            yield from ((name, _force(force, speed)) for name, force in forces.items())
            yield from self._couple(f"M^Φ_{link}", link, -body.inertia * float(known.motion.links[link].epsilon[k]))
        for load in known.loading.forces:
            yield load.name, _force(complex(load.force[k]), self._speed(load.link, load.at))
        for twist in known.loading.moments:
            yield from self._couple(twist.name, twist.link, float(twist.moment[k]))
        if self.expected.mechanism.drive.ram is None:  # the force of a cylinder is among the loads
            yield DRIVING, self._balance()

    @property
    def _by_moment(self) -> bool:
        """Whether what the drive gives is told as a moment."""
        return balancing_quantity(self.expected.mechanism.drive).name == BALANCING

    def _balance(self) -> Due:
        drive, told, k = self.expected.mechanism.drive, self.expected.found.balancing, self.expected.k
        omega, points = float(self.expected.motion.links[drive.link].omega[k]), self.expected.motion.points
        power = float(told.moment[k]) * omega
        if told.force is not None and drive.pushed:
            return _force(complex(told.force[k]), complex(points[drive.end].v[k]))
        if told.force is not None and told.r is not None:
            force = complex(told.force[k])
            return Due(abs(force), power, force / abs(force) if abs(force) > 0 else 0j)
        crank = complex(points[drive.end].r[k]) - complex(points[drive.pivot].r[k])
        return Due(abs(float(told.moment[k]) / crank), power)

    def _couple(self, name: str, link: int, moment: float) -> Iterator[tuple[str, Due]]:
        """Give a couple as two forces at any two points of its link: which two, the sheet chooses; none is missed."""
        points, k = self.expected.motion.points, self.expected.k
        power = moment * float(self.expected.motion.links[link].omega[k])
        lines = self._lines(name)
        if not lines:
            yield name, Due(abs(moment), power)
        for line in lines:
            ends = [complex(points[end].r[k]) for end in line if end in points]
            if len(ends) == len(line) == 2 and ends[0] != ends[1]:
                yield f"{name}/{''.join(line)}", Due(abs(moment) / abs(ends[1] - ends[0]), power)

    def _lines(self, name: str) -> list[tuple[str, str]]:
        """Read which two points a couple stands at."""
        letter, names = self._letter(name), sorted(self.expected.motion.points, key=len, reverse=True)
        written = {one.force.removeprefix(f"{letter}/l") for one in self._read if one.force.startswith(f"{letter}/l")}
        return [(one, text[len(one) :]) for text in written for one in names if text.startswith(one)]

    @cached_property
    def _read(self) -> list[Read]:
        group = next((one for one in self.leaf.groups if one.name == NAME), None)
        return [] if group is None else _equations(group)[0]

    def _speed(self, link: int, place: complex) -> complex:
        """Give the velocity of a place of a link: that of a point of the link, and the turning about it."""
        k, turning = self.expected.k, self.expected.motion.links[link]
        name, own = next(iter(self.expected.mechanism.links[link].points.items()))
        turned = cmath.rect(float(turning.omega[k]), float(turning.angle[k]))
        return complex(self.expected.motion.points[name].v[k]) + 1j * turned * (place - own)


def _force(force: complex, speed: complex) -> Due:
    size = abs(force)
    return Due(size, (speed.conjugate() * force).real, force / size if size else 0j)


def _near(text: str, value: float, slack: float) -> bool:
    """Tell whether a number is written as a value to its last digit, or to what it has of whole numbers."""
    number = text.replace(",", ".").replace("−", "-")
    last = 10.0 ** -len(number.partition(".")[2]) if "." in number else _whole(value)
    return math.isclose(float(number), value, rel_tol=0.0, abs_tol=HALF * last + slack)


def _whole(value: float) -> float:
    """Give the last digit of a whole number of five digits at least, or what a shorter one stands for: 1."""
    return max(1.0, 10.0 ** (math.floor(math.log10(abs(value))) - 4)) if value else 1.0


def _equations(group: Group) -> tuple[list[Read], list[Read]]:
    """Read both equations: that in letters, and that in numbers."""
    found: list[list[Read]] = []
    sign, open_ = 1, False
    for text in (one.plain for one in texts((group,))):
        if text == HEAD:
            found.append([])
            sign, open_ = 1, True
        elif text in ("+", "−"):
            sign = 1 if text == "+" else -1
        elif text == "=":
            open_ = False
        elif open_ and "·" in text:
            force, _, arm = text.rpartition("·")
            found[-1].append(Read(sign, force, arm))
            sign = 1
    return (found[0], found[1]) if len(found) == 2 else ([], [])
