"""The table of values of a kinematics sheet read back: by plan, by analysis, by hand (проверка таблицы)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from drawings.checks import reading, table_grid
from drawings.checks.linkage import accord, by_hand
from drawings.checks.linkage.laid import mass_centres
from drawings.checks.wrong import Wrong
from drawings.lettering.words import letter, word
from drawings.measure.measure import Measured
from drawings.paper.strokes import Leaf, Text
from geometry import draughtsman, hand_error
from plans.checks.compare import MotionComparison
from plans.checks.comparison import Finding
from plans.checks.hand.motion import MotionByHand
from plans.linkage.study import LinkageStudy
from plans.model.order import ORDERS, PLANS
from plans.words.words import message

TABLE = "values"  # the name of the table


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
    named = _named([*comparison.findings, *told.parts], study.language)
    yield from reading.tables(leaf, named)
    for table in tables:
        yield from table_grid.faults(table, TABLE, by_hand.HEADS, study.language)
    yield from _labels(leaf, named, study.language)
    ruled, tried = (
        told.on_sheet(positions, leaf.metadata["scales"], slopes) for slopes in (hand_error.slopes, draughtsman.slopes)
    )
    yield from by_hand.wrong_cells(leaf, named, by_hand.Told(ruled, tried))
    yield from by_hand.missing_rows(leaf, [*_named(due_rows(comparison, told), study.language)])


def due_rows(comparison: MotionComparison, told: MotionByHand) -> list[Finding]:
    """List what the table must tell, by the analysis: of each plan points, parts, links; what the scene states is not.

    What is nothing but rounding needs no row, nor does a normal part that is the whole acceleration of its point.
    """
    found: list[Finding] = []
    for order in ORDERS[1:]:
        own = [one for one in comparison.of(order.plan) if _is_something(one)]
        parts = [one for one in told.parts if one.plan == order.plan and _is_something(one)]
        points = [one for one in own if one.unit == order.point.unit]
        beside = [one for one in parts if not _whole(one, {one.name for one in points}, {one.name for one in parts})]
        found += [*points, *beside, *(one for one in own if one not in points)]
    return [one for one in found if one.name not in told.given]


def _whole(part: Finding, points: set[str], parts: set[str]) -> bool:
    """Tell whether a part is a normal one beside which there is no tangential one."""
    name = part.name.replace("^n", "")
    return name != part.name and name in points and part.name.replace("^n", "^t") not in parts


def _is_something(one: Finding) -> bool:
    most = np.nanmax(np.abs(one.analysis), initial=0.0)
    return bool(most > 2 * np.nanmax(one.allowed, initial=0.0))


def _named(told: Sequence[Finding], language: str) -> dict[str, Finding]:
    """Give findings of velocities and accelerations by their letters as they are read."""
    plans = [order.plan for order in ORDERS[1:]]
    return {_letter(one, language): one for one in told if one.plan in plans}


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
