"""Judging a cell: its number held against the analysis, what follows told, and a mistake of writing named (клетка)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from drawings.grading import verdict
from drawings.grading.allowance import Allowances
from drawings.grading.cells.asked_table import CellAsked, TableAsked
from drawings.grading.cells.own_reading import Readings
from drawings.grading.cells.seen_table import Key, SeenCell
from drawings.grading.cells.written_number import Written, is_read, number
from drawings.grading.verdict import Verdict
from drawings.measure.transform import Affine

DEGREE, TURN = 180 / math.pi, 30 / math.pi
FULL = 360.0  # degrees
POWERS = (1, 2, 3, 4, 6)  # of ten, that a number may be out by
# Of which units a quantity may be told in degrees, and of which in turns a minute, in both languages.
ANGLES = ("rad", "рад", "°", "rad/s", "рад/с", "rad/s²", "рад/с²")
SPEEDS = ("rad/s", "рад/с")
ONCE = (verdict.DECADE, verdict.DEGREES, verdict.TURNS)  # mistakes that a whole table has for one reason


class Guess(NamedTuple):
    """A mistake that a number may come of: its kind, the number that it gives, how far that may be out, whose it is."""

    kind: str
    value: float
    allowed: float
    of: str = ""


@dataclass(frozen=True)
class CellJudge:
    """Judges the cells of one table: how it lies on paper, what is allowed, what the student's own plans show."""

    asked: TableAsked
    seen: Mapping[Key, SeenCell]
    moved: Affine
    by: Allowances
    rough: float  # mm, how finely the sheet is written
    readings: Readings

    def verdicts(self) -> Iterator[Verdict]:
        """Judge each cell; a unit that is mistaken throughout is told where it is first met."""
        told = set[tuple[str, str, str]]()
        for key in sorted(self.seen, key=lambda key: (-self.seen[key].box.high, self.seen[key].box.left)):
            if key not in self.asked.cells:
                continue
            said, cell = self._one(key), self.asked.cells[key]
            if said.kind in ONCE:
                again = said.kind, said.of, cell.unit
                said = said._replace(kind=verdict.FOLLOWS) if again in told else said
                told.add(again)
            yield said

    def _one(self, key: Key) -> Verdict:
        cell, seen = self.asked.cells[key], self.seen[key]
        if not cell.told:
            return self._said(key, verdict.DEAD)
        if not seen.texts or not is_read(seen.texts):
            return self._said(key, verdict.ILLEGIBLE if seen.inked or seen.texts else verdict.MISSING)
        written = number(seen.texts, cell.unit)
        if written is None:
            return self._said(key, verdict.WRONG)
        if not written.understood:
            return self._said(key, verdict.ILLEGIBLE)
        off = min(_apart(written.value, true, cell.unit) for true in cell.true)
        if off <= self._allowed(cell, written):
            return self._said(key, verdict.RIGHT, off)
        if self.readings.agrees(cell, written, self.by, self.rough):
            return self._said(key, verdict.FOLLOWS, off)
        guess = self._mistake(key, written)
        return self._said(key, verdict.WRONG if guess is None else guess.kind, off, guess.of if guess else "")

    def _allowed(self, cell: CellAsked, written: Written) -> float:
        return cell.allowed(self.by, self.rough) + written.rounding

    def _mistake(self, key: Key, written: Written) -> Guess | None:
        """Give the mistake that a number comes of: of the sign first, then the one that fits best."""
        cell = self.asked.cells[key]
        if abs(written.value + cell.true[0]) <= self._allowed(cell, written):
            return Guess(verdict.SIGN, -cell.true[0], 0.0)
        fitting = [
            one for one in self._guesses(key)
            if abs(one.value) > one.allowed and abs(written.value - one.value) <= one.allowed + written.rounding
        ]  # fmt: skip
        return min(fitting, key=lambda one: abs(written.value - one.value) / one.allowed, default=None)

    def _guesses(self, key: Key) -> Iterator[Guess]:
        """Give the mistakes that may be made in a cell."""
        cell = self.asked.cells[key]
        for kind, times, of in _factors(cell.unit):
            for true in cell.true[:1]:
                yield Guess(kind, true * times, cell.allowed(self.by, self.rough) * abs(times), of)
        for other, own in self.asked.cells.items():
            if other != key and own.unit == cell.unit:
                allowed = own.allowed(self.by, self.rough)
                if own.quantity == cell.quantity and own.place != cell.place:
                    yield Guess(verdict.PLACE, own.true[0], allowed, own.place)
                elif own.place == cell.place and own.quantity != cell.quantity:
                    yield Guess(verdict.ROW, own.true[0], allowed, own.quantity)

    def _said(self, key: Key, kind: str, off: float | None = None, of: str = "") -> Verdict:
        cell, box = self.asked.cells[key], self.seen[key].box
        left, right, *above = (self.moved(spot) for spot in box.corners)
        allowed = None if off is None else cell.allowed(self.by, self.rough)
        said = Verdict(self.asked.name, cell.position, cell.name, kind, off, allowed, cell.unit, of=of)
        return said._replace(at=(left, right), frames=((left, right, *above),))


def _apart(value: float, true: float, unit: str) -> float:
    """Give how far a value is from the true one; a whole turn is nothing."""
    return abs(math.remainder(value - true, FULL)) if unit == "°" else abs(value - true)


def _factors(unit: str) -> Iterator[tuple[str, float, str]]:
    """Give by what a number is out that is told in another unit, or twice."""
    for power in POWERS:
        yield verdict.DECADE, 10.0**power, f"10^{power}"
        yield verdict.DECADE, 10.0**-power, f"10^-{power}"
    if unit in ANGLES:
        yield verdict.DEGREES, DEGREE, ""
        yield verdict.DEGREES, 1 / DEGREE, ""
    if unit in SPEEDS:
        yield verdict.TURNS, TURN, ""
        yield verdict.TURNS, 1 / TURN, ""
    yield verdict.TWICE, 2.0, ""
    yield verdict.TWICE, 0.5, ""
