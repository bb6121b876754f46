"""The records of load diagrams, kinematic diagrams, charts of a cyclogram and arms of compensators (диаграммы)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from drawings.bank.compensators import COMPENSATOR
from drawings.bank.due import Bank, CompensatorBody
from drawings.cyclogram.due_rows import BARS, machine_rows
from drawings.diagrams.due import KEYS, ExpectedRow, expected_rows, named
from drawings.forces.due_acting import branches
from drawings.forces.load_diagram import NAME as LOAD
from drawings.grading import verdict
from drawings.grading.curves.figure_records import (
    BEARINGS,
    CHAIN,
    LENGTHS,
    ORDINATES,
    POINTS,
    PRICKED,
    FigureAsked,
    Mistake,
    SceneSheet,
    ValueAsked,
    by_number,
)
from drawings.grading.curves.radial_figures import arm_at, written
from drawings.paper.strokes import Circle
from drawings.paper.walk import flat, group_named
from drawings.reading.marks import MeasuredVector
from plans.bank.harmonics import FORCE, letters
from plans.bank.study import BankStudy
from plans.cyclogram.quantities import CyclogramComparison
from plans.cyclogram.study import CyclogramStudy
from plans.diagrams.quantities import DiagramsComparison
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.model.balance.bank import Compensator
from plans.model.cyclogram import BarRow
from plans.model.diagrams import TURN
from plans.model.machine import Force, Moment
from plans.model.motion import Complexes, Floats
from plans.study import Study
from plans.words.words import because

OVERRUNS = ("overrun_1", "overrun_2")
SWING = "ψ"
WHOLE = ("H", SWING)  # the stroke of what slides, of what swings


def figures_of_loads(study: Study, sheet: SceneSheet) -> Iterator[FigureAsked]:
    """Give the load diagrams of a sheet of forces (row of the table of records)."""
    yield from load_diagrams(sheet, study.of(Statics))


def load_diagrams(sheet: SceneSheet, statics: Statics) -> Iterator[FigureAsked]:
    """Give the load diagrams of a sheet: the stroke and its overruns, and the ordinates at the corners."""
    for load in statics.machine.loads:
        plan = f"{LOAD}-{load.name}"
        marks = {name: mark for (name, _), mark in sheet.marks(plan).items()}
        whole = next((marks[name] for name in WHOLE if name in marks), None)
        if isinstance(whole, MeasuredVector):
            sizes = {
                (name, None): k for k, name in enumerate([whole.name, *(name for name in OVERRUNS if name in marks)])
            }
            yield from sheet.figure(f"{plan} sizes", plan, sizes, kind=LENGTHS, why=because("tool_stroke"))
            corners = [mark for name, mark in marks.items() if (name, None) not in sizes]
            yield from _corners(
                sheet, load, whole, [corner for corner in corners if isinstance(corner, MeasuredVector)]
            )


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
    row, plan = rows[key], named(key)
    marks, places = sheet.vectors(plan), {number: k for k, number in reversed(list(enumerate(row.axis.numbers)))}
    mu, above = next(iter(marks.values())).scale, _above(key)
    whole = bool(np.isclose(row.axis.turned[-1] - row.axis.turned[0], TURN))
    paper = sheet.paper(plan, row.axis.turned, places)
    course = None if above is None else Slope(above, rows[above].at, row.at, row.axis.turned / speed, whole)
    vectors = [] if above is None else list(sheet.vectors(named(above)).values())
    error = np.full(len(row.at), PRICKED)
    if paper is not None and vectors:
        # Both ends of a chord over two positions are out; what their rise says of the derivative is out by so much.
        time = float(np.median(np.diff(row.axis.turned))) / speed
        error = np.full(len(row.at), float(np.hypot(PRICKED, PRICKED * vectors[0].scale / (np.sqrt(2) * time * mu))))
    yield from sheet.figure(
        key, plan, by_number(marks, places), np.asarray(1j * row.at), slack=_slack(row), error=error, kind=ORDINATES,
        paper=paper, behind=() if above is None else (above,), course=course, linear=above is not None,
        why=None if above is None else because("derivative_point"),
        loose=frozenset(np.flatnonzero(np.isnan(rows[VELOCITY].at)).tolist()),
    )  # fmt: skip


def _above(key: str) -> str | None:
    """Give the diagram that another is the derivative of."""
    k = KEYS.index(key)
    return KEYS[k - 1] if k else None


def _slack(row: ExpectedRow) -> Floats:
    """Give by how much a value at a position is out that is read off the curve by chords."""
    if row.key == KEYS[0]:  # which alone is not drawn by chords
        return np.zeros(len(row.at))
    return np.nan_to_num(np.abs(row.result(row.axis.turned) - row.at))


@dataclass(frozen=True)
class Slope:
    """A diagram as the slope of the one above it, which a student may have drawn otherwise."""

    above: str
    risen: Floats  # the true one above
    true: Floats
    times: Floats  # s
    whole: bool  # whether the last position is the first again

    def __call__(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Give the derivative."""
        moved, times = drawn[self.above].imag - self.risen, self.times
        if self.whole:
            moved = np.concatenate((moved[-2:-1], moved, moved[1:2]))
            times = np.concatenate(([times[0] - times[-1] + times[-2]], times, [times[-1] + times[1] - times[0]]))
            return np.asarray(1j * (self.true + np.gradient(moved, times)[1:-1]))
        return np.asarray(1j * (self.true + np.gradient(moved, times)))


CIRCLE = "circle"  # the name of the chart


def rings(sheet: SceneSheet, rows: Sequence[BarRow], sense: int) -> Iterator[FigureAsked]:
    """Give the bearings at which the spans of some rows begin, mm: to the outer circle of each ring."""
    group = group_named(sheet.leaf.groups, CIRCLE)
    radii = [] if group is None else sorted(stroke.radius for stroke in flat((group,)) if isinstance(stroke, Circle))
    if len(radii) != len(rows) + 1:
        return
    found = [
        (f"{k}.{number}", k, span.start) for k, row in enumerate(rows, 1) for number, span in enumerate(row.spans, 1)
    ]
    names, places, turned = zip(*found, strict=True)
    reach = np.array([radii[len(rows) + 1 - k] for k in places])
    true = np.asarray(reach * np.exp(1j * sense * np.array(turned)))
    yield FigureAsked(
        key=CIRCLE, plan=CIRCLE, sheet=sheet.name, unit="mm", scales={"": 1.0},
        items=tuple(ValueAsked(name, None, k, name) for k, name in enumerate(names)), true=true,
        slack=np.zeros(len(true)), error=np.full(len(true), PRICKED), kind=BEARINGS, on_paper=True, rings=places,
        why=because("ring_turn"),
        mistakes=(Mistake(verdict.MIRRORED, true.conj()), *_unset(rows, np.array(places), true, sense)),
    )  # fmt: skip


def _unset(
    rows: Sequence[BarRow], places: np.ndarray[tuple[int, ...], np.dtype[np.intp]], true: Complexes, sense: int
) -> Iterator[Mistake]:
    """Give the rings with a row that is not turned by its setting angle, and with all that are not."""
    turns = np.array([np.exp(-1j * sense * (row.setting or 0.0)) for row in rows])[places - 1]
    for k in (0, *(k for k, row in enumerate(rows, 1) if row.setting)):
        yield Mistake(verdict.UNSET, np.asarray(np.where((places == k) | (k == 0), true * turns, true)))


def figures_of_cyclogram(study: Study, sheet: SceneSheet) -> Iterator[FigureAsked]:
    """Give the bars of a machine's cyclogram (row of the table of records)."""
    found = study.of(CyclogramComparison).analysis
    rows = machine_rows(found, study.of(CyclogramStudy).cams)
    yield from bars(sheet)
    yield from rings(sheet, rows, found.sense)


def bars(sheet: SceneSheet) -> Iterator[FigureAsked]:
    """Give the bars of a cyclogram's rows."""
    marks = {vector.name: vector for vector in sheet.measured.vectors if vector.plan == BARS}
    true = {row.name: row.vector for row in sheet.expected.values() if row.figure == BARS and row.name in marks}
    places = {(name, None): k for k, name in enumerate(true)}
    paper, mistakes = sheet.ruled(BARS, np.array([marks[name].start for name in true])), tuple(_exchanged(true))
    yield from sheet.figure(
        BARS, BARS, places, kind=CHAIN, paper=paper, mistakes=mistakes, called=lambda mark: mark.name
    )


def _exchanged(true: Mapping[str, complex]) -> Iterator[Mistake]:
    """Give the bars with two that follow one another in a row each as long as the other."""
    names = list(true)
    for name, other in pairwise(names):
        if name.partition(".")[0] == other.partition(".")[0]:
            values: Complexes = np.array(list(true.values()))
            k, m = names.index(name), names.index(other)
            values[k], values[m] = (
                complex(true[other].real, true[name].imag),
                complex(true[name].real, true[other].imag),
            )
            yield Mistake(verdict.EXCHANGED, values)


def figures_of_arms(study: Study, sheet: SceneSheet) -> Iterator[FigureAsked]:
    """Give the arms of a bank's compensators (row of the table of records)."""
    expected = Bank(study.of(BankStudy).task, study.comparison("bank"))
    for compensator in expected.analysis.compensators:
        layout = _Layout(sheet, f"{COMPENSATOR}-{compensator.asked.order}", expected, compensator)
        bodies = list(expected.bodies(compensator))
        yield from layout.arms("", [body for body in bodies if not body.coupled])
        yield from layout.arms(" couple", [body for body in bodies if body.coupled])


@dataclass(frozen=True)
class _Layout:
    """The layout of compensators of one order on our own sheet."""

    sheet: SceneSheet
    plan: str
    expected: Bank
    found: Compensator

    def arms(self, part: str, bodies: list[CompensatorBody]) -> Iterator[FigureAsked]:
        """Give the arms of some masses: to scale where their masses are given, else by their directions."""
        drawn = {body.name: arm_at(self.sheet.leaf, self.plan, written(body.name)) for body in bodies}
        shown = [body for body in bodies if drawn[body.name] is not None]
        scales = self.sheet.scales(self.plan)
        if not shown or "l" not in scales:
            return
        scaled = not part and not self.expected.nominal(self.found, not self.sheet.marks(self.plan))
        true = np.array([body.way * self._long(body, drawn, scaled) for body in shown])
        names = tuple(letters(FORCE, body.turns) for body in shown)
        yield FigureAsked(
            self.plan + part, self.plan, self.sheet.name, "m" if scaled else "mm", {"l": scales["l"]},
            tuple(ValueAsked(body.name, None, k, body.name) for k, body in enumerate(shown)), true, np.zeros(len(true)),
            np.full(len(true), PRICKED), POINTS if scaled else BEARINGS, why=because("compensator_arm"),
            on_paper=not scaled, arms=tuple(written(body.name) for body in shown),
            mistakes=(Mistake(verdict.HEAVY, -true), Mistake(verdict.EXCHANGED, true[::-1])),
            behind=() if part else names, course=None if part else self._course(names, true),
        )  # fmt: skip

    def _long(self, body: CompensatorBody, drawn: Mapping[str, tuple[complex, complex] | None], scaled: bool) -> float:
        """Give how long an arm is, m; of one that is not to scale, mm on our own sheet."""
        if scaled and self.found.asked.mass:
            return body.moment / self.found.asked.mass
        start, end = drawn[body.name] or (0j, 1 + 0j)
        return abs(end - start)

    def _course(self, names: tuple[str, ...], true: Complexes) -> Against:
        harmonic = self.expected.analysis.forces[self.found.asked.order]
        turn = self.expected.turn
        forces = np.array([(harmonic.back if "-" in name else harmonic.ahead) * turn for name in names])
        return Against(names, forces, true)


@dataclass(frozen=True)
class Against:
    """The arms of masses against the forces of an order, as these are drawn."""

    names: tuple[str, ...]
    forces: Complexes
    true: Complexes

    def __call__(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Lay each arm off against its force."""
        return np.asarray(self.true * np.array([drawn[name][0] for name in self.names]) / self.forces)
