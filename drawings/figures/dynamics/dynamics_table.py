"""The tables of a machine's motion: results by both roads and by other methods, values at the edges (таблицы)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.figures.dynamics.rays import Strips, strips
from drawings.layout.table import RuledTable, TableRow, table
from drawings.lettering.words import fixed
from drawings.page.drafting import Drafting
from drawings.report.dynamics_tables import NOISE, without_rounding
from plans.model.account import Account
from plans.model.dynamics import Cycle, Reduced, Speeds, Task
from plans.model.flywheel_methods import Methods
from plans.model.motion import Floats

RESULTS, POSITIONS = "results", "positions"
COLUMNS = ("by plan", "by analysis", "true error")  # strips and chords are out by what the exact curve is not
QUANTITIES = (
    ("φ", "°"), ("M_{us}", "N*m"), ("A_{us}", "J"), ("ΔT", "J"),
    ("ΔJ", "kg*m2"), ("ω", "rad/s"), ("ε", "rad/s2"),
)  # fmt: skip
REDUCED = (("φ", "°"), ("M_{red}", "N*m"), ("J_{red}", "kg*m2"), ("dJ/dφ", "kg*m2"))
MOST = 36  # positions that are told
DIGITS = 5
NOTHING = "—"


def positions(task: Task, account: Account, drafting: Drafting, most: int = MOST) -> RuledTable:
    """Tell the values at so many positions at most and at jumps, at these the moment before and behind.

    ε is that in the middle of the strip that begins there.
    """
    cycle = account.cycle
    assert cycle is not None  # else nothing is told of a turn
    named = strips(cycle, task.divisions)
    chosen = named.told(named.every(task.divisions / most))
    columns = _columns(cycle, account.speeds)
    lines = [row for k in chosen for row in _edge(named, columns, k, drafting)]
    heads = tuple(f"{drafting.letter(letter)}, {drafting.word(unit)}" for letter, unit in QUANTITIES)
    return table(lines, "i", heads, drafting.hand.text)._replace(name=POSITIONS)


def reduction(reduced: Reduced, drafting: Drafting) -> RuledTable:
    """Tell the reduced moment and inertia at the positions, where there is no steady turn."""
    heads = tuple(f"{drafting.letter(letter)}, {drafting.word(unit)}" for letter, unit in REDUCED)
    rows = zip(
        np.degrees(reduced.phi), *map(without_rounding, (reduced.moment, reduced.inertia, reduced.slope)), strict=True
    )
    lines = [TableRow(str(k), tuple(_cell(value, drafting) for value in row)) for k, row in enumerate(rows)]
    return table(lines, "i", heads, drafting.hand.text)._replace(name=POSITIONS)


class _Columns(NamedTuple):
    """What the table tells at the edges, in its order, and the moment before each."""

    rows: Floats  # (7, n + 1)
    before: Floats  # (7, n + 1): the moment and the acceleration alone


def _columns(cycle: Cycle, speeds: Speeds | None) -> _Columns:
    nothing = np.full(len(cycle.turned), np.nan)
    after, before = np.append(cycle.moments[:, 0], cycle.moments[-1, 1]), np.append(np.nan, cycle.moments[:, 1])
    motion, last = [nothing, nothing], nothing
    if speeds is not None:
        motion = [speeds.omega, np.append(speeds.epsilon[:, 0], speeds.epsilon[-1, 1])]
        last = np.append(np.nan, speeds.epsilon[:, 1])
    angles = np.degrees(cycle.turned)
    rows = [angles, -after, -cycle.work, cycle.surplus, cycle.varying, *motion]
    sides = [angles, -before, nothing, nothing, nothing, nothing, last]
    return _Columns(*(np.array([without_rounding(row) for row in one]) for one in (rows, sides)))


def _edge(named: Strips, columns: _Columns, k: int, drafting: Drafting) -> Iterator[TableRow]:
    """Give the row of an edge, two of one at which a load jumps."""
    name, jumps = named.names[k], k in named.jumps
    own = columns.rows[:, k].tolist()
    if jumps:
        before = columns.before[:, k].tolist()
        yield TableRow(f"{name}−0", tuple(_cell(value, drafting) for value in before))
    yield TableRow(f"{name}+0" if jumps else name, tuple(_cell(value, drafting) for value in own))


def _cell(value: float, drafting: Drafting) -> str:
    return NOTHING if not np.isfinite(value) else drafting.number(float(value) + 0.0, DIGITS)


def results(own: Account, exact: Account, methods: Methods | None, drafting: Drafting) -> RuledTable:
    """Tell what both roads found, and by how much the strips are out; then the inertia by other methods."""
    pairs = zip(_values(own, drafting), _values(exact, drafting), strict=True)
    lines = [_compared(one, two, drafting) for one, two in pairs]
    lines += _others(exact, methods, drafting)
    heads = tuple(drafting.word(head) for head in COLUMNS)
    return table(lines, drafting.word("quantity"), heads, drafting.hand.text)._replace(name=RESULTS)


class _Value(NamedTuple):
    """What is compared: letter, unit, value, and of what its difference is told; without that, of itself."""

    letter: str
    unit: str
    value: float
    whole: float | None = None


def _values(account: Account, drafting: Drafting) -> Iterator[_Value]:
    """Give what is compared; segments are parts of one length, however small one of them is."""
    cycle, wheel, speeds = account.cycle, account.flywheel, account.speeds
    if cycle is not None:
        lost = np.abs(cycle.work[-1]) <= NOISE * np.abs(cycle.work).max()  # all that a turn of weights leaves over
        yield _Value("M_{dr}", "N*m", 0.0 if lost else cycle.driving)
        yield _Value("A_{us}(2π)", "J", 0.0 if lost else -float(cycle.work[-1]))
    if wheel is not None:
        both = sum(map(abs, wheel.cuts))
        yield from (
            _Value(drafting.true("o_1k", "T"), "J", wheel.cuts[1], both),
            _Value(drafting.true("o_1l", "T"), "J", wheel.cuts[0], both),
        )
        yield from (_Value("J_0", "kg*m2", wheel.whole), _Value("T_0", "J", wheel.energy))
        yield from (_Value("J_0^*", "kg*m2", wheel.own + wheel.present), _Value("J_{fly}", "kg*m2", wheel.inertia))
    if speeds is not None:
        yield from (
            _Value("ω_{max}", "rad/s", speeds.extremes[1]),
            _Value("ω_{min}", "rad/s", speeds.extremes[0]),
            _Value("δ", "", speeds.delta),
        )


def _compared(own: _Value, exact: _Value, drafting: Drafting) -> TableRow:
    named = drafting.letter(own.letter) + (f", {drafting.word(own.unit)}" if own.unit else "")
    numbers = (drafting.number(one.value, DIGITS + 1) for one in (own, exact))
    return TableRow(named, (*numbers, _share(own.value, exact.value, exact.whole, drafting)))


def _share(own: float, exact: float, whole: float | None, drafting: Drafting) -> str:
    """Write a difference in per cent of the exact value, or of what it is a part of."""
    size = abs(exact) if whole is None else whole
    return fixed(100 * (own - exact) / size, drafting.language, 3) if size else NOTHING


def _others(exact: Account, methods: Methods | None, drafting: Drafting) -> Sequence[TableRow]:
    """Give the rows of other methods, each with its difference from the exact value."""
    if methods is None or exact.flywheel is None:
        return ()
    named = {"by Mertsalov": methods.mertsalov, "by Gutyar": methods.gutyar, "without δ²": methods.book}
    whole = exact.flywheel.whole
    cells = (
        (key, ("", drafting.number(value, DIGITS + 1), _share(value, whole, None, drafting)))
        for key, value in named.items()
    )
    return tuple(TableRow(f"J_0 {drafting.word(key)}", row) for key, row in cells)
