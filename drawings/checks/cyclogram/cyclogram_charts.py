"""The self-check of the charts of a cyclogram, with a main mechanism or of cams alone (проверка циклограммы)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from drawings.checks.cyclogram.cyclogram_words import DIGITS, angle, row_name
from drawings.checks.cyclogram.due_rows import parts
from drawings.checks.precise import KNOWN, precise, tells
from drawings.checks.wrong import Wrong, on
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Arc, Group, Leaf
from drawings.paper.walk import groups, texts
from plans.model.cyclogram import Row, within
from plans.words.words import message

BARS, CIRCLE, RING = "bars", "circle", "ring"  # the names of the charts, and how those of the rings begin
BESIDE_RINGS = "ring-names"  # the names that have no room in their rings
SETTING = "set."  # the names of setting angles begin so
UPPER = 0.07  # rad of the abscissa: so far over its lower level is the upper one of a row
ANGLE = 1e-9  # rad: an arc of a leaf is not rounded yet


def bars(measured: Measured, rows: Sequence[Row], begin: float = 0.0) -> Iterator[Wrong]:
    """Hold the line of every span of the bar chart, and every setting angle, against the rows of the analysis."""
    true = dict(true_bars(rows, begin))
    seen = {one.name: one for one in measured.vectors if one.plan == BARS}
    for name in true.keys() | seen.keys():
        if name not in true:
            yield on("stranger_on", BARS, name=name)
        elif name not in seen:
            yield on("missing_on", BARS, name=name)
        elif not abs(seen[name].value - true[name]) <= ANGLE + 2 * measured.quantum * seen[name].scale:
            yield on("differs_on", BARS, name=name)


def true_bars(rows: Sequence[Row], begin: float) -> Iterator[tuple[str, complex]]:
    """Give the lines that there must be, by their names: across rad, upwards shares of a row."""
    for k, row in enumerate(rows, 1):
        own = [one for span in row.spans for one in parts(span, begin)]
        for number, one in enumerate(own, 1):
            yield f"{k}.{number}", complex(one.end - one.start, UPPER * (one.high - one.low))
    for number, row in enumerate((row for row in rows if row.setting), 1):
        zero, there = (within(turned - begin) for turned in (0.0, row.setting or 0.0))
        yield f"{SETTING}{number}", complex(there - zero)


def chart(leaf: Leaf, name: str) -> tuple[Group, ...]:
    """Give the groups of a chart: its lines, and the letters beside them."""
    return tuple(one for one in leaf.groups if one.name in (name, f"{name}-letters"))


def rings(leaf: Leaf, rows: Sequence[Row], sense: int) -> Iterator[Wrong]:
    """Hold the arcs of the rings against the rows of the analysis: each from where its span begins to its end."""
    drawn = {one.name: one for one in groups(leaf.groups) if one.name.startswith(f"{RING}-")}
    for k, row in enumerate(rows):
        name = f"{RING}-{k}"
        ring = drawn.get(name)
        arcs = [stroke for stroke in ring.strokes if isinstance(stroke, Arc)] if ring else []
        true = [sorted((sense * span.start, sense * span.end)) for span in row.spans]
        if len(arcs) != len(true):
            yield on("missing_on", CIRCLE, name=name)
        for arc, (low, high) in zip(arcs, true, strict=False):
            off = max(_apart(arc.start_angle, low), _apart(arc.end_angle, high))
            if not off <= ANGLE:
                yield on("differs_on", CIRCLE, name=name)


def names(leaf: Leaf, rows: Sequence[Row], drafting: Drafting) -> Iterator[Wrong]:
    """See that every ring bears its own name: within it, or beside it where it has no room."""
    rings = {one.name: one for one in groups(leaf.groups) if one.name.startswith(f"{RING}-")}
    beside = [rings[one] for one in (BESIDE_RINGS,) if one in rings]
    for k, row in enumerate(rows):
        name, number = row_name(row, drafting), f"{RING}-{k}"
        if not any(text.plain == name for text in texts([*beside, *(rings[one] for one in (number,) if one in rings)])):
            yield on("missing_on", CIRCLE, name=name)


def angles(leaf: Leaf, rows: Sequence[Row], drafting: Drafting) -> Iterator[Wrong]:
    """Read the angles that the charts tell back: each span's, where it has room for it, and no other."""
    exact = precise(drafting)
    for chart in (BARS, CIRCLE):
        due = [angle(span, exact) for row in rows for span in row.spans]
        turns = (math.degrees(within(row.setting)) for row in rows if row.setting is not None)
        due += [f"{exact.number(one)}°" for one in turns]
        for text in (text.plain for group in leaf.groups if group.name.startswith(chart) for text in texts((group,))):
            told = text.rsplit(" ", 1)[-1] if text.endswith("°") else ""
            if told[:1].isdigit() and "−" not in text and not any(tells(told, one, (DIGITS,), KNOWN) for one in due):
                yield message("wrong.told", text=text)


def _apart(one: float, other: float) -> float:
    return abs(math.remainder(one - other, math.tau))
