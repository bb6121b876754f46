"""The record of a bar chart of a cyclogram: what each mechanism does over the turn (прямоугольная циклограмма)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

import numpy as np

from drawings.due.machine_rows import BARS, true_bars
from drawings.due.machine_rows import rows as machine_rows
from drawings.grading import verdict
from drawings.grading.curves.asked_figure import BEARINGS, CHAIN, PRICKED, FigureAsked, Item, Mistake, Values
from drawings.grading.curves.figure_records import OwnSheet
from drawings.paper.strokes import Circle
from drawings.paper.walk import flat, group_named
from plans.model.cyclogram import Row
from plans.study import Study
from plans.words.words import because

CIRCLE = "circle"  # the name of the chart


def rings(own: OwnSheet, rows: Sequence[Row], sense: int) -> Iterator[FigureAsked]:
    """Give the bearings at which the spans of some rows begin, mm: to the outer circle of each ring."""
    group = group_named(own.leaf.groups, CIRCLE)
    radii = [] if group is None else sorted(one.radius for one in flat((group,)) if isinstance(one, Circle))
    if len(radii) != len(rows) + 1:
        return
    due = [
        (f"{k}.{number}", k, span.start) for k, row in enumerate(rows, 1) for number, span in enumerate(row.spans, 1)
    ]
    names, places, turned = zip(*due, strict=True)
    reach = np.array([radii[len(rows) + 1 - k] for k in places])
    true = np.asarray(reach * np.exp(1j * sense * np.array(turned)))
    yield FigureAsked(
        key=CIRCLE, plan=CIRCLE, sheet=own.name, unit="mm", scales={"": 1.0},
        items=tuple(Item(name, None, k, name) for k, name in enumerate(names)), true=true, slack=np.zeros(len(true)),
        error=np.full(len(true), PRICKED), kind=BEARINGS, on_paper=True, rings=places, why=because("ring_turn"),
        mistakes=(Mistake(verdict.MIRRORED, true.conj()), *_unset(rows, np.array(places), true, sense)),
    )  # fmt: skip


def _unset(
    rows: Sequence[Row], places: np.ndarray[tuple[int, ...], np.dtype[np.intp]], true: Values, sense: int
) -> Iterator[Mistake]:
    """Give the rings with a row that is not turned by its setting angle, and with all that are not."""
    turns = np.array([np.exp(-1j * sense * (row.setting or 0.0)) for row in rows])[places - 1]
    for k in (0, *(k for k, row in enumerate(rows, 1) if row.setting)):
        yield Mistake(verdict.UNSET, np.asarray(np.where((places == k) | (k == 0), true * turns, true)))


def figures_of(study: Study, own: OwnSheet) -> Iterator[FigureAsked]:
    """Give the bars of a machine's cyclogram (row of the table of records)."""
    found = study.comparison("cyclogram").analysis
    rows = machine_rows(found, study["cyclogram"].cams)
    yield from bars(own, rows, found.positions[0].turned)
    yield from rings(own, rows, found.sense)


def bars(own: OwnSheet, rows: Sequence[Row], begin: float) -> Iterator[FigureAsked]:
    """Give the bars of some rows, over an abscissa that begins at a turn."""
    marks = {one.name: one for one in own.measured.vectors if one.plan == BARS}
    true = {name: value for name, value in true_bars(rows, begin) if name in marks}
    if not true:
        return
    first = next(iter(marks.values()))
    feet = np.array([marks[name].start for name in true])
    yield FigureAsked(
        key=BARS, plan=BARS, sheet=own.name, unit=first.unit, scales={own.letter(BARS, first.scale): first.scale},
        items=tuple(Item(name, None, k, name) for k, name in enumerate(true)), true=np.array(list(true.values())),
        slack=np.zeros(len(true)), error=np.full(len(true), PRICKED), kind=CHAIN,
        paper=own.ruled(BARS, feet), mistakes=tuple(_exchanged(true)),
    )  # fmt: skip


def _exchanged(true: Mapping[str, complex]) -> Iterator[Mistake]:
    """Give the bars with two that follow one another in a row each as long as the other."""
    names = list(true)
    for one, other in pairwise(names):
        if one.partition(".")[0] == other.partition(".")[0]:
            values: Values = np.array(list(true.values()))
            k, m = names.index(one), names.index(other)
            values[k], values[m] = complex(true[other].real, true[one].imag), complex(true[one].real, true[other].imag)
            yield Mistake(verdict.EXCHANGED, values)
