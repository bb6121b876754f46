"""What must stand on the sheet of a cyclogram by the analysis alone: bars, rings, table (лист циклограммы)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Final, NamedTuple

import numpy as np

from drawings.checks.expected import Expected
from drawings.layout.table import cell_name
from drawings.linkage.due import mass_centres, measures
from drawings.page.scale import drafting_of
from drawings.paper.statement import Kind
from drawings.paper.strokes import Leaf
from plans.analytic.points import placed
from plans.linkage.quantities import road_of
from plans.model.cam import Cam
from plans.model.cyclogram import BACK, BEGIN, END, ENTRY, EXIT, LEAVE, SLIVER, TURN, Cyclogram, Row, Span, within
from plans.model.mechanism import FRAME
from plans.model.motion import POSITIONS
from plans.study import Study

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


class Stretch(NamedTuple):
    """A part of a span between turns of the chart's abscissa, rad, with the levels at its ends."""

    span: Span
    start: float
    end: float
    low: float
    high: float


def chart(own: Sequence[Row], begin: float = 0.0) -> Iterator[Expected]:
    """Give the lines of the bar chart, each of a span or a setting angle."""
    for name, value in true_bars(own, begin):
        yield Expected(Kind.VECTOR, BARS, name, value, ANGLE)


def true_bars(own: Sequence[Row], begin: float) -> Iterator[tuple[str, complex]]:
    """Give the lines that there must be, by their names: across rad, upwards shares of a row."""
    for k, row in enumerate(own, 1):
        for number, one in enumerate((one for span in row.spans for one in parts(span, begin)), 1):
            yield f"{k}.{number}", complex(one.end - one.start, UPPER * (one.high - one.low))
    for number, row in enumerate((row for row in own if row.setting), 1):
        zero, there = (within(turned - begin) for turned in (0.0, row.setting or 0.0))
        yield f"{SETTING}{number}", complex(there - zero)


def machine_rows(found: Cyclogram, cams: Sequence[Cam]) -> tuple[Row, ...]:
    """Give the rows of a machine: its strokes, its tool, its cams, or where there are none when one may move."""
    begin, end = (found.of(role)[0].turned for role in (BEGIN, END))
    strokes = Span(begin, _after(begin, end), "work"), Span(end, _after(end, begin), "idle")
    own = Row("strokes", strokes), Row("tool", tuple(_tool(found)))
    return *own, *(cam_rows(cams) or (_feed(found),))


def cam_rows(cams: Sequence[Cam]) -> tuple[Row, ...]:
    """Give a row for each cam that turns, its phases counted from its setting angle on."""
    return tuple(Row(one.name, tuple(_phases(one)), one.setting) for one in cams if not one.translates)


def parts(span: Span, begin: float) -> Iterator[Stretch]:
    """Cut a span where the chart's abscissa, which begins at a turn, ends."""
    first, size, (low, high) = within(span.start - begin), span.end - span.start, LEVELS[span.kind]
    cuts = [0.0, TURN - first, size] if first + size > TURN + SLIVER else [0.0, size]
    for one, other in pairwise(cuts):
        start = first + one - (TURN if one else 0.0)
        levels = (low + (high - low) * gone / size for gone in (one, other))
        yield Stretch(span, start, start + other - one, *levels)


def _phases(cam: Cam) -> Iterator[Span]:
    lowest = min(level for one in cam.phases for level in (one.level, one.level + one.change))
    kinds = ["rest" if one.kind == "dwell" and one.level == lowest else one.kind for one in cam.phases]
    for k, one in enumerate(cam.phases):
        own = kinds[k]
        label = own if kinds.count(own) == 1 else f"{own}\N{NO-BREAK SPACE}{kinds[: k + 1].count(own)}"
        yield Span(cam.setting + one.start, cam.setting + one.end, own, label)


def _tool(found: Cyclogram) -> Iterator[Span]:
    """Give what the tool does between its places: it works from where it comes to the work to where it leaves it."""
    places = {role: one[0].turned for role in (BEGIN, ENTRY, EXIT, END, BACK, LEAVE) if (one := found.of(role))}
    at, work = places[BEGIN], (places.get(ENTRY, places[BEGIN]), places.get(EXIT, places[END]))
    over = places.get(BACK, places[END]), places.get(LEAVE, at)
    turns = sorted(within(one - at) for one in set(places.values()))
    for start, end in pairwise((*turns, TURN)):
        middle = at + (start + end) / 2
        kind = "cut" if _between(middle, *work) else "back over" if _between(middle, *over) else "overrun"
        yield Span(at + start, at + end, kind)


def _feed(found: Cyclogram) -> Row:
    """Give when an auxiliary mechanism may move: its rise while the tool is off the work, then it is free."""
    first, last = (LEAVE, ENTRY) if found.of(LEAVE) else (EXIT, BACK)
    start, end = (found.of(role)[0].turned for role in (first, last))
    end = _after(start, end)
    return Row("feed", (Span(start, end, "rise", "rise"), Span(end, start + TURN, "free")), start)


def _after(start: float, end: float) -> float:
    """Give a turn that comes after another within one turn of the shaft, rad."""
    return start + (end - start) % TURN


def _between(turned: float, start: float, end: float) -> bool:
    return (turned - start) % TURN < (end - start) % TURN


CHARACTERISTIC, TABLE = "characteristic", "stations"
FAR = 1e-9  # of the mechanism's size: both roads agree in a place far better
ANGLES, LENGTHS, WHOLE = 1e-5, 1e-3, 360.0  # degrees and mm that both roads may differ by; a turn
INFINITE = "∞"


def due(study: Study, leaves: Sequence[Leaf]) -> Iterator[Expected]:
    """Give what must stand on the sheets of a scene's cyclogram (row of the table of sheets)."""
    found: Cyclogram = study.comparison("cyclogram").analysis
    rows = machine_rows(found, study["cyclogram"].cams)
    yield from chart(rows, found.positions[0].turned)
    yield from _table(study, found)
    for leaf in leaves[:1]:
        yield from _plan(study, found, leaf.metadata["characteristic"])
        for one in measures(study["linkage"], study.comparison("linkage"), drafting_of(study.scene)):
            yield one._replace(may_lack=True)


def _plan(study: Study, found: Cyclogram, shown: int) -> Iterator[Expected]:
    """Give the crank's pins of all positions, and the points of the one in full lines."""
    own = study["cyclogram"]
    mechanism, turned = own.pictured.mechanism, [one.turned for one in found.positions]
    # The sketch is of the first position of the scene: there the analysis is assembled, and goes on to the others.
    phi = np.concatenate([own.linkage.turn.phi[:1], found.sense * np.array(turned)])
    motion = road_of(own.linkage).motion(phi, 0)
    drive, fixed = mechanism.drive, mechanism.links[FRAME].points
    places = {name: complex(one.r[1 + shown]) for name, one in motion.points.items()} | dict(fixed)
    size = max(abs(place) for place in places.values())
    for name, place in places.items():
        if name != drive.pivot:
            yield Expected(Kind.POINT, POSITIONS.plan, name, place, FAR * size, shown)
    for name, (link, centre) in mass_centres(own.pictured).items():
        spot = complex(placed(mechanism, motion, link, centre)[1 + shown])
        yield Expected(Kind.POINT, POSITIONS.plan, name, spot, FAR * size, shown)
    for k, pin in enumerate(motion.points[drive.end].r[1:].tolist()):
        lacks = k == shown
        yield Expected(Kind.POINT, CHARACTERISTIC, f"{drive.end}_{k}", complex(pin), FAR * size, k, may_lack=lacks)


def _table(study: Study, found: Cyclogram) -> Iterator[Expected]:
    """Give the cells of the table: place of the tool, turn of the shaft by both roads, how sharp it is."""
    word = drafting_of(study.scene).word
    for k, one in enumerate(found.positions):
        row = f"{k}  {word(f'role {one.role}')}"
        gone = one.share * (1000 * found.stroke if found.sliding else math.degrees(found.stroke))
        turned, rests = math.degrees(one.turned), one.role in (BEGIN, END)
        yield Expected(Kind.NUMBER, TABLE, cell_name(row, 0), gone, LENGTHS)
        for column in (1, 2):
            yield Expected(Kind.NUMBER, TABLE, cell_name(row, column), turned, ANGLES, period=WHOLE)
        condition = INFINITE if rests else one.condition
        yield Expected(Kind.NUMBER, TABLE, cell_name(row, 3), condition, FAR, digits=3)
