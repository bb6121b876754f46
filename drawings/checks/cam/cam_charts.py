"""The self-check of the cyclogram of several cams: bars, rings, angles, notes (проверка циклограммы вала)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.checks import reading
from drawings.checks.cyclogram import cyclogram_charts, due_notes, due_rows
from drawings.checks.cyclogram.cyclogram_bars import BarStrokes
from drawings.checks.cyclogram.cyclogram_charts import BARS, CIRCLE
from drawings.checks.cyclogram.cyclogram_rings import RingStrokes
from drawings.checks.documents_old import written_notes
from drawings.checks.precise import precise
from drawings.checks.wrong import Wrong
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf
from plans.model.cam import Cam

DIGITS = 7  # of the numbers of the notes


def faults(measured: Measured, leaf: Leaf, cams: Sequence[Cam], drafting: Drafting) -> Iterator[Wrong]:
    """Hold the charts of a shaft against its cams as they are asked for."""
    turning = [one for one in cams if not one.translates]
    rows, shown = due_rows.cam_rows(turning), leaf.metadata["figures"]
    if BARS in shown:
        yield from cyclogram_charts.bars(measured, rows)
        vectors = [one for one in measured.vectors if one.plan == BARS]
        yield from BarStrokes(cyclogram_charts.chart(leaf, BARS), rows, (), vectors, drafting).faults()
    if CIRCLE in shown:
        yield from cyclogram_charts.rings(leaf, rows, turning[0].sense)
        yield from cyclogram_charts.names(leaf, rows, drafting)
        own = cyclogram_charts.chart(leaf, CIRCLE)
        yield from RingStrokes(own, rows, (), turning[0].sense, drafting).faults()
    yield from reading.marked_scales(leaf)
    yield from cyclogram_charts.angles(leaf, rows, drafting)
    yield from written_notes.faults(leaf, due_notes.settings(turning, precise(drafting)), (DIGITS,))
