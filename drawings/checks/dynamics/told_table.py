"""A table of a machine's motion held to what its rows must say, each once, each cell in its place (строки таблиц)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.checks import reading
from drawings.checks.documents_old import ruled
from drawings.checks.dynamics.dynamics_expected import KNOWN
from drawings.checks.graphs.figure_strokes import read
from drawings.checks.wrong import Wrong, within
from drawings.paper.strokes import Group, Leaf
from drawings.paper.walk import groups
from plans.words.words import message

NOTHING = "—"


class DueCell(NamedTuple):
    """What a cell must say: a value, NaN for a dash, with so many digits, or so many `places` after the mark."""

    value: float
    slack: float = 0.0
    digits: int = 0
    places: int = 0

    def holds(self, text: str) -> bool:
        """Tell whether a text says it to its last digit."""
        if math.isnan(self.value) or text == NOTHING:
            return math.isnan(self.value) and text == NOTHING
        if self.places and not re.fullmatch(rf"\S+[.,]\d{{{self.places}}}", text):
            return False
        return reading.reads(text, self.value, self.slack, self.digits)


class Shared(NamedTuple):
    """A difference in per cent, written with an exponent; nothing where it is less than rounding shows."""

    value: float

    def holds(self, text: str) -> bool:
        """Tell whether a text says it to its last digit."""
        if text == NOTHING:
            return abs(self.value) <= 200 * KNOWN
        found = re.fullmatch(r"-?\d[.,]\d{1,2}e[+-]\d\d", text)
        least = 200 * KNOWN + 5.0001e-3 * 10 ** math.floor(math.log10(abs(self.value) or 1.0))
        return found is not None and abs(float(text.replace(",", ".")) - self.value) <= least


class DueTable(NamedTuple):
    """A table as it must be read: its name, its headings from that of the names on, the cells of each row by its name.

    None is a cell that is empty.
    """

    name: str
    heads: Sequence[str]
    rows: Mapping[str, Sequence[DueCell | None]]

    def faults(self, leaf: Leaf) -> Iterator[Wrong]:
        """Hold the parts of the table that stand on a sheet: their lines, headings, and each row to its last digit."""
        heads, due = [read(head) for head in self.heads], {read(name): row for name, row in self.rows.items()}
        blank = {(name, j + 1) for name, row in due.items() for j, cell in enumerate(row) if cell is None}
        for part in parts(leaf, self.name):
            yield from ruled.faults(part, self.name, heads, blank)
        for name, *cells in rows(leaf, self.name):
            if name not in due:
                yield from () if [name, *cells] == heads else (message("wrong.told", text=" ".join((name, *cells))),)
                continue
            true = [cell for cell in due[name] if cell is not None]
            if len(cells) != len(true):
                yield within("row", self.name, name=name)
                continue
            wrong = (text for text, cell in zip(cells, true, strict=True) if not cell.holds(text))
            yield from (message("wrong.row_cell", text=text, name=name) for text in wrong)

    def set_faults(self, leaves: Sequence[Leaf]) -> Iterator[Wrong]:
        """See that every row stands on the sheets of a set, once, and in its order."""
        due = [read(name) for name in self.rows]
        seen = [row[0] for leaf in leaves for row in rows(leaf, self.name)]
        seen = [name for name in seen if name in set(due)]
        if not seen and due:
            yield message("wrong.missing", name=self.name)
            return
        yield from (message("wrong.row_missing", name=name) for name in due if name not in set(seen))
        if not set(due) - set(seen) and seen != due:
            yield within("row", self.name, name=next(a for a, b in zip(seen, [*due, ""], strict=False) if a != b))


def parts(leaf: Leaf, name: str) -> list[Group]:
    """Give the parts of a table that stand on a sheet."""
    return [one for one in groups(leaf.groups) if one.name.removeprefix(f"{name}-").isdigit()]


def rows(leaf: Leaf, name: str) -> list[list[str]]:
    """Give the texts of all rows of a table on a sheet, part by part from the top, an empty cell left out."""
    return [
        [text.plain for text in row if text.plain]
        for part in parts(leaf, name)
        for row in sorted(reading.rows(part), key=lambda row: -row[0].at.imag)
    ]
