"""The tables of a rotor: its masses and counterweights with their moments, and what both roads found (таблицы)."""

from __future__ import annotations

import math

from drawings.figures.rotor.letters import index, lowered
from drawings.layout.value_table import APART, UNDER, Row, Setting, Table, row
from drawings.lettering.lettering import text_width
from drawings.page.drafting import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, LineStyle, Stroke, Text
from plans.checks.comparison import Comparison, Finding
from plans.checks.rotor_comparison import EQUILIBRIUM
from plans.model.rotor import Balance, Correction, Rotor, Unbalance

# The headings by the number of cells in a row: of masses, and of what both roads found.
HEADINGS = {
    6: ("m, kg", "D, mm", "φ, °", "h, mm", "m·D, kg·m", "m·D·h, kg·m²"),
    3: ("by plan", "by analysis", "difference"),
}
FIRST = {6: "mass number", 3: "quantity"}
DIGITS = 5
NOTHING = "—"


class RotorTable(Table):
    """A table with one row of headings, all cells of one width."""

    __slots__ = ()

    @property
    def across(self) -> int:
        """How many cells a row has."""
        return len(self.lines[0].cells)

    @property
    def width(self) -> float:
        """The width of one part, mm."""
        return self.names + self.across * self.cell

    def of(self, chosen: slice) -> Table:
        """Give the table: all of it belongs together."""
        return self

    def size(self, setting: Setting) -> tuple[float, float]:
        """Give width and height on paper, mm."""
        rows = math.ceil(len(self.lines) / setting.parts) + 1
        return setting.parts * self.width + (setting.parts - 1) * APART, rows * self.row

    def draw(self, corner: complex, setting: Setting, drafting: Drafting) -> list[Group]:
        """Draw the table from its upper left corner, each part a group."""
        per_part = math.ceil(len(self.lines) / setting.parts)
        groups: list[Group] = []
        for k in range(0, len(self.lines), per_part):
            at = corner + k / per_part * (self.width + APART)
            strokes = (*self._ruled(at, k, per_part, drafting.hand), *self._lettered(at, k, per_part, drafting))
            groups.append(Group((Group(strokes),), f"table-{self.across}-{k}"))
        return groups

    def _ruled(self, corner: complex, first: int, count: int, hand: Hand) -> list[Stroke]:
        rows = len(self.lines[first : first + count]) + 1
        lefts = [0.0, *(self.names + self.cell * k for k in range(self.across + 1))]
        main, thin = LineStyle(hand.main), LineStyle(hand.construction)
        down = -1j * rows * self.row
        upright = [
            Line(corner + x, corner + x + down, main if k in (0, 1, self.across + 1) else thin)
            for k, x in enumerate(lefts)
        ]
        level = [-1j * self.row * k for k in range(rows + 1)]
        flat = [
            Line(corner + y, corner + y + self.width, main if k in (0, 1, rows) else thin) for k, y in enumerate(level)
        ]
        return [*upright, *flat]

    def _lettered(self, corner: complex, first: int, count: int, drafting: Drafting) -> list[Stroke]:
        head = Row(drafting.word(FIRST[self.across]), headings(self.across, drafting))
        strokes: list[Stroke] = []
        for k, line in enumerate((head, *self.lines[first : first + count])):
            base = corner - 1j * (self.row * (k + 1) - UNDER * self.text)
            strokes.append(Text(base + self.names / 2, line.name, self.text, "middle", True))
            strokes += [
                Text(base + self.names + self.cell * (j + 0.5), cell, self.text, "middle", True)
                for j, cell in enumerate(line.cells)
            ]
        return strokes


def headings(across: int, drafting: Drafting) -> tuple[str, ...]:
    """Give the headings of a table with so many cells in a row."""
    return tuple(drafting.word(key) for key in HEADINGS[across])


def masses(rotor: Rotor, balance: Balance, drafting: Drafting) -> RotorTable:
    """Tell the masses of a rotor, then its counterweights."""
    lines = [_mass(rotor, one, drafting) for one in rotor.masses]
    lines += [_correction(rotor, one, drafting) for one in balance.corrections]
    return _table(lines, drafting)


def _mass(rotor: Rotor, one: Unbalance, drafting: Drafting) -> Row:
    return _row(one.name, one.mass, one.radius, float(one.angle), rotor.arm(one.place), one.moment, drafting)


def _correction(rotor: Rotor, one: Correction, drafting: Drafting) -> Row:
    name, size, arm = index(one.plane.name, drafting), one.moment.size, rotor.arm(one.plane.place)
    return _row(name, one.mass, one.radius, one.moment.angle, arm, size, drafting)


def _row(
    name: str, mass: float | None, radius: float | None, angle: float | None, arm: float, moment: float,
    drafting: Drafting,
) -> Row:  # fmt: skip
    far = None if radius is None else 1000 * radius
    values = (mass, far, angle, 1000 * arm, moment, abs(moment * arm))
    return Row(name, tuple(NOTHING if one is None else drafting.number(one, DIGITS) for one in values))


def results(comparison: Comparison, drafting: Drafting) -> RotorTable:
    """Tell what both roads found, with the difference."""
    told = (one for one in comparison.findings if one.plan != EQUILIBRIUM and one.largest > 0)
    return _table([row(one, _name(one, drafting), (0,), drafting.language) for one in told], drafting)


def _name(finding: Finding, drafting: Drafting) -> str:
    head, _, after = finding.name.partition("'")
    prime = "'" if finding.name.endswith("'") else after
    return f"{lowered(head, drafting)}{prime}, {drafting.word(finding.unit)}"


def _table(lines: list[Row], drafting: Drafting) -> RotorTable:
    """Measure a table: cells as wide as the widest text, all of them alike."""
    text, across = drafting.hand.text, len(lines[0].cells)
    cells = (*headings(across, drafting), *(cell for line in lines for cell in line.cells))
    names = (drafting.word(FIRST[across]), *(line.name for line in lines))
    cell, name = (max(text_width(Text(0j, one, text)) for one in own) + text for own in (cells, names))
    return RotorTable(tuple(lines), (0,), text, name, cell)
