"""The self-check of the notes of force sheets: what is given, the powers on the lever (пояснения)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from drawings.checks.forces.scheme_forces import Floor
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.wrong import Wrong
from drawings.lettering.words import number, span, word
from drawings.paper.strokes import Leaf
from drawings.paper.walk import texts
from plans.checks.force_bill import ForceBill
from plans.checks.hand.quantity import SLIP
from plans.checks.ram_law import stroke_of
from plans.forces.statics import Statics
from plans.model.machine import ALWAYS, GEAR, Force
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
        """Hold what is given, and what is said of the lever."""
        for due in (*self._given(), *self._lever()):
            if _flat(read(due)) not in self.said:
                yield message("wrong.missing", name=_flat(read(due)))

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
        yield from self._drive()
        lengths = self.statics.study.form.mechanism.lengths
        for name, length in lengths.items() if len(lengths) <= MOST_LENGTHS else ():
            yield f"l_{{{name}}} = {self._number(1000 * float(length))}"
        yield from self._loads()
        for one in sorted({one.coefficient for one in machine.friction.values()}):
            yield self._number(one)
        yield word(language, "known lines")
        yield word(language, "force hand note", slip=self._number(SLIP))

    def _drive(self) -> Iterator[str]:
        """Tell the crank's rates in the position, and of a cylinder its law."""
        language, drive, expected = self.floor.language, self.statics.study.mechanism.drive, self._expected.expected
        turned = expected.motion.links[drive.link]
        omega, epsilon = (float(rate[expected.k]) for rate in (turned.omega, turned.epsilon))
        rates = {"omega": self._number(omega), "epsilon": self._number(epsilon)}
        if drive.ram is not None:
            lengths, v, a = stroke_of(self.statics.study.mechanism, len(expected.motion.phi))
            line = f"{drive.ram.foot}{drive.ram.point}"
            stroke = " … ".join(self._number(1000 * float(end)) for end in lengths[[0, -1]])
            law = {"v": span(v, language), "a": span(a, language)}
            yield word(language, "cylinder", link=drive.link, line=line, stroke=stroke, **law, **rates)
        elif drive.turns:
            rates = rates if epsilon else {"omega": rates["omega"]}
            yield word(language, "crank" if epsilon else "even crank", link=drive.link, **rates)

    def _loads(self) -> Iterator[str]:
        language, machine, letter = self.floor.language, self.statics.machine, self.floor.letter
        for force in machine.forces:
            yield letter(force.name)
            yield self._load(force)
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

    def _load(self, force: Force) -> str:
        """Tell a force: its size and what it acts against, where it resists, on which stroke, with what overrun."""
        language, letter = self.floor.language, self.floor.letter(force.name)
        size = f"{self._number(force.size)} {word(language, 'N')}"
        if force.diagram is not None:
            said = word(language, "load diagram", name=letter)
        elif force.direction is None and force.line is None:
            said = word(language, "load against", name=letter, size=size, point=force.point)
        else:
            said = word(language, "load always", name=letter, size=size)
        told = [said, *self._line(force), *([word(language, "load resisting")] if force.resists else [])]
        told += [] if force.during == ALWAYS else [word(language, force.during)]
        if any(force.overrun):
            shares = dict.fromkeys(self._number(share) for share in force.overrun)
            told.append(word(language, "overrun", share="; ".join(shares)))
        return ", ".join(told)

    def _line(self, force: Force) -> Iterator[str]:
        """Tell between which points a force acts, and along which line, if that is not said by the points."""
        language, ends = self.floor.language, {force.point}
        if force.other is not None:
            ends.add(force.other.point)
            yield word(language, "load between", start=force.point, end=force.other.point)
        if force.line is not None and {*force.line} != ends:
            yield word(language, "load along", line="".join(force.line))

    @property
    def hung(self) -> bool:
        """Whether anything has a moment on the lever, which at rest has no arms."""
        return any(abs(one) > self._slack for one in self._powers())

    def _lever(self) -> Iterator[str]:
        """Give what the notes must say of a lever on which anything has a moment, which the analysis says."""
        if not self.hung:
            return
        yield word(self.floor.language, "lever arms")
        if self.statics.study.mechanism.drive.ram is not None:
            yield word(self.floor.language, "balanced lever")

    def _powers(self) -> Iterator[float]:
        """Give the powers of the known forces and of the couples, W."""
        for bill in self.bills.values():
            for force in (one for one in bill.known if not one.name.startswith("R_")):
                yield (bill.speed(force.link, force.at).conjugate() * force.value).real
            for couple in bill.couples:
                yield couple.moment * float(bill.expected.motion.links[couple.link].omega[bill.expected.k])

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
