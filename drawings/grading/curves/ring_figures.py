"""The record of a circular cyclogram: where each span begins in the ring of its row (круговая циклограмма)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from drawings.grading import verdict
from drawings.grading.curves.asked_figure import BEARINGS, PRICKED, FigureAsked, Item, Mistake, Values
from drawings.grading.curves.own_sheet import OwnSheet
from drawings.paper.strokes import Circle
from drawings.paper.walk import flat, group_named
from plans.model.cyclogram import Row
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
