"""The table of the output's S, v, a by the plans for all positions, or every so many of them (таблица S, v, a)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from drawings.figures.diagrams.rows import SLIDING, TURNING
from drawings.layout.table import RuledTable, TableRow, table
from drawings.layout.thinning import every
from drawings.lettering.words import fixed
from drawings.page.drafting import Drafting
from plans.diagrams.study import DiagramsStudy
from plans.model.diagrams import Course, Diagrams

NAME = "output"
MOST = 36  # positions that are told: of more every so many
ABSENT = "—"
NOUGHT = 1e-9  # of the largest: a rounding


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
    columns = list(_columns(whole(found, own.course.omega), own.course.omega))
    for k in told_positions(found):
        cells = (_cell(values[k], largest, drafting) for values, largest in columns)
        yield TableRow(
            str(found.axis.numbers[k]), (fixed(math.degrees(found.axis.turned[k]), drafting.language), *cells)
        )


def _columns(course: Course, omega: float) -> Iterator[tuple[list[float], float]]:
    """Give the values of each column, and the largest that it has or that the one before it can make it."""
    largest = 0.0
    for column in course:
        largest = max(float(np.nanmax(np.abs(column), initial=0.0)), omega * largest)
        yield column.tolist(), largest


def whole(found: Diagrams, omega: float) -> Course:
    """Give S, v and a at the positions; of an output that turns fully with its even turn, (M,) each."""
    s, v, a = found.at
    return Course(s + found.count.turns * found.axis.turned, v + found.count.turns * omega, a)


def _cell(value: float, largest: float, drafting: Drafting) -> str:
    if math.isnan(value):
        return ABSENT
    return drafting.number(0.0 if abs(value) <= NOUGHT * largest else value)
