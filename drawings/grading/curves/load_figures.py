"""The record of load diagrams: a load over its stroke, there and back, and the sizes of that (диаграмма нагрузки)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from drawings.due.loads import branches
from drawings.figures.dynamics.load_diagram import NAME as LOAD
from drawings.grading import verdict
from drawings.grading.curves.asked_figure import LENGTHS, ORDINATES, PRICKED, FigureAsked, Item, Mistake, Values
from drawings.grading.curves.figure_records import OwnSheet
from drawings.measure.measured import MeasuredVector
from plans.forces.statics import Statics
from plans.forces.stroke import Stroke
from plans.model.machine import Force, Moment
from plans.model.mechanism import Output
from plans.model.motion import Extremes
from plans.study import Study
from plans.words.words import because

OVERRUNS = ("overrun_1", "overrun_2")
SWING = "ψ"
WHOLE = ("H", SWING)  # the stroke of what slides, of what swings


def figures_of(study: Study, own: OwnSheet) -> Iterator[FigureAsked]:
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
