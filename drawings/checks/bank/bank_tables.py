"""The self-check of the tables of a bank: each row that must be there, each cell to its last digit (таблицы)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping

from drawings.checks import reading
from drawings.checks.bank.bank_expected import Body, Expected
from drawings.checks.documents_old import ruled
from drawings.checks.linkage import accord
from drawings.checks.linkage import by_hand as hand
from drawings.checks.rotor.rotor_tables import Cell
from drawings.checks.wrong import Wrong, within
from drawings.figures.bank.bank_table import COMPENSATORS, ORDERS, RESULTS
from drawings.lettering.bank_letters import lowered
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import groups
from geometry import draughtsman, hand_error
from plans.bank.harmonics import HARMONICS
from plans.bank.letters import FORCE, MOMENT, SINGLE, STATIC, letters
from plans.bank.study import BankStudy
from plans.checks.comparison import Finding
from plans.checks.hand.bank import FIGURES, bank_by_hand
from plans.model.balance.bank import Compensator, Harmonic

HEADS = {
    ORDERS: ("order", "one force", "bank force", "force left", "bank moment"),
    COMPENSATORS: ("mass number", "m·r, kg·m", "m, kg", "r, mm", "shaft speed", "φ, °"),
}
UNITS = {FORCE: "N", MOMENT: "N*m", STATIC: "kg*m"}  # of the results by their letters
CELLS = 2, 3  # of a row of results beside its name, without and with the column of the hand


def faults(leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Read both tables of a sheet back."""
    rows = {ORDERS: dict(_orders(expected)), COMPENSATORS: dict(_compensators(expected))}
    for name, due in rows.items():
        heading = [Text(0j, drafting.word(key)).plain for key in HEADS[name]]
        yield from _table(leaf, name, due, heading)
    yield from _results(leaf, expected, drafting)


def due(expected: Expected) -> Iterator[str]:
    """Name the tables that the sheets must bear."""
    yield ORDERS
    if expected.compensated:
        yield COMPENSATORS
    if any(map(compared, expected.comparison.findings)):
        yield RESULTS


def by_hand(leaf: Leaf, bank: BankStudy, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Hold what a hand may be out in the polygons, and what the notes say of both roads."""
    told = [one for one in expected.comparison.findings if compared(one)]
    due = {Text(0j, lowered(one.name)).plain: one._replace(largest=_largest(one)) for one in told}
    scales = leaf.metadata["scales"]
    polygons = any(name.startswith(tuple(FIGURES.values())) for name in scales)
    both = (bank_by_hand(bank, scales, slopes) for slopes in (hand_error.slopes, draughtsman.slopes))
    yield from hand.wrong_results(leaf, RESULTS, due, hand.Told(*both) if polygons else None, drafting.language)
    yield from accord.apart(leaf, told, drafting.language, polygons)
    heads = [Text(0j, drafting.word(key)).plain for key in (hand.HEADS if polygons else hand.HEADS[:-1])]
    for part in (one for one in groups(leaf.groups) if one.name.removeprefix(f"{RESULTS}-").isdigit()):
        yield from ruled.faults(part, RESULTS, heads)


def _largest(one: Finding) -> float:
    """Give what the digits of a row are counted from: its own value, or what rounding leaves no digits of."""
    return max(float(abs(one.analysis[0])), float(one.allowed[0]) * 10.0 ** (hand.PLACES - 1))


def _results(leaf: Leaf, expected: Expected, drafting: Drafting) -> Iterator[Wrong]:
    """Read the table of what both roads found back: every vector and every mass that is more than rounding."""
    due = {Text(0j, lowered(one.name)).plain: one for one in expected.comparison.findings if compared(one)}
    own = [one for one in groups(leaf.groups) if one.name.removeprefix(f"{RESULTS}-").isdigit()]
    seen = dict[str, int]()
    for group in own:
        for text, name, _ in reading.wrong_values(group, due, (0,)):
            yield within("cell", RESULTS, name=name, text=text)
        for first, *cells in ([text.plain for text in row] for row in reading.rows(group)):
            name, _, unit = first.rpartition(", ")
            seen[name] = len(cells)
            if name in due and unit != Text(0j, drafting.word(UNITS[due[name].name.partition("_")[0]])).plain:
                yield within("row", RESULTS, name=first)
    yield from (within("row", RESULTS, name=name) for name, count in seen.items() if name in due and count not in CELLS)
    if own or leaf.metadata["of"] == 1:
        yield from (within("missing_from", RESULTS, name=one.name) for name, one in due.items() if name not in seen)


def compared(one: Finding) -> bool:
    """Tell whether a finding must stand there: a vector of an order of the bank, or a static moment of a mass."""
    told = one.plan in (HARMONICS, COMPENSATORS) and one.name.startswith(("F_", "M_", "mr_"))
    return told and abs(one.analysis[0]) > one.allowed[0]


def _table(leaf: Leaf, name: str, due: Mapping[str, list[Cell]], heading: list[str]) -> Iterator[Wrong]:
    own = [one for one in groups(leaf.groups) if one.name.removeprefix(f"{name}-").isdigit()]
    for part in own:
        yield from ruled.faults(part, name, heading)
    seen, headed = set[str](), 0
    for first, *cells in ([text.plain for text in row] for group in own for row in reading.rows(group)):
        if [first, *cells] == heading:
            headed += 1
        elif first not in due or first in seen:
            yield within("in", name, text=first)
        elif len(cells) != len(due[first]):
            yield within("row", name, name=first)
        else:
            seen.add(first)
            wrong = (text for text, cell in zip(cells, due[first], strict=True) if not cell.holds(text))
            yield from (within("cell", name, name=first, text=text) for text in wrong)
    if headed != len(own):
        yield within("in", name, text=heading[0])
    if own or leaf.metadata["of"] == 1:  # of several sheets one bears it
        yield from (within("missing_from", name, name=one) for one in due if one not in seen)


def _orders(expected: Expected) -> Iterator[tuple[str, list[Cell]]]:
    """Give what must be told of each order: of one mechanism, of the bank, what is left, and the moment."""
    answered = {one.asked.order for one in expected.analysis.compensators}
    for order, single in expected.analysis.single.items():
        force, moment = expected.analysis.forces[order], expected.analysis.moments[order]
        cells = [_size(expected, SINGLE, single), _size(expected, FORCE, force)]
        cells += [Cell(0.0) if order in answered else cells[1], _size(expected, MOMENT, moment)]
        yield str(order), cells


def _size(expected: Expected, kind: str, one: Harmonic) -> Cell:
    """Give the largest that two vectors turning against each other come to: both along one line."""
    sizes = [abs(one.ahead), abs(one.back)]
    slack = 2 * expected.allowed[letters(kind, one.order)]
    return Cell(0.0 if max(sizes) <= one.slack else math.fsum(sizes), slack)


def _compensators(expected: Expected) -> Iterator[tuple[str, list[Cell]]]:
    """Give what must be told of each mass: of those of a couple the first stands for both."""
    for one in expected.analysis.compensators:
        for body in expected.bodies(one):
            if not body.name.endswith("'"):
                yield Text(0j, lowered(body.name)).plain, _cells(expected, one, body)


def _cells(expected: Expected, one: Compensator, body: Body) -> list[Cell]:
    slack, mass = expected.slack_of(one), None if body.coupled else one.asked.mass
    far = Cell(None) if mass is None else Cell(1000 * body.moment / mass, 1000 * slack / mass)
    angle = math.degrees(cmath.phase(body.way / expected.turn))
    turned = Cell(angle, math.degrees(2 * slack / body.moment), True)
    return [Cell(body.moment, slack), Cell(mass), far, Cell(body.turns * expected.task.speed), turned]
