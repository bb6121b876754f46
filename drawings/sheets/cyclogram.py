"""The sheet of the cyclogram: plan of characteristic positions, bar chart, circular chart, table (циклограмма)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import partial
from typing import Any

from drawings.figures.cyclogram import bar_chart, characteristic_plan, characteristic_table, circular_chart
from drawings.figures.cyclogram.bar_chart import Chart
from drawings.layout.contents import Panel
from drawings.page.drafting import Drafting, drafting_of
from drawings.paper.strokes import Leaf
from drawings.report.cyclogram_notes import CyclogramNotes
from drawings.sheets.leaves import lay_out
from drawings.sheets.stated_scales import Caption, Draft, Exhibit
from plans.checks.cyclogram_comparison import CyclogramComparison
from plans.cyclogram.rows import rows_of
from plans.cyclogram.study import CYCLOGRAM, CyclogramStudy
from plans.study import Study

FOREMOST = 1.5  # the plan is the figure from which angles are read


def leaves(study: Study) -> tuple[Leaf, ...]:
    """Lay out the sheets of a scene's cyclogram (row of the table of sheets)."""
    return sheets(study[CYCLOGRAM], study.comparison(CYCLOGRAM))


def sheets(study: CyclogramStudy, comparison: CyclogramComparison) -> tuple[Leaf, ...]:
    """Lay out the sheets of a cyclogram whose two roads are compared."""
    drafting = drafting_of(study.scene)
    figures = _plan(study, drafting), *_charts(study, drafting)
    said = CyclogramNotes(study.cyclogram, study.cams, drafting).all
    title = drafting.word("cyclogram sheet title")

    def facts(names: Collection[str]) -> dict[str, Any]:
        shown = characteristic_plan.shown_of(study.cyclogram)
        return {"figures": list(names), "characteristic": shown}

    return lay_out(study.scene, [Draft(CYCLOGRAM, title, (*figures, _table(comparison, drafting)), (), said, facts)])


def chart_of(study: CyclogramStudy) -> Chart:
    """Give what the charts show; the turn begins at the first extreme."""
    turned = tuple(one.turned for one in study.cyclogram.positions)
    return Chart(rows_of(study.cyclogram, study.cams), turned, turned[0])


def _plan(study: CyclogramStudy, drafting: Drafting) -> Exhibit:
    bones = characteristic_plan.bones_of(study)
    room = characteristic_plan.measure(bones, drafting)
    return Exhibit(Panel(room, FOREMOST), partial(characteristic_plan.draw, study, bones, room, drafting=drafting))


def _charts(study: CyclogramStudy, drafting: Drafting) -> Iterator[Exhibit]:
    chart, sense = chart_of(study), study.cyclogram.sense
    room = bar_chart.measure(chart, drafting)
    yield Exhibit(Panel(room), partial(bar_chart.draw, chart, room, drafting=drafting))
    room = circular_chart.measure(chart, drafting)
    yield Exhibit(Panel(room), partial(circular_chart.draw, chart, sense, room, drafting=drafting))


def _table(comparison: CyclogramComparison, drafting: Drafting) -> Caption:
    table = characteristic_table.characteristic(comparison, drafting)
    return Caption(Panel(table.block(table.name)), partial(table.write, drafting=drafting))
