"""The graph of quantities over the strips of a turn: ordinates at the edges, curves, numbers (график по участкам)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.figures.dynamics.rays import Strips
from drawings.figures.graphs.axes import BEYOND, Axes
from drawings.figures.graphs.part import Letter, Part
from drawings.page.drafting import Drafting
from drawings.paper.hand import Hand
from drawings.paper.statement import Kind, Statement
from drawings.paper.strokes import INK, Circle, Group, Line, LineStyle, Polyline, Stroke
from drawings.paper.ties import apart
from drawings.paper.walk import stating
from drawings.symbols.dashes import fit_dashes
from drawings.symbols.figure import Subject
from drawings.symbols.symbols import TICK
from plans.model.dynamics import TURN
from plans.model.motion import Floats

DOT = 0.6  # mm, radius of a point of a curve
LEAST = 0.05  # mm: a shorter ordinate is a point
APART = 2.4  # sizes of a number from one numbered edge to the next


class Trace(NamedTuple):
    """A curve of a graph: its points in true units, how it is drawn, its letter and where along it that stands."""

    x: Floats
    y: Floats
    style: str = "result"  # a line of the hand
    letter: str = ""
    at: float = 0.5  # share of its points
    side: float = math.pi / 2


class StripGraph(NamedTuple):
    """A quantity over the turn: its letter, unit, values at the edges after and before a jump, and all its curves.

    Values are drawn from the level `base`, which the axis of angles stands for.
    """

    name: str
    letter: str
    unit: str
    values: Floats  # (n + 1,)
    before: Floats  # (n + 1,)
    traces: tuple[Trace, ...]
    base: float = 0.0
    axis: str = ""  # the letter of the axis, if it is not that of the quantity

    @property
    def symbol(self) -> str:
        """The letter of the scale."""
        return self.letter.split("_")[0].lstrip("Δ")

    @property
    def span(self) -> tuple[float, float]:
        """The least and the greatest value above the base, zero among them."""
        ys = np.concatenate([self.values - self.base, *(trace.y - self.base for trace in self.traces)])
        return min(float(ys.min()), 0.0), max(float(ys.max()), 0.0)


def graph_part(graph: StripGraph, strips: Strips, axes: Axes, drafting: Drafting) -> Part:
    """Draw a graph on its axes, each ordinate that is numbered measurable."""
    hand = drafting.hand
    length = abs(axes.on(TURN) - axes.on(0.0))
    numbered = strips.spaced(length, APART * hand.number)
    lines = (
        *axes.lines((0.0, TURN), graph.span, hand, graph.name),
        *_edges(graph, strips, numbered, axes, hand),
        *(stroke for trace in graph.traces for stroke in _curve(graph, trace, axes, hand)),
    )
    return Part(graph.name, lines, (*_letters(graph, axes, drafting), *_numbers(graph, strips, numbered, axes, hand)))


def _edges(graph: StripGraph, strips: Strips, numbered: tuple[int, ...], axes: Axes, hand: Hand) -> Iterator[Stroke]:
    """Draw tick, ordinate and points of each edge."""
    tick = TICK * axes.rise
    for k in strips.marked(numbered):
        angle = float(strips.turned[k])
        foot, value, other = axes.on(angle), graph.values[k] - graph.base, graph.before[k] - graph.base
        yield Line(foot - tick, foot + tick, hand.drafted)
        if k in numbered:
            yield from _ordinate(graph, strips.names[k], k, (foot, axes.on(angle, value)), value, axes, hand)
        for tip in apart((axes.on(angle, value), axes.on(angle, other))):
            yield Circle(tip, DOT * hand.symbol, INK)


def _ordinate(
    graph: StripGraph, name: str, k: int, ends: tuple[complex, complex], value: float, axes: Axes, hand: Hand
) -> Iterator[Stroke]:
    if abs(ends[1] - ends[0]) > LEAST:
        data = Subject(graph.name, graph.symbol, k).data("vector", name, axes.rise * float(value), axes.up)
        yield Group((Line(*ends, hand.drafted),), "", data, name)


def _curve(graph: StripGraph, trace: Trace, axes: Axes, hand: Hand) -> Iterator[Stroke]:
    points = tuple(axes.on(x, y) for x, y in zip(trace.x.tolist(), (trace.y - graph.base).tolist(), strict=True))
    style: LineStyle = getattr(hand, trace.style)
    lines = fit_dashes([Polyline(points, False, style)])
    yield stating(Statement(Kind.CURVE, graph.name, trace.letter or graph.letter), *lines)


def _letters(graph: StripGraph, axes: Axes, drafting: Drafting) -> Iterator[Letter]:
    """Letter both axes at their ends, and the curves that have letters."""
    size, letter = drafting.hand.letter, drafting.letter(graph.axis or graph.letter)
    high, last = axes.on(0.0, graph.span[1]) + BEYOND * axes.rise, axes.on(TURN) + BEYOND * axes.along
    yield Letter(high, f"{letter}, {drafting.word(graph.unit)}", size, cmath.phase(axes.along))
    yield Letter(last, "φ", size, cmath.phase(axes.rise))
    for trace in graph.traces:
        if trace.letter:
            k = round(trace.at * (len(trace.x) - 1))
            spot = axes.on(float(trace.x[k]), float(trace.y[k]) - graph.base)
            yield Letter(spot, drafting.letter(trace.letter), size, trace.side)


def _numbers(graph: StripGraph, strips: Strips, numbered: tuple[int, ...], axes: Axes, hand: Hand) -> Iterator[Letter]:
    """Number the edges at the axis, each on the side away from its ordinate."""
    for k in numbered:
        away = axes.rise if axes.below(float(graph.values[k]) - graph.base) else -axes.rise
        yield Letter(axes.on(strips.turned[k]), strips.names[k], hand.number, cmath.phase(away), TICK + 0.6)
