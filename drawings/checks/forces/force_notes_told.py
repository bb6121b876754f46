"""The self-check of the notes of force sheets: what is given, the powers on the lever (пояснения)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from drawings.checks import reading
from drawings.checks.forces.scheme_forces import Floor
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.wrong import Wrong
from drawings.lettering.words import number, word
from drawings.paper.strokes import Leaf
from drawings.paper.walk import texts
from plans.checks.force_bill import ForceBill
from plans.checks.hand.quantity import SLIP
from plans.forces.primary import BALANCING, DRIVING
from plans.forces.statics import Statics
from plans.model.kinetostatics import NOTHING
from plans.model.machine import GEAR
from plans.words.words import message

MOST_LENGTHS = 16  # of a mechanism with more the notes do not tell them
DIGITS = 5  # of the sum of powers
_SIGNS = str.maketrans({"\N{NO-BREAK SPACE}": " ", "\n": " "})


@dataclass(frozen=True)
class ForceNotes:
    """The notes of the sheets of one position, in one line."""

    said: str
    statics: Statics
    bills: Mapping[tuple[int, ...], ForceBill]
    floor: Floor

    def faults(self) -> Iterator[Wrong]:
        """Hold what is given, and the powers on the lever."""
        for due in self._given():
            if _flat(read(due)) not in self.said:
                yield message("wrong.missing", name=_flat(read(due)))
        yield from self._lever()

    @property
    def _expected(self) -> ForceBill:
        return next(iter(self.bills.values()))

    def _number(self, value: float, digits: int = 4) -> str:
        return number(value, self.floor.language, digits)

    def _given(self) -> Iterator[str]:
        """Give what the notes must say of the scene."""
        language, machine = self.floor.language, self.statics.machine
        for link, body in machine.bodies.items():
            yield from [f"m_{{{link}}} = {self._number(body.mass)} {word(language, 'kg')}"] if body.mass else []
            inertia = f"J_{{S{link}}} = {self._number(body.inertia)} {word(language, 'kg*m2')}"
            yield from [inertia] if body.inertia else []
        drive, expected = self.statics.study.mechanism.drive, self._expected.expected
        if drive.turns and drive.ram is None:
            turned = expected.motion.links[drive.link]
            omega, epsilon = (float(rate[expected.k]) for rate in (turned.omega, turned.epsilon))
            rates = {"omega": self._number(omega), **({"epsilon": self._number(epsilon)} if epsilon else {})}
            yield word(language, "crank" if epsilon else "even crank", link=drive.link, **rates)
        lengths = self.statics.study.form.mechanism.lengths
        for name, length in lengths.items() if len(lengths) <= MOST_LENGTHS else ():
            yield f"l_{{{name}}} = {self._number(1000 * float(length))}"
        yield from self._loads()
        for one in sorted({one.coefficient for one in machine.friction.values()}):
            yield self._number(one)
        yield word(language, "known lines")
        yield word(language, "force hand note", slip=self._number(SLIP))

    def _loads(self) -> Iterator[str]:
        language, machine, letter = self.floor.language, self.statics.machine, self.floor.letter
        for force in machine.forces:
            yield letter(force.name)
            if force.diagram is None:
                yield f"{self._number(force.size)} {word(language, 'N')}"
        for moment in machine.moments:
            yield f"{self._number(moment.size)} {word(language, 'N*m')}"
        for spring in machine.springs:
            stiffness = f"{self._number(spring.stiffness)} {word(language, 'N/m')}"
            free = f"{self._number(spring.free)} {word(language, 'm')}"
            yield word(language, "spring given", name=letter(spring.name), stiffness=stiffness, free=free)
        how = machine.transmission
        if how.kind == GEAR:
            angles = {
                "at": self._number(float(np.degrees(how.at))),
                "pressure": self._number(float(np.degrees(how.pressure))),
            }
            yield word(
                language, "gear given", radius=f"{self._number(1000 * how.radius)} {word(language, 'mm')}", **angles
            )

    def _powers(self) -> Iterator[tuple[str, float]]:
        """Give the powers of what hangs on the lever, W, by letters."""
        loads = {one.name for one in self._expected.expected.loading.moments}
        for bill in self.bills.values():
            for force in (one for one in bill.known if not one.name.startswith("R_")):
                speed = bill.speed(force.link, force.at)
                yield read(self.floor.letter(force.name)), (speed.conjugate() * force.value).real
            for couple in bill.couples:
                hung = couple.name in loads or not couple.name[2:].replace(",", "").isdigit()
                if couple.name != BALANCING and hung:
                    omega = float(bill.expected.motion.links[couple.link].omega[bill.expected.k])
                    yield read(self.floor.letter(couple.name)), couple.moment * omega

    def _lever(self) -> Iterator[Wrong]:
        """Hold the powers on the lever one by one, and their sum."""
        if self.statics.study.mechanism.drive.ram is not None:
            return
        due, slack = dict(self._powers()), self._slack
        parts = {"powers": "@1", "total": "@2", "drive": "@3", "force": self.floor.letter(DRIVING)}
        pattern = re.escape(_flat(read(word(self.floor.language, "forces of lever", **parts))))
        found = re.search(re.sub(r"@\d", r"(.+?)", pattern) + r"(?= |$)", self.said)
        least = NOTHING * max(map(abs, due.values()), default=0.0) + slack
        if found is None:
            yield from (
                [message("wrong.missing", name=_flat(pattern)[:8])]
                if any(abs(one) > least for one in due.values())
                else []
            )
            return
        told = dict(one.rsplit(" ", 1) for one in found[1].split(", ") if " " in one)
        for name, power in due.items():
            due_here = name in told or abs(power) > least
            if due_here and not (name in told and reading.reads(told[name], power, slack, 4)):
                yield message("wrong.told", text=f"{name} {told.get(name, '')}")
        total = sum(due.values())
        for text, value in ((found[2], total), (found[3], -total)):
            if not reading.reads(text, value, slack, DIGITS):
                yield message("wrong.told", text=text)

    @property
    def _slack(self) -> float:
        """What the two roads may differ by in a power, W."""
        expected = self._expected.expected
        speeds = (abs(complex(one.v[expected.k])) for one in expected.motion.points.values())
        return self.floor.force * max(speeds, default=0.0)


def notes_of(leaves: Sequence[Leaf]) -> str:
    """Give the notes of some sheets in one line."""
    own = (one for leaf in leaves for one in leaf.groups if one.name == "notes")
    return _flat(" ".join(text.plain for one in own for text in texts((one,))))


def _flat(text: str) -> str:
    return re.sub(" +", " ", text.translate(_SIGNS))
