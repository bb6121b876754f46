"""A graph: its room, its axes in their spot, ticks, ordinates, curves, numbers; techniques give the values (график)."""

import cmath
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from drawings.kinds.axes import BEYOND, Axes, Letter
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.lettering import text_width
from drawings.page.page import Drafting, Scale, fitting
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Circle, Group, Kind, Line, LineStyle, Polyline, Statement, Stroke, Text
from drawings.paper.walk import apart, stating
from drawings.symbols.figure import Subject, around
from drawings.symbols.symbols import TICK, fit_dashes
from plans.model.motion import Complexes, Floats

DOT = 0.7  # mm, radius of a point of a curve
LEAST = 0.05  # mm: a shorter ordinate is a point
SEEN, JUMP = 0.01, 8.0  # of the largest value, and times the steps beside it: a smooth curve changes less in a step
TURNED = "Δφ"  # what the crank has turned from the first position of a graph on; φ is its angle from the x axis
BESIDE, HEADS = 1.0, 2.0  # mm from the end of a tick to its number, and from the tip of an axis to its letter


class GraphForm(NamedTuple):
    """How graphs of one kind stand on paper: what they measure."""

    ratio: float  # one is drawn so many times as long as it is high
    taller: float  # times as high as that, where there is room
    margins: Margins  # paper around it for letters, in their sizes
    letters: float  # it is drawn at least so many of its letters long

    def room(self, name: str, long: float, axis: tuple[str, str], title: str, hand: Hand) -> Picture:
        """Measure a graph: its scale is that of the abscissas, the one of the ordinates follows from its height."""
        margins = around(self.margins, hand, BEYOND / 2, 0.0, BEYOND)
        wide, high = text_width(Text(0j, title, hand.title)), long / self.ratio
        middle, least = complex(long, high) / 2, self.letters * hand.letter
        return Picture(name, long, high, middle, *axis, margins, wide, least, taller=self.taller)


def standing(
    room: Picture, spot: Spot, span: tuple[float, float], up: tuple[str, str], drafting: Drafting, stated: float = 0.0
) -> Axes:
    """Stand axes in a spot: ordinates at the largest standard scale for their span, or at a stated one.

    `up` is the letter and the unit of the ordinates. What height their scale leaves lies below: a graph hangs from its
    heading.
    """
    room, (_, high) = room.filling(spot), span
    tall = room.high / spot.scale.mu
    scale = Scale(stated, *up) if stated else fitting(high - span[0], tall, *up, drafting.standard)
    return Axes(room.place(*spot).on(0j) + 1j * (tall - high / scale.mu), spot.scale, scale)


class Graph(NamedTuple):
    """A graph that is drawn: the name by which it states, its axes, the hand that draws it."""

    name: str
    axes: Axes
    hand: Hand

    def tick(self, x: float, style: LineStyle | None = None) -> Line:
        """Draw the tick of an abscissa."""
        foot, half = self.axes.on(x), TICK * self.axes.rise
        return Line(foot - half, foot + half, style or self.hand.drafted)

    def ordinate(
        self,
        x: float,
        value: float,
        name: str,
        position: int | None = None,
        style: LineStyle | None = None,
        title: str = "",
        least: float = LEAST,
    ) -> Iterator[Stroke]:
        """Draw an ordinate from the axis, which can be measured; one that is too short is none."""
        foot, tip = self.axes.on(x), self.axes.on(x, value)
        if abs(tip - foot) > least:
            subject = Subject(self.name, self.axes.up.letter.strip("{}"), position)
            data = subject.data("vector", name, self.axes.rise * value, self.axes.up)
            yield Group((Line(foot, tip, style or self.hand.drafted),), "", data, title or name)

    def dot(self, x: float, value: float, radius: float = DOT, style: LineStyle = INK) -> Circle:
        """Draw the point of a value."""
        return Circle(self.axes.on(x, value), radius * self.hand.symbol, style)

    def station(
        self,
        x: float,
        sides: Sequence[float],
        name: str,
        position: int | None = None,
        numbered: bool = True,
        radius: float = DOT,
    ) -> Iterator[Stroke]:
        """Draw a tick, its ordinate where it is numbered, the point of a value, or those of both sides of a jump."""
        yield self.tick(x)
        if numbered:
            yield from self.ordinate(x, sides[0], name, position)
        tips = apart(self.axes.on(x, value) for value in sides)
        yield from (Circle(tip, radius * self.hand.symbol, INK) for tip in tips)

    def places(self, x: Floats, y: Floats) -> tuple[complex, ...]:
        """Give the places of values on paper."""
        return tuple(self.axes.on(*spot) for spot in zip(x.tolist(), y.tolist(), strict=True))

    def curve(self, x: Floats, y: Floats, style: LineStyle, jumps: Sequence[int] = ()) -> Iterator[Stroke]:
        """Draw a curve, broken at its gaps and jumps."""
        for run in stretches(y, jumps):
            part = slice(run[0], run[-1] + 1)
            yield from fit_dashes([Polyline(self.places(x[part], y[part]), False, style)])

    def stated(self, curve: str, strokes: Iterable[Stroke]) -> Group:
        """Give strokes as a curve of the graph, by its name."""
        return stating(Statement(Kind.CURVE, self.name, curve), *strokes)

    def ends(self, across: tuple[float, str], up: tuple[float, str]) -> Iterator[Letter]:
        """Letter both axes, each at the end of what it goes over."""
        axes, size = self.axes, self.hand.letter
        yield Letter(axes.on(0.0, up[0]) + BEYOND * axes.rise, up[1], size, cmath.phase(axes.along), HEADS)
        yield Letter(axes.on(across[0]) + BEYOND * axes.along, across[1], size, cmath.phase(axes.rise))

    def number(self, x: float, text: str, value: float = 0.0) -> Letter:
        """Number an abscissa at the axis, on the side away from its ordinate."""
        away = self.axes.rise if self.axes.below(value) else -self.axes.rise
        return Letter(self.axes.on(x), text, self.hand.number, cmath.phase(away), TICK + BESIDE)


def leaps(values: Floats | Complexes) -> list[int]:
    """Give the places after which dense values jump (скачок): where one step is many times those on either side of it.

    >>> leaps(np.array([0.0, 0.1, 0.2, 5.0, 5.1, 5.2])), leaps(np.array([0.0, 1.0, 2.0, 4.0]))
    ([2], [])
    """
    steps = np.abs(np.diff(values))
    around = np.pad(steps, 1, constant_values=np.nan)
    seen = steps > SEEN * np.nanmax(np.abs(values), initial=0.0)
    return [int(k) for k in np.flatnonzero(seen & (steps > JUMP * np.fmax(around[:-2], around[2:])))]


def dashed(places: Sequence[complex], jumps: Sequence[int], hand: Hand) -> Iterator[Stroke]:
    """Draw the jumps of a curve in dashed lines, from the places before them to those behind."""
    return fit_dashes(Line(places[k], places[k + 1], hand.path) for k in jumps)


def stretches(values: Floats, jumps: Sequence[int] = ()) -> Iterator[Sequence[int]]:
    """Give the runs of places between the gaps and the jumps of dense values, two places long at least.

    >>> [list(run) for run in stretches(np.array([1.0, 2.0, np.nan, 3.0, 4.0, np.nan, 5.0]))]
    [[0, 1], [3, 4]]
    """
    gaps = np.flatnonzero(np.isnan(values))
    ends = sorted({*gaps.tolist(), *(gaps + 1).tolist(), *(k + 1 for k in jumps)})
    for run in np.split(np.arange(len(values)), ends):
        if len(run) > 1:
            yield [int(k) for k in run]
