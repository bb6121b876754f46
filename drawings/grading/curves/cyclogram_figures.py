"""The record of a bar chart of a cyclogram: what each mechanism does over the turn (прямоугольная циклограмма)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

import numpy as np

from drawings.due.machine_rows import BARS, true_bars
from drawings.due.machine_rows import rows as machine_rows
from drawings.grading import verdict
from drawings.grading.curves.asked_figure import CHAIN, PRICKED, FigureAsked, Item, Mistake, Values
from drawings.grading.curves.own_sheet import OwnSheet
from drawings.grading.curves.ring_figures import rings
from plans.model.cyclogram import Row
from plans.study import Study


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
