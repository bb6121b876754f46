"""The table of values: every drawn quantity by plan and by analysis, with the difference (таблица результатов)."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from drawings.layout.table import RuledTable, TableRow
from drawings.layout.table import table as measure
from drawings.lettering.words import fixed, number, word
from drawings.page.drafting import Drafting
from plans.checks.comparison import Comparison, Finding

COLUMNS = ("by plan", "by analysis", "difference")
DIGITS = 5  # of the largest value of a row; the others keep its decimals
PLAIN = 1e-3  # a smaller per cent is written by its power of ten
NOISE = 9  # a difference below 10^-9 % is said to be below it: its own digits differ from machine to machine


def rows(comparison: Comparison, positions: tuple[int, ...], given: set[str], language: str) -> list[TableRow]:
    """Give a row for every velocity and acceleration of a point and a link, for some positions.

    Left out are the names in `given`, which the scene states, and what stays zero: links that do not turn.
    """
    chosen = [finding for plan in ("velocities", "accelerations") for finding in comparison.of(plan)]
    return [
        row(finding, _name(finding, language), positions, language)
        for finding in chosen
        if finding.name not in given and np.nanmax(np.abs(finding.construction), initial=0.0) > 0
    ]


def row(finding: Finding, name: str, positions: tuple[int, ...], language: str) -> TableRow:
    """Give the row of a finding under a name."""
    return TableRow(name, tuple(cell for k in positions for cell in _cells(finding, k, language)))


def _name(finding: Finding, language: str) -> str:
    symbol, index = finding.name.split("_", 1)
    return f"{symbol}_{{{index}}}, {word(language, finding.unit)}"


def _cells(finding: Finding, position: int, language: str) -> tuple[str, str, str]:
    ours, theirs = finding.construction[position], finding.analysis[position]
    if np.isnan(abs(ours)) or np.isnan(abs(theirs)):
        return "—", "—", "—"
    true = [float(abs(value)) if np.iscomplexobj(value) else float(value) for value in (ours, theirs)]
    places = max(DIGITS - 1 - int(np.floor(np.log10(finding.largest))), 0)
    share = _per_cent(float(finding.difference[position]) / finding.largest * 100, language)
    if max(map(abs, true)) <= finding.allowed[position]:
        share = "—"  # of what is nothing but for rounding there is no share
    return fixed(true[0], language, places), fixed(true[1], language, places), share


def _per_cent(value: float, language: str) -> str:
    """Write a difference in per cent; below what matters on any sheet its digits are rounding, not result."""
    if value < 10.0**-NOISE:
        return f"<10^{{−{NOISE}}}"
    if value < PLAIN:
        power = math.floor(math.log10(value))
        return f"{number(value / 10.0**power, language, 2)}·10^{{−{-power}}}"
    return number(value, language, 2)


def table(lines: Sequence[TableRow], positions: tuple[int, ...], drafting: Drafting) -> RuledTable:
    """Measure a table of values."""
    heads = tuple(drafting.word(key) for key in COLUMNS)
    return measure(lines, drafting.word("quantity"), heads, drafting.hand.text, positions)
