"""The record of a sheet of a machine's motion: its graphs, the loop, its tangents, its run (графики листа динамики)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from types import MappingProxyType
from typing import Any, Final, NamedTuple

import numpy as np

from drawings.dynamics.due import LOOP, SEGMENTS, TANGENTS
from drawings.dynamics.due_graphs import (
    BEFORE,
    INERTIA,
    KNOWN,
    MOMENTS,
    SPEEDS,
    SURPLUS,
    TACHOGRAM,
    WORKS,
    AnalysedTurn,
)
from drawings.grading import verdict
from drawings.grading.curves.diagram_figures import figures_of_loads
from drawings.grading.curves.figure_records import (
    BEARINGS,
    ORDINATES,
    PRICKED,
    Course,
    FigureAsked,
    Mistake,
    SceneSheet,
    ValueAsked,
    by_number,
)
from plans.analytic.dynamics.speeds import energy_at
from plans.dynamics.quantities import DynamicsComparison
from plans.dynamics.study import DynamicsStudy
from plans.model.dynamics import TURN, Flywheel, Speeds, edge_names, settled
from plans.model.motion import Complexes, Floats
from plans.model.run import STEADY, MachineRun
from plans.study import Study
from plans.words.words import Message, because

ALIKE = 0.05  # by how much the factors at both edges of a strip may differ that are taken for one: a fair hand's do


def moved_means(drawn: Floats, after: Floats, before: Floats, means: Floats) -> Floats:
    """Give the means of the strips by the values behind their edges, where the true ones are known.

    A strip whose edges are out by one factor is out by it, any other by how far both are; a jump keeps its share.

    >>> true = np.array([0.0, 2.0, 4.0])
    >>> moved_means(2 * true, true, true, np.array([1.1, 3.1])).tolist()
    [2.2, 6.2]
    >>> moved_means(true + 1, true, true, np.array([1.1, 3.1])).round(3).tolist()
    [2.1, 4.1]
    """
    after, before = (settled(row, float(np.abs(after).max())) for row in (after, before))
    end, jumps = before[1:], settled(before[1:] - after[1:], float(np.abs(after).max())) != 0
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        first = drawn[:-1] / after[:-1]
        last = np.where(jumps, first, drawn[1:] / end)
        first = np.where((after[:-1] == 0) & (drawn[:-1] == 0), last, first)
        last = np.where((end == 0) & (drawn[1:] == 0) & ~jumps, first, last)
        right = np.where(jumps, end * first, drawn[1:])
        alike = np.abs(first - last) <= ALIKE
        moved = (drawn[:-1] - after[:-1] + right - end) / 2
    moved = np.where(np.isfinite(moved), moved, drawn[:-1] - after[:-1])
    factor = np.where(alike, first, 0.0) / 2 + np.where(alike, last, 0.0) / 2
    return np.where(alike, means * factor, means + moved)


BEARING, CUT = "bearings of the loop", "cuts of the loop"


class TurnCourses(NamedTuple):
    """A turn in strips, and how the figures of its motion follow from one another."""

    expected: AnalysedTurn
    scales: tuple[float, float] = (1.0, 1.0)  # of the loop: kg*m2 and J a mm

    @property
    def turned(self) -> Floats:
        """The edges of the strips, rad."""
        return self.expected.cycle.turned

    def works(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Add up the areas of the strips under a graph of moments, whose means are out as their edges are."""
        after, before = self.expected.graphs[MOMENTS], self.expected.before
        means = moved_means(drawn[MOMENTS].imag, after, before, self.expected.cycle.way * self.expected.cycle.means)
        return np.asarray(1j * np.concatenate(([0.0], np.cumsum(means * np.diff(self.turned)))))

    def surplus(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Take the works of the loads from those of the drive, which gives as much over the turn; an engine's drive."""
        works, way = drawn[WORKS].imag, self.expected.cycle.way
        return np.asarray(-1j * way * (works[0] + (works[-1] - works[0]) * self.turned / TURN - works))

    def loop(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Lay the surplus off over the inertia, mm."""
        inertia, energy = self.scales
        return np.asarray(drawn[INERTIA].real / inertia + 1j * drawn[SURPLUS].imag / energy)

    def cuts(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Give what tangents of some bearings cut off the axis of energy, J: o1l, o1k."""
        points, (low, high) = drawn[LOOP], (ray.imag / ray.real for ray in drawn[BEARING])
        energy = self.scales[1]
        least = (points.imag - low * points.real).min() * energy
        most = (points.imag - high * points.real).max() * energy
        return np.array([1j * least, 1j * most])

    def speeds(self, drawn: Mapping[str, Complexes]) -> Complexes:
        """Give the speeds above their mean from energies, inertias and what the tangents cut off, rad/s."""
        low, high = self.wheel.slopes
        least, most = drawn[CUT].imag
        whole = (most - least) / (high - low)
        energy = whole * high - most
        with np.errstate(divide="ignore", invalid="ignore"):
            omega = np.sqrt(2 * (energy + drawn[SURPLUS].imag) / (whole + drawn[INERTIA].real))
        return np.asarray(1j * (omega - self.expected.mean))

    @property
    def wheel(self) -> Flywheel:
        """The flywheel that is asked for."""
        assert self.expected.wheel is not None  # asked before
        return self.expected.wheel

    @property
    def true(self) -> dict[str, Complexes]:
        """The graphs by analysis."""
        ways = ((name, row if name == INERTIA else 1j * row) for name, row in self.expected.graphs.items())
        return {name: np.asarray(row, dtype=np.complex128) for name, row in ways}


# By what the values of a graph are found; of an engine too.
WHY: Final[Mapping[str, Message]] = MappingProxyType({WORKS: because("integral_chord"), SURPLUS: because("steady")})
ENGINE: Final[Mapping[str, Message]] = MappingProxyType({**WHY, SURPLUS: because("steady_engine")})


def figures_of_dynamics(study: Study, sheet: SceneSheet) -> Iterator[FigureAsked]:
    """Give the figures of a sheet of dynamics (row of the table of records)."""
    comparison, task = study.of(DynamicsComparison), study.of(DynamicsStudy).task
    yield from figures_of_loads(study, sheet)
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


# Shares of a stage at which its curve is read, by how the instants there are written: of the first, of any other.
READ: Final = MappingProxyType(
    {0.25: ("t_1/4", "(3t_{0}+t_{1})/4"), 0.5: ("t_1/2", "(t_{0}+t_{1})/2"), 0.75: ("3t_1/4", "(t_{0}+3t_{1})/4")}
)


def tachogram(sheet: SceneSheet, constructed: MachineRun | None, exact: MachineRun | None) -> Iterator[FigureAsked]:
    """Give the tachogram of a sheet: the speeds where its stages end, and between, off the curve."""
    marks = {vector.name: vector for vector in sheet.measured.vectors if vector.plan == TACHOGRAM}
    scales = sheet.scales(TACHOGRAM)
    if not marks or constructed is None or exact is None or not {"t", "ω"} <= scales.keys():
        return
    instants = dict(_instants(constructed))
    expected = {name: instants[name] for name in instants if name in marks or not _ends(name)}
    names, t = list(expected), np.array(list(expected.values()))
    true, drawn = (np.interp(t, *_rising(run)) for run in (exact, constructed))
    first = next(name for name in names if name in marks)
    zero = marks[first].start - instants[first] / scales["t"]
    paper = sheet.over(TACHOGRAM, np.asarray(zero + t / scales["t"]), t)
    # An instant is pricked too: on a steep curve it moves the speed that is read there.
    steep = np.abs(np.interp(t, constructed.t, constructed.epsilon)) * scales["t"] / scales["ω"]
    ends = np.concatenate(([0.0], t[[k for k, name in enumerate(names) if _ends(name)]]))
    straight = np.interp(t, ends, np.interp(ends, *_rising(exact)))  # as if the moments of a stage were constant
    yield FigureAsked(
        key=TACHOGRAM, plan=TACHOGRAM, sheet=sheet.name, unit=marks[first].unit,
        scales={"t": scales["t"], "ω": scales["ω"]},
        items=tuple(ValueAsked(name, None, k, f"ω({name})") for k, name in enumerate(names)),
        true=np.asarray(1j * true), slack=np.abs(true - drawn), error=PRICKED * np.hypot(1.0, steep), kind=ORDINATES,
        paper=None if paper is None else paper._replace(turn=None), why=because("run_stage"),
        mistakes=(Mistake(verdict.STRAIGHT, np.asarray(1j * straight)),),
    )  # fmt: skip


def _ends(name: str) -> bool:
    """Tell whether a place of a tachogram is the end of a stage, whose ordinate is drawn."""
    return name.removeprefix("t_").isdigit()


def _instants(run: MachineRun) -> Iterator[tuple[str, float]]:
    """Give the instants at which a tachogram is held, s, by their names in their order."""
    ends = [0.0, *(float(run.t[stage.last]) for stage in run.stages)]
    for k, (start, end) in enumerate(pairwise(ends), 1):
        if run.stages[k - 1].name != STEADY:  # there the speed swings, and is read at both ends alone
            for share, (first, other) in READ.items():
                yield first if k == 1 else other.format(k - 1, k), start + share * (end - start)
        yield f"t_{k}", end


def _rising(run: MachineRun) -> tuple[Floats, Floats]:
    kept = np.append(np.diff(run.t) > 0, True)
    return run.t[kept], run.omega[kept]


def bare_speeds(sheet: SceneSheet, expected: AnalysedTurn, exact: AnalysedTurn) -> Iterator[FigureAsked]:
    """Give the graph of the speeds without the flywheel."""
    marks, before = sheet.vectors(BEFORE), expected.account.before
    if not marks or before is None:
        return
    turned = expected.cycle.turned
    divisions, sure = expected.task.divisions, exact.account.before
    places = np.searchsorted(turned, TURN * np.arange(divisions) / divisions - KNOWN).tolist()
    paper = sheet.paper(BEFORE, turned, dict(enumerate(places)))
    omega = expected.omega
    flywheeled = () if omega is None else (Mistake(verdict.FLYWHEEL, np.asarray(1j * omega)),)
    behind = (SURPLUS, INERTIA) if sheet.vectors(SURPLUS) and sheet.vectors(INERTIA) else ()
    yield from sheet.figure(
        BEFORE, BEFORE, by_number(marks, dict(enumerate(places))), np.asarray(1j * before.omega), kind=ORDINATES,
        scales={"ω": next(iter(marks.values())).scale}, paper=paper, why=because("speed_by_energy"), behind=behind,
        slack=np.abs(before.omega - (before if sure is None else sure).omega), mistakes=flywheeled,
        course=partial(speeds_before, before) if behind else None,
    )  # fmt: skip


def speeds_before(true: Speeds, drawn: Mapping[str, Complexes]) -> Complexes:
    """Give the speeds without the flywheel by surplus energies and inertias: their mean is what it must be."""
    surplus, inertia = drawn[SURPLUS].imag, drawn[INERTIA].real + true.inertia
    energy = energy_at(float(np.ptp(true.omega) / 2 + true.omega.min()), surplus, inertia)
    if energy is None:  # with such energies the machine would stop: nothing follows from them
        return np.full(len(surplus), complex(np.nan, np.nan))
    return np.asarray(1j * np.sqrt(2 * np.maximum(energy + surplus, 0.0) / inertia))
