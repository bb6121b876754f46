"""The table of values of a kinematics sheet read back: by plan, by analysis, by hand (проверка таблицы)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.checks import reading
from drawings.checks.linkage import accord, by_hand
from drawings.checks.linkage.laid import mass_centres
from drawings.checks.wrong import Wrong
from drawings.layout import value_table
from drawings.measure.measure import Measured
from drawings.paper.strokes import Leaf, Text
from geometry import draughtsman, hand_error
from plans.checks.compare import MotionComparison
from plans.checks.hand.motion import MotionByHand
from plans.linkage.study import LinkageStudy
from plans.model.order import PLANS


def faults(measured: Measured, leaf: Leaf, study: LinkageStudy, comparison: MotionComparison) -> Iterator[Wrong]:
    """Read the table of values: each row that must be there, by plan, by analysis, and what a hand may be out."""
    positions = sorted({k for table in reading.value_tables(leaf) for k in reading.positions_of(table)})
    yield from by_hand.wrong_scales(measured, leaf, PLANS)
    yield from accord.faults(leaf, comparison.findings, comparison.kappa, study.language)
    if not positions:
        return
    told = MotionByHand(study, comparison, mass_centres(study))
    due = value_table.told(comparison, told.parts)
    named = {Text(0j, value_table.label(one, study.language)).plain.rsplit(", ", 1)[0]: one for one in due}
    yield from reading.tables(leaf, named)
    ruled, tried = (
        told.on_sheet(positions, leaf.metadata["scales"], slopes) for slopes in (hand_error.slopes, draughtsman.slopes)
    )
    yield from by_hand.wrong_cells(leaf, named, by_hand.Told(ruled, tried))
    yield from by_hand.missing_rows(leaf, [name for name, one in named.items() if one.name not in told.given])
