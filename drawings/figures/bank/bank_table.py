"""The tables of a bank: its orders before and after, its compensators (таблицы блока)."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence

from drawings.figures.bank.compensator_layout import COUPLED, MASS
from drawings.layout.table import RuledTable, TableRow, table
from drawings.layout.value_table import BY_HAND, row_by_hand
from drawings.layout.value_table import DIGITS as FIGURES
from drawings.lettering.bank_letters import lowered
from drawings.page.drafting import Drafting
from drawings.report.balance.bank_notes import direction
from plans.bank.letters import FORCE, MOMENT, STATIC, letters, roman
from plans.checks.balance.bank_comparison import EQUILIBRIUM
from plans.checks.comparison import Comparison, Finding
from plans.model.balance.bank import BankBalance, Compensator

ORDERS, COMPENSATORS, RESULTS = "orders", "compensators", "results"  # the names of the tables
ORDER_HEADS = ("one force", "bank force", "force left", "bank moment")
COMPENSATOR_HEADS = ("m·r, kg·m", "m, kg", "r, mm", "shaft speed", "φ, °")
DIGITS = 5
NOTHING = "—"


def orders(balance: BankBalance, drafting: Drafting) -> RuledTable:
    """Tell of each order the largest force of one mechanism, of the bank, what is left of it, and the moment."""
    answered = {one.asked.order for one in balance.compensators}
    lines = []
    for order, single in balance.single.items():
        force = balance.forces[order].size
        sizes = single.size, force, 0.0 if order in answered else force, balance.moments[order].size
        lines.append(TableRow(str(order), tuple(drafting.number(one, DIGITS) for one in sizes)))
    heads = tuple(drafting.word(head) for head in ORDER_HEADS)
    return table(lines, drafting.word("order"), heads, drafting.hand.text)._replace(name=ORDERS)


def compensators(balance: BankBalance, drafting: Drafting) -> RuledTable | None:
    """Tell each mass of the compensators; None where there are none."""
    lines = [row for one in balance.compensators for row in _masses(one, balance, drafting)]
    heads = tuple(drafting.word(head) for head in COMPENSATOR_HEADS)
    if not lines:
        return None
    return table(lines, drafting.word("mass number"), heads, drafting.hand.text)._replace(name=COMPENSATORS)


def results(comparison: Comparison, by_hand: bool, drafting: Drafting) -> RuledTable | None:
    """Tell what both roads found of every order and of the compensators, and what a hand may be out; None of nothing.

    Without `by_hand` there is no polygon in which a hand might err.
    """
    heads = tuple(drafting.word(head) for head in (BY_HAND if by_hand else BY_HAND[:-1]))
    lines = [_result(one, drafting) for one in compared(comparison)]
    lines = [line._replace(cells=line.cells[: len(heads)]) for line in lines]
    if not lines:
        return None
    return table(lines, drafting.word("quantity"), heads, drafting.hand.text)._replace(name=RESULTS)


def _result(one: Finding, drafting: Drafting) -> TableRow:
    """Give the row of a finding: values to their own digits, as orders differ by powers."""
    known = float(one.allowed[0]) * 10 ** (FIGURES - 1)
    own = one._replace(largest=max(float(abs(one.analysis[0])), known))  # rounding has no digits
    return row_by_hand(own, f"{lowered(one.name)}, {drafting.word(one.unit)}", (0,), drafting.language)


def compared(comparison: Comparison) -> list[Finding]:
    """List what the table of results tells."""
    return [one for one in comparison.findings if _is_told(one)]


def _is_told(one: Finding) -> bool:
    """Tell whether a finding stands in the table of results: a vector of the bank or a mass, more than rounding."""
    kept = one.name.partition("_")[0] in (FORCE, MOMENT, STATIC) and one.plan != EQUILIBRIUM
    return kept and abs(one.analysis[0]) > one.allowed[0]


def _masses(one: Compensator, balance: BankBalance, drafting: Drafting) -> Iterator[TableRow]:
    """Give the rows of the masses that are needed."""
    order, mass, speed = one.asked.order, one.asked.mass, balance.task.speed
    slack = balance.forces[order].slack / (order * speed) ** 2
    for moment, angle, sense in ((one.with_crank, one.with_angle, 1), (one.against, one.against_angle, -1)):
        if angle is not None:
            far = None if mass is None else 1000 * moment / mass
            cells = _cells(
                (moment, mass, far, sense * order * speed, direction(cmath.rect(moment, angle), slack)), drafting
            )
            yield TableRow(lowered(letters(MASS, sense * order)), cells)
    if one.couple_angle is not None:
        moment = max(one.with_crank, one.against)
        angle = direction(cmath.rect(moment, one.couple_angle), slack)
        cells = _cells((one.couple, None, None, order * speed, angle), drafting)
        yield TableRow(lowered(f"{COUPLED}{roman(order)}"), cells)


def _cells(values: Sequence[float | None], drafting: Drafting) -> tuple[str, ...]:
    return tuple(NOTHING if one is None else drafting.number(one, DIGITS) for one in values)
