"""The rows that the charts of a cyclogram must show, by the analysis alone: bars and rings (строки циклограммы)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Final, NamedTuple

from drawings.checks.expected import Expected
from drawings.paper.strokes import Kind
from plans.model.cam import Cam
from plans.model.cyclogram import BACK, BEGIN, END, ENTRY, EXIT, LEAVE, SLIVER, TURN, BarRow, Cyclogram, Period, within

# From which level of its row to which the line of a span leads: 0 the lower, 1 the upper.
LEVELS: Final = {
    "rise": (0.0, 1.0),
    "dwell": (1.0, 1.0),
    "return": (1.0, 0.0),
    "rest": (0.0, 0.0),
    "work": (0.0, 1.0),
    "idle": (1.0, 0.0),
    "cut": (1.0, 1.0),
    "overrun": (0.0, 0.0),
    "back over": (0.0, 0.0),
    "free": (1.0, 0.0),
}
BARS, SETTING = "bars", "set."  # the chart; how the names of setting angles begin
UPPER = 0.07  # rad of the abscissa: so far over its lower level is the upper one of a row
ANGLE = 1e-9  # rad: what both roads may differ by


class BarStretch(NamedTuple):
    """A part of a span between turns of the chart's abscissa, rad, with the levels at its ends."""

    span: Period
    start: float
    end: float
    low: float
    high: float


def chart(rows: Sequence[BarRow], begin: float = 0.0) -> Iterator[Expected]:
    """Give the lines of the bar chart, each of a span or a setting angle."""
    yield from (Expected(Kind.VECTOR, BARS, name, value, ANGLE) for name, value in true_bars(rows, begin))


def true_bars(rows: Sequence[BarRow], begin: float) -> Iterator[tuple[str, complex]]:
    """Give the lines that there must be, by their names: across rad, upwards shares of a row."""
    for k, row in enumerate(rows, 1):
        for number, stretch in enumerate((stretch for span in row.spans for stretch in parts(span, begin)), 1):
            yield f"{k}.{number}", complex(stretch.end - stretch.start, UPPER * (stretch.high - stretch.low))
    for number, row in enumerate((row for row in rows if row.setting), 1):
        zero, there = (within(turned - begin) for turned in (0.0, row.setting or 0.0))
        yield f"{SETTING}{number}", complex(there - zero)


def machine_rows(found: Cyclogram, cams: Sequence[Cam]) -> tuple[BarRow, ...]:
    """Give the rows of a machine: its strokes, its tool, its cams, or where there are none when one may move."""
    begin, end = (found.of(role)[0].turned for role in (BEGIN, END))
    strokes = Period(begin, _after(begin, end), "work"), Period(end, _after(end, begin), "idle")
    machine = BarRow("strokes", strokes), BarRow("tool", tuple(_tool(found)))
    return *machine, *(cam_rows(cams) or (_feed(found),))


def cam_rows(cams: Sequence[Cam]) -> tuple[BarRow, ...]:
    """Give a row for each cam that turns, its phases counted from its setting angle on."""
    return tuple(BarRow(cam.name, tuple(_phases(cam)), cam.setting) for cam in cams if not cam.translates)


def parts(span: Period, begin: float) -> Iterator[BarStretch]:
    """Cut a span where the chart's abscissa, which begins at a turn, ends."""
    first, size, (low, high) = within(span.start - begin), span.end - span.start, LEVELS[span.kind]
    cuts = [0.0, TURN - first, size] if first + size > TURN + SLIVER else [0.0, size]
    for cut, other in pairwise(cuts):
        start = first + cut - (TURN if cut else 0.0)
        levels = (low + (high - low) * gone / size for gone in (cut, other))
        yield BarStretch(span, start, start + other - cut, *levels)


def _phases(cam: Cam) -> Iterator[Period]:
    lowest = min(level for phase in cam.phases for level in (phase.level, phase.level + phase.change))
    kinds = ["rest" if phase.kind == "dwell" and phase.level == lowest else phase.kind for phase in cam.phases]
    for k, phase in enumerate(cam.phases):
        kind = kinds[k]
        label = kind if kinds.count(kind) == 1 else f"{kind}\N{NO-BREAK SPACE}{kinds[: k + 1].count(kind)}"
        yield Period(cam.setting + phase.start, cam.setting + phase.end, kind, label)


def _tool(found: Cyclogram) -> Iterator[Period]:
    """Give what the tool does between its places: it works from where it comes to the work to where it leaves it."""
    places = {role: stops[0].turned for role in (BEGIN, ENTRY, EXIT, END, BACK, LEAVE) if (stops := found.of(role))}
    at, work = places[BEGIN], (places.get(ENTRY, places[BEGIN]), places.get(EXIT, places[END]))
    over = places.get(BACK, places[END]), places.get(LEAVE, at)
    turns = sorted(within(turned - at) for turned in set(places.values()))
    for start, end in pairwise((*turns, TURN)):
        middle = at + (start + end) / 2
        kind = "cut" if _between(middle, *work) else "back over" if _between(middle, *over) else "overrun"
        yield Period(at + start, at + end, kind)


def _feed(found: Cyclogram) -> BarRow:
    """Give when an auxiliary mechanism may move: its rise while the tool is off the work, then it is free."""
    first, last = (LEAVE, ENTRY) if found.of(LEAVE) else (EXIT, BACK)
    start, end = (found.of(role)[0].turned for role in (first, last))
    end = _after(start, end)
    return BarRow("feed", (Period(start, end, "rise", "rise"), Period(end, start + TURN, "free")), start)


def _after(start: float, end: float) -> float:
    """Give a turn that comes after another within one turn of the shaft, rad."""
    return start + (end - start) % TURN


def _between(turned: float, start: float, end: float) -> bool:
    return (turned - start) % TURN < (end - start) % TURN
