"""The graph of a quantity over the angle of the crank: axes, positions, ordinates and a smooth curve (график)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from drawings.kinds.axes import BEYOND, Axes
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.extent import every, numbered
from drawings.lettering.lettering import text_width
from drawings.page.scale import Drafting, Scale, fitting
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import INK, Circle, Group, Line, LineStyle, Polyline, Stroke, Text
from drawings.paper.walk import stating, tied
from drawings.symbols.dashes import fit_dashes
from drawings.symbols.figure import Subject, heading
from drawings.symbols.symbols import TICK
from plans.model.motion import Floats

TURN = 360.0  # degrees
RATIO = 1.6  # a graph is drawn so many times as long as it is high
TALLER = 1.6  # times as high as that, where there is room
TALLEST = 2.0  # times the largest of the positions: towards a dead centre of a drive forces have no limit
MARGINS = Margins(3.2, 1.6, 1.0)  # paper around the graph for letters and numbers, in sizes of a letter
LETTERS = 18.0  # a graph is drawn at least so many of its letters long: its positions are numbered
DOT = 0.7  # mm, radius of a point of the curve
LEAN = 0.5  # of the angle to the axis, by which a number is leant towards one side of its tick
BELOW = -math.pi / 2  # a number stands on the side of its axis away from the ordinate
ROUNDED = 1e-9  # degrees: angles of positions are rounded sums
LEAST = 0.05  # mm: a shorter ordinate is a point
BEFORE = "before"  # the name of the thin curve
APART = 2.4  # sizes of a number from one number to the next, where they stand apart
SPARE = 0.5  # sizes of a number that stay free between two
DOTTED = 3.0  # radii of a point from one point to the next: nearer ones run into a line


ANGLE, WAY = ("φ", "°"), ("s", "m")  # letter and unit of an axis


class GraphCurve(NamedTuple):
    """A quantity over the angle of the crank, degrees in the sense of rotation; NaN is a gap.

    Over the stroke of a slide that is pushed along the abscissas are metres from where it begins.
    A crank that turns fully is followed over a turn from position 0 on, any other one through its positions.
    """

    letter: str  # marked up: "M_{bal}"
    unit: str
    angles: Floats  # dense, from 0 on
    values: Floats
    stations: Floats  # of the positions
    ordinates: Floats
    title: str = ""
    divisions: int = 0  # of the whole turn, where its end has a number and numbers stand apart
    before: Floats | None = None  # what the quantity was before a change, as dense: a thin curve
    numbers: tuple[int, ...] = ()  # of the positions, where these are not all
    axis: tuple[str, str] = ANGLE  # letter and unit of the abscissas
    shown: tuple[int, ...] = ()  # the places of those that the sheets of its set are of: they are always numbered
    stated: float = 0.0  # mu of the quantity, where it is stated
    states: str = ""  # the name of the curve, by which its graph states it; the thin one is this, "before"

    @property
    def span(self) -> tuple[float, float]:
        """The least and the largest value, zero among them."""
        values = np.concatenate([self.values, self.ordinates, *([] if self.before is None else [self.before])])
        return float(np.nanmin(values, initial=0.0)), float(np.nanmax(values, initial=0.0))

    @property
    def length(self) -> float:
        """The angle in degrees that the graph goes through."""
        return float(self.angles[-1])

    @property
    def closed(self) -> bool:
        """Does the graph end where it began, at position 0 after a turn?"""
        return abs(self.length - TURN) <= ROUNDED and self.axis == ANGLE


def swing(curve: GraphCurve) -> GraphCurve:
    """Give the part of a curve over a turn that a crank which cannot turn fully passes through in its positions."""
    reached = np.array(sorted({*curve.stations[~np.isnan(curve.ordinates)]}))
    if not np.isnan(curve.values).any() or len(reached) < 2:
        return curve
    apart = np.diff(reached, append=reached[0] + TURN)
    start, length = np.roll(reached, -1)[apart.argmax()], TURN - apart.max()
    stations, angles = (np.mod(row - start, TURN) for row in (curve.stations, curve.angles[:-1]))
    values, turns = np.concatenate([curve.values[:-1], curve.ordinates]), np.concatenate([angles, stations])
    order = np.argsort(turns, kind="stable")
    order = order[turns[order] <= length + ROUNDED]
    return curve._replace(angles=turns[order], values=values[order], stations=stations)


def bounded(dense: Any, own: Any) -> Any:
    """Break a dense curve with gaps where it outgrows its positions: it goes to infinity beside a gap."""
    if not np.isnan(dense).any():
        return dense
    return np.where(np.abs(dense) > TALLEST * np.nanmax(np.abs(own), initial=0.0), np.nan, dense)


def measure(curve: GraphCurve, name: str, drafting: Drafting) -> Picture:
    """Measure the room of a graph: its scale is that of the angle, the quantity's own follows from the height."""
    hand = drafting.hand
    side, below, above = (size * hand.letter for size in MARGINS)
    margins = Margins(side + BEYOND / 2, below, above + BEYOND + 2 * hand.title + hand.text)
    high = curve.length / RATIO
    heading = text_width(Text(0j, curve.title, hand.title))
    middle, least = complex(curve.length, high) / 2, LETTERS * hand.letter
    return Picture(name, curve.length, high, middle, *curve.axis, margins, heading, least, taller=TALLER)


def scale_of(curve: GraphCurve, room: Picture, spot: Spot, standard: str) -> Scale:
    """Choose the largest standard scale of the quantity for the height of a graph."""
    low, high = curve.span
    symbol = curve.letter.split("_")[0].split("^")[0]
    if curve.stated:
        return Scale(curve.stated, symbol, curve.unit)
    return fitting(high - low, room.high / spot.scale.mu, symbol, curve.unit, standard)


class GraphFigure(NamedTuple):
    """A graph placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    curve: GraphCurve
    name: str
    lines: tuple[Stroke, ...]
    stations: tuple[tuple[str, complex, float], ...]  # number, foot, side of the number
    axes: tuple[tuple[str, complex, float], ...]  # letter, end of the axis, side of the letter
    hand: Hand

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole graph, its positions numbered and its axes lettered."""
        hand = self.hand
        letters = [labels.beside(end, letter, hand.letter, 1.2, side) for letter, end, side in self.axes]
        letters += [labels.beside(at, number, hand.number, TICK + 0.6, side) for number, at, side in self._parted()]
        return (Group((*self.lines, Group(tuple(letters))), self.name),)

    def _parted(self) -> Sequence[tuple[str, complex, float]]:
        """Lean numbers without room side by side apart, the left one to the left: they stand in the order of feet."""
        sides = {one: one[2] for one in self.stations}
        for one, other in pairwise(sorted(self.stations, key=lambda station: station[1].real)):
            if (other[1] - one[1]).real < text_width(Text(0j, other[0], self.hand.number)) + SPARE * self.hand.number:
                sides |= {one: one[2] * (1 + LEAN), other: other[2] * (1 - LEAN)}
        return [(number, at, side) for (number, at, _), side in sides.items()]


def draw(curve: GraphCurve, room: Picture, spot: Spot, drafting: Drafting) -> GraphFigure:
    """Draw the graph in its spot, with its title and both of its scales above it."""
    room = room.filling(spot)
    hand, scale = drafting.hand, scale_of(curve, room, spot, drafting.standard)
    place = room.place(*spot)
    low, high = curve.span
    spare = room.high / spot.scale.mu - (high - low) / scale.mu
    zero = place.on(0j)
    frame = Axes(zero + 1j * (spare / 2 - low / scale.mu), spot.scale, scale)
    scales = f"{drafting.scale(spot.scale)};  {drafting.scale(scale)}"
    scales += "" if curve.before is None else f";  {drafting.word('thin before')}"
    ordinates, stations = _ordinates(curve, room.name, frame, hand)
    title = heading(spot.box, curve.title, scales, hand)
    curves = [*_before(curve, room.name, frame, hand)]
    curves += _said(curve, room.name, curve.states, _line(curve.angles, curve.values, frame, hand.result))
    lines = (title, *_axes(curve, room.name, frame, hand), *ordinates, *curves)
    last = frame.on(curve.length)
    ends = (frame.on(0.0, high) + 1j * BEYOND, last + BEYOND)
    axes = ((f"{curve.letter}, {drafting.word(curve.unit)}", ends[0], 0.0), (curve.axis[0], ends[1], math.pi / 2))
    if curve.closed:
        stations.append((str(curve.divisions), last, BELOW))  # of no divisions: position 0 again
    return GraphFigure(curve, room.name, lines, tuple(stations), axes, hand)


def _numbered(curve: GraphCurve, feet: Sequence[complex], length: float, hand: Hand) -> tuple[int, ...]:
    """Choose the positions that bear numbers and ordinates: no nearer to one another than their letters."""
    if curve.divisions:
        step = every(APART * hand.number * curve.divisions / length, curve.divisions)
        return tuple(range(0, len(feet), step))
    last = max(curve.numbers, default=len(feet) - 1)
    wide = text_width(Text(0j, str(last), hand.number))
    # Where a turn ends with position 0 again it begins with its number, and that of the shown one is beside it.
    first = dict.fromkeys((*([0] if curve.closed else []), *curve.shown))
    return numbered(feet, length, wide + SPARE * hand.number, first)


def _axes(curve: GraphCurve, plan: str, frame: Axes, hand: Hand) -> Iterator[Stroke]:
    """Draw both axes with their arrowheads, and a tick at their end."""
    last = frame.on(curve.length)
    yield from frame.lines((0.0, curve.length), curve.span, hand, plan if curve.states else "")
    yield Line(last - 1j * TICK, last + 1j * TICK, hand.other)


def _ordinates(
    curve: GraphCurve, plan: str, frame: Axes, hand: Hand
) -> tuple[list[Stroke], list[tuple[str, complex, float]]]:
    """Draw tick, ordinate and point of each position that is no gap; each ordinate can be measured.

    Where numbers have no room, a position between two of them has its tick and its point alone, and where even these
    have none, not all positions have them.
    """
    strokes: list[Stroke] = []
    stations: list[tuple[str, complex, float]] = []
    gone = complex(math.nan, math.nan)  # a gap beyond the last position that is held
    length = abs(frame.on(curve.length) - frame.zero)
    places = [frame.on(float(angle)) for angle in curve.stations]
    feet = [foot if tied(abs(foot - frame.zero) - length) <= 0 else gone for foot in places]
    known = _numbered(curve, feet, length, hand)
    pointed = [k for k, foot in enumerate(feet) if foot is not gone]
    for k in pointed if curve.divisions else numbered(feet, length, DOTTED * DOT * hand.symbol, known):
        foot, value = feet[k], float(curve.ordinates[k])
        number = curve.numbers[k] if curve.numbers else k
        if k in known:
            stations.append((str(number), foot, -BELOW if frame.below(value) else BELOW))
        strokes.append(Line(foot - 1j * TICK, foot + 1j * TICK, hand.drafted))
        if math.isnan(value):
            continue
        tip = frame.on(float(curve.stations[k]), value)
        if k in known and abs(tip - foot) > LEAST:
            data = Subject(plan, frame.up.letter, number).data("vector", str(number), 1j * value, frame.up)
            style = hand.relative if k in curve.shown else hand.drafted
            strokes.append(Group((Line(foot, tip, style),), "", data, str(number)))
        strokes.append(Circle(tip, DOT * hand.symbol, INK))
    return strokes, stations


def _before(curve: GraphCurve, plan: str, frame: Axes, hand: Hand) -> Iterator[Stroke]:
    if curve.before is not None:
        lines = _line(curve.angles, curve.before, frame, hand.other)
        yield Group(tuple(_said(curve, plan, f"{curve.states}, {BEFORE}", lines)), BEFORE)


def _said(curve: GraphCurve, plan: str, name: str, lines: Iterator[Stroke]) -> Iterator[Stroke]:
    """Give a curve as what it states, where the graph states any."""
    yield from (stating(Statement(Kind.CURVE, plan, name), *lines),) if curve.states else lines


def _line(angles: Floats, values: Floats, frame: Axes, style: LineStyle) -> Iterator[Stroke]:
    """Draw a curve, broken at its gaps."""
    for run in stretches(values):
        points = [frame.on(float(angles[k]), float(values[k])) for k in run]
        yield from fit_dashes([Polyline(tuple(points), False, style)])


def stretches(values: Floats) -> Iterator[Sequence[int]]:
    """Give the runs of places between the gaps of dense values, two places long at least.

    >>> [list(run) for run in stretches(np.array([1.0, 2.0, math.nan, 3.0, 4.0, math.nan, 5.0]))]
    [[0, 1], [3, 4]]
    """
    gaps = np.flatnonzero(np.isnan(values))
    for run in np.split(np.arange(len(values)), sorted({*gaps.tolist(), *(gaps + 1).tolist()})):
        if len(run) > 1:
            yield [int(k) for k in run]
