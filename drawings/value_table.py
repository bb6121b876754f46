"""The table of values: every drawn quantity by plan and by analysis, with the difference (таблица результатов)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from drawings.hand import Hand
from drawings.page import Field
from drawings.strokes import Group, Line, LineStyle, SheetError, Stroke, Text, text_width
from drawings.words import fixed, number, word
from plans.compare import Comparison, Finding

ROW, LETTERING = 7.0, 3.5
NAME_WIDTH = 24.0
DIGITS = 5  # of the largest value of a row; the others keep its decimals
NOISE = 9  # a difference below 10^-9 % is said to be below it: its own digits differ from machine to machine


class Row(NamedTuple):
    """A line of the table: a quantity's name with its unit, and its cells."""

    name: str
    cells: tuple[str, ...]


def rows(comparison: Comparison, positions: tuple[int, ...], given: set[str], language: str) -> list[Row]:
    """Give a row for every velocity and acceleration of a point and a link, for some positions.

    Left out are the names in `given`, which the scene states, and what stays zero: links that do not turn.
    """
    chosen = [finding for plan in ("velocities", "accelerations") for finding in comparison.of(plan)]
    return [
        Row(_name(finding, language), tuple(cell for k in positions for cell in _cells(finding, k, language)))
        for finding in chosen
        if finding.name not in given and np.nanmax(np.abs(finding.construction), initial=0.0) > 0
    ]


def _name(finding: Finding, language: str) -> str:
    symbol, index = finding.name.split("_", 1)
    return f"{symbol}_{{{index}}}, {word(language, finding.unit)}"


def _cells(finding: Finding, position: int, language: str) -> tuple[str, str, str]:
    ours, theirs = finding.construction[position], finding.analysis[position]
    if np.isnan(abs(ours)) or np.isnan(abs(theirs)):
        return "—", "—", "—"
    true = [float(abs(value)) if np.iscomplexobj(value) else float(value) for value in (ours, theirs)]
    places = max(DIGITS - 1 - int(np.floor(np.log10(finding.largest))), 0)
    per_cent = float(finding.difference[position]) / finding.largest * 100
    return fixed(true[0], language, places), fixed(true[1], language, places), _per_cent(per_cent, language)


def _per_cent(value: float, language: str) -> str:
    """Write a difference in per cent; below what matters on any sheet its digits are rounding, not result."""
    return f"<10^{{−{NOISE}}}" if value < 10.0**-NOISE else number(value, language, 2)


def table(lines: list[Row], positions: tuple[int, ...], field: Field, hand: Hand, language: str) -> Group:
    """Draw the table at the top of a field: two rows of headings, then the quantities, in as many columns as fit."""
    per_column = max(int(field.height // ROW) - 2, 1)
    blocks = [lines[k : k + per_column] for k in range(0, len(lines), per_column)]
    width = field.width / max(len(blocks), 1)
    _fits(lines, positions, (width - NAME_WIDTH) / (3 * len(positions)))
    strokes: list[Stroke] = []
    for k, block in enumerate(blocks):
        left = field.left + k * width
        strokes += _block(block, positions, Field(left, field.bottom, left + width, field.top), hand, language)
    return Group(tuple(strokes), "values")


def _fits(lines: list[Row], positions: tuple[int, ...], cell: float) -> None:
    """Refuse a table whose numbers would run over each other."""
    widest = max(text_width(Text(0j, text, LETTERING)) for line in lines for text in line.cells)
    if widest > cell - 1:
        raise SheetError(
            f"the table of values for {len(positions)} positions needs cells of {widest + 1:.0f} mm and the sheet "
            f"has room for {cell:.0f} mm. Fix: name fewer positions in [sheet] plans, or take a larger format"
        )


def _block(lines: list[Row], positions: tuple[int, ...], field: Field, hand: Hand, language: str) -> list[Stroke]:
    main, thin = LineStyle(hand.main), LineStyle(hand.construction)
    cell = (field.width - NAME_WIDTH) / (3 * len(positions))
    columns = [field.left, *(field.left + NAME_WIDTH + cell * k for k in range(3 * len(positions) + 1))]
    bottom = field.top - ROW * (len(lines) + 2)
    strokes: list[Stroke] = []
    for k, x in enumerate(columns):
        heavy = k in (0, 1) or (k - 1) % 3 == 0
        top = field.top if heavy else field.top - ROW
        strokes.append(Line(complex(x, bottom), complex(x, top), main if heavy else thin))
    for k in range(len(lines) + 3):
        y = field.top - ROW * k
        left = columns[1] if k == 1 else field.left
        strokes.append(Line(complex(left, y), complex(field.right, y), main if k in (0, 2, len(lines) + 2) else thin))
    strokes += _headings(positions, columns, field, language)
    for k, line in enumerate(lines):
        y = field.top - ROW * (k + 3) + 1.9
        strokes.append(Text(complex(columns[0] + 1.5, y), line.name, LETTERING, "start", True))
        for x, text in zip(columns[1:], line.cells, strict=False):
            strokes.append(Text(complex(x + cell / 2, y), text, LETTERING, "middle", True))
    return strokes


def _headings(positions: tuple[int, ...], columns: list[float], field: Field, language: str) -> list[Stroke]:
    high, low = field.top - ROW + 1.9, field.top - 2 * ROW + 1.9
    name = Text(
        complex((columns[0] + columns[1]) / 2, (high + low) / 2), word(language, "quantity"), 3.5, "middle", True
    )
    strokes: list[Stroke] = [name]
    for k, position in enumerate(positions):
        left, right = columns[1 + 3 * k], columns[4 + 3 * k]
        title = word(language, "position", position=position)
        strokes.append(Text(complex((left + right) / 2, high), title, LETTERING, "middle", True))
        for j, key in enumerate(("by plan", "by analysis", "difference")):
            x = (columns[1 + 3 * k + j] + columns[2 + 3 * k + j]) / 2
            strokes.append(Text(complex(x, low), word(language, key), LETTERING, "middle", True))
    return strokes
