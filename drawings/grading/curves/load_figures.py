"""The records of load diagrams, of kinematic diagrams, of charts of a cyclogram (диаграммы)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from drawings.cyclogram.due_rows import BARS, machine_rows, true_bars
from drawings.diagrams.due import KEYS, ExpectedRow, expected_rows, named
from drawings.forces.due_loads import branches
from drawings.forces.load_diagram import NAME as LOAD
from drawings.grading import verdict
from drawings.grading.curves.figure_records import (
    BEARINGS,
    CHAIN,
    LENGTHS,
    ORDINATES,
    PRICKED,
    FigureAsked,
    Item,
    Mistake,
    OwnSheet,
    Sizes,
    Values,
)
from drawings.measure.measured import MeasuredVector
from drawings.paper.strokes import Circle
from drawings.paper.walk import flat, group_named
from plans.diagrams.quantities import DiagramsComparison
from plans.forces.statics import Statics
from plans.forces.stroke import Stroke
from plans.model.cyclogram import Row
from plans.model.diagrams import TURN
from plans.model.machine import Force, Moment
from plans.model.mechanism import Output
from plans.model.motion import Extremes
from plans.study import Study
from plans.words.words import because

OVERRUNS = ("overrun_1", "overrun_2")
SWING = "ψ"
WHOLE = ("H", SWING)  # the stroke of what slides, of what swings


def figures_of_loads(study: Study, own: OwnSheet) -> Iterator[FigureAsked]:
    """Give the load diagrams of a sheet of forces (row of the table of records)."""
    statics: Statics = study["forces"]
    yield from load_diagrams(own, statics, study.comparison("forces").motion.road.extremes)


def load_diagrams(
    own: OwnSheet, statics: Statics, extremes: Callable[[Output], Extremes | None]
) -> Iterator[FigureAsked]:
    """Give the load diagrams of a sheet, over the strokes of the analysis."""
    every: Sequence[Force | Moment] = (*statics.machine.forces, *statics.machine.moments)
    for load in every:
        plan = f"{LOAD}-{load.name}"
        marks = {one.name: one for one in own.measured.vectors if one.plan == plan}
        whole = next((marks[name] for name in WHOLE if name in marks), None)
        if whole is not None:
            diagram = _Diagram(own, plan, load, marks, whole)
            yield from diagram.sizes(statics.over(extremes)[load.stroke])
            yield from diagram.corners()


class Corner(NamedTuple):
    """A corner of a load by its law: where on the stroke, shares; how large, N or N*m, there and at the other end."""

    share: float
    size: float
    mirrored: float


@dataclass(frozen=True)
class _Diagram:
    """A load diagram of our own sheet with its load."""

    own: OwnSheet
    plan: str
    load: Force | Moment
    marks: Mapping[str, MeasuredVector]
    whole: MeasuredVector

    def sizes(self, stroke: Stroke) -> Iterator[FigureAsked]:
        """Give the stroke and its overruns, which are drawn to scale."""
        length = abs(stroke.reach[1] - stroke.reach[0])
        length = length if stroke.sliding else math.degrees(length)
        due = {self.whole.name: length} | {
            name: share * length for name, share in zip(OVERRUNS, self.load.overrun, strict=True) if name in self.marks
        }
        yield FigureAsked(
            key=f"{self.plan} sizes", plan=self.plan, sheet=self.own.name, unit=self.whole.unit,
            scales={self.whole.quantity: self.whole.scale},
            items=tuple(Item(name, None, k, name) for k, name in enumerate(due)),
            true=np.array(list(due.values()), dtype=np.complex128), slack=np.zeros(len(due)),
            error=np.full(len(due), PRICKED), kind=LENGTHS, why=because("tool_stroke"),
        )  # fmt: skip

    def corners(self) -> Iterator[FigureAsked]:
        """Give the ordinates at the corners of the load."""
        drawn = {name: one for name, one in self.marks.items() if name not in (*WHOLE, *OVERRUNS)}
        law = list(_law(self.load))
        if not drawn:
            return
        first, step = next(iter(drawn.values())), self.whole.value.real / self.whole.scale
        due = [self._corner(one, law, step) for one in drawn.values()]
        shares = np.array([one.share for one in due])
        feet: Values = np.asarray(complex(self.whole.start.real, first.start.imag) + shares * step)
        yield FigureAsked(
            key=self.plan, plan=self.plan, sheet=self.own.name, unit=first.unit,
            scales={self.whole.quantity: self.whole.scale, first.quantity: first.scale},
            units={self.whole.quantity: self.whole.unit},
            items=tuple(Item(name, None, k, f"{first.quantity}({name})") for k, name in enumerate(drawn)),
            true=1j * np.array([one.size for one in due]), slack=np.zeros(len(due)),
            error=np.full(len(due), PRICKED), kind=ORDINATES, returns=True,
            paper=self.own.over(self.plan, feet, shares * self._long), why=because("load"),
            mistakes=(Mistake(verdict.MIRRORED, 1j * np.array([one.mirrored for one in due])),),
        )  # fmt: skip

    @property
    def _long(self) -> float:
        """The stroke, m or rad."""
        whole = self.whole.value.real
        return math.radians(whole) if self.whole.name == SWING else whole

    def _corner(self, mark: MeasuredVector, law: Sequence[Corner], step: float) -> Corner:
        """Give the corner of the law that a mark of our own sheet is of: on paper the nearest."""
        at = complex(mark.start.real - self.whole.start.real, mark.value.imag / mark.scale)
        return min(law, key=lambda one: abs(complex(one.share * step, one.size / mark.scale) - at))


def _law(load: Force | Moment) -> Iterator[Corner]:
    """Give the corners of a load, each with what the load would be there of a diagram begun at its other end."""
    for _, shares, sizes in branches(load):
        mirrored = np.interp(1 - shares, shares, sizes, 0.0, 0.0)
        yield from (Corner(*map(float, one)) for one in zip(shares, sizes, mirrored, strict=True))


VELOCITY = KEYS[1]


def figures_of_diagrams(study: Study, own: OwnSheet) -> Iterator[FigureAsked]:
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


def figures_of_cyclogram(study: Study, own: OwnSheet) -> Iterator[FigureAsked]:
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
