"""The table of the output's S, v, a by the plans for all positions, or every so many of them (таблица S, v, a)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.figures.diagrams.frame import SLIDING, TURNING
from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.thinning import every
from drawings.lettering.words import fixed
from drawings.page.drafting import Drafting
from plans.diagrams.study import DiagramsStudy
from plans.model.diagrams import Course, Diagrams

NAME = "output"
MOST = 36  # positions that are told: of more every so many
ABSENT = "—"
NOUGHT = 1e-9  # of the largest: a rounding
DIGITS = 4  # of the largest of a column, whose numbers all have its decimals
PLACES = range(-3, 8)  # decimals of a column; of none below 0; of other sizes each number has its own digits


def output_table(own: DiagramsStudy, drafting: Drafting) -> RuledTable:
    """Rule the table of the output's course."""
    found = own.drawn
    letters = SLIDING if own.course.travel.sliding else TURNING
    units = [drafting.word(unit) for unit in own.units]
    heads = ("φ, °", *(f"{letter}, {unit}" for letter, unit in zip(letters, units, strict=True)))
    told = table(list(_rows(own, found, drafting)), drafting.word("position head"), heads, drafting.hand.text)
    return told._replace(name=NAME)


def told_positions(found: Diagrams) -> tuple[int, ...]:
    """Choose the places of the axis that the table tells, rising by their positions' numbers."""
    count = len(found.axis.numbers) - found.axis.closed
    step = every(count / MOST, count)
    return tuple(sorted(range(0, count, step), key=lambda k: found.axis.numbers[k]))


def _rows(own: DiagramsStudy, found: Diagrams, drafting: Drafting) -> Iterator[TableRow]:
    columns = tuple(_columns(whole(found, own.course.omega), own.course.omega))
    for k in told_positions(found):
        cells = (_cell(column, k, drafting) for column in columns)
        yield TableRow(
            str(found.axis.numbers[k]), (fixed(math.degrees(found.axis.turned[k]), drafting.language), *cells)
        )


class _Column(NamedTuple):
    """A column's values, the largest that the one before it can make of them, and its own largest."""

    values: list[float]
    could: float
    largest: float

    @property
    def places(self) -> int | None:
        """Decimals of all its numbers; None where each has its own digits."""
        if self.largest <= NOUGHT * self.could or not math.isfinite(self.largest):
            return None
        places = DIGITS - 1 - math.floor(math.log10(self.largest))
        return max(places, 0) if places in PLACES else None


def _columns(course: Course, omega: float) -> Iterator[_Column]:
    """Give the columns of S, v, a."""
    could = 0.0
    for column in course:
        largest = float(np.nanmax(np.abs(column), initial=0.0))
        could = max(largest, omega * could)
        yield _Column(column.tolist(), could, largest)


def whole(found: Diagrams, omega: float) -> Course:
    """Give S, v and a at the positions; of an output that turns fully with its even turn, (M,) each."""
    s, v, a = found.at
    return Course(s + found.count.turns * found.axis.turned, v + found.count.turns * omega, a)


def _cell(column: _Column, k: int, drafting: Drafting) -> str:
    value, places = column.values[k], column.places
    if math.isnan(value):
        return ABSENT
    told = 0.0 if abs(value) <= NOUGHT * column.could else value
    return drafting.number(told, DIGITS) if places is None else fixed(told, drafting.language, places)
