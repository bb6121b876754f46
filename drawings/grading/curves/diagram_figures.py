"""The record of the kinematic diagrams: S, v and a of the output over the turn (кинематические диаграммы)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from drawings.due.diagrams import KEYS, ExpectedRow, expected_rows, named
from drawings.grading.curves.asked_figure import ORDINATES, PRICKED, FigureAsked, Item, Sizes, Values
from drawings.grading.curves.figure_records import OwnSheet
from plans.checks.diagrams_comparison import DiagramsComparison
from plans.model.diagrams import TURN
from plans.study import Study
from plans.words.words import because

VELOCITY = KEYS[1]


def figures_of(study: Study, own: OwnSheet) -> Iterator[FigureAsked]:
    """Give the kinematic diagrams of a sheet of kinematics (row of the table of records)."""
    shown = [key for key in KEYS if own.vectors(named(key))]
    comparison = study.comparison("diagrams") if shown else None
    if isinstance(comparison, DiagramsComparison):
        rows = {row.key: row for row in expected_rows(comparison)}
        speed = abs(study["linkage"].mechanism.drive.omega)
        yield from (_figure(own, rows, key, speed) for key in shown)


def _figure(own: OwnSheet, rows: Mapping[str, ExpectedRow], key: str, speed: float) -> FigureAsked:
    row, plan = rows[key], named(key)
    marks, places = own.vectors(plan), {number: k for k, number in reversed(list(enumerate(row.axis.numbers)))}
    mu, above = next(iter(marks.values())).scale, _above(key)
    whole = bool(np.isclose(row.axis.turned[-1] - row.axis.turned[0], TURN))
    paper = own.paper(plan, row.axis.turned, places)
    course = None if above is None else Slope(above, rows[above].at, row.at, row.axis.turned / speed, whole)
    seen = [] if above is None else list(own.vectors(named(above)).values())
    error = np.full(len(row.at), PRICKED)
    if paper is not None and seen:
        # Both ends of a chord over two positions are out; what their rise says of the derivative is out by so much.
        time = float(np.median(np.diff(row.axis.turned))) / speed
        error = np.full(len(row.at), float(np.hypot(PRICKED, PRICKED * seen[0].scale / (np.sqrt(2) * time * mu))))
    return FigureAsked(
        key=key, plan=plan, sheet=own.name, unit=next(iter(marks.values())).unit, scales={own.letter(plan, mu): mu},
        items=tuple(Item(one.name, k, places[k], f"{one.quantity}_{one.name}") for k, one in sorted(marks.items())),
        true=np.asarray(1j * row.at), slack=_slack(row), error=error, kind=ORDINATES, paper=paper,
        behind=() if above is None else (above,), course=course, linear=above is not None,
        why=None if above is None else because("derivative_point"),
        loose=frozenset(np.flatnonzero(np.isnan(rows[VELOCITY].at)).tolist()),
    )  # fmt: skip


def _above(key: str) -> str | None:
    """Give the diagram that another is the derivative of."""
    k = KEYS.index(key)
    return KEYS[k - 1] if k else None


def _slack(row: ExpectedRow) -> Sizes:
    """Give by how much a value at a position is out that is read off the curve by chords."""
    if row.key == KEYS[0]:  # which alone is not drawn by chords
        return np.zeros(len(row.at))
    return np.nan_to_num(np.abs(row.result(row.axis.turned) - row.at))


@dataclass(frozen=True)
class Slope:
    """A diagram as the slope of the one above it, which a student may have drawn otherwise."""

    above: str
    risen: Sizes  # the true one above
    true: Sizes
    times: Sizes  # s
    whole: bool  # whether the last position is the first again

    def __call__(self, own: Mapping[str, Values]) -> Values:
        """Give the derivative."""
        moved, times = own[self.above].imag - self.risen, self.times
        if self.whole:
            moved = np.concatenate((moved[-2:-1], moved, moved[1:2]))
            times = np.concatenate(([times[0] - times[-1] + times[-2]], times, [times[-1] + times[1] - times[0]]))
            return np.asarray(1j * (self.true + np.gradient(moved, times)[1:-1]))
        return np.asarray(1j * (self.true + np.gradient(moved, times)))
