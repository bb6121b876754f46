"""The self-check of what is followed over the turn: graphs along the guides, hodographs (графики и годографы)."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from drawings.checks.bank.bank_expected import LEFT, WHOLE, WHOLE_MOMENT, Expected
from drawings.checks.bank.bank_views import origin
from drawings.checks.graphs.figure_strokes import FigureStrokes, figure
from drawings.checks.graphs.scale_line import written_scales
from drawings.checks.wrong import Wrong, on
from drawings.figures.bank import turn_graph
from drawings.figures.bank.turn_graph import STATIONS
from drawings.figures.graphs.curve_graph import TURN
from drawings.lettering.words import number
from drawings.measure.measure import Measured
from drawings.measure.measured import MeasuredVector
from drawings.page.drafting import Drafting
from drawings.paper.strokes import Leaf, Line, Polyline
from drawings.paper.walk import groups
from plans.model.motion import Complexes
from plans.words.words import message

# Of each curve: its finding, its letter, and the graph that it stands on where all forces keep to one line.
CURVES = {
    turn_graph.FORCE: (WHOLE, "F", "force_graph"),
    turn_graph.LEFT: (LEFT, "F'", "force_graph"),
    turn_graph.MOMENT: (WHOLE_MOMENT, "M", "moment_graph"),
}
SHORT = 0.1  # mm: an ordinate that is shorter may be a point


def due(expected: Expected, figures: Collection[str]) -> Iterator[str]:
    """Name the curves that the sheets must show, and those that they show of what is hardly more than rounding."""
    for plan, (name, _, _) in CURVES.items():
        first = WHOLE if name == LEFT else name
        seen = figure_of(expected, plan) in figures
        lasting = expected.straight(LEFT) or (expected.acts(LEFT, seen) and not expected.faint(LEFT))
        shown = expected.acts(first, seen) and not expected.faint(first)
        if shown and (name != LEFT or (expected.compensated and lasting)):
            yield plan


def figure_of(expected: Expected, plan: str) -> str:
    """Name the figure on which a curve stands."""
    name, _, graph = CURVES[plan]
    return graph if expected.straight(name) else plan


def faults(
    measured: Measured, leaf: Leaf, expected: Expected, drafting: Drafting, figures: frozenset[str]
) -> Iterator[Wrong]:
    """Hold every curve that a sheet must show."""
    for plan in due(expected, figures):
        strokes = figure(leaf, figure_of(expected, plan))
        if strokes is not None and figure_of(expected, plan) in figures:
            kind = _Graph if expected.straight(CURVES[plan][0]) else _Hodograph
            yield from kind(plan, strokes, measured, expected, drafting).faults()


@dataclass(frozen=True)
class _Course:
    """A curve on a sheet, with what it must show."""

    plan: str
    strokes: FigureStrokes
    measured: Measured
    expected: Expected
    drafting: Drafting

    @property
    def values(self) -> Complexes:
        return self.expected.force_of(CURVES[self.plan][0])

    @property
    def slack(self) -> float:
        """What both roads may differ by."""
        return self.expected.allowed[CURVES[self.plan][0]]

    @property
    def letter(self) -> str:
        return CURVES[self.plan][1]

    @property
    def stations(self) -> range:
        whole = len(self.values) - 1
        return range(0, whole, whole // STATIONS)

    def faults(self) -> Iterator[Wrong]:
        """Hold it."""
        raise NotImplementedError

    def drawn(self, spots: Complexes, near: float) -> bool:
        """Tell whether a chain of lines goes through all places on paper, in their order."""
        chains = (np.array(one.points) for one in self.strokes.of(Polyline) if len(one.points) == len(spots))
        return any(bool(np.abs(chain - spots).max() <= near) for chain in chains)


class _Graph(_Course):
    """A curve along the guides over the angle."""

    @cached_property
    def marks(self) -> dict[int, MeasuredVector]:
        """The ordinates by the places of their values."""
        return {
            one.position: one for one in self.measured.vectors if one.plan == self.plan and one.position is not None
        }

    @cached_property
    def mu(self) -> float:
        """The scale of the ordinates, by any mark of the graph: those of one graph share it."""
        data = [one.data for one in groups((self.strokes.group,)) if one.data.get("kind") == "vector"]
        return float(data[0]["scale"]) if data else 1.0

    @cached_property
    def zero(self) -> complex:
        """Where the axes cross: the foot of the first ordinate of the graph, turned back along the axis."""
        for one in groups((self.strokes.group,)):
            if one.data.get("kind") == "vector" and isinstance(one.strokes[0], Line):
                return one.strokes[0].start - self.along(int(one.data["position"]))
        return 0j

    @cached_property
    def angle(self) -> float:
        """The scale of the angle as it is written, degrees/mm."""
        return written_scales(self.strokes.group).get("φ", float("nan"))

    def along(self, k: int) -> float:
        """Give how far from zero a value stands, mm."""
        return TURN * k / (len(self.values) - 1) / self.angle

    def faults(self) -> Iterator[Wrong]:
        values, paper = self.values.real, self.slack / self.mu + 2 * self.measured.quantum
        last = len(values) - 1
        for k in (*self.stations, last):
            one, name = self.marks.get(k), str(k * STATIONS // last % STATIONS)
            if one is None and abs(values[k]) > SHORT * self.mu:
                yield on("missing_on", self.plan, name=name)
            elif (
                one is not None
                and not abs(one.value - 1j * values[k]) <= self.slack + 2 * self.measured.quantum * self.mu
            ):
                yield on("differs_on", self.plan, name=name)
            elif one is not None and not abs(one.start - self.zero - self.along(k)) <= paper:
                yield on("foot", self.plan, name=name)
        yield from (
            on("stranger_on", self.plan, name=one.name) for k, one in self.marks.items() if k % (last // STATIONS)
        )
        spots = np.array([self.zero + self.along(k) + 1j * value / self.mu for k, value in enumerate(values)])
        if not self.drawn(spots, paper):
            yield on("curve", self.plan)
        yield from self._letters(spots)

    def _letters(self, spots: Complexes) -> Iterator[Wrong]:
        """Hold the letter of a curve that is one of two, that of the axis, and the scale of the ordinates."""
        texts = self.strokes.texts
        unit = self.drafting.word("N*m" if self.letter == "M" else "N")
        if f"{self.letter.rstrip(chr(39))}, {unit}" not in texts:
            yield on("letter", self.plan, name=self.letter)
        if self.expected.compensated and self.letter != "M" and not self.strokes.lettered(self.letter, spots.tolist()):
            yield on("letter", self.plan, name=self.letter)
        found = written_scales(self.strokes.group).get(self.letter.rstrip("'"), 0.0)
        if number(found, self.drafting.language) != number(self.mu, self.drafting.language):
            yield message("wrong.scale", text=f"μ_{self.letter}")


class _Hodograph(_Course):
    """A curve of the ends of a vector."""

    def faults(self) -> Iterator[Wrong]:
        zero, mu = origin(self.strokes)
        paper = self.slack + 2 * self.measured.quantum * mu
        marks = [one for one in (*self.measured.points, *self.measured.vectors) if one.plan == self.plan]
        for number_, k in enumerate(self.stations):
            own = [one for one in marks if one.position == number_ and one.name == str(number_)]
            if not own:
                yield on("missing_on", self.plan, name=str(number_))
            if any(abs(one.value - self.values[k]) > paper for one in own):
                yield on("differs_on", self.plan, name=str(number_))
        arrows = [one for one in self.measured.vectors if one.plan == self.plan]
        if any(abs(one.value - self.values[0]) > paper for one in arrows):
            yield on("differs_on", self.plan, name=self.letter)
        if not arrows and abs(self.values[0]) > SHORT * mu:
            yield on("missing_on", self.plan, name=self.letter)
        if not self.drawn(np.asarray(zero + self.values[:-1] / mu), paper / mu):
            yield on("curve", self.plan)
