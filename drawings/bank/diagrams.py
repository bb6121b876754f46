"""Figures of a bank by order and over the turn: polygons of orders, graphs of force and moment (диаграммы блока)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.bank.star import BankView, ShownOrder
from drawings.kinds import polygon
from drawings.kinds.axes import Letter, Part
from drawings.kinds.curve_graph import ANGLE, FORM, SPARE, TURN
from drawings.kinds.graph import Graph, standing
from drawings.kinds.polygon import RESULT, Letters, Polygon, Sizes
from drawings.layout.picture import Picture, Spot
from drawings.lettering.lettering import every, text_width
from drawings.lettering.words import lowered_bank
from drawings.page.page import Drafting, Scale
from drawings.paper.strokes import Stroke, Text
from drawings.rotor.polygon import CROWD
from drawings.symbols.figure import heading
from plans.bank.harmonics import FORCE, MOMENT
from plans.model.motion import Floats

NAMES = {FORCE: "order_forces", MOMENT: "order_moments"}  # of the polygons, before the order
BACK = "back"  # after the order of what turns against the crank
UNITS = {FORCE: "N", MOMENT: "N*m"}  # of the scales
SIZES = Sizes(9.0, 1.4, 5.2)
LETTERS = Letters(lowered_bank, lambda name: name.partition(",")[2])
RANGE = 2.6  # a polygon is drawn at most so many times its least: standard scales are up to 2.5 times apart
WIDEST = 0.00025  # a scale as long as one is written


def plan_of(kind: str, signed: int) -> str:
    """Name the figure of a polygon.

    >>> plan_of(MOMENT, -2)
    'order_moments-2-back'
    """
    name = f"{NAMES[kind]}-{abs(signed)}"
    return name if signed > 0 else f"{name}-{BACK}"


def polygons(shown: BankView, drafting: Drafting) -> Iterator[Polygon]:
    """Give the polygons of every order whose vectors do not vanish; of too many members the sum alone."""
    for order in shown.shown():
        vectors = order.vectors
        if len(vectors) > CROWD + 1:
            vectors = tuple(vector for vector in vectors if vector.kind == RESULT)
        if vectors:
            name, scale = plan_of(order.kind, order.signed), (order.kind, UNITS[order.kind])
            yield Polygon(name, title_of(order, drafting), scale, vectors, order.closed, LETTERS, SIZES)


def title_of(shown: ShownOrder, drafting: Drafting) -> str:
    """Give the title of a polygon: what it is of, which order, which sense."""
    name = "moments of order" if shown.kind == MOMENT else "forces of order"
    return drafting.word(name if shown.signed > 0 else f"{name} back", order=abs(shown.signed))


def polygon_room(shown: Polygon, drafting: Drafting) -> Picture:
    """Measure the room that a polygon needs, what stands under its title included."""
    room = polygon.measure(shown, drafting)
    under = text_width(Text(0j, shown.under(Scale(WIDEST, *shown.scale), drafting), drafting.hand.text))
    return room._replace(heading=max(room.heading, under), most=RANGE * room.least)


STATIONS = 12  # ordinates over the turn
ACTING, LEFT, ROCKING = "bank_force", "left_force", "bank_moment"  # of what a curve is


class TurnCurve(NamedTuple):
    """A curve over the turn: of what, its values at even angles from 0 to the whole turn, the line that draws it."""

    plan: str
    letter: str
    values: Floats
    style: str = "result"

    @property
    def angles(self) -> Floats:
        """The angles of the values, degrees."""
        return np.linspace(0.0, TURN, len(self.values))


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
        values = np.concatenate([curve.values for curve in self.curves])
        return float(values.min(initial=0.0)), float(values.max(initial=0.0))

    def measure(self, drafting: Drafting) -> Picture:
        """Measure the room of a graph."""
        return FORM.room(self.name, TURN, ANGLE, self.title, drafting.hand)

    def draw(self, room: Picture, spot: Spot, drafting: Drafting) -> Part:
        """Draw the graph in its spot, with its title and both of its scales above it."""
        hand, unit = drafting.hand, drafting.word(self.unit)
        axes = standing(room, spot, self.span, (self.letter.lstrip("Σz"), self.unit), drafting)
        graph = Graph(self.name, axes, hand)
        told = f";  {drafting.word('compensated force')}" if len(self.curves) > 1 else ""
        lines: list[Stroke] = [heading(spot.box, self.title, drafting.scale(spot.scale, axes.up) + told, hand)]
        lines += axes.lines((0.0, TURN), self.span, hand, self.name)
        apart = (text_width(Text(0j, "360", hand.number)) + SPARE * hand.number) * axes.across.mu
        shown = stations(self.curves[0])[:: every(apart / TURN * STATIONS, STATIONS)]
        for curve in self.curves:
            for k in shown:
                part = graph._replace(name=curve.plan)
                lines += part.station(float(curve.angles[k]), [float(curve.values[k])], number(curve, k), k)
            lines.append(graph.stated(curve.plan, graph.curve(curve.angles, curve.values, getattr(hand, curve.style))))
        first, ends = self.curves[0], graph.ends((TURN, ", ".join(ANGLE)), (self.span[1], f"{self.letter}, {unit}"))
        numbers = (graph.number(float(first.angles[k]), number(first, k), first.values[k]) for k in shown)
        return Part(self.name, tuple(lines), (*ends, *_letters(self, graph), *numbers))


def stations(curve: TurnCurve) -> range:
    """Give which values have ordinates."""
    whole = len(curve.values) - 1
    return range(0, whole + 1, whole // STATIONS)


def number(curve: TurnCurve, k: int) -> str:
    """Number the station of a value by the crank's angle, as the scheme of the mechanism is."""
    return f"{curve.angles[k]:.0f}"


def _letters(shown: TurnGraph, graph: Graph) -> Iterator[Letter]:
    """Letter each of several curves where it is farthest from zero, clear of the axis of ordinates."""
    for curve in shown.curves if len(shown.curves) > 1 else ():
        clear = (len(curve.values) - 1) // (2 * STATIONS)
        k = clear + int(np.abs(curve.values[clear:-clear]).argmax())
        spot = graph.axes.on(float(curve.angles[k]), float(curve.values[k]))
        yield Letter(spot, curve.letter, graph.hand.letter, math.copysign(math.pi / 2, curve.values[k]))
