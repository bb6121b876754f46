"""What a sheet of a cyclogram tells, read back: dimensions, letters of the charts, table, notes (проверка надписей)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from drawings.checks import reading
from drawings.checks.cyclogram_charts import SHARE
from drawings.checks.precise import precise, tells
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong
from drawings.figures.cyclogram import characteristic_table
from drawings.figures.cyclogram.characteristic_plan import OVERRUNS, STROKE
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Leaf, Text
from drawings.paper.walk import groups, texts
from drawings.report.cyclogram_notes import CyclogramNotes
from plans.checks.cyclogram_comparison import CyclogramComparison
from plans.model.cam import Cam
from plans.model.cyclogram import BEGIN, END, ENTRY, EXIT, Cyclogram, Position
from plans.words.words import message

NOTES = "notes"  # the name of their figure
DIGITS = 7  # of the numbers of the notes
CELLS = 4  # of a row of the table


def dimensions(leaf: Leaf, found: Cyclogram, drafting: Drafting) -> Iterator[Wrong]:
    """Read the dimensions of the stroke and of the overruns back, mm."""
    if not found.sliding:
        return
    places = {one.role: one.place for one in found.positions if not one.back}
    pairs = ((ENTRY, BEGIN), (EXIT, END))
    due = [abs(places[one] - places[end]) for one, end in pairs if one in places]
    for name, sizes in ((OVERRUNS, due), (STROKE, [found.stroke])):
        seen = [text.plain.removeprefix("H = ") for group in _named(leaf, name) for text in texts((group,))]
        if len(seen) != len(sizes):
            yield message("wrong.missing", name=name)
        for text, size in zip(seen, sizes, strict=False):
            if not reads(text, 1000 * size, SHARE * size):
                yield message("wrong.told", text=text)


def table(leaf: Leaf, found: Cyclogram, drafting: Drafting) -> Iterator[Wrong]:
    """Read the table back: every position of the analysis, every cell to its last digit."""
    tables = [one for one in groups(leaf.groups) if one.name.startswith(f"{characteristic_table.NAME}-")]
    seen = [[text.plain for text in row] for group in tables for row in reading.rows(group)]
    for number, one in enumerate(found.positions if tables else ()):
        name = characteristic_table.name(number, one, drafting)
        cells = next((cells for first, *cells in seen if first == name), None)
        if cells is None or len(cells) != CELLS:
            yield message("wrong.row_missing", name=name)
            continue
        wrong = (text for text, due in zip(cells, _due(one, found), strict=True) if not due.holds(text))
        yield from (message("wrong.row_cell", name=name, text=text) for text in wrong)


class Cell(NamedTuple):
    """What a cell must say: its value, its decimals or else its digits; of an angle whole turns are left aside."""

    true: float
    places: int = 0
    digits: int = 0
    turns: bool = False

    def holds(self, text: str) -> bool:
        """Tell whether a text says it."""
        if math.isinf(self.true):
            return text == characteristic_table.INFINITE
        value = reading.value(text)
        if value is None or (self.places and len(re.split("[.,]", text)[-1]) != self.places):
            return False
        whole = 360.0 * round((value - self.true) / 360.0) if self.turns else 0.0
        return reads(text, self.true + whole, SHARE * max(abs(self.true), 1.0), self.digits)


def _due(one: Position, found: Cyclogram) -> tuple[Cell, ...]:
    """Give what the cells of a position must say."""
    gone = one.share * (1000 * found.stroke if found.sliding else math.degrees(found.stroke))
    turned = Cell(math.degrees(one.turned), characteristic_table.PLACES, turns=True)
    known = math.inf if one.role in (BEGIN, END) else one.condition
    return Cell(gone, characteristic_table.LENGTHS), turned, turned, Cell(known, digits=characteristic_table.TIMES)


def notes(leaf: Leaf, comparison: CyclogramComparison, cams: tuple[Cam, ...], drafting: Drafting) -> Iterator[Wrong]:
    """Read the notes of the first sheet back against those of the analysis; the construction alone knows of notches."""
    if not leaf.metadata["notes"]:
        return
    pairs = zip(comparison.analysis.positions, comparison.construction.positions, strict=True)
    positions = tuple(one._replace(notched=ours.notched) for one, ours in pairs)
    found = replace(comparison.analysis, positions=positions)
    true = " ".join(Text(0j, one).plain for one in CyclogramNotes(found, cams, precise(drafting)).all)
    told = " ".join(text.plain for group in _named(leaf, NOTES) for text in texts((group,)))
    if not tells(_even(told), _even(true), (DIGITS,), SHARE):
        yield message("wrong.notes")


def _even(text: str) -> str:
    """Write a text with single spaces: a line's end is one."""
    return " ".join(text.split())


def _named(leaf: Leaf, name: str) -> Iterator[Group]:
    return (one for one in groups(leaf.groups) if one.name == name)
