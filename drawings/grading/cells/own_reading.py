"""What a student reads off his own plans: a number that agrees with them follows, however wrong they are (отсчёт)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from drawings.eye.alike import folded
from drawings.grading.allowance import Allowances
from drawings.grading.cells.asked_table import CellAsked
from drawings.grading.cells.written_number import Written
from drawings.grading.curves.asked_figure import ORDINATES
from drawings.grading.curves.drawn_figure import DrawnFigure
from drawings.grading.drawn_plan import DrawnPlan
from drawings.grading.own_places import own_places
from drawings.lettering.words import letter
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
