"""The records of load diagrams, kinematic diagrams, charts of a cyclogram and arms of compensators (диаграммы)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from drawings.cyclogram.due_rows import BARS
from drawings.diagrams.due import KEYS, ExpectedRow, expected_rows, named
from drawings.forces.due_acting import branches
from drawings.forces.load_diagram import NAME as LOAD
from drawings.grading import verdict
from drawings.grading.curves.figure_records import LENGTHS, ORDINATES, FigureAsked, Mistake, SceneSheet, by_number
from drawings.reading.marks import MeasuredVector
from plans.diagrams.quantities import DiagramsComparison
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.model.diagrams import TURN
from plans.model.machine import Force, Moment
from plans.model.motion import Complexes, Floats
from plans.study import Study
from plans.words.words import because

OVERRUNS = ("overrun_1", "overrun_2")
SWING = "ψ"
WHOLE = ("H", SWING)  # the stroke of what slides, of what swings


def figures_of_loads(study: Study, sheet: SceneSheet) -> Iterator[FigureAsked]:
    """Give the load diagrams of a sheet: the stroke and its overruns, and the ordinates at the corners."""
    for load in study.of(Statics).machine.loads:
        plan = f"{LOAD}-{load.name}"
        marks = {name: mark for (name, _), mark in sheet.marks(plan).items()}
        whole = next((marks[name] for name in WHOLE if name in marks), None)
        if isinstance(whole, MeasuredVector):
            names = (whole.name, *(name for name in OVERRUNS if name in marks))
            sizes = {(name, None): k for k, name in enumerate(names)}
            yield from sheet.figure(f"{plan} sizes", plan, sizes, kind=LENGTHS, why=because("tool_stroke"))
            corners = (mark for name, mark in marks.items() if name not in names)
            yield from _corners(sheet, load, whole, [mark for mark in corners if isinstance(mark, MeasuredVector)])


class Corner(NamedTuple):
    """A corner of a load by its law: where on the stroke, shares; how large, N or N*m, there and at the other end."""

    share: float
    size: float
    mirrored: float


def _corners(
    sheet: SceneSheet, load: Force | Moment, whole: MeasuredVector, drawn: Sequence[MeasuredVector]
) -> Iterator[FigureAsked]:
    if not drawn:
        return
    law, first, step = list(_law(load)), drawn[0], whole.value.real / whole.scale

    def of(mark: MeasuredVector) -> Corner:
        """Give the corner that a mark of our own sheet is of: on paper the nearest."""
        at = complex(mark.start.real - whole.start.real, mark.value.imag / mark.scale)
        return min(law, key=lambda corner: abs(complex(corner.share * step, corner.size / mark.scale) - at))

    corners = [of(vector) for vector in drawn]
    shares, long = np.array([corner.share for corner in corners]), whole.value.real
    feet: Complexes = np.asarray(complex(whole.start.real, first.start.imag) + shares * step)
    yield from sheet.figure(
        first.plan, first.plan, {(vector.name, None): k for k, vector in enumerate(drawn)},
        1j * np.array([corner.size for corner in corners]), kind=ORDINATES, returns=True, why=because("load"),
        scales={whole.quantity: whole.scale, first.quantity: first.scale}, units={whole.quantity: whole.unit},
        called=lambda mark: f"{mark.quantity}({mark.name})",
        paper=sheet.over(first.plan, feet, shares * (math.radians(long) if whole.name == SWING else long)),
        mistakes=(Mistake(verdict.MIRRORED, 1j * np.array([corner.mirrored for corner in corners])),),
    )  # fmt: skip


def _law(load: Force | Moment) -> Iterator[Corner]:
    """Give the corners of a load, each with what the load would be there of a diagram begun at its other end."""
    for _, shares, sizes in branches(load):
        mirrored = np.interp(1 - shares, shares, sizes, 0.0, 0.0)
        yield from (Corner(*map(float, corner)) for corner in zip(shares, sizes, mirrored, strict=True))


VELOCITY = KEYS[1]


def figures_of_diagrams(study: Study, sheet: SceneSheet) -> Iterator[FigureAsked]:
    """Give the kinematic diagrams of a sheet of kinematics (row of the table of records)."""
    shown = [key for key in KEYS if sheet.vectors(named(key))]
    comparison = study.comparison("diagrams") if shown else None
    if isinstance(comparison, DiagramsComparison):
        rows = {row.key: row for row in expected_rows(comparison)}
        speed = abs(study.of(LinkageStudy).mechanism.drive.omega)
        for key in shown:
            yield from _figure(sheet, rows, key, speed)


def _figure(sheet: SceneSheet, rows: Mapping[str, ExpectedRow], key: str, speed: float) -> Iterator[FigureAsked]:
    row, plan, k = rows[key], named(key), KEYS.index(key)
    marks, places = sheet.vectors(plan), {number: k for k, number in reversed(list(enumerate(row.axis.numbers)))}
    above = KEYS[k - 1] if k else None  # that it is the derivative of
    whole = bool(np.isclose(row.axis.turned[-1] - row.axis.turned[0], TURN))
    paper = sheet.paper(plan, row.axis.turned, places)
    course = None if above is None else partial(_slope, rows[above], row, row.axis.turned / speed, whole)
    yield from sheet.figure(
        key, plan, by_number(marks, places), np.asarray(1j * row.at), slack=_slack(row), kind=ORDINATES,
        paper=paper, behind=() if above is None else (above,), course=course, linear=above is not None,
        why=None if above is None else because("derivative_point"),
        loose=frozenset(np.flatnonzero(np.isnan(rows[VELOCITY].at)).tolist()),
    )  # fmt: skip


def _slack(row: ExpectedRow) -> Floats:
    """Give by how much a value at a position is out that is read off the curve by chords."""
    if row.key == KEYS[0]:  # which alone is not drawn by chords
        return np.zeros(len(row.at))
    return np.nan_to_num(np.abs(row.result(row.axis.turned) - row.at))


def _slope(
    above: ExpectedRow, row: ExpectedRow, times: Floats, whole: bool, drawn: Mapping[str, Complexes]
) -> Complexes:
    """Give a diagram as the slope of the one above it, which a student may have drawn otherwise, over times, s.

    Of a `whole` turn the last position is the first again.
    """
    moved = drawn[above.key].imag - above.at
    if whole:
        moved = np.concatenate((moved[-2:-1], moved, moved[1:2]))
        times = np.concatenate(([times[0] - times[-1] + times[-2]], times, [times[-1] + times[1] - times[0]]))
        return np.asarray(1j * (row.at + np.gradient(moved, times)[1:-1]))
    return np.asarray(1j * (row.at + np.gradient(moved, times)))


def figures_of_cyclogram(_: Study, sheet: SceneSheet) -> Iterator[FigureAsked]:
    """Give the bars of a cyclogram's rows (row of the table of records)."""
    yield from sheet.figure(BARS, BARS, called=lambda mark: mark.name)
