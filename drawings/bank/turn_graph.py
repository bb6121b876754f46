"""The graph of the force or the moment of a bank along its guides over a turn, before and after (график по углу)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from drawings.kinds.axes import BEYOND, Axes
from drawings.kinds.curve_graph import BELOW, LEAST, LETTERS, MARGINS, RATIO, TALLER, TURN
from drawings.layout.labels import Labels
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.lettering import text_width
from drawings.page.scale import Drafting, Scale, fitting
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import INK, Circle, Group, Line, Polyline, Stroke, Text
from drawings.paper.walk import stating
from drawings.symbols.dashes import fit_dashes
from drawings.symbols.figure import Subject, heading
from drawings.symbols.symbols import TICK
from plans.model.motion import Floats

STATIONS = 12  # ordinates over the turn
DOT = 0.7  # mm, radius of a point of a curve
FORCE, LEFT, MOMENT = "bank_force", "left_force", "bank_moment"  # of what a curve is


class TurnCurve(NamedTuple):
    """A curve over the turn: of what, its values at even angles from 0 to the whole turn, the line that draws it."""

    plan: str
    letter: str
    values: Floats
    style: str = "result"


class TurnGraph(NamedTuple):
    """A graph of curves of one quantity: its name, its title, the letter and the unit of its scale."""

    name: str
    title: str
    letter: str
    unit: str
    curves: tuple[TurnCurve, ...]

    @property
    def span(self) -> tuple[float, float]:
        """The least and the largest value, zero among them."""
        values = np.concatenate([one.values for one in self.curves])
        return float(values.min(initial=0.0)), float(values.max(initial=0.0))


@dataclass(frozen=True)
class TurnGraphFigure:
    """A graph placed on paper: its lines, and the letters still to be placed among the lines of all figures."""

    shown: TurnGraph
    axes: Axes
    lines: tuple[Stroke, ...]
    drafting: Drafting

    def letter(self, labels: Labels) -> tuple[Group, ...]:
        """Give the whole graph: its axes and curves lettered, its stations numbered."""
        letters = (*self._axes(labels), *self._curves(labels), *self._stations(labels))
        return (Group((*self.lines, Group(letters)), self.shown.name),)

    def _axes(self, labels: Labels) -> Iterator[Stroke]:
        hand, high = self.drafting.hand, self.shown.span[1]
        text = f"{self.shown.letter}, {self.drafting.word(self.shown.unit)}"
        yield labels.beside(self.axes.on(0.0, high) + 1j * BEYOND, text, hand.letter, 1.2, 0.0)
        yield labels.beside(self.axes.on(TURN) + BEYOND, "φ", hand.letter, 1.2, math.pi / 2)

    def _curves(self, labels: Labels) -> Iterator[Stroke]:
        """Letter each of several curves where it is farthest from zero."""
        for one in self.shown.curves if len(self.shown.curves) > 1 else ():
            k = int(np.abs(one.values).argmax())
            spot, side = on(self.axes, one, k), math.copysign(math.pi / 2, one.values[k])
            yield labels.beside(spot, one.letter, self.drafting.hand.letter, 1.2, side)

    def _stations(self, labels: Labels) -> Iterator[Stroke]:
        first = self.shown.curves[0]
        for k in stations(first):
            side = -BELOW if self.axes.below(float(first.values[k])) else BELOW
            foot = self.axes.on(angle(first, k))
            yield labels.beside(foot, number(first, k), self.drafting.hand.number, TICK + 0.6, side)


def angle(one: TurnCurve, k: int) -> float:
    """Give the angle in degrees of a value of a curve."""
    return TURN * k / (len(one.values) - 1)


def on(axes: Axes, one: TurnCurve, k: int) -> complex:
    """Give the place on paper of a value of a curve."""
    return axes.on(angle(one, k), float(one.values[k]))


def stations(one: TurnCurve) -> range:
    """Give which values have ordinates."""
    whole = len(one.values) - 1
    return range(0, whole + 1, whole // STATIONS)


def number(one: TurnCurve, k: int) -> str:
    """Number the station of a value; the turn ends in 0 again."""
    return str(k * STATIONS // (len(one.values) - 1) % STATIONS)


def measure(shown: TurnGraph, drafting: Drafting) -> Picture:
    """Measure the room of a graph: its scale is that of the angle, the quantity's own follows from the height."""
    hand = drafting.hand
    side, below, above = (size * hand.letter for size in MARGINS)
    margins = Margins(side + BEYOND / 2, below, above + BEYOND + 2 * hand.title + hand.text)
    title, high = text_width(Text(0j, shown.title, hand.title)), TURN / RATIO
    least = LETTERS * hand.letter
    return Picture(shown.name, TURN, high, complex(TURN, high) / 2, "φ", "°", margins, title, least, taller=TALLER)


def draw(shown: TurnGraph, room: Picture, spot: Spot, drafting: Drafting) -> TurnGraphFigure:
    """Draw the graph in its spot, with its title and both of its scales above it."""
    room = room.filling(spot)
    hand, (low, high), symbol = drafting.hand, shown.span, shown.letter.lstrip("Σz")
    scale = fitting(high - low, room.high / spot.scale.mu, symbol, shown.unit, drafting.standard)
    axes = _placed(shown, room, spot, scale)
    scales = f"{drafting.scale(spot.scale)};  {drafting.scale(scale)}"
    lines = [heading(spot.box, shown.title, scales, hand), *axes.lines((0.0, TURN), shown.span, hand, shown.name)]
    for one in shown.curves:
        course = stating(Statement(Kind.CURVE, shown.name, one.plan), *_line(one, axes, hand))
        lines += [*_ordinates(one, axes, hand), course]
    return TurnGraphFigure(shown, axes, tuple(lines), drafting)


def _placed(shown: TurnGraph, room: Picture, spot: Spot, scale: Scale) -> Axes:
    """Put the axes so that what the graph needs of its height stands in the middle."""
    low, high = shown.span
    spare = room.high / spot.scale.mu - (high - low) / scale.mu
    zero = room.place(*spot).on(0j) + 1j * (spare / 2 - low / scale.mu)
    return Axes(zero, spot.scale, scale)


def _ordinates(one: TurnCurve, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Draw tick, ordinate and point of each station; each ordinate can be measured."""
    for k in stations(one):
        foot, tip, value = axes.on(angle(one, k)), on(axes, one, k), float(one.values[k])
        yield Line(foot - 1j * TICK, foot + 1j * TICK, hand.drafted)
        if abs(tip - foot) > LEAST:
            data = Subject(one.plan, axes.up.letter, k).data("vector", number(one, k), 1j * value, axes.up)
            yield Group((Line(foot, tip, hand.drafted),), "", data, number(one, k))
        yield Circle(tip, DOT * hand.symbol, INK)


def _line(one: TurnCurve, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    points = tuple(on(axes, one, k) for k in range(len(one.values)))
    yield from fit_dashes([Polyline(points, False, getattr(hand, one.style))])
