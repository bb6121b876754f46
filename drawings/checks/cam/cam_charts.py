"""The self-check of the cyclogram of several cams: bars, rings, angles, notes (проверка циклограммы вала)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from drawings.checks import cyclogram_charts, reading
from drawings.checks.wrong import Wrong, within
from drawings.figures.cyclogram import bar_chart, circular_chart
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf
from drawings.report.cyclogram_notes import settings_of
from plans.cyclogram.rows import rows_of_cams
from plans.model.cam import Cam


def faults(measured: Measured, leaf: Leaf, cams: Sequence[Cam], drafting: Drafting) -> Iterator[Wrong]:
    """Hold the charts of a shaft against its cams as they are asked for."""
    turning = [one for one in cams if not one.translates]
    rows = rows_of_cams(turning)
    if bar_chart.NAME in leaf.metadata["figures"]:
        yield from cyclogram_charts.bars(measured, rows)
    if circular_chart.NAME in leaf.metadata["figures"]:
        yield from cyclogram_charts.rings(leaf, rows, turning[0].sense)
        yield from cyclogram_charts.names(leaf, rows, drafting)
    yield from reading.marked_scales(leaf)
    yield from cyclogram_charts.angles(leaf, rows, drafting)
    if leaf.metadata["number"] == leaf.metadata["of"] and leaf.description != " ".join(settings_of(turning, drafting)):
        yield within("in", "notes", text=leaf.description)
