"""The tables of a machine's motion: results by both roads and by other methods, values at the edges (таблицы)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from drawings.figures.dynamics.strips import strips
from drawings.layout.table import RuledTable, TableRow, table
from drawings.layout.value_table import COLUMNS
from drawings.lettering.words import fixed
from drawings.page.drafting import Drafting
from plans.model.account import Account
from plans.model.dynamics import Task
from plans.model.flywheel_methods import Methods

RESULTS, POSITIONS = "results", "positions"
QUANTITIES = (
    ("φ", "°"), ("M_{us}", "N*m"), ("A_{us}", "J"), ("ΔT", "J"), ("ΔJ", "kg*m2"), ("ω", "rad/s"), ("ε", "rad/s2"),
)  # fmt: skip
MOST = 36  # rows of positions: of more strips every so many are told
DIGITS = 5
NOTHING = "—"


def positions(task: Task, account: Account, drafting: Drafting) -> RuledTable:
    """Tell the values at the edges; at a jump the moment before it and behind it, ε from an edge to the next one."""
    lines = [row for k in told(account, task) for row in _edge(task, account, k, drafting)]
    heads = tuple(f"{drafting.letter(letter)}, {drafting.word(unit)}" for letter, unit in QUANTITIES)
    return table(lines, "i", heads, drafting.hand.text)._replace(name=POSITIONS)


def told(account: Account, task: Task) -> tuple[int, ...]:
    """Choose the edges that are told: all, or of many every so many with those at which a load jumps."""
    cycle = account.cycle
    assert cycle is not None  # else nothing is told of it
    last = len(cycle.turned) - 1
    every = -(-last // MOST)
    return tuple(sorted({*range(0, last, every), last, *strips(cycle, task.divisions).jumps}))


def _edge(task: Task, account: Account, k: int, drafting: Drafting) -> Iterator[TableRow]:
    cycle, speeds = account.cycle, account.speeds
    assert cycle is not None
    named, last = strips(cycle, task.divisions), len(cycle.turned) - 1
    name, jumps = named.names[k], k in named.jumps
    own = [float(np.degrees(cycle.turned[k])), -cycle.moments[min(k, last - 1), 0 if k < last else 1]]
    own += [-cycle.work[k], cycle.surplus[k], cycle.varying[k]]
    own += [speeds.omega[k] if speeds else None, speeds.epsilon[k] if speeds and k < last else None]
    if jumps:
        yield TableRow(f"{name}−0", tuple(_cell(v, drafting) for v in (own[0], -cycle.moments[k - 1, 1], *[None] * 5)))
    yield TableRow(f"{name}+0" if jumps else name, tuple(_cell(value, drafting) for value in own))


def _cell(value: float | None, drafting: Drafting) -> str:
    return NOTHING if value is None or not np.isfinite(value) else drafting.number(float(value) + 0.0, DIGITS)


def results(own: Account, exact: Account, methods: Methods | None, drafting: Drafting) -> RuledTable:
    """Tell what both roads found, with the difference; then the inertia by other methods."""
    pairs = zip(_values(own), _values(exact), strict=True)
    lines = [_compared(name, unit, one, two, drafting) for (name, unit, one), (_, _, two) in pairs]
    lines += _others(exact, methods, drafting)
    heads = tuple(drafting.word(head) for head in COLUMNS)
    return table(lines, drafting.word("quantity"), heads, drafting.hand.text)._replace(name=RESULTS)


def _values(account: Account) -> Iterator[tuple[str, str, float]]:
    """Give what is compared: letter, unit, value."""
    cycle, wheel, speeds = account.cycle, account.flywheel, account.speeds
    if cycle is not None:
        yield "M_{dr}", "N*m", cycle.driving
        yield "A_{us}(2π)", "J", -float(cycle.work[-1])
    if wheel is not None:
        yield from (("o_1k·μ_T", "J", wheel.cuts[1]), ("o_1l·μ_T", "J", wheel.cuts[0]))
        yield from (("J_0", "kg*m2", wheel.whole), ("T_0", "J", wheel.energy))
        yield from (("J_0^*", "kg*m2", wheel.own + wheel.present), ("J_{fly}", "kg*m2", wheel.inertia))
    if speeds is not None:
        yield from (("ω_{max}", "rad/s", speeds.extremes[1]), ("ω_{min}", "rad/s", speeds.extremes[0]))
        yield "δ", "", speeds.delta


def _compared(name: str, unit: str, own: float, exact: float, drafting: Drafting) -> TableRow:
    named = drafting.letter(name) + (f", {drafting.word(unit)}" if unit else "")
    return TableRow(
        named, (drafting.number(own, DIGITS + 1), drafting.number(exact, DIGITS + 1), _share(own, exact, drafting))
    )


def _share(own: float, exact: float, drafting: Drafting) -> str:
    """Write a difference in per cent of the exact value."""
    return fixed(100 * (own - exact) / abs(exact), drafting.language, 3) if exact else NOTHING


def _others(exact: Account, methods: Methods | None, drafting: Drafting) -> Sequence[TableRow]:
    """Give the rows of other methods, each with its difference from the exact value."""
    if methods is None or exact.flywheel is None:
        return ()
    named = {"by Mertsalov": methods.mertsalov, "by Gutyar": methods.gutyar, "without δ²": methods.book}
    whole = exact.flywheel.whole
    cells = (
        (key, ("", drafting.number(value, DIGITS + 1), _share(value, whole, drafting))) for key, value in named.items()
    )
    return tuple(TableRow(f"J_0 {drafting.word(key)}", row) for key, row in cells)
