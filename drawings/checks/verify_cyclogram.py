"""The self-check of a cyclogram sheet: plan, charts, table, notes against the analysis (проверка листа)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from drawings.checks import cyclogram_charts, cyclogram_told, reading
from drawings.checks.cyclogram.cyclogram_bars import BarStrokes
from drawings.checks.cyclogram.cyclogram_rings import RingStrokes
from drawings.checks.linkage.laid import mass_centres
from drawings.checks.wrong import Wrong, on
from drawings.figures.cyclogram import bar_chart, characteristic_plan, circular_chart
from drawings.measure.measure import Measured
from drawings.page.drafting import drafting_of
from drawings.paper.strokes import Leaf
from plans.analytic.balance.mass_centre import placed
from plans.checks.compare import road_of
from plans.checks.cyclogram_comparison import CyclogramComparison
from plans.cyclogram.rows import rows_of
from plans.cyclogram.study import CYCLOGRAM, CyclogramStudy
from plans.model.cyclogram import Cyclogram
from plans.model.mechanism import FRAME
from plans.model.order import POSITIONS
from plans.study import Study

FAR = 1e-9  # of the mechanism's size, or rad: both roads agree in a place far better


def faults(measured: Measured, leaf: Leaf, study: Study) -> Iterator[Wrong]:
    """Hold all that one sheet of a cyclogram shows against the analysis (row of the table of sheets)."""
    return check(measured, leaf, study[CYCLOGRAM], study.comparison(CYCLOGRAM))


def check(measured: Measured, leaf: Leaf, study: CyclogramStudy, comparison: CyclogramComparison) -> Iterator[Wrong]:
    """Hold what a sheet shows against the analysis: the figures that its data name, table, notes, scales."""
    found, drafting = comparison.analysis, drafting_of(study.scene)
    rows, numbered = rows_of(found, study.cams), [one.turned for one in found.positions]
    if characteristic_plan.NAME in leaf.metadata["figures"]:
        yield from _places(measured, leaf, study, found)
        yield from cyclogram_told.dimensions(leaf, found, drafting)
    if bar_chart.NAME in leaf.metadata["figures"]:
        yield from cyclogram_charts.bars(measured, rows, found.positions[0].turned)
        own = tuple(one for one in leaf.groups if one.name in _chart(bar_chart.NAME))
        vectors = [one for one in measured.vectors if one.plan == bar_chart.NAME]
        yield from BarStrokes(own, rows, numbered, vectors, drafting).faults()
    if circular_chart.NAME in leaf.metadata["figures"]:
        yield from cyclogram_charts.rings(leaf, rows, found.sense)
        yield from cyclogram_charts.names(leaf, rows, drafting)
        own = tuple(one for one in leaf.groups if one.name in _chart(circular_chart.NAME))
        yield from RingStrokes(own, rows, numbered, found.sense, drafting).faults()
    yield from reading.marked_scales(leaf)
    yield from cyclogram_charts.angles(leaf, rows, drafting)
    yield from cyclogram_told.table(leaf, found, drafting)
    yield from cyclogram_told.notes(leaf, comparison, study.cams, drafting)


def _chart(name: str) -> tuple[str, str]:
    """Name the groups of a chart: its lines, and the letters beside them."""
    return name, f"{name}-letters"


def _places(measured: Measured, leaf: Leaf, study: CyclogramStudy, found: Cyclogram) -> Iterator[Wrong]:
    """Hold the crank's pins and the points of the position in full lines against the analysis; none may be missing."""
    true = _true(study, found, leaf.metadata["characteristic"])
    seen = {(one.plan, one.name): one for one in measured.points}
    size = max(abs(value) for value in true.values())
    for (plan, name), value in true.items():
        mark = seen.get((plan, name))
        if mark is None:
            yield on("missing_on", characteristic_plan.NAME, name=name)
        elif not abs(mark.value - value) <= FAR * size + 2 * measured.quantum * mark.scale:
            yield on("differs_on", characteristic_plan.NAME, name=name)
    yield from (on("stranger_on", characteristic_plan.NAME, name=name) for plan, name in seen.keys() - true.keys())


def _true(study: CyclogramStudy, found: Cyclogram, shown: int) -> dict[tuple[str, str], complex]:
    """Give the places that the plan must show, m from the datum, by plan and name."""
    road, mechanism = road_of(study.linkage), study.linkage.mechanism
    motion = road.motion(found.sense * np.array([one.turned for one in found.positions]), 0)
    end, fixed = mechanism.drive.end, mechanism.links[FRAME].points
    pins = motion.points[end].r
    places = {
        (POSITIONS.plan, name): complex(points.r[shown])
        for name, points in motion.points.items()
        if name != mechanism.drive.pivot
    }
    places |= {(POSITIONS.plan, name): place for name, place in fixed.items() if name != mechanism.drive.pivot}
    places |= {
        (POSITIONS.plan, name): complex(placed(mechanism, motion, link, own)[shown])
        for name, (link, own) in mass_centres(study.linkage).items()
    }
    numbered = (k for k in range(len(pins)) if k != shown)
    return places | {(characteristic_plan.NAME, f"{end}_{k}"): complex(pins[k]) for k in numbered}
