"""What a task asks for of a curve: its values at the places that a sheet marks, what each rests on (график задания).

A value is a complex number in true units: of a graph it goes along the way of the ordinates, of a loop or a profile it
is a point seen from the pole. The arrays of a figure have a value for each of its places, marked or not.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any, Final, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from drawings.checks.expected import Expected
from drawings.checks.readers import written_scales
from drawings.grading import verdict
from drawings.grading.altered import Dues, idle_due
from drawings.grading.asked import CURVES
from drawings.paper.strokes import Key, Kind, Leaf, Line
from drawings.paper.walk import flat, group_named
from drawings.reading.marks import MeasuredPoint, MeasuredVector
from drawings.reading.measure import Measured
from drawings.redrawn import Original, Originals
from geometry.hand_error import EVEN
from plans.model.dynamics import TURN
from plans.model.motion import Complexes, Floats
from plans.techniques import named, technique_of
from plans.words.words import Message

# Of what a student has drawn of the figures before it to what this figure is if it is drawn on from there.
Course: TypeAlias = Callable[[Mapping[str, Complexes]], Complexes]

# Of a slip of a mm: how far an ordinate is out, both of whose ends are pricked (standard deviation, mm).
PRICKED = float(EVEN * np.sqrt(2))
STEP = float(np.sqrt(2))  # of that: how far each step of a curve is out that is drawn on from step to step
ORDINATES, POINTS, BEARINGS, LENGTHS = "ordinates", "points", "bearings", "lengths"
SIZED = (BEARINGS, LENGTHS)  # of which a part alone is held


Place: TypeAlias = tuple[str, int | None]  # the name and the position of a mark
MARKS: Final[Mapping[type, Kind]] = MappingProxyType({MeasuredVector: Kind.VECTOR, MeasuredPoint: Kind.POINT})


class ValueAsked(NamedTuple):
    """One value that is asked for: the name and position of its mark, its place in the figure, what it is called."""

    name: str
    position: int | None
    place: int
    called: str


class Mistake(NamedTuple):
    """A mistake that has a name, and what the figure is with it; each value may go on by one size, `along`."""

    kind: str
    values: Complexes
    along: Complexes | None = None

    def fitted(self, drawn: Complexes) -> Mistake:
        """Give the mistake by the size that a drawn figure has it by."""
        there = ~np.isnan(drawn)
        if self.along is None or not there.any():
            return self
        apart, ways = (drawn - self.values)[there], self.along[there]
        size = float((apart * ways.conj()).real.sum() / (np.abs(ways) ** 2).sum())
        return self._replace(values=self.values + size * self.along)


class Paper(NamedTuple):
    """Where a graph lies on our own sheet, mm: its axis, the foot of each ordinate on it, and where along it that is.

    The last are in true units: angles turned, or a way; `turn` is so many of them as a turn has, if they are angles.
    """

    axis: tuple[complex, complex]
    feet: Complexes
    along: Floats
    turn: float | None = TURN


@dataclass(frozen=True)
class FigureAsked:
    """A curve that is asked for: its marks' plan, its sheet, what it is in true units, and how it is drawn.

    `error` is how far a hand that slips by a mm is out in each value, mm, as its standard deviation, drawn on from what
    is before it. `slack` is what the method itself leaves out. `behind` are the figures that `course` goes on from.
    """

    key: str
    plan: str
    sheet: str
    unit: str
    scales: Mapping[str, float]  # true units a mm, by the letters that they are written with; across, then up
    items: tuple[ValueAsked, ...]
    true: Complexes
    slack: Floats
    error: Floats
    kind: str = POINTS
    way: complex = 1j  # of the ordinates on paper
    paper: Paper | None = None
    behind: tuple[str, ...] = ()
    course: Course | None = None
    linear: bool = False  # whether it is out by the factor that all before it are out by
    mistakes: tuple[Mistake, ...] = ()
    on_paper: bool = False  # whether its values are mm of paper, and its scales what these stand for
    stepped: bool = False  # whether each value is laid off from the one before it
    loose: frozenset[int] = frozenset()  # places that the curve need not reach: no velocity is known there
    why: Message | None = None
    returns: bool = False  # whether it goes there and back over its axis
    curved: tuple[int, ...] = ()  # the places that one line goes through, and may be read off it
    edges: tuple[str, ...] = ()  # the names of all its places, where not its marks alone have them
    units: Mapping[str, str] = field(default_factory=dict)  # of its scales that are neither of its values nor of SI
    title: str = ""  # of its sheet

    @property
    def scale(self) -> float:
        """The scale of the values, true units a mm; of those that are mm of paper 1."""
        return 1.0 if self.on_paper else tuple(self.scales.values())[-1]

    @property
    def is_graph(self) -> bool:
        """Whether it has axes of its own, and would be read there on a form."""
        return self.kind == ORDINATES and self.paper is not None

    @property
    def largest(self) -> float:
        """The largest of its values that are known, true units: at a dead centre one may be none."""
        return float(np.nanmax(np.abs(self.true), initial=0.0))

    @property
    def numbers(self) -> dict[str, int]:
        """The places by their names."""
        named = {item.name: item.place for item in self.items}
        return named | {name: k for k, name in enumerate(self.edges)}

    @property
    def stated(self) -> dict[str, str]:
        """The letters that its scales are written with, and their units, as far as these are known."""
        last = {} if self.on_paper else {tuple(self.scales)[-1]: self.unit}
        return {letter: {**last, **self.units}.get(letter, "") for letter in self.scales if letter}

    @property
    def places(self) -> npt.NDArray[np.intp]:
        """The places that are asked for."""
        return np.array([item.place for item in self.items], dtype=np.intp)

    def off(self, drawn: Complexes, true: Complexes) -> Floats:
        """Give how far drawn values are from what they should be, true units; of a bearing across it."""
        apart = drawn - true
        if self.kind == ORDINATES:
            return np.asarray(np.abs((apart / self.way).real))
        if self.kind == LENGTHS:
            return np.asarray(np.abs(np.abs(drawn) - np.abs(true)))
        if self.kind == BEARINGS:
            long = np.maximum(np.abs(true), np.finfo(float).tiny)
            ahead = (drawn * true.conj()).real > 0
            return np.asarray(np.where(ahead, np.abs((drawn * true.conj()).imag) / long, np.abs(drawn) + np.abs(true)))
        return np.abs(apart)

    def allowed(self, slip: float, deviations: float) -> Floats:
        """Give what each value may be out, true units, of a hand that slips by so many mm."""
        return np.asarray(deviations * slip * self.scale * self.error + self.slack)

    def step(self, start: int, end: int) -> float:
        """Give by what share of what is allowed at a place the step to it from another may be out: slips add up."""
        grown = max(float(self.error[end] ** 2 - self.error[start] ** 2), 0.0)
        return float(np.sqrt(grown + PRICKED**2)) / float(self.error[end])


FLUSH = 0.05  # mm: a foot that is nearer to an axis stands on it; a sheet is written to a hundredth of that


class SceneSheet(NamedTuple):
    """A sheet of the scene as it is seen: its name, its strokes, its marks; and what is due on it."""

    name: str
    leaf: Leaf
    measured: Measured
    expected: Mapping[Key, Expected]

    def marks(self, plan: str) -> dict[Place, MeasuredVector | MeasuredPoint]:
        """Give the marks of a plan by their names and positions."""
        return {(mark.name, mark.position): mark for mark in self.measured.marks if mark.plan == plan}

    def figure(
        self, key: str, plan: str, places: Mapping[Any, int] | None = None, true: Complexes | None = None, **how: Any
    ) -> Iterator[FigureAsked]:
        """Ask for those marks of a plan that have places in a figure, or for all: they must be what is due.

        `true` are the values at all places, where more of them are known than are marked; `called` names a mark.
        """
        marks, called = self.marks(plan), how.pop("called", named_by_quantity)
        shown = {place: marks[place] for place in (marks if places is None else places) if place in marks}
        if not shown:
            return
        if places is None or true is None:
            places = {place: k for k, place in enumerate(shown)}
        values = np.zeros(len(shown), dtype=np.complex128) if true is None else true.copy()
        for place, mark in shown.items():
            row = self.expected.get((MARKS[type(mark)], plan, *place))
            if row is not None and (true is None or how.get("kind") not in SIZED) and math.isfinite(row.allowed):
                values[places[place]] = row.vector
        first = next(iter(shown.values()))
        plain = {"unit": first.unit, "scales": {self.letter(plan, first.scale): first.scale}, "slack": 0.0, **how}
        sizes = {name: np.broadcast_to(plain.get(name, PRICKED), len(values)) for name in ("slack", "error")}
        items = tuple(ValueAsked(place[0], place[1], places[place], called(mark)) for place, mark in shown.items())
        yield FigureAsked(key=key, plan=plan, sheet=self.name, items=items, true=values, **plain | sizes)

    def vectors(self, plan: str) -> dict[int, MeasuredVector]:
        """Give the ordinates of a graph by their positions."""
        ordinates = (vector for vector in self.measured.vectors if vector.plan == plan)
        return {vector.position: vector for vector in ordinates if vector.position is not None}

    def scales(self, plan: str, *figures: str) -> dict[str, float]:
        """Give the scales that are written over a figure, by their letters."""
        groups = (group_named(self.leaf.groups, name) for name in (*figures, plan))
        return {letter: mu for group in groups if group is not None for letter, mu in written_scales(group).items()}

    def letter(self, plan: str, mu: float) -> str:
        """Give the letter that a scale of a figure is written with."""
        found = (letter for letter, scale in self.scales(plan).items() if abs(scale - mu) <= WRITTEN * mu)
        return next(found, "")

    def paper(self, plan: str, abscissas: Floats, places: Mapping[int, int] | None = None) -> Paper | None:
        """Give where a graph lies, whose places are at some abscissas; None where two ordinates do not tell it.

        The places of its marks are their positions, or what `places` says of these.
        """
        feet = {k if places is None else places[k]: vector for k, vector in self.vectors(plan).items()}
        if len(feet) < 2:
            return None
        (first, vector), (last, other) = min(feet.items()), max(feet.items())
        step = (other.start - vector.start) / (abscissas[last] - abscissas[first])
        return self.over(plan, np.asarray(vector.start + step * (abscissas - abscissas[first])), abscissas)

    def over(self, plan: str, feet: Complexes, abscissas: Floats) -> Paper | None:
        """Give where a graph lies whose ordinates have some feet: the longest line of it that has all."""
        group = group_named(self.leaf.groups, plan)
        strokes = flat(() if group is None else (group,))
        lines = (line for line in strokes if isinstance(line, Line) and line.start != line.end)
        ways = ((line, (line.end - line.start) / abs(line.end - line.start)) for line in lines)
        whole = (line for line, way in ways if (np.abs(((feet - line.start) / way).imag) <= FLUSH).all())
        axis = max(whole, key=lambda line: abs(line.end - line.start), default=None)
        return None if axis is None else Paper((axis.start, axis.end), feet, abscissas)


WRITTEN = 1e-3  # of a scale: three digits are written at the least


def named_by_quantity(mark: MeasuredVector | MeasuredPoint) -> str:
    """Give what a mark is called: a number by the letter of its quantity, else with its position."""
    if mark.position is None:
        return mark.name
    return f"{mark.quantity}_{mark.name}" if mark.name.rstrip("'").isdigit() else f"{mark.name}_{mark.position}"


def by_number(marks: Mapping[int, MeasuredVector], places: Mapping[int, int] | None = None) -> dict[Place, int]:
    """Give the places of the ordinates of a graph: their positions, or what `places` says of these."""
    return {(mark.name, k): k if places is None else places[k] for k, mark in sorted(marks.items())}


def figures_asked(originals: Originals) -> tuple[FigureAsked, ...]:
    """Give the curves that the sheets of a scene ask for."""
    return tuple(figure for sheet in originals.sheets for figure in _of_sheet(originals, sheet))


def _of_sheet(originals: Originals, sheet: Original) -> Iterator[FigureAsked]:
    if row := CURVES.get(technique_of(sheet.kind)):
        read, idle = originals.read_back(sheet), idle_due(originals, sheet.kind)
        shown = SceneSheet(sheet.name, read.leaf, read.measured, originals.expected(sheet))
        figures = dict[str, FigureAsked]()
        for figure in named(row)(originals.study, shown):
            mistakes = (*([_idle(figure, idle)] if idle else ()), *figure.mistakes)
            error, title = _by_hand(figure, figures), sheet.leaf.title
            figures[figure.key] = replace(figure, mistakes=mistakes, error=error, title=title)
        yield from figures.values()


def _by_hand(figure: FigureAsked, before: Mapping[str, FigureAsked]) -> Floats:
    """Give how far a figure is out, mm a mm of slip, that is drawn on from what a hand has pricked before it."""
    known = {key: other.true for key, other in before.items()}
    if figure.course is None or not set(figure.behind) <= known.keys():
        return figure.error
    due, moved = figure.course(known), [np.zeros(len(figure.true))]
    for other in (before[key] for key in figure.behind):
        for way in (other.way,) if other.kind == ORDINATES else (1 + 0j, 1j):
            for step in np.eye(len(other.true)) * PRICKED * other.scale * way:
                both = (figure.course({**known, other.key: other.true + by}) - due for by in (step, -step))
                moved.append(np.max([np.abs(part) for part in both], axis=0))  # of a tangent one way tells nothing
    size = np.sqrt(np.nansum(np.square(moved), axis=0)) / figure.scale
    steps = np.arange(len(figure.true)) if figure.stepped else np.zeros(len(figure.true))
    return np.asarray(np.maximum(figure.error, np.hypot(size, PRICKED * np.sqrt(1 + STEP**2 * steps))))


def _idle(figure: FigureAsked, dues: Dues) -> Mistake:
    """Give a figure as it is if the idle stroke is loaded; where nothing is known of it, nothing."""
    rows = {place: dues.get((Kind.VECTOR, figure.plan, name)) for name, place in figure.numbers.items()}
    values = np.full(len(figure.true), complex(np.nan, np.nan))
    for place, row in rows.items():
        values[place] = values[place] if row is None else row.vector
    return Mistake(verdict.IDLE, values)
