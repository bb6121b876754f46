"""What the tables of a machine's motion must say by the analysis: results, values at the edges, reduction (таблицы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from drawings.checks.dynamics.dynamics_expected import INERTIA, KNOWN, MOMENTS, SURPLUS, WORKS, Expected
from drawings.checks.dynamics.told_table import DueCell, DueTable
from drawings.lettering.thinning import every
from drawings.page.drafting import Drafting
from plans.checks.dynamics_comparison import DynamicsComparison
from plans.model.account import Account
from plans.model.dynamics import TURN, Cycle, Reduced
from plans.model.edge_names import edge_names
from plans.model.motion import Floats

RESULTS, POSITIONS = "results", "positions"
DIGITS, FINER, PLACES = 5, 6, 3  # of values at the edges; of results; of per cents after the mark
COUNTS = (36, 12, 8)  # positions that are told at the most, as the paper takes them
LOST = 1e-9  # of the largest work: all that a turn of weights leaves over
SEEN = 1e-3  # of the largest moment: a smaller jump cannot be seen
HEADS = ("quantity", "by plan", "by analysis", "true error")
REDUCED = (("φ", "°"), ("M_{red}", "N*m"), ("J_{red}", "kg*m2"), ("dJ/dφ", "kg*m2"))
EDGES = (
    ("φ", "°"),
    ("M_{us}", "N*m"),
    ("A_{us}", "J"),
    ("ΔT", "J"),
    ("ΔJ", "kg*m2"),
    ("ω", "rad/s"),
    ("ε", "rad/s2"),
)
METHODS = (("by Mertsalov", "mertsalov"), ("by Gutyar", "gutyar"), ("without δ²", "book"))

Told = tuple[str, str, float, float]  # letter, unit, value, what a difference of it is told of


def results(expected: Expected, comparison: DynamicsComparison, drafting: Drafting) -> DueTable:
    """Give what both roads find, and by how much the strips are out; then the inertia by other methods."""
    heads = [drafting.word(key) for key in HEADS]
    pairs = zip(*(_told(one, drafting.notation) for one in (expected.account, comparison.exact)), strict=True)
    rows: dict[str, Sequence[DueCell | None]] = {}
    for (letter, unit, own, _), (_, _, exact, whole) in pairs:
        rows[_named(letter, unit, drafting)] = (_fine(own), _fine(exact), _share(own, exact, whole))
    methods, wheel = comparison.methods, comparison.exact.flywheel
    for key, name in METHODS if methods is not None and wheel is not None else ():
        value, whole = float(getattr(methods, name)), wheel.whole if wheel is not None else 0.0
        rows[f"J_0 {drafting.word(key)}"] = (None, _fine(value), _share(value, whole, abs(whole)))
    return DueTable(RESULTS, heads, rows)


def _told(account: Account, notation: str) -> Iterator[Told]:
    """Give each quantity of the results; the parts of a length are told in shares of it."""
    cycle, wheel, speeds = account.cycle, account.flywheel, account.speeds
    if cycle is not None:
        lost = abs(cycle.work[-1]) <= LOST * np.abs(cycle.work).max()
        work = 0.0 if lost else -float(cycle.work[-1])
        mean = 0.0 if lost else cycle.driving
        yield from (("M_{dr}", "N*m", mean, abs(mean)), ("A_{us}(2π)", "J", work, abs(work)))
    if wheel is not None:
        (low, high), there = wheel.cuts, wheel.own + wheel.present
        both, missing = abs(low) + abs(high), max(wheel.whole - there, 0.0)
        for letter, cut in (("o_1k", high), ("o_1l", low)):
            yield f"{letter}/K_T" if notation == "K" else f"{letter}·μ_T", "J", cut, both
        yield from (("J_0", "kg*m2", wheel.whole, abs(wheel.whole)), ("T_0", "J", wheel.energy, abs(wheel.energy)))
        yield from (("J_0^*", "kg*m2", there, abs(there)), ("J_{fly}", "kg*m2", missing, missing))
    if speeds is not None:
        low, high = speeds.extremes
        delta = 2 * (high - low) / (high + low)
        yield from (("ω_{max}", "rad/s", high, high), ("ω_{min}", "rad/s", low, low), ("δ", "", delta, delta))


def _named(letter: str, unit: str, drafting: Drafting) -> str:
    return drafting.letter(letter) + (f", {drafting.word(unit)}" if unit else "")


def _fine(value: float) -> DueCell:
    return DueCell(value, KNOWN * abs(value), FINER)


def _share(own: float, exact: float, whole: float) -> DueCell:
    """Give a difference in per cent of a whole; of nothing there is no share."""
    if not whole:
        return DueCell(np.nan)
    return DueCell(100 * (own - exact) / whole, 200 * KNOWN * max(abs(own), whole) / whole, 0, PLACES)


def edges(expected: Expected, most: int, drafting: Drafting) -> DueTable:
    """Give the values at both ends, at jumps on both sides, and every so many positions that `most` have room."""
    cycle, task = expected.cycle, expected.task
    jumped = jumps(cycle)
    names, step = edge_names(cycle.turned, task.divisions), every(task.divisions / most, task.divisions)
    rows: dict[str, Sequence[DueCell | None]] = {}
    after, before = (_cells(columns) for columns in _sides(expected))
    for k, name in enumerate(names):
        if k in jumped:
            rows |= {f"{name}−0": before[k], f"{name}+0": after[k]}
        elif k in (0, len(names) - 1) or (name.isdigit() and int(name) % step == 0):
            rows[name] = after[k]
    return DueTable(POSITIONS, ["i", *(_named(letter, unit, drafting) for letter, unit in EDGES)], rows)


def jumps(cycle: Cycle) -> list[int]:
    """Give the inner edges at which the moment jumps to the eye."""
    apart = np.abs(cycle.moments[1:, 0] - cycle.moments[:-1, 1])
    return list((np.flatnonzero(apart > SEEN * np.abs(cycle.moments).max()) + 1).tolist())


def _sides(expected: Expected) -> tuple[list[Floats], list[Floats]]:
    """Give the columns behind the edges, and before them: there the moment and the acceleration are others."""
    cycle, graphs, speeds = expected.cycle, expected.graphs, expected.account.speeds
    angles = 360 * cycle.turned / TURN
    none = np.full(len(angles), np.nan)
    omega, after, before = none, none, none
    if speeds is not None:
        omega, sides = speeds.omega, speeds.epsilon
        after, before = np.append(sides[:, 0], sides[-1, 1]), np.append(np.nan, sides[:, 1])
    own = [angles, *(graphs[name] for name in (MOMENTS, WORKS, SURPLUS, INERTIA)), omega, after]
    return own, [angles, expected.before, none, none, none, none, before]


def _cells(columns: Sequence[Floats]) -> list[list[DueCell]]:
    """Give the cells of all rows; rounding is counted in shares of the largest of a column."""
    slacks = [KNOWN * float(np.nanmax(np.abs(column), initial=0.0)) for column in columns]
    return [
        [DueCell(float(value), slack, DIGITS) for value, slack in zip(row, slacks, strict=True)]
        for row in zip(*columns, strict=True)
    ]


def reduction(reduced: Reduced, drafting: Drafting) -> DueTable:
    """Give the reduced moment and inertia at the positions, where there is no steady turn."""
    columns = [360 * reduced.phi / TURN, reduced.moment, reduced.inertia, reduced.slope]
    rows: Mapping[str, Sequence[DueCell | None]] = {str(k): row for k, row in enumerate(_cells(columns))}
    return DueTable(POSITIONS, ["i", *(_named(letter, unit, drafting) for letter, unit in REDUCED)], rows)
