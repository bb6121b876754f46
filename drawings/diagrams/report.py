"""The output's course in tables and in words, on the sheet and in the report (выходное звено в отчёте)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from drawings.diagrams.rows import SLIDING, TURNING
from drawings.kinds.graph import TURNED
from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.lettering import every
from drawings.lettering.words import fixed, number
from drawings.page.page import Drafting
from drawings.paper.strokes import Leaf
from drawings.report.formula import Chapters, see
from drawings.report.report import Report, chapter, heading, tabled
from plans.diagrams.study import DiagramsStudy
from plans.model.diagrams import Diagrams, OutputRates, chord_error
from plans.model.motion import Floats
from plans.quantity import Quantity
from plans.study import Study
from plans.words.words import said, word


def diagram_notes(diagrams: DiagramsStudy, drafting: Drafting) -> list[str]:
    """Say why there are no diagrams where they are wanted; what is said of those drawn stands with them."""
    if not diagrams.wanted or diagrams.left_out is None:
        return []
    return [drafting.word("diagrams left out", why=said(diagrams.left_out, drafting.language))]


NAME = "output"
MOST = 36  # positions that are told: of more every so many
ABSENT = "—"
NOUGHT = 1e-9  # of the largest: a rounding
DIGITS = 4  # of the largest of a column, whose numbers all have its decimals
PLACES = range(-3, 8)  # decimals of a column; of none below 0; of other sizes each number has its own digits


def output_table(diagrams: DiagramsStudy, drafting: Drafting) -> RuledTable:
    """Rule the table of the output's course."""
    found = diagrams.drawn
    letters = SLIDING if diagrams.course.travel.sliding else TURNING
    units = [drafting.word(unit) for unit in diagrams.units]
    heads = (f"{TURNED}, °", *(f"{letter}, {unit}" for letter, unit in zip(letters, units, strict=True)))
    ruled = table(list(_rows(diagrams, found, drafting)), drafting.word("position head"), heads, drafting.hand.text)
    return ruled._replace(name=NAME)


def told_positions(found: Diagrams) -> tuple[int, ...]:
    """Choose the places of the axis that the table tells, rising by their positions' numbers."""
    count = len(found.axis.numbers) - found.axis.closed
    step = every(count / MOST, count)
    return tuple(sorted(range(0, count, step), key=lambda k: found.axis.numbers[k]))


def _rows(diagrams: DiagramsStudy, found: Diagrams, drafting: Drafting) -> Iterator[TableRow]:
    columns = tuple(_columns(whole(found, diagrams.course.omega), diagrams.course.omega))
    for k in told_positions(found):
        cells = (_shown(column, k, drafting) for column in columns)
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


def _columns(course: OutputRates, omega: float) -> Iterator[_Column]:
    """Give the columns of S, v, a."""
    could = 0.0
    for column in course:
        largest = float(np.nanmax(np.abs(column), initial=0.0))
        could = max(largest, omega * could)
        yield _Column(column.tolist(), could, largest)


def whole(found: Diagrams, omega: float) -> OutputRates:
    """Give S, v and a at the positions; of an output that turns fully with its even turn, (M,) each."""
    s, v, a = found.at
    return OutputRates(s + found.count.turns * found.axis.turned, v + found.count.turns * omega, a)


def _shown(column: _Column, k: int, drafting: Drafting) -> str:
    value, places = column.values[k], column.places
    if math.isnan(value):
        return ABSENT
    rounded = 0.0 if abs(value) <= NOUGHT * column.could else value
    return drafting.number(rounded, DIGITS) if places is None else fixed(rounded, drafting.language, places)


TOLD = (0, 1, 2, 3, 5)  # of the findings: S, v, a by the plans, v and a by chords


def chapters(study: Study, leaves: Mapping[str, Sequence[Leaf]]) -> Chapters:
    """Tell the output's course at all positions with the chords; why there are no diagrams, if they are wanted."""
    diagrams = study.of(DiagramsStudy)
    language = study.scene.sheet.language
    if diagrams.diagrams is not None:
        lines = _values(diagrams.diagrams, study.comparison("diagrams").findings, language)
        return Chapters(values=(*lines, *see(leaves, language, "diagrams")))
    if diagrams.left_out is None or not diagrams.wanted:
        return Chapters()
    return Chapters(left_out=(word(language, "report.no_diagrams", why=diagrams.left_out),))


def _values(found: Diagrams, findings: Sequence[Quantity], language: str) -> Iterator[str]:
    """Tabulate the course; v by a chord stands with the position from which it goes on."""
    yield chapter(language, "diagrams")
    chosen = [findings[k] for k in TOLD]
    columns = [np.degrees(found.axis.turned), *(_column(finding, len(found.axis.numbers)) for finding in chosen)]
    heads = [f"{TURNED}, °", *(heading(finding, language) for finding in chosen)]
    yield from tabled(heads, columns, language, ABSENT, found.axis.numbers)
    yield ""
    yield from _errors(found, chosen, language)


def _column(finding: Quantity, count: int) -> Floats:
    """Give the values by construction; what is but a rounding of the largest is 0, and from the last goes no chord."""
    values = np.where(np.abs(finding.construction) <= finding.allowed, 0.0, finding.construction).real
    return np.pad(values, (0, count - len(values)), constant_values=np.nan)


def _errors(found: Diagrams, findings: Sequence[Quantity], language: str) -> Iterator[str]:
    """Tell how far the chords are out at the most, and where."""
    numbers = found.axis.numbers
    pairs: tuple[tuple[Floats, Floats], ...] = ((found.speeds, found.true_speeds), (found.growths, found.true_growths))
    for finding, (values, true), fast in zip(findings[3:], pairs, (True, False), strict=True):
        error = chord_error(values, true)
        if error is not None:
            place = f"{numbers[error.at]}–{numbers[error.at + 1]}" if fast else str(numbers[error.at])
            off = number(100 * error.share, language, 3)
            yield word(language, "report.chords", name=finding.name.split(" ")[0], off=off, place=place)


REPORT = Report(chapters)
