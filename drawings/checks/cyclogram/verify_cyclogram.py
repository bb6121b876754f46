"""The self-check of a cyclogram sheet: plan, charts, table, notes against the analysis (проверка листа)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.checks import reading
from drawings.checks.cyclogram import characteristic, cyclogram_charts, cyclogram_told, due_rows
from drawings.checks.cyclogram.cyclogram_bars import BarStrokes
from drawings.checks.cyclogram.cyclogram_charts import BARS, CIRCLE
from drawings.checks.cyclogram.cyclogram_rings import RingStrokes
from drawings.checks.cyclogram.cyclogram_told import TABLE
from drawings.checks.documents_old import title_block, together
from drawings.checks.graphs.scale_line import ratio
from drawings.checks.linkage.laid import ground
from drawings.checks.wrong import Wrong, on
from drawings.measure.measure import Measured
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Leaf
from plans.checks.cyclogram_comparison import CyclogramComparison
from plans.cyclogram.study import CYCLOGRAM, CyclogramStudy
from plans.study import Study


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold all that one sheet of a cyclogram shows against the analysis (row of the table of sheets)."""
    return check(measured, leaf, study[CYCLOGRAM], study.comparison(CYCLOGRAM))


def set_faults(sheets: Sequence[tuple[Measured, Leaf]], study: Study) -> Iterator[Wrong]:
    """See that the plan, both charts, the whole table and the notes stand on the sheets, each once."""
    leaves, found = [leaf for _, leaf in sheets], study.comparison(CYCLOGRAM).analysis
    yield from together.figures(leaves, (characteristic.PLAN, BARS, CIRCLE))
    yield from together.table(leaves, TABLE, cyclogram_told.names(found, drafting_of(study.scene)))
    yield from together.notes(leaves)


def check(measured: Measured, leaf: Leaf, study: CyclogramStudy, comparison: CyclogramComparison) -> Iterator[Wrong]:
    """Hold what a sheet shows against the analysis: the figures that its data name, table, notes, scales."""
    found, drafting = comparison.analysis, drafting_of(study.scene)
    rows, numbered = due_rows.rows(found, study.cams), [one.turned for one in found.positions]
    at = ground(measured) if characteristic.PLAN in leaf.metadata["figures"] else None
    if at is not None:
        yield from characteristic.faults(measured, leaf, study, found, at)
    elif characteristic.PLAN in leaf.metadata["figures"]:
        yield on("missing_on", characteristic.PLAN, name=study.linkage.mechanism.drive.end)
    if BARS in leaf.metadata["figures"]:
        yield from cyclogram_charts.bars(measured, rows, found.positions[0].turned)
        own = cyclogram_charts.chart(leaf, BARS)
        vectors = [one for one in measured.vectors if one.plan == BARS]
        yield from BarStrokes(own, rows, numbered, vectors, drafting).faults()
    if CIRCLE in leaf.metadata["figures"]:
        yield from cyclogram_charts.rings(leaf, rows, found.sense)
        yield from cyclogram_charts.names(leaf, rows, drafting)
        own = cyclogram_charts.chart(leaf, CIRCLE)
        yield from RingStrokes(own, rows, numbered, found.sense, drafting).faults()
    yield from reading.marked_scales(leaf)
    yield from cyclogram_charts.angles(leaf, rows, drafting)
    yield from cyclogram_told.table(leaf, found, drafting)
    yield from cyclogram_told.notes(leaf, comparison, study.cams, drafting)
    scale = "" if at is None else ratio(at.scale, drafting.language)
    yield from title_block.faults(leaf, study.scene, CYCLOGRAM, drafting.word("cyclogram sheet title"), scale)
