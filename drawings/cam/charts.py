"""The cyclogram of several cams on one shaft: linear and circular chart, settings (циклограмма кулачкового вала)."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from functools import partial
from typing import Any

from drawings.cyclogram import bar_chart, circular_chart
from drawings.cyclogram.bar_chart import Chart
from drawings.cyclogram.report import settings_of
from drawings.layout.contents import Panel
from drawings.page.drafting import Drafting
from drawings.sheets.stated_scales import Draft, Exhibit
from plans.cyclogram.rows import EVERY, rows_of_cams
from plans.model.cam import Cam


def drafts(cams: Sequence[Cam], drafting: Drafting) -> list[Draft]:
    """Give the draft of the charts; a cam alone has its phases on its own sheet."""
    turning = [one for one in cams if not one.translates]
    if len(turning) < 2:
        return []
    said, title = tuple(settings_of(turning, drafting)), drafting.word("cyclogram sheet title")
    return [Draft("cam", title, tuple(_shows(turning, drafting)), (), said, _facts)]


def _shows(cams: Sequence[Cam], drafting: Drafting) -> Iterator[Exhibit]:
    chart = Chart(rows_of_cams(cams))
    room = bar_chart.measure(chart, drafting)
    yield Exhibit(Panel(room), partial(bar_chart.draw, chart, room, drafting=drafting))
    room = circular_chart.measure(chart, drafting)
    yield Exhibit(Panel(room), partial(circular_chart.draw, chart, cams[0].sense, room, drafting=drafting))


def _facts(figures: Collection[str]) -> dict[str, Any]:
    return {"cam": EVERY, "figures": list(figures)}
