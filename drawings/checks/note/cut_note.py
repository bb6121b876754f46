"""The self-check of a cut in a note: its equations, and the numbers put into them, by analysis (проверка записки)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from functools import cached_property
from itertools import permutations

from drawings.checks.forces.cut_equations import CutEquationsCheck, Turning
from drawings.checks.forces.scheme_forces import Floor
from drawings.checks.forces.written_equations import WrittenMoments, WrittenTerm
from drawings.checks.note.written_note import Told, WrittenNote, signed
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong
from drawings.report.formula import DIGITS, Formula
from plans.checks.force_bill import ForceBill
from plans.forces.primary import BALANCING
from plans.words.words import message

_SOLVED = re.compile(r"(?:\((?P<sum>[^()]+)\) / (?P<arm>[\d.]+)|(?P<whole>[^()]+))")


class CutNote(CutEquationsCheck):
    """The lines of a note on one cut, the bill of its forces, and the scale of its drawn force plan, if it is drawn."""

    written: WrittenNote  # type: ignore[assignment]

    def __init__(
        self, label: str, lines: list[str], bill: ForceBill, floor: Floor, formula: Formula, scale: float | None
    ) -> None:
        self.formula, self.scale = formula, scale
        written = WrittenNote(lines, {})
        super().__init__(label, written, bill, floor)  # type: ignore[arg-type]
        written.letters.update((letter, self._letter(name)) for letter, name in self._names.items())

    def faults(self) -> Iterator[Wrong]:
        """Hold what the equations beside a scheme are held to; from what each number comes; no line is strange."""
        yield from super().faults()
        yield from (message("wrong.told", text=line) for line in self.written.strange)
        seen = list[str]()
        for one in self.written.told:
            if not self._holds(one, seen.count(one.letter)):
                yield message("wrong.told", text=one.text)
            seen.append(one.letter)

    def _holds(self, one: Told, before: int) -> bool:
        """Tell whether a line holds that is told so many times before: what moments give the polygon may give anew."""
        name, between = self._names.get(one.letter, ""), one.equals[:-1]
        solved = next((own for own in self.written.moments if own.terms[0].force == self._letter(name)), None)
        if solved is None:
            return before == 0 and self._derived(name, between)
        if before:
            return before == 1 and name.startswith("R_") and self._measured(name, between)
        return len(between) == 1 and self._put_in(solved, between[0])

    def _derived(self, name: str, between: tuple[str, ...]) -> bool:
        """Tell whether what stands between a letter and its number is that from which it comes."""
        if name in self._sources:
            letters, *numbers = self._sources[name]
            told = between[1:] and [_bare(text) for text in between[1].split(r" \cdot ")]
            none = self.floor.moment if name.startswith("M") else self.floor.force
            return len(between) == 2 and between[0] == letters and self._all(told, numbers, none)
        if name.startswith("R^u"):
            sigma = self.formula.letter("Σ")
            return between == (rf"-{sigma} {self.formula.letter('F_u')}",)
        return self._measured(name, between)

    def _measured(self, name: str, between: tuple[str, ...]) -> bool:
        """Tell whether a reaction is measured on the force plan by its scale, where one is drawn."""
        size = abs(self._forces_by_name[name].value) if name in self._forces_by_name else 0.0
        if self.scale is None or not name.startswith("R_"):
            return not between
        if not between:
            return size <= 2 * self.floor.force
        slack = self.floor.force / self.scale
        length, _, scale = between[0].partition(r" \cdot ")
        return reads(length, size / self.scale, slack, DIGITS) and reads(scale, self.scale, 0.0, DIGITS)

    def _all(self, told: object, due: list[float], none: float) -> bool:
        """Tell whether both numbers of a product are told; the motion's may be out by what gives a product of none."""
        texts, (part, rate) = told if isinstance(told, list) else [], due
        slacks = (self._off * abs(part) or self._off, max(self._off * abs(rate), none / abs(part) if part else 0.0))
        found = zip(texts, due, slacks, strict=False)
        return len(texts) == len(due) and all(reads(text, value, slack, DIGITS) for text, value, slack in found)

    @property
    def _off(self) -> float:
        """The share of a force that the two roads may differ by."""
        largest = max((abs(one.value) for one in self._forces_by_name.values()), default=0.0)
        return self.floor.force / largest if largest else 0.0

    @cached_property
    def _moments_by_name(self) -> dict[str, float]:
        """Every moment that may be told: where a cylinder drives, also that which the crank is left with, none."""
        return {**super()._moments_by_name, **self._left}

    @property
    def _left(self) -> dict[str, float]:
        drive, k = self.bill.expected.mechanism.drive, self.bill.expected.k
        driven = self.bill.group is None and drive.ram is not None
        return {BALANCING: float(self.bill.expected.found.balancing.moment[k])} if driven else {}

    def _turnings(self, about: complex, links: tuple[int, ...], written: set[str]) -> dict[str, Turning]:
        """Give the moments of all that acts, with that which is left."""
        left = {self._letter(name): Turning(moment) for name, moment in self._left.items()}
        return super()._turnings(about, links, written) | left

    @cached_property
    def _names(self) -> dict[str, str]:
        names = (*self._forces_by_name, *self._moments_by_name)
        return {self.formula.letter(self.floor.letter(name)): name for name in names}

    @cached_property
    def _sources(self) -> Mapping[str, tuple[str, float, float]]:
        """Give from what weights, inertia forces and couples come: in letters, and both numbers of the product."""
        expected, letter = self.bill.expected, self.formula.letter
        found: dict[str, tuple[str, float, float]] = {}
        for link in self.bill.links:
            body = expected.machine.bodies.get(link)
            if body is None:
                continue
            mass, epsilon = letter(f"m_{link}"), float(expected.motion.links[link].epsilon[expected.k])
            centre = letter(f"a_{{S_{{{link}}}}}")
            found[f"G_{link}"] = f"{mass} g", body.mass, abs(expected.machine.gravity)
            found[f"Φ_{link}"] = f"{mass} {centre}", body.mass, abs(expected.acceleration(body))
            turned = rf"-{letter(f'J_{link}')} {letter(f'ε_{link}')}"
            found[f"M^Φ_{link}"] = turned, -body.inertia, epsilon
        return found

    def _true(self, term: WrittenTerm, due: Turning, arms: Mapping[str, str]) -> bool:
        """Tell whether a term has the sign of its moment, and an arm if it is a force; numbers tell how long it is."""
        small = abs(due.moment) <= self.floor.moment + self.floor.force * due.far
        if bool(term.arm) != (due.size > 0) and not small:
            return False
        if not term.arm:  # a couple stands by its letter, whose number has the sign
            return small or term.sign > 0
        return (small or term.sign == math.copysign(1, due.moment)) and self._spans(term, due)

    def _spans(self, term: WrittenTerm, due: Turning) -> bool:
        """Tell whether an arm that is lettered by two points is as long as they are apart."""
        if not term.arm.startswith("l_") or due.size <= self.floor.force:
            return True
        length, slack = abs(due.moment) / due.size, due.far * self.floor.force / due.size
        near = slack + self.floor.moment / due.size
        runs = (self.bill.place(one) - self.bill.place(other) for one, other in self._lines.get(term.arm, ()))
        return any(abs(abs(run) - length) <= near + 1e-9 * length for run in runs)

    @cached_property
    def _lines(self) -> dict[str, list[tuple[str, str]]]:
        """The pairs of points by the letter of the line between them."""
        found: dict[str, list[tuple[str, str]]] = {}
        for own in permutations(self.bill.expected.motion.points, 2):
            found.setdefault(self.formula.letter(f"l_{{{''.join(own)}}}"), []).append(own)
        return found

    def _put_in(self, one: WrittenMoments, text: str) -> bool:
        """Tell whether the numbers of a solved equation are those of its terms, one for one."""
        found = _SOLVED.fullmatch(text)
        about = next((name for name in self.bill.expected.motion.points if name.replace("_", "") == one.about), None)
        if found is None or about is None:
            return False
        several: tuple[tuple[int, ...], ...] = () if one.link is not None else (self.bill.links,)
        links = (*several, *((link,) for link in self.bill.links if one.link in (None, link)))
        first, *others = one.terms
        numbers = list(signed(found["sum"] or found["whole"]))
        spot, written = self.bill.place(about), {term.force for term in one.terms}
        return len(numbers) == len(others) and any(
            self._solves(
                first, found["arm"], list(zip(others, numbers, strict=True)), self._turnings(spot, own, written)
            )
            for own in links
        )

    def _solves(
        self,
        first: WrittenTerm,
        arm: str | None,
        pairs: list[tuple[WrittenTerm, tuple[int, str]]],
        due: dict[str, Turning],
    ) -> bool:
        own = due.get(first.force)
        if own is None or bool(arm) != bool(first.arm) or (arm and not self._long(arm, own)):
            return False
        sense = -first.sign if first.arm else -1
        return all(term.force in due and self._numbered(term, told, due[term.force], sense) for term, told in pairs)

    def _numbered(self, term: WrittenTerm, told: tuple[int, str], due: Turning, sense: int) -> bool:
        """Tell whether a number, or the product of a force and its arm, is a term's on the other side of the sign."""
        sign, text = told
        size, _, arm = text.partition(r" \cdot ")
        if not term.arm:
            value = sense * due.moment
            return not arm and reads(f"{'-' if sign < 0 else ''}{size}", value, self.floor.moment, DIGITS)
        small = abs(due.moment) <= self.floor.moment + self.floor.force * due.far
        right = small or sign == sense * math.copysign(1, due.moment)
        return right and reads(size, due.size, self.floor.force, DIGITS) and self._long(arm, due)

    def _long(self, arm: str, due: Turning) -> bool:
        if due.size <= self.floor.force:
            return True
        length = abs(due.moment) / due.size
        slack = (2 * due.far * self.floor.force + self.floor.moment) / due.size
        return reads(arm, length, slack, DIGITS)


def _bare(text: str) -> str:
    return text.strip("()")
