"""The tables of a rotor: its masses and counterweights with their moments, and what both roads found (таблицы)."""

from __future__ import annotations

import math
from typing import TypeAlias

from drawings.figures.rotor.letters import index, lowered
from drawings.layout.contents import Block
from drawings.layout.value_table import APART, UNDER, Row, Setting, Table, row
from drawings.lettering.lettering import text_width
from drawings.page.drafting import Drafting
from drawings.page.page import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, LineStyle, Stroke, Text
from plans.checks.comparison import Comparison, Finding
from plans.checks.rotor_comparison import EQUILIBRIUM
from plans.model.rotor import Balance, Correction, Rotor, Unbalance

# The headings by the number of cells in a row: of masses, and of what both roads found.
HEADINGS = {
    6: ("m, kg", "D, mm", "φ, °", "h, mm", "m·D, kg·m", "m·D·h, kg·m²"),
    4: ("m, kg", "D, mm", "φ, °", "m·D, kg·m"),  # where no arm is but zero
    3: ("by plan", "by analysis", "difference"),
}
FIRST = {6: "mass number", 4: "mass number", 3: "quantity"}
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
    rows = [_mass(rotor, one) for one in rotor.masses]
    rows += [_correction(rotor, one, drafting) for one in balance.corrections]
    flat = not any(arm for _, (_, _, _, arm, _) in rows)
    return _table([_row(name, values, flat, drafting) for name, values in rows], drafting)


# Mass kg, radius m, angle in degrees, arm m, static moment kg*m.
Values: TypeAlias = tuple[float | None, float | None, float | None, float, float]


def _mass(rotor: Rotor, one: Unbalance) -> tuple[str, Values]:
    return one.name, (one.mass, one.radius, float(one.angle), rotor.arm(one.place), one.moment)


def _correction(rotor: Rotor, one: Correction, drafting: Drafting) -> tuple[str, Values]:
    moment, arm = one.moment, rotor.arm(one.plane.place)
    return index(one.plane.name, drafting), (one.mass, one.radius, moment.angle, arm, moment.size)


def _row(name: str, values: Values, flat: bool, drafting: Drafting) -> Row:
    mass, radius, angle, arm, moment = values
    far = None if radius is None else 1000 * radius
    told = (mass, far, angle, moment) if flat else (mass, far, angle, 1000 * arm, moment, abs(moment * arm))
    return Row(name, tuple(NOTHING if one is None else drafting.number(one, DIGITS) for one in told))


def results(comparison: Comparison, drafting: Drafting) -> RotorTable:
    """Tell what both roads found, with the difference."""
    told = (one for one in comparison.findings if one.plan != EQUILIBRIUM and one.largest > 0)
    return _table([_compared(one, drafting) for one in told], drafting)


def _compared(finding: Finding, drafting: Drafting) -> Row:
    """Give the row of a finding; what vanishes is 0 by both roads."""
    name = _name(finding, drafting)
    if max(abs(finding.construction[0]), abs(finding.analysis[0])) <= finding.allowed[0]:
        return Row(name, ("0", "0", NOTHING))
    return row(finding, name, (0,), drafting.language)


def block(table: RotorTable, name: str) -> Block:
    """Give the room of a table that stands among the figures."""
    return Block(name, (table.size(Setting(1, 1)),))


def write(table: RotorTable, drafting: Drafting, box: Field) -> Group:
    """Write a table in its box."""
    return Group(tuple(table.draw(complex(box.left, box.top), Setting(1, 1), drafting)), "results")


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
