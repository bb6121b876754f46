"""Judging the cells of a table: what each is, then the one fault of a row or a column that costs once (ячейки)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from drawings.grading import verdict
from drawings.grading.allowance import Allowances
from drawings.grading.cells.asked_table import CellAsked, Drawn, TableAsked, TableDrawn
from drawings.grading.cells.seen_table import Key, SeenCell
from drawings.grading.curves.figure_records import ORDINATES, FigureAsked
from drawings.grading.drawn_plan import DrawnPlan, drawn_places
from drawings.grading.judgement import spot_of
from drawings.grading.verdict import Verdict
from drawings.grading.written_number import WrittenNumber, is_read, number
from drawings.lettering.words import letter
from drawings.paper.strokes import Text
from drawings.paper.walk import texts
from drawings.reading.alphabet import folded
from drawings.reading.sheet import SeenSheet
from geometry.board import Reading
from geometry.replay import redraw
from plans.model.motion import Complexes
from plans.words.words import term

FULL = 360.0  # degrees


class BesideTables(NamedTuple):
    """The plans and graphs that a student has drawn beside his tables, the mistakes found in them, and their sheets."""

    plans: Sequence[DrawnPlan]
    figures: Sequence[tuple[FigureAsked, Complexes]]
    sheets: Set[str]
    mistakes: Set[str] = frozenset()

    def shown(self, cell: CellAsked, by: Allowances, rough: float, language: str) -> Iterator[tuple[float, float]]:
        """Give what the student's own plans and graphs show for a cell, and what may be out in reading it off."""
        every = (*self._sizes(cell, language), *self._ordinates(cell, cell.allowed(by, rough), language))
        yield from ((value, cell.pricked(by, rough, scale)) for value, scale in every)
        for rate in () if cell.reading is None else self._rates(cell.reading, cell.position):
            yield rate, cell.allowed(by, rough)

    def _sizes(self, cell: CellAsked, language: str) -> Iterator[tuple[float, float]]:
        """Give the sizes, or the angles, of the vectors that a cell tells of, and what a mm of their plans shows."""
        for plan in self._of(cell.position):
            unit, mm = folded(_written(plan.asked.unit, language)), plan.scale
            for vector in plan.asked.vectors:
                value = plan.value(vector.letters)
                if value is None or not value or not vector.true:
                    continue
                sized = unit == folded(cell.unit) and cell.is_(abs(vector.true))
                if sized or _read(vector.name, language) in cell.read:
                    yield abs(value), mm
                elif cell.unit == DEGREE and cell.is_(math.degrees(cmath.phase(vector.true))):
                    yield math.degrees(cmath.phase(value)), math.degrees(mm / abs(value))

    def _ordinates(self, cell: CellAsked, near: float, language: str) -> Iterator[tuple[float, float]]:
        """Give the ordinates of graphs that show the quantity of a cell, and their scales."""
        for asked, values in self.figures:
            if asked.kind != ORDINATES or folded(_written(asked.unit, language)) != folded(cell.unit):
                continue
            for name, place in asked.numbers.items():
                true, value = ((row[place] / asked.way).real for row in (asked.true, values))
                here = cell.position is None or name in (cell.place, str(cell.position))
                if here and abs(true - cell.true) <= near and not np.isnan(value):
                    yield float(value), asked.scale

    def _rates(self, reading: Reading, position: int | None) -> Iterator[float]:
        """Give a rate as it is read off the student's own plans: square to the arm, and by all of the vector."""
        again = redraw(list(reading), drawn_places(self._of(position)))
        arm, turning = (spot_of(again[mark]) for mark in reading)
        if arm and turning is not None:
            yield from ((turning / arm).imag, math.copysign(abs(turning / arm), (turning / arm).imag))

    def _of(self, position: int | None) -> list[DrawnPlan]:
        return [plan for plan in self.plans if plan.asked.position == position]


def _read(name: str, language: str) -> str:
    """Give the name of a vector as a table has it and as it is seen."""
    symbol, _, index = name.partition("_")
    return folded(Text(0j, letter(language, f"{symbol}_{{{index}}}")).plain)


def _written(unit: str, language: str) -> str:
    return Text(0j, term(language, "unit", unit)).plain


DEGREE, A_RADIAN, A_MINUTE = "°", 180 / math.pi, 30 / math.pi
POWERS = (1, 2, 3, 4, 6)  # of ten, that a number may be out by
ALIKE = 0.05  # of a value: what is known no better is told by no factor
SEVERAL, COURSE = 2, 3  # cells that must all be out alike for two or half, another quantity; for a zero, a row beside
# Of which units a quantity may be told in degrees, and of which in turns a minute, in both languages.
ANGLES = ("rad", "рад", "°", "rad/s", "рад/с", "rad/s²", "рад/с²")
SPEEDS = ("rad/s", "рад/с")
FREE = "ΔJ"  # whose zero is anybody's choice: what is constant of an inertia may be counted in
ONCE = (verdict.DECADE, verdict.DEGREES, verdict.TURNS)  # mistakes that a whole table has for one reason
Fault = tuple[str, str, int, Callable[[Key], float | None]]  # its kind, of what, in how many cells, the number by it


@dataclass(frozen=True)
class CellJudge:
    """Judges the cells of one table: what is allowed, what the student's own plans show beside it."""

    drawn: TableDrawn
    by: Allowances
    rough: float  # mm, how finely the sheet is written
    shown: BesideTables

    @property
    def asked(self) -> TableAsked:
        """What is asked for."""
        return self.drawn.asked

    def verdicts(self) -> Iterator[Verdict]:
        """Judge each cell; a fault of a whole column, or a unit mistaken throughout, is told where it is first met."""
        said, met = {key: self._verdict(key) for key in self._keys}, set[tuple[str, str, str]]()
        kinds = self._following(said) | self._named(said)
        for key, one in said.items():
            kind, of = kinds.get(key, (one.kind, one.of))
            if kind in ONCE:
                again = kind, of, self.asked.cells[key].unit
                kind, of = (verdict.FOLLOWS, "") if again in met else (kind, of)
                met.add(again)
            yield one._replace(kind=kind, of=of)

    @property
    def _keys(self) -> list[Key]:
        asked = [key for key in self.drawn.cells if key in self.asked.cells]
        # One cell may be of plan and analysis together.
        once = {id(self.drawn.cells[key]): key for key in reversed(asked)}
        return sorted(once.values(), key=lambda key: (-self.drawn.cells[key].box.high, self.drawn.cells[key].box.left))

    @cached_property
    def _numbers(self) -> dict[Key, WrittenNumber]:
        """The numbers that are written and understood."""
        read = (key for key in self._keys if self.drawn.cells[key].texts and is_read(self.drawn.cells[key].texts))
        found = ((key, number(self.drawn.cells[key].texts, self.asked.cells[key].unit)) for key in read)
        return {key: one for key, one in found if one is not None}

    def _verdict(self, key: Key) -> Verdict:
        cell, drawn = self.asked.cells[key], self.drawn.cells[key]
        if not cell.told:
            return self._said(key, verdict.DEAD)
        if key in self.drawn.doubled:
            return self._said(key, verdict.DOUBLED)
        if not drawn.texts or not is_read(drawn.texts):
            return self._said(key, verdict.ILLEGIBLE if drawn.inked or drawn.texts else verdict.MISSING)
        written = self._numbers.get(key)
        if written is None:
            return self._said(key, verdict.WRONG)
        if not written.understood:
            return self._said(key, verdict.ILLEGIBLE)
        off = _apart(written.value, cell.true, cell.unit)
        if off <= self._allowed(key):
            return self._said(key, verdict.RIGHT, off)
        for value, allowed in self.shown.shown(cell, self.by, self.rough, self.asked.language):
            if _apart(written.value, value, cell.unit) <= allowed + written.rounding:
                return self._said(key, verdict.FOLLOWS if off > allowed else verdict.RIGHT, off)
        told = cell.quantity, cell.unit
        same = (other for other in self.asked.cells.values() if (other.quantity, other.unit) == told)
        idle = (one.idle for one in same if abs(one.true - cell.true) <= ALIKE * abs(cell.true))  # of both roads
        known = (value for value in idle if value is not None and verdict.IDLE in self.shown.mistakes)
        if any(_apart(written.value, value, cell.unit) <= self._allowed(key) for value in known):
            return self._said(key, verdict.FOLLOWS, off)
        return self._said(key, verdict.WRONG, off)

    def _allowed(self, key: Key, times: float = 1.0) -> float:
        return self.asked.cells[key].allowed(self.by, self.rough) * abs(times) + self._numbers[key].rounding

    def _following(self, said: Mapping[Key, Verdict]) -> dict[Key, tuple[str, str]]:
        """Give the cells that are out by the factor of another one of their row that is wrong before, or follows."""
        found = dict[Key, tuple[str, str]]()
        kinds = (verdict.WRONG, verdict.FOLLOWS)
        out = [key for key, one in said.items() if one.kind in kinds and key in self._numbers]
        for key in (key for key in out if said[key].kind == verdict.WRONG):
            before = out[: out.index(key)]
            beside = [other for other in out if said[other].kind == verdict.FOLLOWS or other in before]
            if any(self._alike(key, other) for other in beside if other != key):
                found[key] = verdict.FOLLOWS, ""
        return found

    def _alike(self, key: Key, other: Key) -> bool:
        """Tell whether two cells of one row, or column of results, of different quantities are out by one factor."""
        one, two = self.asked.cells[key], self.asked.cells[other]
        if one.quantity == two.quantity or (one.place, one.position) != (two.place, two.position) or not two.true:
            return False
        factor, slack = self._numbers[other].value / two.true, self._allowed(other) / abs(two.true)
        far = slack * abs(one.true) + self._allowed(key)
        return abs(self._numbers[key].value - factor * one.true) <= far <= ALIKE * abs(one.true)

    def _named(self, said: Mapping[Key, Verdict]) -> dict[Key, tuple[str, str]]:
        """Give wrong cells the one fault that all those of their quantity have; it costs once."""
        columns, found = dict[tuple[str, str], list[Key]](), dict[Key, tuple[str, str]]()
        for key, one in said.items():
            if one.kind == verdict.WRONG and key in self._numbers:
                cell = self.asked.cells[key]
                columns.setdefault((cell.quantity, cell.unit), []).append(key)
        for wrong in columns.values():
            for kind, of, least, value in self._faults(wrong):
                if len(wrong) >= least and all(self._fits(key, value(key)) for key in wrong):
                    found |= {wrong[0]: (kind, of)} | dict.fromkeys(wrong[1:], (verdict.FOLLOWS, ""))
                    break
        return found

    def _fits(self, key: Key, value: float | None) -> bool:
        return value is not None and abs(self._numbers[key].value - value) <= self._allowed(key)

    def _faults(self, wrong: Sequence[Key]) -> Iterator[Fault]:
        """Give the faults that cells of one quantity may have, the surest first."""
        cells = self.asked.cells
        yield verdict.SIGN, "", 1, lambda key: -cells[key].true
        ordered = sorted(_factors(cells[wrong[0]].unit), key=lambda row: self._misfit(wrong, row[1]))
        for kind, _, of in ordered[: 1 if self._misfit(wrong, ordered[0][1]) <= 1 else 0]:
            yield kind, of, SEVERAL if kind == verdict.TWICE else 1, lambda key: self._numbers[key].value
        for step in (-1, 1):
            yield verdict.PLACE, "", COURSE, lambda key, step=step: self._beside(key, step)  # type: ignore[misc]
        away = float(np.median([self._numbers[key].value - cells[key].true for key in wrong]))
        free = len(wrong) == sum(cells[key].quantity == cells[wrong[0]].quantity == FREE for key in self._keys)
        yield verdict.ZERO if free else verdict.LEVEL, "", COURSE, lambda key: cells[key].true + away
        for quantity in dict.fromkeys(cell.quantity for cell in cells.values()):
            if quantity != cells[wrong[0]].quantity:
                yield verdict.ROW, quantity, SEVERAL, lambda key, quantity=quantity: self._other(key, quantity)  # type: ignore[misc]

    def _misfit(self, wrong: Sequence[Key], times: float) -> float:
        """Give how far numbers are at the most from being out by a factor, as a share of what they may be."""
        dues = ((key, self.asked.cells[key].true * times) for key in wrong)
        return max(
            abs(self._numbers[key].value - due) / min(self._allowed(key, times), ALIKE * abs(due)) if due else math.inf
            for key, due in dues
        )

    def _beside(self, key: Key, step: int) -> float | None:
        """Give the true value of a quantity so many places further; the last of a turn goes before the first."""
        cells = self.asked.cells
        row = [other for other in self._keys if cells[other].quantity == cells[key].quantity and other[2] == key[2]]
        row.sort(key=lambda other: cells[other].position or 0)
        return cells[row[(row.index(key) + step) % len(row)]].true

    def _other(self, key: Key, quantity: str) -> float | None:
        """Give the true value of another quantity in the same place."""
        one = self.asked.cells[key]
        same = (
            cell for cell in self.asked.cells.values()
            if (cell.quantity, cell.place, cell.position, cell.unit) == (quantity, one.place, one.position, one.unit)
        )  # fmt: skip
        return next((cell.true for cell in same), None)

    def _said(self, key: Key, kind: str, off: float | None = None) -> Verdict:
        cell, (left, right, *above) = self.asked.cells[key], self.drawn.cells[key].box.corners
        allowed = None if off is None else cell.allowed(self.by, self.rough)
        said = Verdict(self.asked.name, cell.position, cell.name, kind, off, allowed, cell.unit)
        return said._replace(at=(left, right), frames=((left, right, *above),))


def _apart(value: float, true: float, unit: str) -> float:
    return abs(math.remainder(value - true, FULL)) if unit == DEGREE else abs(value - true)


def _factors(unit: str) -> Iterator[tuple[str, float, str]]:
    """Give by what a number is out that is told in another unit, or twice."""
    yield from ((verdict.DECADE, 10.0**power, f"10^{power}") for size in POWERS for power in (size, -size))
    for kind, times, units in (
        (verdict.DEGREES, A_RADIAN, ANGLES), (verdict.TURNS, A_MINUTE, SPEEDS), (verdict.TWICE, 2.0, (unit,))
    ):  # fmt: skip
        yield from ((kind, factor, "") for factor in (times, 1 / times) if unit in units)


def table_verdicts(
    found: Drawn, asked: Sequence[TableAsked], shown: BesideTables, by: Allowances, sheet: SeenSheet
) -> Iterator[Verdict]:
    """Judge the tables of a sheet; what is due of them and not there is missing, or told where that is not sure."""
    for drawn in found:
        yield from CellJudge(drawn, by, sheet.measured.quantum, shown).verdicts()
        yield from _missing(drawn.asked, drawn.cells, shown.sheets, sheet)
    there = {drawn.asked.sought for drawn in found}
    for table in asked:
        if table.sought not in there and set(table.sheets) & shown.sheets:
            # The word in its corner is still there, or all words are outlines: it is not read, and not missing.
            words = [folded(text.plain) == table.corner for text in texts(sheet.leaf.groups)]
            read = sum(drawn.parts for drawn in found if drawn.asked.corner == table.corner)
            stands, data = sum(words) > read or not words, sheet.measured.metadata
            lost = [] if stands else list(_missing(table, {}, shown.sheets, sheet))
            if lost or stands or "form" not in data or data.get("of") == 1:  # else it is on another page of the form
                yield from lost or [Verdict(table.name, None, "", verdict.UNTABLED)]


def _missing(asked: TableAsked, cells: Mapping[Key, SeenCell], sheets: Set[str], sheet: SeenSheet) -> Iterator[Verdict]:
    """Name the cells that must stand on a sheet, and do not: where it is ours, or the only one of a form."""
    data = sheet.measured.metadata
    whole = data.get("of") == 1 if "form" in data else data or sheet.measured.marks
    expected = {asked.cells[key].sheet for key in cells if key in asked.cells} | sheets if whole else set()
    for key, cell in asked.cells.items():
        if key not in cells and cell.told and cell.sheet in expected:
            yield Verdict(asked.name, cell.position, cell.name, verdict.MISSING, unit=cell.unit)
