"""The graph of the force or the moment of a bank along its guides over a turn, before and after (график по углу)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.kinds.axes import Letter, Part
from drawings.kinds.curve_graph import ANGLE, FORM, TURN
from drawings.kinds.graph import Graph, standing
from drawings.layout.picture import Picture, Spot
from drawings.page.scale import Drafting
from drawings.paper.strokes import Stroke
from drawings.symbols.figure import heading
from plans.model.motion import Floats

STATIONS = 12  # ordinates over the turn
FORCE, LEFT, MOMENT = "bank_force", "left_force", "bank_moment"  # of what a curve is


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


def stations(curve: TurnCurve) -> range:
    """Give which values have ordinates."""
    whole = len(curve.values) - 1
    return range(0, whole + 1, whole // STATIONS)


def number(curve: TurnCurve, k: int) -> str:
    """Number the station of a value; the turn ends in 0 again."""
    return str(k * STATIONS // (len(curve.values) - 1) % STATIONS)


def measure(shown: TurnGraph, drafting: Drafting) -> Picture:
    """Measure the room of a graph."""
    return FORM.room(shown.name, TURN, ANGLE, shown.title, drafting.hand)


def draw(shown: TurnGraph, room: Picture, spot: Spot, drafting: Drafting) -> Part:
    """Draw the graph in its spot, with its title and both of its scales above it."""
    hand, unit = drafting.hand, drafting.word(shown.unit)
    axes = standing(room, spot, shown.span, (shown.letter.lstrip("Σz"), shown.unit), drafting)
    graph = Graph(shown.name, axes, hand)
    lines: list[Stroke] = [heading(spot.box, shown.title, drafting.scale(spot.scale, axes.up), hand)]
    lines += axes.lines((0.0, TURN), shown.span, hand, shown.name)
    for curve in shown.curves:
        for k in stations(curve):
            own = graph._replace(name=curve.plan)
            lines += own.station(float(curve.angles[k]), [float(curve.values[k])], number(curve, k), k)
        lines.append(graph.stated(curve.plan, graph.curve(curve.angles, curve.values, getattr(hand, curve.style))))
    first, ends = shown.curves[0], graph.ends((TURN, ANGLE[0]), (shown.span[1], f"{shown.letter}, {unit}"))
    numbers = (graph.number(float(first.angles[k]), number(first, k), first.values[k]) for k in stations(first))
    return Part(shown.name, tuple(lines), (*ends, *_letters(shown, graph), *numbers))


def _letters(shown: TurnGraph, graph: Graph) -> Iterator[Letter]:
    """Letter each of several curves where it is farthest from zero."""
    for curve in shown.curves if len(shown.curves) > 1 else ():
        k = int(np.abs(curve.values).argmax())
        spot = graph.axes.on(float(curve.angles[k]), float(curve.values[k]))
        yield Letter(spot, curve.letter, graph.hand.letter, math.copysign(math.pi / 2, curve.values[k]))
