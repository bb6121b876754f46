"""The self-check of a rotor's tables: each row that must be there, each cell to its last digit (проверка таблиц)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.checks import reading
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong, within
from drawings.lettering.rotor_letters import index, lowered
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Group, Leaf, Text
from drawings.paper.walk import groups
from plans.checks.comparison import Comparison, Finding
from plans.checks.rotor_comparison import EQUILIBRIUM
from plans.model.rotor import Balance, Correction, Rotor
from plans.rotor.balancing import UNBALANCES
from plans.rotor.letters import unbalance_letters

TURN = 360.0
MASSES, RESULTS, NOTHING, DIGITS = "masses", "results", "—", 5
HEADINGS = ("m, kg", "D, mm", "φ, °", "h, mm", "m·D, kg·m", "m·D·h, kg·m²")
FLAT = ("m, kg", "D, mm", "φ, °", "m·D, kg·m")  # where every arm is zero


class Cell(NamedTuple):
    """What a cell must say, None for a dash; how far rounding can have moved it; whether whole turns are left aside."""

    true: float | None
    slack: float = 0.0
    turns: bool = False

    def holds(self, text: str) -> bool:
        """Tell whether a text says it; of a direction that rounding alone has any will do, and none."""
        if self.turns and self.slack >= TURN:
            return True
        if self.true is None or text == NOTHING:
            return self.true is None and text == NOTHING
        return reads(text, self.true + self._turns(text), self.slack, DIGITS)

    def _turns(self, text: str) -> float:
        found = reading.value(text) if self.turns else None
        return 0.0 if found is None or self.true is None else TURN * round((found - self.true) / TURN)


def named(comparison: Comparison, language: str) -> Mapping[str, Finding]:
    """Give the findings that a sheet tells by their letters as they are read."""
    found = (one for one in comparison.findings if one.plan != EQUILIBRIUM)
    return {Text(0j, lowered(one.name, language)).plain: one for one in found}


def direction(value: complex, slack: float) -> Cell:
    """Give the cell of the direction of a vector that rounding can have moved so far."""
    if abs(value) <= slack:
        return Cell(None, TURN, True)
    return Cell(math.degrees(math.atan2(value.imag, value.real)), math.degrees(slack / abs(value)), True)


def results(leaf: Leaf, comparison: Comparison, drafting: Drafting) -> Iterator[Wrong]:
    """Read the table of results back: under the polygon that ends the construction stands every finding."""
    known, seen = named(comparison, drafting.language), set[str]()
    for group in _tables(leaf, RESULTS):
        for text, name, _ in reading.wrong_values(group, known, (0,)):
            yield within("cell", RESULTS, name=name, text=text)
        for row in reading.rows(group):
            name, *cells = (text.plain for text in row)
            name, _, unit = name.rpartition(", ")
            seen.add(name)
            one = known.get(name)
            if one is not None and unit != drafting.word(one.unit):
                yield within("cell", RESULTS, name=one.name, text=unit)
            if one is not None and "0" in cells[:2] and not abs(one.analysis[0]) <= one.allowed[0] + _whole(one):
                yield within("cell", RESULTS, name=one.name, text="0")
            if one is not None and len(cells) != 3:  # by plan, by analysis, difference
                yield within("row", RESULTS, name=one.name)
    if UNBALANCES in leaf.metadata["figures"]:
        missing = (one.name for name, one in known.items() if one.largest > 0 and name not in seen)
        yield from (within("missing_from", RESULTS, name=name) for name in missing)


def _whole(one: Finding) -> float:
    """Give what 0 may stand for: of a row whose largest leaves no decimals, the half of a unit."""
    return 0.5 if one.largest >= 10.0 ** (DIGITS - 1) else 0.0


def names(rotor: Rotor, comparison: Comparison, drafting: Drafting) -> list[str]:
    """Name the rows that the table of masses must have."""
    return [name for name, _ in _MassTable(rotor, comparison, drafting).lines()]


def masses(leaf: Leaf, rotor: Rotor, comparison: Comparison, drafting: Drafting) -> Iterator[Wrong]:
    """Read the table of masses back: every cell, and every row of the run that stands on this sheet."""
    table = _MassTable(rotor, comparison, drafting)
    lines, seen = dict(table.lines()), list[str]()
    for name, *cells in (
        [text.plain for text in row] for group in _tables(leaf, MASSES) for row in reading.rows(group)
    ):
        if name not in lines:
            yield from () if [name, *cells] == table.heading else (within("in", MASSES, text=name),)
            continue
        seen.append(name)
        if len(cells) != len(lines[name]):
            yield within("row", MASSES, name=name)
            continue
        wrong = (text for text, cell in zip(cells, lines[name], strict=True) if not cell.holds(text))
        yield from (within("cell", MASSES, name=name, text=text) for text in wrong)
    missing = (name for name in _run(leaf, list(lines)) if name not in seen)
    yield from (within("missing_from", MASSES, name=name) for name in missing)


def _run(leaf: Leaf, names: Sequence[str]) -> Sequence[str]:
    """Give the rows that a sheet must bear: those that its data tell, and all of them if it is alone."""
    whole = (0, len(names)) if leaf.metadata["of"] == 1 else (0, 0)
    return names[slice(*leaf.metadata["rows"].get(MASSES, whole))]


def _tables(leaf: Leaf, name: str) -> Iterator[Group]:
    return (one for one in groups(leaf.groups) if one.name.startswith(name))


class _MassTable(NamedTuple):
    """What the table of masses must say by the analysis."""

    rotor: Rotor
    comparison: Comparison
    drafting: Drafting

    @property
    def heading(self) -> list[str]:
        """The texts of the headings as they are read."""
        keys = ("mass number", *(FLAT if self.flat else HEADINGS))
        return [Text(0j, self.drafting.word(key)).plain for key in keys]

    @property
    def flat(self) -> bool:
        """Whether every arm is zero."""
        return not any(self.rotor.arm(one.place) for own in (self.rotor.masses, self.rotor.planes) for one in own)

    def lines(self) -> Iterator[tuple[str, list[Cell]]]:
        """Give the cells of each row by its name."""
        for one in self.rotor.masses:
            told = Cell(one.mass), _millimetres(Cell(one.radius)), Cell(float(one.angle), 0.0, True)
            yield one.name, self._line(*told, self.rotor.arm(one.place), Cell(one.moment))
        analysis: Balance = self.comparison.analysis
        allowed = {one.name: float(one.allowed[0]) for one in self.comparison.findings if one.plan == UNBALANCES}
        for found in analysis.corrections:
            slack = allowed[unbalance_letters(found.plane.name)]
            told = found_mass(found, slack), _millimetres(radius(found, slack)), direction(found.moment.value, slack)
            size = Cell(found.moment.size, slack)
            yield (
                index(found.plane.name, self.drafting.language),
                self._line(*told, self.rotor.arm(found.plane.place), size),
            )

    def _line(self, mass: Cell, far: Cell, angle: Cell, arm: float, moment: Cell) -> list[Cell]:
        assert moment.true is not None  # every mass has one
        if self.flat:
            return [mass, far, angle, moment]
        turned = Cell(moment.true * arm, moment.slack * abs(arm))
        return [mass, far, angle, Cell(1000 * arm), moment, turned]


def found_mass(one: Correction, slack: float) -> Cell:
    """Give what must be told of the mass kg of a counterweight."""
    return Cell(one.mass, 0.0 if one.plane.radius is None else slack / one.plane.radius)


def radius(one: Correction, slack: float) -> Cell:
    """Give what must be told of the radius m of a counterweight."""
    return Cell(one.radius, 0.0 if one.plane.mass is None else slack / one.plane.mass)


def _millimetres(one: Cell) -> Cell:
    return one if one.true is None else Cell(1000 * one.true, 1000 * one.slack)
