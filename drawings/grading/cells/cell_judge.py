"""Judging a cell: its number held against the analysis, what follows told, and a mistake of writing named (клетка)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from drawings.eye.alike import folded
from drawings.grading import verdict
from drawings.grading.allowance import Allowances
from drawings.grading.cells.asked_table import CellAsked, Key, SeenCell, TableAsked
from drawings.grading.cells.written_number import Written, is_read, number
from drawings.grading.curves.asked_figure import ORDINATES
from drawings.grading.curves.drawn_figure import DrawnFigure
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.own_places import own_places
from drawings.grading.verdict import Verdict
from drawings.lettering.words import letter
from drawings.measure.transform import Affine
from drawings.paper.strokes import Text
from geometry.board import Mark
from geometry.errors import DraftError
from geometry.replay import redraw
from geometry.span import Reading
from plans.words.words import term


@dataclass(frozen=True)
class Readings:
    """The plans and graphs that a student has drawn, and the language that the letters of his tables are in."""

    drawn: Sequence[DrawnPlan]
    figures: Sequence[DrawnFigure]
    language: str

    def agrees(self, cell: CellAsked, written: Written, by: Allowances, rough: float) -> bool:
        """Tell whether a number is what the student's own plans show."""
        ordinates = self._ordinates(cell, cell.allowed(by, rough))
        for size, scale in (*self._sizes(cell), *ordinates):
            if abs(written.value - size) <= cell.pricked(by, rough, scale) + written.rounding:
                return True
        rate = None if cell.reading is None else self._rate(cell.reading, cell.position)
        return rate is not None and abs(written.value - rate) <= cell.allowed(by, rough) + written.rounding

    def _sizes(self, cell: CellAsked) -> Iterator[tuple[float, float]]:
        """Give the sizes of the vectors that a cell is read off, and the scales of their plans."""
        for plan in self._of(cell.position) if cell.read else ():
            for one in plan.asked.vectors:
                value = plan.value(one.letters)
                if value is not None and _seen(one.name, self.language) in cell.read:
                    yield abs(value), plan.scale

    def _ordinates(self, cell: CellAsked, near: float) -> Iterator[tuple[float, float]]:
        """Give the ordinates of graphs that show the quantity of a cell, and their scales."""
        for figure in self.figures:
            asked = figure.asked
            if asked.kind != ORDINATES or folded(_written(asked.unit, self.language)) != folded(cell.unit):
                continue
            for one in asked.items:
                true, value = ((values[one.place] / asked.way).real for values in (asked.true, figure.values))
                if one.position == cell.position and abs(true - cell.true[0]) <= near and not np.isnan(value):
                    yield float(value), asked.scale

    def _rate(self, reading: Reading, position: int | None) -> float | None:
        """Give a rate as it is read off the student's own plans."""
        again = redraw(list(reading), own_places(self._of(position)))
        arm, turning = (_point(again[mark]) for mark in reading)
        return None if arm is None or turning is None or arm == 0 else (turning / arm).imag

    def _of(self, position: int | None) -> list[DrawnPlan]:
        return [plan for plan in self.drawn if plan.asked.position == position]


def _seen(name: str, language: str) -> str:
    """Give the name of a vector as a table has it and as it is seen."""
    symbol, _, index = name.partition("_")
    return folded(Text(0j, letter(language, f"{symbol}_{{{index}}}")).plain)


def _written(unit: str, language: str) -> str:
    return Text(0j, term(language, "unit", unit)).plain


def _point(mark: Mark) -> complex | None:
    try:
        value = complex(np.asarray(mark.point).reshape(-1)[0])
    except (DraftError, TypeError):
        return None
    return value if np.isfinite(value) else None


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
