"""The table of values of a kinematics sheet read back: by plan, by analysis, by hand (проверка таблицы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from drawings.checks import reading, table_grid
from drawings.checks.linkage import accord, by_hand
from drawings.checks.linkage.laid import mass_centres
from drawings.checks.wrong import Wrong
from drawings.lettering.words import letter, word
from drawings.measure.measure import Measured
from drawings.paper.strokes import Group, Leaf, Text
from geometry import draughtsman, hand_error
from plans.checks.compare import MotionComparison
from plans.checks.comparison import Finding
from plans.checks.hand.motion import MotionByHand
from plans.linkage.study import LinkageStudy
from plans.model.order import ORDERS, PLANS
from plans.words.words import message

TABLE = "values"  # the name of the table
EQUAL = by_hand.EQUAL


def faults(measured: Measured, leaf: Leaf, study: LinkageStudy, comparison: MotionComparison) -> Iterator[Wrong]:
    """Read the table of values: each row that must be there, by plan, by analysis, and what a hand may be out."""
    tables = list(reading.value_tables(leaf))
    positions = sorted({k for table in tables for k in reading.positions_of(table)})
    yield from by_hand.wrong_scales(measured, leaf, PLANS)
    yield from accord.faults(leaf, comparison.findings, comparison.kappa, study.language)
    told = MotionByHand(study, comparison, mass_centres(study))
    if leaf.metadata["of"] == 1 and positions != sorted(leaf.metadata["plans"]) and due_rows(comparison, told):
        yield message("wrong.missing", name=TABLE)
    if not positions:
        return
    single = named([*comparison.findings, *told.parts], study.language)
    every = dict(_joined(tables, single))
    known = single | {head: same[0] for head, same in every.items()}
    yield from reading.tables(leaf, known)
    for head, same in every.items():
        for one in same[1:]:
            yield from reading.tables(leaf, {head: one})
    for table in tables:
        yield from table_grid.faults(table, TABLE, by_hand.HEADS, study.language)
    yield from _labels(leaf, known, study.language)
    ruled, tried = (
        told.on_sheet(positions, leaf.metadata["scales"], slopes) for slopes in (hand_error.slopes, draughtsman.slopes)
    )
    yield from by_hand.wrong_cells(leaf, known, by_hand.Told(ruled, tried))
    yield from by_hand.missing_rows(leaf, _with_same(named(due_rows(comparison, told), study.language)))


def due_rows(comparison: MotionComparison, told: MotionByHand) -> list[Finding]:
    """List what the table must tell, by the analysis: of each plan points, parts, links; what the scene states is not.

    What is nothing but rounding needs no row, nor does a normal part that is the whole acceleration of its point.
    """
    found: list[Finding] = []
    for order in ORDERS[1:]:
        own = [one for one in comparison.of(order.plan) if is_something(one)]
        parts = [one for one in told.parts if one.plan == order.plan and is_something(one)]
        points = [one for one in own if one.unit == order.point.unit]
        beside = [one for one in parts if not _whole(one, {one.name for one in points}, {one.name for one in parts})]
        found += [*points, *beside, *(one for one in own if one not in points)]
    return [one for one in found if one.name not in told.given]


def _whole(part: Finding, points: set[str], parts: set[str]) -> bool:
    """Tell whether a part is a normal one beside which there is no tangential one."""
    name = part.name.replace("^n", "")
    return name != part.name and name in points and part.name.replace("^n", "^t") not in parts


def is_something(one: Finding) -> bool:
    """Tell whether a finding is more than rounding in some position, by the analysis."""
    most = np.nanmax(np.abs(one.analysis), initial=0.0)
    return bool(most > 2 * np.nanmax(one.allowed, initial=0.0))


def named(told: Sequence[Finding], language: str) -> dict[str, Finding]:
    """Give findings of velocities and accelerations by their letters as they are read."""
    plans = [order.plan for order in ORDERS[1:]]
    return {_letter(one, language): one for one in told if one.plan in plans}


def _joined(tables: Sequence[Group], single: Mapping[str, Finding]) -> Iterator[tuple[str, list[Finding]]]:
    """Give the findings of each row that several names stand before: "vD = vS5"; all of them are known, and one.

    Vectors of equal size alone are not: the analysis has them equal in every position.
    """
    for head in (text.plain.rsplit(", ", 1)[0] for one in tables for row in reading.rows(one) for text in row):
        same = [single[name] for name in head.split(EQUAL) if name in single]
        if len(same) == head.count(EQUAL) + 1 > 1 and all(_one(same[0], other) for other in same[1:]):
            yield head, same


def _with_same(due: Mapping[str, Finding]) -> dict[str, frozenset[str]]:
    """Give with each row those before it that the analysis has equal to it in every position."""
    names = list(due)
    return {name: frozenset(one for one in names[:k] if _one(due[one], due[name])) for k, name in enumerate(names)}


def _one(first: Finding, other: Finding) -> bool:
    apart = np.abs(first.analysis - other.analysis)
    known = np.isfinite(apart)
    return first.unit == other.unit and bool(np.all(apart[known] <= (first.allowed + other.allowed)[known]))


def _letter(one: Finding, language: str) -> str:
    symbol, _, index = one.name.partition("_")
    return Text(0j, letter(language, f"{symbol}_{{{index}}}")).plain


def _labels(leaf: Leaf, named: dict[str, Finding], language: str) -> Iterator[Wrong]:
    """See that each row of a quantity has its unit."""
    units = {f"{name}, {Text(0j, word(language, one.unit)).plain}" for name, one in named.items()}
    for table in reading.value_tables(leaf):
        for row in reading.rows(table):
            head = row[0].plain
            if len(row) > len(by_hand.HEADS) - 1 and ", " in head and head not in units:
                yield message("wrong.told", text=head)
