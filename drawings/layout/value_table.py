"""The table of values: every drawn quantity by plan and by analysis, with the difference (таблица результатов)."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from drawings.lettering.lettering import text_width
from drawings.lettering.words import fixed, number, word
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, LineStyle, Stroke, Text
from plans.checks.comparison import Comparison, Finding

# In sizes of the letters: a row, how far a text stands above its row's line, and the least cell.
ROW, UNDER, CELL = 2.0, 0.65, 4.0
HEADINGS = 2  # rows
APART = 6.0  # mm between two bands or two parts of the table
MOST_PARTS = 4  # side by side: more are wider than an A1 sheet
COLUMNS = ("by plan", "by analysis", "difference")
DIGITS = 5  # of the largest value of a row; the others keep its decimals
PLAIN = 1e-3  # a smaller per cent is written by its power of ten
NOISE = 9  # a difference below 10^-9 % is said to be below it: its own digits differ from machine to machine


class Row(NamedTuple):
    """A line of the table: a quantity's name with its unit, and its cells."""

    name: str
    cells: tuple[str, ...]

    def of(self, positions: slice) -> Row:
        """Give the row over some of its positions; each has three cells."""
        return Row(self.name, self.cells[3 * positions.start : 3 * positions.stop])


class Setting(NamedTuple):
    """How a table is set: positions across, and parts of its rows side by side."""

    across: int
    parts: int


def rows(comparison: Comparison, positions: tuple[int, ...], given: set[str], language: str) -> list[Row]:
    """Give a row for every velocity and acceleration of a point and a link, for some positions.

    Left out are the names in `given`, which the scene states, and what stays zero: links that do not turn.
    """
    chosen = [finding for plan in ("velocities", "accelerations") for finding in comparison.of(plan)]
    return [
        row(finding, _name(finding, language), positions, language)
        for finding in chosen
        if finding.name not in given and np.nanmax(np.abs(finding.construction), initial=0.0) > 0
    ]


def row(finding: Finding, name: str, positions: tuple[int, ...], language: str) -> Row:
    """Give the row of a finding under a name."""
    return Row(name, tuple(cell for k in positions for cell in _cells(finding, k, language)))


def _name(finding: Finding, language: str) -> str:
    symbol, index = finding.name.split("_", 1)
    return f"{symbol}_{{{index}}}, {word(language, finding.unit)}"


def _cells(finding: Finding, position: int, language: str) -> tuple[str, str, str]:
    ours, theirs = finding.construction[position], finding.analysis[position]
    if np.isnan(abs(ours)) or np.isnan(abs(theirs)):
        return "—", "—", "—"
    true = [float(abs(value)) if np.iscomplexobj(value) else float(value) for value in (ours, theirs)]
    places = max(DIGITS - 1 - int(np.floor(np.log10(finding.largest))), 0)
    told = _per_cent(float(finding.difference[position]) / finding.largest * 100, language)
    if max(map(abs, true)) <= finding.allowed[position]:
        told = "—"  # of what is nothing but for rounding there is no share
    return fixed(true[0], language, places), fixed(true[1], language, places), told


def _per_cent(value: float, language: str) -> str:
    """Write a difference in per cent; below what matters on any sheet its digits are rounding, not result."""
    if value < 10.0**-NOISE:
        return f"<10^{{−{NOISE}}}"
    if value < PLAIN:
        power = math.floor(math.log10(value))
        return f"{number(value / 10.0**power, language, 2)}·10^{{−{-power}}}"
    return number(value, language, 2)


class Table(NamedTuple):
    """The table in its natural size: cells as wide as their widest text, all of them alike."""

    lines: tuple[Row, ...]
    positions: tuple[int, ...]
    text: float  # size of the letters, mm
    names: float  # width of the column of names, mm
    cell: float  # width of a cell, mm

    @property
    def row(self) -> float:
        """Height of a row, mm."""
        return ROW * self.text

    def part(self, rows: slice) -> Table:
        """Give the table of some of its rows."""
        return self._replace(lines=self.lines[rows])

    def of(self, chosen: slice) -> Table:
        """Give the table of some of its positions."""
        return self._replace(lines=tuple(line.of(chosen) for line in self.lines), positions=self.positions[chosen])

    def size(self, setting: Setting) -> tuple[float, float]:
        """Give width and height on paper, mm."""
        bands = math.ceil(len(self.positions) / setting.across)
        width = self.names + 3 * self.cell * min(setting.across, len(self.positions))
        rows = math.ceil(len(self.lines) / setting.parts) + HEADINGS
        return setting.parts * width + (setting.parts - 1) * APART, bands * rows * self.row + (bands - 1) * APART

    def settings(self) -> list[Setting]:
        """List the ways to set the table, in bands or in parts side by side, that no other beats both ways."""
        count = len(self.positions)
        across = sorted({math.ceil(count / bands) for bands in range(1, count + 1)}, reverse=True)
        ways = [Setting(wide, parts) for parts in range(1, MOST_PARTS + 1) for wide in across]
        sizes = [self.size(way) for way in ways]
        larger = [any(w <= wide and h <= high and (w, h) != (wide, high) for w, h in sizes) for wide, high in sizes]
        return [way for way, worse in zip(ways, larger, strict=True) if not worse]

    def drawn(self, corner: complex, setting: Setting, hand: Hand, language: str) -> list[Group]:
        """Draw the table from its upper left corner, each band and part a group that says its positions."""
        per_part = max(1, math.ceil(len(self.lines) / setting.parts))  # where no force acts at all there are no lines
        width = self.names + 3 * self.cell * min(setting.across, len(self.positions)) + APART
        height = (per_part + HEADINGS) * self.row + APART
        groups: list[Group] = []
        for band in range(0, len(self.positions), setting.across):
            for k in range(0, len(self.lines), per_part):
                at = corner + complex(k / per_part * width, -band / setting.across * height)
                chosen = slice(band, band + setting.across)
                piece = self.of(chosen).part(slice(k, k + per_part))
                data = {"positions": " ".join(str(position) for position in piece.positions)}
                strokes = Group(tuple(_block(piece, at, hand, language)))
                groups.append(Group((strokes,), f"values-{len(groups) + 1}", data))
        return groups


def table(lines: list[Row], positions: tuple[int, ...], text: float, language: str) -> Table:
    """Measure a table of values."""
    headings = [word(language, key) for key in COLUMNS]
    cell = max(text_width(Text(0j, one, text)) for one in (*headings, *(c for line in lines for c in line.cells)))
    names = max(text_width(Text(0j, one, text)) for one in (word(language, "quantity"), *(line.name for line in lines)))
    return Table(tuple(lines), positions, text, names + text, max(cell, CELL * text) + text)


def _block(piece: Table, corner: complex, hand: Hand, language: str) -> list[Stroke]:
    """Draw one band of the table: its lines, two rows of headings, and a row for each quantity."""
    count, row = 3 * len(piece.positions), piece.row
    left, top = corner.real, corner.imag
    columns = [left, *(left + piece.names + piece.cell * k for k in range(count + 1))]
    strokes = _ruled(piece, columns, top, hand)
    strokes += _headings(piece, columns, top, language)
    for k, line in enumerate(piece.lines):
        y = top - row * (k + HEADINGS + 1) + UNDER * piece.text
        strokes.append(Text(complex(left + piece.text / 2, y), line.name, piece.text, "start", True))
        for x, text in zip(columns[1:], line.cells, strict=False):
            strokes.append(Text(complex(x + piece.cell / 2, y), text, piece.text, "middle", True))
    return strokes


def _ruled(piece: Table, columns: list[float], top: float, hand: Hand) -> list[Stroke]:
    main, thin = LineStyle(hand.main), LineStyle(hand.construction)
    rows, strokes = len(piece.lines) + HEADINGS, list[Stroke]()
    for k, x in enumerate(columns):
        heavy = k in (0, 1) or (k - 1) % 3 == 0
        high = top if heavy else top - piece.row
        strokes.append(Line(complex(x, top - rows * piece.row), complex(x, high), main if heavy else thin))
    for k in range(rows + 1):
        y = top - piece.row * k
        left = columns[1] if k == 1 else columns[0]
        style = main if k in (0, HEADINGS, rows) else thin
        strokes.append(Line(complex(left, y), complex(columns[-1], y), style))
    return strokes


def _headings(piece: Table, columns: list[float], top: float, language: str) -> list[Stroke]:
    size, row = piece.text, piece.row
    high, low = top - row + UNDER * size, top - 2 * row + UNDER * size
    middle = complex((columns[0] + columns[1]) / 2, top - row - size / 2)
    strokes: list[Stroke] = [Text(middle, word(language, "quantity"), size, "middle", True)]
    for k, position in enumerate(piece.positions):
        left, right = columns[1 + 3 * k], columns[4 + 3 * k]
        title = word(language, "position", position=position)
        strokes.append(Text(complex((left + right) / 2, high), title, size, "middle", True))
        for j, key in enumerate(COLUMNS):
            x = (columns[1 + 3 * k + j] + columns[2 + 3 * k + j]) / 2
            strokes.append(Text(complex(x, low), word(language, key), size, "middle", True))
    return strokes
