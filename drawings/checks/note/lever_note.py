"""The self-check of the lever in a note: each force with its arm and moment by powers alone (проверка рычага)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from drawings.checks.forces.scheme_forces import Floor
from drawings.checks.note.lines import cells
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong
from drawings.report.formula import DIGITS, Formula
from drawings.report.markdown import header
from plans.checks.force_bill import ForceBill
from plans.forces.primary import DRIVING
from plans.words.words import message, word

HEADS = ("force", "size", "lever_arm", "lever_moment")


class Due(NamedTuple):
    """A force N, or a couple without one, with its power W and what that may be off by."""

    size: float
    power: float
    off: float


@dataclass(frozen=True)
class LeverNote:
    """The lines on the lever of a position, its scale (m/s)/mm, and what the roads may differ by in a velocity."""

    lines: Sequence[str]
    bills: Sequence[ForceBill]
    floor: Floor
    formula: Formula
    scale: float
    speed: float

    def faults(self) -> Iterator[Wrong]:
        """Hold what is said, the table row by row, and the moment that balances all."""
        letter, language = self.formula.letter, self.floor.language
        sigma = letter("Σ")
        said = rf"$${sigma} M_{{p}}(F_{{i}}) + M_{{p}}({letter('P_bal')}) = 0$$"
        heads = header([word(language, f"table.{one}") for one in HEADS])
        lines = [line.replace("{,}", ".") for line in self.lines]
        if lines[:3] != [said, *heads] or len(lines) < 5:
            yield message("wrong.missing", name=said)
            return
        *rows, whole, last = lines[3:]
        yield from self._rows([_cells(one) for one in rows])
        total = sum(one.power for one in self._due.values())
        if _cells(whole)[:3] != [sigma, "", ""] or not self._reads(_cells(whole)[3], total / self.scale, self._off):
            yield message("wrong.told", text=whole)
        if not self._balances(last, total):
            yield message("wrong.told", text=last)

    def _rows(self, rows: Sequence[Sequence[str]]) -> Iterator[Wrong]:
        letters = {self.formula.letter(self.floor.letter(name)): one for name, one in self._due.items()}
        seen = [row[0] for row in rows]
        for row in rows:
            one = letters.get(row[0])
            if one is None or seen.count(row[0]) > 1 or len(row) != len(HEADS) or not self._holds(row, one):
                yield message("wrong.told", text=" | ".join(row))
        for name, one in letters.items():
            if name not in seen and abs(one.power) > one.off:
                yield message("wrong.missing", name=name)

    def _holds(self, row: Sequence[str], due: Due) -> bool:
        """Tell whether a row has a force's size, its arm and its moment; a couple has its moment alone."""
        size, arm, moment = row[1:]
        if not self._reads(moment, due.power / self.scale, due.off / self.scale):
            return False
        if not size:
            return not arm and due.size <= self.floor.force
        length = abs(due.power) / due.size if due.size else 0.0
        off = due.off / due.size if due.size else 0.0
        return self._reads(size, due.size, self.floor.force) and self._reads(arm, length / self.scale, off / self.scale)

    def _balances(self, line: str, total: float) -> bool:
        """Tell whether a line says what balances the powers at the crank's rate, with each number of the product."""
        letter, bill = self.formula.letter, self.bills[-1]
        drive, k = bill.expected.mechanism.drive, bill.expected.k
        omega = float(bill.expected.motion.links[drive.link].omega[k])
        start = f"- ${letter('M_bal')} = -{letter('μ_v')} {letter('Σ')} M_{{p}} / {letter(f'ω_{drive.link}')} = "
        numbers, equal, told = line.removeprefix(start).partition(" = ")
        product, over, rate = numbers.partition(" / ")
        scale, _, moment = product.partition(r" \cdot ")
        value = told.partition(r"\text")[0]
        unit = self.formula.quantity(0.0, "N*m").removeprefix(self.formula.number(0.0))
        off = self._off * self.scale / abs(omega) if omega else 0.0
        return (
            line.startswith(start)
            and bool(equal and over)
            and told == f"{value}{unit}$"
            and self._reads(scale, -self.scale, 0.0)
            and self._reads(moment, total / self.scale, self._off)
            and self._reads(rate, omega, 1e-9 * abs(omega))
            and self._reads(value, -total / omega if omega else 0.0, off)
        )

    def _reads(self, text: str, value: float, off: float) -> bool:
        return reads(text.strip("$()"), value, off, DIGITS)

    @property
    def _off(self) -> float:
        """What the sum of the moments on paper may be off by, N*mm."""
        return sum(one.off for one in self._due.values()) / self.scale

    @cached_property
    def _due(self) -> Mapping[str, Due]:
        """Give all forces and couples of the machine but reactions and what balances it, with their powers."""
        return dict(one for bill in self.bills for one in self._of(bill))

    def _of(self, bill: ForceBill) -> Iterator[tuple[str, Due]]:
        for force in (one for one in bill.known if not one.name.startswith("R_") and one.name != DRIVING):
            speed, size = bill.speed(force.link, force.at), abs(force.value)
            off = size * self.speed + self.floor.force * abs(speed)
            yield force.name, Due(size, (speed.conjugate() * force.value).real, off)
        twists = {one.name for one in bill.expected.loading.moments}
        for one in (one for one in bill.couples if one.name.startswith("M^") or one.name in twists):
            omega = float(bill.expected.motion.links[one.link].omega[bill.expected.k])
            off = self.floor.moment * abs(omega) + abs(one.moment) * self.speed
            yield one.name, Due(0.0, one.moment * omega, off)


def _cells(line: str) -> list[str]:
    return [cell.strip("$") for cell in cells(line)]
