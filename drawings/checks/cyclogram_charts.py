"""The self-check of the charts of a cyclogram, with a main mechanism or of cams alone (проверка циклограммы)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from drawings.checks.precise import precise, tells
from drawings.checks.wrong import Wrong, on
from drawings.figures.cyclogram import bar_chart, circular_chart, course
from drawings.figures.cyclogram.bar_chart import HIGH, LOW, SETTING
from drawings.figures.cyclogram.course import stretches
from drawings.measure.measure import Measured
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Arc, Leaf, Text
from drawings.paper.walk import groups, texts
from plans.model.cyclogram import Row, within
from plans.words.words import message

ANGLE = 1e-9  # rad: an arc of a leaf is not rounded yet
SHARE = 1e-9  # of a number, that the two roads may differ by


def bars(measured: Measured, rows: Sequence[Row], begin: float = 0.0) -> Iterator[Wrong]:
    """Hold the line of every span of the bar chart, and every setting angle, against the rows of the analysis."""
    true = dict(_true(rows, begin))
    seen = {one.name: one for one in measured.vectors if one.plan == bar_chart.NAME}
    for name in true.keys() | seen.keys():
        if name not in true:
            yield on("stranger_on", bar_chart.NAME, name=name)
        elif name not in seen:
            yield on("missing_on", bar_chart.NAME, name=name)
        elif not abs(seen[name].value - true[name]) <= ANGLE + 2 * measured.quantum * seen[name].scale:
            yield on("differs_on", bar_chart.NAME, name=name)


def _true(rows: Sequence[Row], begin: float) -> Iterator[tuple[str, complex]]:
    """Give the lines that there must be, by their names: across rad, upwards shares of a row."""
    for k, row in enumerate(rows, 1):
        parts = [one for span in row.spans for one in stretches(span, begin)]
        for number, one in enumerate(parts, 1):
            yield f"{k}.{number}", complex(one.end - one.start, (HIGH - LOW) * (one.high - one.low))
    for number, row in enumerate((row for row in rows if row.setting), 1):
        zero, there = (within(turned - begin) for turned in (0.0, row.setting or 0.0))
        yield f"{SETTING}{number}", complex(there - zero)


def rings(leaf: Leaf, rows: Sequence[Row], sense: int) -> Iterator[Wrong]:
    """Hold the arcs of the rings against the rows of the analysis: each from where its span begins to its end."""
    drawn = {one.name: one for one in groups(leaf.groups) if one.name.startswith(f"{circular_chart.RING_NAME}-")}
    for k, row in enumerate(rows):
        name = f"{circular_chart.RING_NAME}-{k}"
        ring = drawn.get(name)
        arcs = [stroke for stroke in ring.strokes if isinstance(stroke, Arc)] if ring else []
        true = [sorted((sense * span.start, sense * span.end)) for span in row.spans]
        if len(arcs) != len(true):
            yield on("missing_on", circular_chart.NAME, name=name)
        for arc, (low, high) in zip(arcs, true, strict=False):
            off = max(_apart(arc.start_angle, low), _apart(arc.end_angle, high))
            if not off <= ANGLE:
                yield on("differs_on", circular_chart.NAME, name=name)


def names(leaf: Leaf, rows: Sequence[Row], drafting: Drafting) -> Iterator[Wrong]:
    """See that every ring bears its own name: within it, or beside it where it has no room."""
    rings = {one.name: one for one in groups(leaf.groups) if one.name.startswith(f"{circular_chart.RING_NAME}-")}
    beside = [rings[one] for one in (circular_chart.BESIDE_RINGS,) if one in rings]
    for k, row in enumerate(rows):
        name, number = Text(0j, course.name(row, drafting)).plain, f"{circular_chart.RING_NAME}-{k}"
        if not any(text.plain == name for text in texts([*beside, *(rings[one] for one in (number,) if one in rings)])):
            yield on("missing_on", circular_chart.NAME, name=name)


def angles(leaf: Leaf, rows: Sequence[Row], drafting: Drafting) -> Iterator[Wrong]:
    """Read the angles that the charts tell back: each span's, where it has room for it, and no other."""
    exact = precise(drafting)
    for chart in (bar_chart.NAME, circular_chart.NAME):
        due = [course.angle(span, exact) for row in rows for span in row.spans]
        due += [course.setting(row, exact) for row in rows if row.setting is not None]
        for text in (text.plain for group in leaf.groups if group.name.startswith(chart) for text in texts((group,))):
            told = text.rsplit(" ", 1)[-1] if text.endswith("°") else ""
            if (
                told[:1].isdigit()
                and "−" not in text
                and not any(tells(told, one, (course.DIGITS,), SHARE) for one in due)
            ):
                yield message("wrong.told", text=text)


def _apart(one: float, other: float) -> float:
    return abs(math.remainder(one - other, math.tau))
