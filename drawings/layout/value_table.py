"""The table of values: drawn quantities by plan and by analysis, with what a hand may be out (таблица результатов)."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Mapping, Sequence

import numpy as np

from drawings.layout.table import Cell, Later, RuledTable, TableRow
from drawings.layout.table import table as measure
from drawings.lettering.words import fixed, letter, word
from drawings.page.page import Drafting
from drawings.paper.walk import tied
from plans.model.motion import ORDERS
from plans.quantity import Comparison, Quantity

# Of every table of values, in this order: `table`, `by_roads` of checks/expected.py, form/laid.py and grading/cells
# count on it. One more needs cells below, a word, and to be expected (due.py of a technique).
COLUMNS = ("by plan", "by analysis", "drawing error")
BOTH = "by both"  # heads the one column of a table in which plan and analysis agree in all that is printed
NOTHING, WIDE = "—", "8"
DIGITS = 5  # of the largest value of a row; the others keep its decimals


def rows(lines: Sequence[Sequence[Quantity]], positions: tuple[int, ...], language: str) -> list[TableRow]:
    """Give a row for each velocity, acceleration, part or rate by positions; what is one by its cause has one row."""
    return [value_row(same[0], label(same, language), positions, language) for same in lines]


def listed(comparison: Comparison, parts: Sequence[Quantity] = (), given: Collection[str] = ()) -> list[Quantity]:
    """List what a table tells: points, parts, links of each plan, but for names `given` in the scene and zeros."""
    found: list[Quantity] = []
    for order in ORDERS[1:]:
        of_plan = [row for row in comparison.of(order.plan) if np.nanmax(np.abs(row.construction), initial=0.0) > 0]
        points = [row for row in of_plan if row.unit == order.point.unit]
        beside = [row for row in parts if row.plan == order.plan and _is_something(row)]
        found += [*points, *_new(beside, points), *(row for row in of_plan if row not in points)]
    return [row for row in found if row.name not in given]


def _is_something(part: Quantity) -> bool:
    """Tell whether a part is anywhere more than rounding."""
    return bool(np.nanmax(np.abs(part.construction), initial=0.0) > np.nanmax(part.allowed, initial=0.0))


def _new(parts: Sequence[Quantity], points: Sequence[Quantity]) -> list[Quantity]:
    """Leave out a normal part that is the whole acceleration of a point."""
    known, whole = {row.name for row in parts}, {row.name for row in points}
    return [
        row for row in parts if not (row.name.replace("^n", "") in whole and row.name.replace("^n", "^t") not in known)
    ]


def value_row(finding: Quantity, name: str, positions: tuple[int, ...], language: str) -> TableRow:
    """Give the row of a finding under a name: by plan, by analysis, what a hand may be out."""
    return TableRow(name, tuple(cell for k in positions for cell in _cells(finding, k, language)))


def label(same: Sequence[Quantity], language: str) -> str:
    """Name findings of a motion that are one as the table does, with their unit: "v_{D} = v_{S5}, m/s"."""
    names = (row.name.split("_", 1) for row in same)
    letters = " = ".join(letter(language, f"{symbol}_{{{index}}}") for symbol, index in names)
    return f"{letters}, {word(language, same[0].unit)}"


def _pair(finding: Quantity, position: int, language: str) -> tuple[str, str] | None:
    """Write a value by plan and by analysis; None at a gap."""
    both = finding.construction[position], finding.analysis[position]
    if np.isnan(np.abs(both)).any():
        return None
    found = (float(abs(value)) if np.iscomplexobj(value) else float(value) for value in both)
    plan, analysis = (fixed(value, language, _places(finding)) for value in found)
    return plan, analysis


def _places(finding: Quantity) -> int:
    return max(DIGITS - 1 - math.floor(tied(math.log10(finding.largest))), 0)


def _cells(finding: Quantity, position: int, language: str) -> tuple[Cell, Cell, Cell]:
    pair, places = _pair(finding, position, language), _places(finding)
    if pair is None:
        return NOTHING, NOTHING, NOTHING
    widest = re.sub(r"\d", WIDE, f"±{fixed(finding.largest, language, places)}")
    return *pair, Later(finding.name, position, widest, places, finding.largest)


def by_hand(errors: Mapping[tuple[str, int], float], language: str) -> Callable[[Later], str]:
    """Give how the cells of what a hand may be out are written, by the names and positions of the findings."""

    def write(cell: Later) -> str:
        error = errors.get((cell.name, cell.position), math.nan)
        if not error <= cell.most:  # a dead centre: the slips tell nothing, or no more than that anything may be drawn
            return NOTHING
        return f"±{_two_digits(error, cell.places, language)}"

    return write


def _two_digits(value: float, most: int, language: str) -> str:
    """Write a number with two significant digits, but no more than so many decimals."""
    if value < 10.0 ** (1 - most):
        return fixed(value, language, most)
    rounded = float(f"{value:.1e}")
    return fixed(rounded, language, max(1 - math.floor(math.log10(rounded)), 0))


def table(lines: Sequence[TableRow], positions: tuple[int, ...], drafting: Drafting) -> RuledTable:
    """Measure a table of values: of plan and analysis one column where they agree in all that is printed."""
    each, columns = len(COLUMNS), tuple[str, ...](COLUMNS)
    if all(line.cells[k] == line.cells[k + 1] for line in lines for k in range(0, len(line.cells), each)):
        columns = BOTH, COLUMNS[-1]
        lines = [
            line._replace(cells=tuple(cell for k, cell in enumerate(line.cells) if k % each != 1)) for line in lines
        ]
    heads = tuple(drafting.word(key) for key in columns)
    return measure(lines, drafting.word("quantity"), heads, drafting.hand.text, positions)
