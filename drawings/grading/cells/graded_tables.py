"""The tables of one sheet graded: found by their corners and rows, judged cell by cell (оценка таблиц)."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from drawings.grading import verdict
from drawings.grading.allowance import Allowances
from drawings.grading.cells.asked_table import CellAsked, TableAsked
from drawings.grading.cells.seen_table import Key, SeenCell, SeenTable, ruling, tables_seen
from drawings.grading.curves.drawn_figure import DrawnFigure
from drawings.grading.curves.figure_records import ORDINATES
from drawings.grading.drawn_plan import DrawnPlan, drawn_places
from drawings.grading.verdict import Verdict
from drawings.grading.written_number import WrittenNumber, is_read, number
from drawings.lettering.words import letter
from drawings.paper.strokes import Text
from drawings.paper.walk import texts
from drawings.reading.alphabet import folded
from drawings.reading.sheet import SeenSheet
from geometry.board import Mark, Reading
from geometry.errors import DraftError
from geometry.replay import redraw
from plans.words.words import term


class BesideTables(NamedTuple):
    """The plans and graphs that a student has drawn beside his tables, and which sheets of the task these are of."""

    plans: Sequence[DrawnPlan]
    figures: Sequence[DrawnFigure]
    sheets: Set[str]

    def agrees(self, cell: CellAsked, written: WrittenNumber, by: Allowances, rough: float, language: str) -> bool:
        """Tell whether a number is what the student's own plans show; his tables are lettered in a language."""
        ordinates = self._ordinates(cell, cell.allowed(by, rough), language)
        for size, scale in (*self._sizes(cell, language), *ordinates):
            if abs(written.value - size) <= cell.pricked(by, rough, scale) + written.rounding:
                return True
        rate = None if cell.reading is None else self._rate(cell.reading, cell.position)
        return rate is not None and abs(written.value - rate) <= cell.allowed(by, rough) + written.rounding

    def _sizes(self, cell: CellAsked, language: str) -> Iterator[tuple[float, float]]:
        """Give the sizes of the vectors that a cell is read off, and the scales of their plans."""
        for plan in self._of(cell.position) if cell.read else ():
            for vector in plan.asked.vectors:
                value = plan.value(vector.letters)
                if value is not None and _read(vector.name, language) in cell.read:
                    yield abs(value), plan.scale

    def _ordinates(self, cell: CellAsked, near: float, language: str) -> Iterator[tuple[float, float]]:
        """Give the ordinates of graphs that show the quantity of a cell, and their scales."""
        for figure in self.figures:
            asked = figure.asked
            if asked.kind != ORDINATES or folded(_written(asked.unit, language)) != folded(cell.unit):
                continue
            for item in asked.items:
                true, value = ((values[item.place] / asked.way).real for values in (asked.true, figure.values))
                if item.position == cell.position and abs(true - cell.true) <= near and not np.isnan(value):
                    yield float(value), asked.scale

    def _rate(self, reading: Reading, position: int | None) -> float | None:
        """Give a rate as it is read off the student's own plans."""
        again = redraw(list(reading), drawn_places(self._of(position)))
        arm, turning = (_point(again[mark]) for mark in reading)
        return None if arm is None or turning is None or arm == 0 else (turning / arm).imag

    def _of(self, position: int | None) -> list[DrawnPlan]:
        return [plan for plan in self.plans if plan.asked.position == position]


def _read(name: str, language: str) -> str:
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


class NumberSlip(NamedTuple):
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
    by: Allowances
    rough: float  # mm, how finely the sheet is written
    shown: BesideTables
    doubled: Set[Key] = frozenset()

    def verdicts(self) -> Iterator[Verdict]:
        """Judge each cell; a unit that is mistaken throughout is told where it is first met."""
        met = set[tuple[str, str, str]]()
        for key in sorted(self.seen, key=lambda key: (-self.seen[key].box.high, self.seen[key].box.left)):
            if key not in self.asked.cells:
                continue
            said, cell = self._verdict(key), self.asked.cells[key]
            if said.kind in ONCE:
                again = said.kind, said.of, cell.unit
                said = said._replace(kind=verdict.FOLLOWS) if again in met else said
                met.add(again)
            yield said

    def _verdict(self, key: Key) -> Verdict:
        cell, drawn = self.asked.cells[key], self.seen[key]
        if not cell.told:
            return self._said(key, verdict.DEAD)
        if key in self.doubled:
            return self._said(key, verdict.DOUBLED)
        if not drawn.texts or not is_read(drawn.texts):
            return self._said(key, verdict.ILLEGIBLE if drawn.inked or drawn.texts else verdict.MISSING)
        written = number(drawn.texts, cell.unit)
        if written is None:
            return self._said(key, verdict.WRONG)
        if not written.understood:
            return self._said(key, verdict.ILLEGIBLE)
        off = _apart(written.value, cell.true, cell.unit)
        if off <= self._allowed(cell, written):
            return self._said(key, verdict.RIGHT, off)
        if self.shown.agrees(cell, written, self.by, self.rough, self.asked.language):
            return self._said(key, verdict.FOLLOWS, off)
        guess = self._mistake(key, written)
        return self._said(key, verdict.WRONG if guess is None else guess.kind, off, guess.of if guess else "")

    def _allowed(self, cell: CellAsked, written: WrittenNumber) -> float:
        return cell.allowed(self.by, self.rough) + written.rounding

    def _mistake(self, key: Key, written: WrittenNumber) -> NumberSlip | None:
        """Give the mistake that a number comes of: of the sign first, then the one that fits best."""
        cell = self.asked.cells[key]
        if abs(written.value + cell.true) <= self._allowed(cell, written):
            return NumberSlip(verdict.SIGN, -cell.true, 0.0)
        fitting = [
            guess for guess in self._guesses(key)
            if abs(guess.value) > guess.allowed and abs(written.value - guess.value) <= guess.allowed + written.rounding
        ]  # fmt: skip
        return min(fitting, key=lambda guess: abs(written.value - guess.value) / guess.allowed, default=None)

    def _guesses(self, key: Key) -> Iterator[NumberSlip]:
        """Give the mistakes that may be made in a cell."""
        cell = self.asked.cells[key]
        for kind, times, of in _factors(cell.unit):
            yield NumberSlip(kind, cell.true * times, cell.allowed(self.by, self.rough) * abs(times), of)
        for other, beside in self.asked.cells.items():
            if other != key and beside.unit == cell.unit:
                allowed = beside.allowed(self.by, self.rough)
                if beside.quantity == cell.quantity and beside.place != cell.place:
                    yield NumberSlip(verdict.PLACE, beside.true, allowed, beside.place)
                elif beside.place == cell.place and beside.quantity != cell.quantity:
                    yield NumberSlip(verdict.ROW, beside.true, allowed, beside.quantity)

    def _said(self, key: Key, kind: str, off: float | None = None, of: str = "") -> Verdict:
        cell, box = self.asked.cells[key], self.seen[key].box
        left, right, *above = box.corners
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


class TableDrawn(NamedTuple):
    """A table that is found on a sheet: its cells, in so many parts, and which of them differ in two."""

    asked: TableAsked
    cells: Mapping[Key, SeenCell]
    parts: int = 1
    doubled: Set[Key] = frozenset()


Drawn = Sequence[TableDrawn]


def tables_drawn(sheet: SeenSheet, asked: Sequence[TableAsked]) -> Drawn:
    """Find the tables that are asked for on a sheet; all parts of one are put together."""
    corners = {table.corner for table in asked}
    found: dict[int, dict[Key, SeenCell]] = {}
    doubled: dict[int, set[Key]] = {}
    parts = Counter[int]()
    for table in tables_seen(ruling(sheet.leaf), corners) if asked else ():
        fits = max(range(len(asked)), key=lambda k: _fit(table, asked[k], sheet))
        if _fit(table, asked[fits], sheet)[0] > 0:
            cells = found.setdefault(fits, {})
            parts[fits] += 1
            doubled.setdefault(fits, set()).update(_doubled(asked[fits], cells, table.cells))
            cells |= {key: cell for key, cell in table.cells.items() if key not in cells or not cells[key].texts}
    return [TableDrawn(asked[k], cells, parts[k], doubled[k]) for k, cells in sorted(found.items())]


def _doubled(asked: TableAsked, first: Mapping[Key, SeenCell], second: Mapping[Key, SeenCell]) -> Iterator[Key]:
    """Give the cells in which two copies of a table have numbers that differ."""
    for key in (key for key in asked.cells if key in first and key in second):
        ours, theirs = (" ".join(text.plain for text in cells[key].texts) for cells in (first, second))
        if ours and theirs and ours != theirs:
            yield key


def answered(found: Drawn, others: Collection[str]) -> bool:
    """Tell whether the tables of a sheet can be graded: written in, or such that nothing else stands on their sheets.

    `others` are the sheets that more is asked for on: where all of it is lost it is not marked down.
    """
    return any(_filled(asked, cells) or not set(asked.sheets) & set(others) for asked, cells, *_ in found)


def alone(found: Drawn, sheet: SeenSheet) -> set[str]:
    """Give the sheets of tables that are written in on the only sheet of its kind, of which all is due then."""
    written = (asked for asked, cells, *_ in found if _filled(asked, cells) and sheet.measured.metadata.get("of") == 1)
    return {name for asked in written for name in asked.sheets}


def _filled(asked: TableAsked, cells: Mapping[Key, SeenCell]) -> bool:
    return any(cells[key].texts for key in asked.cells if key in cells)


def _fit(table: SeenTable, asked: TableAsked, sheet: SeenSheet) -> tuple[int, bool, int]:
    """Give how many cells of a table are asked for, whether its sheet is titled so, how many cells are as they must."""
    keys = [key for key in table.cells if key in asked.cells]
    said = sum(_says(table.cells[key], asked.cells[key]) for key in keys)
    return len(keys), sheet.leaf.title in asked.titles, said


def _says(drawn: SeenCell, asked: CellAsked) -> bool:
    written = number(drawn.texts, asked.unit)
    return written is not None and abs(written.value - asked.true) <= asked.printed


def table_verdicts(
    found: Drawn, asked: Sequence[TableAsked], shown: BesideTables, by: Allowances, sheet: SeenSheet
) -> Iterator[Verdict]:
    """Judge the tables of a sheet; what is due of them and not there is missing, or told where that is not sure."""
    for table, cells, _, doubled in found:
        yield from CellJudge(table, cells, by, sheet.measured.quantum, shown, doubled).verdicts()
        yield from _missing(table, cells, shown.sheets, sheet)
    there = {found_.asked.sought for found_ in found}
    for table in asked:
        if table.sought not in there and set(table.sheets) & shown.sheets:
            lost = [] if _stands(table, found, sheet) else list(_missing(table, {}, shown.sheets, sheet))
            yield from lost or [Verdict(table.name, None, "", verdict.UNTABLED)]


def _missing(asked: TableAsked, cells: Mapping[Key, SeenCell], sheets: Set[str], sheet: SeenSheet) -> Iterator[Verdict]:
    """Name the cells that must stand on a sheet of ours, and do not."""
    expected = {asked.cells[key].sheet for key in cells if key in asked.cells} | sheets if _is_whole(sheet) else set()
    for key, cell in asked.cells.items():
        if key not in cells and cell.told and cell.sheet in expected:
            yield Verdict(asked.name, cell.position, cell.name, verdict.MISSING, unit=cell.unit)


def _stands(asked: TableAsked, found: Drawn, sheet: SeenSheet) -> bool:
    """Tell whether the word in the corner of a table is still there: its lines are not read, and it is not missing."""
    words = sum(folded(text.plain) == asked.corner for text in texts(sheet.leaf.groups))
    return words > sum(table.parts for table in found if table.asked.corner == asked.corner)


def _is_whole(sheet: SeenSheet) -> bool:
    """Tell whether all that its sheets of the task have stands on a sheet: it is ours, or the only one of a form."""
    data = sheet.measured.metadata
    return data.get("of") == 1 if "form" in data else bool(data or sheet.measured.marks)
