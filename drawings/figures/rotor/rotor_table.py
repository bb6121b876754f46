"""The tables of a rotor: its masses and counterweights with their moments, and what both roads found (таблицы)."""

from __future__ import annotations

from typing import TypeAlias

from drawings.layout.table import RuledTable, TableRow, table
from drawings.layout.value_table import BY_HAND, row_by_hand
from drawings.lettering.rotor_letters import index, lowered
from drawings.page.drafting import Drafting
from plans.checks.comparison import Comparison, Finding
from plans.checks.rotor_comparison import EQUILIBRIUM
from plans.model.rotor import Balance, Correction, Rotor, Unbalance

MASSES, RESULTS = "masses", "results"  # the names of the tables
HEADINGS = ("m, kg", "D, mm", "φ, °", "h, mm", "m·D, kg·m", "m·D·h, kg·m²")
FLAT = ("m, kg", "D, mm", "φ, °", "m·D, kg·m")  # where every arm is zero
DIGITS = 5
NOTHING = "—"


def masses(rotor: Rotor, balance: Balance, drafting: Drafting) -> RuledTable:
    """Tell the masses of a rotor, then its counterweights."""
    rows = [_mass(rotor, one) for one in rotor.masses]
    rows += [_correction(rotor, one, drafting) for one in balance.corrections]
    flat = not any(arm for _, (_, _, _, arm, _) in rows)
    lines = [_row(name, values, flat, drafting) for name, values in rows]
    return _table(MASSES, lines, "mass number", FLAT if flat else HEADINGS, drafting)


# Mass kg, radius m, angle in degrees, arm m, static moment kg*m.
Values: TypeAlias = tuple[float | None, float | None, float | None, float, float]


def _mass(rotor: Rotor, one: Unbalance) -> tuple[str, Values]:
    return one.name, (one.mass, one.radius, float(one.angle), rotor.arm(one.place), one.moment)


def _correction(rotor: Rotor, one: Correction, drafting: Drafting) -> tuple[str, Values]:
    moment, arm = one.moment, rotor.arm(one.plane.place)
    return index(one.plane.name, drafting.language), (one.mass, one.radius, moment.angle, arm, moment.size)


def _row(name: str, values: Values, flat: bool, drafting: Drafting) -> TableRow:
    mass, radius, angle, arm, moment = values
    far = None if radius is None else 1000 * radius
    cells = (mass, far, angle, moment) if flat else (mass, far, angle, 1000 * arm, moment, moment * arm)
    return TableRow(name, tuple(NOTHING if one is None else drafting.number(one, DIGITS) for one in cells))


def results(comparison: Comparison, drafting: Drafting) -> RuledTable:
    """Tell what both roads found, and what a hand may be out."""
    return _table(RESULTS, [_line(one, drafting) for one in compared(comparison)], "quantity", BY_HAND, drafting)


def compared(comparison: Comparison) -> list[Finding]:
    """List what the table of results tells."""
    return [one for one in comparison.findings if one.plan != EQUILIBRIUM and one.largest > 0]


def _line(finding: Finding, drafting: Drafting) -> TableRow:
    """Give the row of a finding; what vanishes is 0 by both roads."""
    line = row_by_hand(finding, _name(finding, drafting), (0,), drafting.language)
    if max(abs(finding.construction[0]), abs(finding.analysis[0])) <= finding.allowed[0]:
        return line._replace(cells=("0", "0", line.cells[-1]))
    return line


def _name(finding: Finding, drafting: Drafting) -> str:
    head, _, after = finding.name.partition("'")
    prime = "'" if finding.name.endswith("'") else after
    return f"{lowered(head, drafting.language)}{prime}, {drafting.word(finding.unit)}"


def _table(name: str, lines: list[TableRow], first: str, heads: tuple[str, ...], drafting: Drafting) -> RuledTable:
    words = tuple(drafting.word(head) for head in heads)
    return table(lines, drafting.word(first), words, drafting.hand.text)._replace(name=name)
