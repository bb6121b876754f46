"""The graph of a quantity over the angle of the crank: axes, positions, ordinates and a smooth curve (график)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from drawings.kinds.axes import Letter, Part
from drawings.kinds.graph import DOT, TURNED, Graph, GraphForm, dashed, leaps, standing
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.lettering import every, numbered, text_width
from drawings.page.page import Drafting
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Stroke, Text
from drawings.paper.walk import tied
from drawings.symbols.figure import explained, heading
from plans.model.motion import Floats

TURN = 360.0  # degrees
TALLEST = 2.0  # times the largest of the positions: towards a dead centre of a drive forces have no limit
FORM = GraphForm(1.6, 1.6, Margins(3.2, 1.6, 1.0), 18.0)
LEAN = 0.5  # of the angle to the axis, by which a number is leant towards one side of its tick
ROUNDED = 1e-9  # degrees: angles of positions are rounded sums
BEFORE = "before"  # the name of the thin curve
APART = 2.4  # sizes of a number from one number to the next, where they stand apart
SPARE = 0.5  # sizes of a number that stay free between two
DOTTED = 3.0  # radii of a point from one point to the next: nearer ones run into a line


NUMBER = "1"  # the unit of a bare number
ANGLE, WAY = ("φ", "°"), ("s", "m")  # letter and unit of the scale of an axis


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
    name: str = ""  # of the graph
    under: tuple[str, ...] = ()  # lines below its scales: what its abscissas are
    states: str = ""  # the name of the curve, by which its graph states it; the thin one is this, "before"
    form: GraphForm = FORM

    @property
    def span(self) -> tuple[float, float]:
        """The least and the largest value, zero among them."""
        values = np.concatenate([self.values, self.ordinates, *([] if self.before is None else [self.before])])
        return float(np.nanmin(values, initial=0.0)), float(np.nanmax(values, initial=0.0))

    def lettered(self, drafting: Drafting) -> str:
        """Letter its axis, with the unit where it is no bare number."""
        return self.letter if self.unit == NUMBER else f"{self.letter}, {drafting.word(self.unit)}"

    @property
    def symbol(self) -> str:
        """The letter of the scale."""
        return self.letter.split("_")[0].split("^")[0]

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


def bounded(dense: Any, nodes: Any) -> Any:
    """Break a dense curve with gaps where it outgrows its positions: it goes to infinity beside a gap."""
    if not np.isnan(dense).any():
        return dense
    return np.where(np.abs(dense) > TALLEST * np.nanmax(np.abs(nodes), initial=0.0), np.nan, dense)


def measure(curve: GraphCurve, drafting: Drafting) -> Picture:
    """Measure the room of a graph."""
    room = curve.form.room(curve.name, curve.length, curve.axis, curve.title, drafting.hand)
    return explained(room, curve.under, drafting.hand)


def draw(curve: GraphCurve, room: Picture, spot: Spot, drafting: Drafting) -> Part:
    """Draw the graph in its spot, with its title and both of its scales above it."""
    hand, (_, high) = drafting.hand, curve.span
    axes = standing(room, spot, curve.span, (curve.symbol, curve.unit), drafting, curve.stated)
    graph = Graph(room.name, axes, hand)
    scales = drafting.scale(spot.scale, axes.up)
    if curve.before is not None:
        apart = np.nan_to_num(np.abs(curve.before - curve.values)).max() / axes.up.mu
        scales += f";  {drafting.word('thin before' if apart > hand.result.width / 2 else 'before as after')}"
    (ordinates, numbers), jumps = _ordinates(curve, graph), leaps(curve.values)
    before = None if curve.before is None else graph.curve(curve.angles, curve.before, hand.other)
    lines = (
        heading(spot.box, curve.title, scales, hand, *curve.under),
        *axes.lines((0.0, curve.length), curve.span, hand, room.name if curve.states else ""),
        graph.tick(curve.length, hand.other),
        *ordinates,
        *([Group(tuple(_said(curve, graph, f"{curve.states}, {BEFORE}", before)), BEFORE)] if before else []),
        *_said(curve, graph, curve.states, graph.curve(curve.angles, curve.values, hand.result, jumps)),
        *dashed(graph.places(curve.angles, curve.values), jumps, hand),
    )
    if curve.closed:
        numbers.append(graph.number(curve.length, str(curve.divisions)))  # of no divisions: position 0 again
    across = TURNED if curve.axis == ANGLE else curve.axis[0]
    ends = graph.ends((curve.length, across), (high, curve.lettered(drafting)))
    return Part(room.name, lines, (*ends, *_parted(numbers)))


def _parted(numbers: Sequence[Letter]) -> Sequence[Letter]:
    """Lean numbers without room side by side apart, the left one to the left: they stand in the order of feet."""
    letters = dict.fromkeys(numbers)
    sides = {letter: letter.side for letter in letters}
    for left, other in pairwise(sorted(letters, key=lambda letter: letter.at.real)):
        if (other.at - left.at).real < text_width(Text(0j, other.text, left.size)) + SPARE * left.size:
            sides |= {left: left.side * (1 + LEAN), other: other.side * (1 - LEAN)}
    return [letter._replace(side=side) for letter, side in sides.items()]


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


def _ordinates(curve: GraphCurve, graph: Graph) -> tuple[list[Stroke], list[Letter]]:
    """Draw tick, ordinate and point of each position that is no gap, and give the numbers.

    Where numbers have no room, a position between two of them has its tick and its point alone, and where even these
    have none, not all positions have them.
    """
    strokes: list[Stroke] = []
    letters: list[Letter] = []
    axes, hand = graph.axes, graph.hand
    gone = complex(math.nan, math.nan)  # a gap beyond the last position that is held
    length = abs(axes.on(curve.length) - axes.zero)
    places = [axes.on(float(angle)) for angle in curve.stations]
    feet = [foot if tied(abs(foot - axes.zero) - length) <= 0 else gone for foot in places]
    known = _numbered(curve, feet, length, hand)
    pointed = [k for k, foot in enumerate(feet) if foot is not gone]
    for k in pointed if curve.divisions else numbered(feet, length, DOTTED * DOT * hand.symbol, known):
        x, value, number = float(curve.stations[k]), float(curve.ordinates[k]), curve.numbers[k] if curve.numbers else k
        strokes.append(graph.tick(x))
        if k in known:
            letters.append(graph.number(x, str(number), value))
        if math.isnan(value):
            continue
        if k in known:
            style = hand.relative if k in curve.shown else hand.drafted
            strokes += graph.ordinate(x, value, str(number), number, style)
        strokes.append(graph.dot(x, value))
    return strokes, letters


def _said(curve: GraphCurve, graph: Graph, name: str, lines: Iterator[Stroke]) -> Iterator[Stroke]:
    """Give a curve as what it states, where the graph states any."""
    yield from (graph.stated(name, lines),) if curve.states else lines
