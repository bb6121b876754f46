"""The record of a sheet of a machine's motion: its graphs, the loop, its tangents (графики листа динамики)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from types import MappingProxyType
from typing import Any, Final

import numpy as np

from drawings.dynamics.due import LOOP, SEGMENTS, TANGENTS
from drawings.dynamics.due_graphs import INERTIA, MOMENTS, SPEEDS, SURPLUS, WORKS, AnalysedTurn
from drawings.grading import verdict
from drawings.grading.curves.diagram_figures import load_diagrams
from drawings.grading.curves.figure_records import (
    BEARINGS,
    ORDINATES,
    PRICKED,
    Course,
    FigureAsked,
    Mistake,
    SceneSheet,
    by_number,
)
from drawings.grading.curves.run_figures import BEARING, CUT, TurnCourses, bare_speeds, tachogram
from plans.dynamics.quantities import DynamicsComparison
from plans.dynamics.study import DynamicsStudy
from plans.model.dynamics import edge_names
from plans.model.motion import Complexes
from plans.study import Study
from plans.words.words import Message, because

# By what the values of a graph are found; of an engine too.
WHY: Final[Mapping[str, Message]] = MappingProxyType({WORKS: because("integral_chord"), SURPLUS: because("steady")})
ENGINE: Final[Mapping[str, Message]] = MappingProxyType({**WHY, SURPLUS: because("steady_engine")})


def figures_of_dynamics(study: Study, sheet: SceneSheet) -> Iterator[FigureAsked]:
    """Give the figures of a sheet of dynamics (row of the table of records)."""
    comparison, task = study.of(DynamicsComparison), study.of(DynamicsStudy).task
    yield from load_diagrams(sheet, study.of(DynamicsStudy).statics)
    if comparison.analysis.cycle is None:
        return
    drawn = _GradedDynamics(sheet, AnalysedTurn(task, comparison.analysis), AnalysedTurn(task, comparison.exact))
    yield from drawn.graphs()
    yield from drawn.loop()
    yield from bare_speeds(sheet, drawn.expected, drawn.exact)
    yield from tachogram(sheet, comparison.construction.run, comparison.exact.run)


@dataclass(frozen=True)
class _GradedDynamics:
    """A sheet with what the analysis says of it: by the chords of the construction, and exactly."""

    sheet: SceneSheet
    expected: AnalysedTurn
    exact: AnalysedTurn

    def graphs(self) -> Iterator[FigureAsked]:
        """Give the graphs over the turn in the order in which they are drawn."""
        turn = TurnCourses(self.expected)
        alone = self.expected.cycle.way * self.expected.graphs[WORKS]
        undriven = Mistake(verdict.UNDRIVEN, np.asarray(1j * alone))
        yield from self._graph(MOMENTS, mistakes=tuple(self._unloaded()))
        yield from self._graph(WORKS, (MOMENTS,), turn.works)
        yield from self._graph(SURPLUS, (WORKS,), turn.surplus, (undriven,))  # the works of the loads alone
        yield from self._graph(INERTIA)

    def _graph(
        self, name: str, behind: tuple[str, ...] = (), course: Course | None = None, mistakes: tuple[Mistake, ...] = ()
    ) -> Iterator[FigureAsked]:
        marks = self.sheet.vectors(name)
        if not marks:
            return
        values, way = self.expected.graphs[name], 1 + 0j if name == INERTIA else 1j
        # Of loads that but for the strips take nothing either account may say that they drive.
        alike = self.expected.cycle.way * self.exact.cycle.way if name in (MOMENTS, WORKS) else 1.0
        slack = np.abs(values - alike * self.exact.graphs.get(name, alike * values))
        yield from self.sheet.figure(
            name, name, by_number(marks), np.asarray(way * values), kind=ORDINATES, way=way, slack=slack,
            why=(ENGINE if self.expected.cycle.engine else WHY).get(name), behind=behind,
            paper=self.sheet.paper(name, self.expected.cycle.turned), course=course, mistakes=mistakes,
            linear=course is not None and name != SPEEDS, stepped=name == WORKS,
            edges=edge_names(self.expected.cycle.turned, self.expected.task.divisions),
        )  # fmt: skip

    def scale(self, name: str) -> float:
        """Give the scale of a graph's ordinates, true units a mm."""
        return next((vector.scale for vector in self.sheet.vectors(name).values()), 1.0)

    def _unloaded(self) -> Iterator[Mistake]:
        """Give the graph of moments without what loads have over one of its stretches between jumps."""
        after, before = self.expected.graphs[MOMENTS], self.expected.before
        jumps = np.flatnonzero(np.abs(after - before) > 0.5 * self.scale(MOMENTS))  # mm: a smaller one is not seen
        bounds = [0, *(k for k in jumps.tolist() if 0 < k < len(after) - 1), len(after)]
        for low, high in pairwise(bounds):
            if high - low < len(after):
                values = after.copy()
                values[low:high] = 0.0
                yield Mistake(verdict.UNLOADED, np.asarray(1j * values))

    def loop(self) -> Iterator[FigureAsked]:
        """Give the loop, its tangents, what they cut off, and the speeds that follow from it."""
        scales = self.sheet.scales(LOOP)
        if not {"J", "T"} <= scales.keys():
            return
        turn = TurnCourses(self.expected, (scales["J"], scales["T"]))
        yield from self._points(turn)
        if self.expected.wheel is not None and self.expected.omega is not None:
            yield from self._tangents(turn)
            yield from self._graph(SPEEDS, (SURPLUS, INERTIA, CUT), turn.speeds)

    def _points(self, turn: TurnCourses) -> Iterator[FigureAsked]:
        true = turn.loop(turn.true)
        places = {(name, k): k for name, k in self.sheet.marks(LOOP) if k is not None}
        yield from self.sheet.figure(
            LOOP, LOOP, places, true, unit="mm", scales={"J": turn.scales[0], "T": turn.scales[1]}, on_paper=True,
            slack=np.abs(true - turn.loop(TurnCourses(self.exact, turn.scales).true)),
            error=np.full(len(true), 2 * PRICKED),  # in x and in y, each measured off a graph
            why=because("loop_point"), behind=(SURPLUS, INERTIA), course=turn.loop, curved=tuple(range(len(true))),
            mistakes=(Mistake(verdict.AXES, 1j * true.conj()), Mistake(verdict.MIRRORED, -true.conj())),
        )  # fmt: skip

    def _tangents(self, turn: TurnCourses) -> Iterator[FigureAsked]:
        wheel, ratio = turn.wheel, turn.scales[0] / turn.scales[1]
        loop = (vector for vector in self.sheet.measured.vectors if vector.plan == LOOP)
        drawn = {vector.name: vector for vector in loop if vector.position is None}
        slopes = np.array([complex(1.0, slope * ratio) for slope in wheel.slopes])
        sides = zip(TANGENTS, slopes, strict=True)
        bearings = np.array([drawn[name].value if name in drawn else slope for name, slope in sides])
        true = np.abs(bearings) * slopes / np.abs(slopes)
        swapped = np.abs(bearings) * slopes[::-1] / np.abs(slopes[::-1])
        yield from self._aside(
            BEARING, TANGENTS, true, unit="mm", scales={"": 1.0}, kind=BEARINGS, why=because("tangent_angle"),
            mistakes=(Mistake(verdict.EXCHANGED, swapped),),
        )  # fmt: skip
        cuts = np.array([1j * cut for cut in wheel.cuts])
        off = np.array([1j * cut for cut in self.exact.wheel.cuts]) if self.exact.wheel else cuts
        # A ruler is laid to a point, and leans as its angle is drawn: on the axis it is out by as much as it is far.
        touches = np.array([touch.varying for touch in wheel.touches]) / turn.scales[0]
        leaning = touches * np.abs(slopes) ** 2 / np.abs(bearings)
        ruled = PRICKED * np.sqrt(1.0 + np.abs(slopes) ** 2 + leaning**2)
        yield from self._aside(
            CUT, SEGMENTS, cuts, unit="J", scales={"T": turn.scales[1]}, kind=ORDINATES, why=because("ruler"),
            error=ruled, slack=np.abs(cuts - off), behind=(LOOP, BEARING), course=turn.cuts,
        )  # fmt: skip

    def _aside(self, key: str, names: Sequence[str], true: Complexes, **how: Any) -> Iterator[FigureAsked]:
        yield from self.sheet.figure(key, LOOP, {(name, None): k for k, name in enumerate(names)}, true, **how)
