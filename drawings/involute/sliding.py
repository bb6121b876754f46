"""The graph of specific sliding along the line of action, its active part, the base pitch (удельное скольжение)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from drawings.involute.due import reach
from drawings.kinds.axes import Letter, Part
from drawings.kinds.graph import Graph, GraphForm, standing
from drawings.layout.picture import Margins, Picture, Spot
from drawings.lettering.words import Slot, joined, with_index
from drawings.page.page import Drafting
from drawings.paper.strokes import Kind, Statement, Stroke
from drawings.symbols.figure import Dimension, heading
from plans.involute.action import apart
from plans.involute.study import InvoluteStudy
from plans.model.motion import Floats

NAME, LAMBDA = "sliding", "λ"
FORM = GraphForm(1.4, 2.0, Margins(3.5, 2.5, 1.5), 26.0)
ABOVE = 2.2  # the ordinate that the graph goes up to: sliding is less than 1, above it stand the dimensions
LEVELS = {"g_α": 1.9, "p_b": 1.35}  # the ordinates of the dimensions
POINTS = 121


class ShownSliding(NamedTuple):
    """Specific sliding of both wheels over the distance from N_1, m."""

    places: Mapping[str, float]  # of N_1, B_1, P, B_2, and of N_2 where it lies on
    length: float
    low: float
    curves: Mapping[str, tuple[Floats, Floats]]
    sizes: Mapping[str, float]  # of the dimensions from B_1 on, m
    feet: Mapping[str, tuple[float, float]]  # where, and sliding: of wheel 1 at B_1, of wheel 2 at B_2


def shown(study: InvoluteStudy) -> ShownSliding:
    """Give the graph of a pair: sliding by segments of the line of action."""
    action, ratio = study.action, study.pair.teeth[0] / study.pair.teeth[1]
    far, sense = apart(*action.ends), study.pair.sense
    pole, start, end = apart(action.ends[0], action.pole), action.feet[0], action.strings[0]
    places = {"N_1": 0.0, "B_1": start, "P": pole, "B_2": end} | ({"N_2": far} if sense > 0 else {})
    to = reach(study.pair, far, end, action.sliding)
    curves = dict[str, tuple[Floats, Floats]]()
    for n, span in zip(("λ_1", "λ_2"), to.spans, strict=True):
        x = np.linspace(*span, POINTS)
        other = far - x if sense > 0 else far + x
        pair = {"λ_1": (x, other * ratio), "λ_2": (other * ratio, x)}[n]
        curves[n] = x, 1 - pair[1] / pair[0]
    sizes = {"g_α": action.length, "p_b": study.pair.rack.base_pitch}
    feet = dict(zip(("λ_B1", "λ_B2"), zip((start, end), action.sliding, strict=True), strict=True))
    return ShownSliding(places, to.length, to.low, curves, sizes, feet)


def measure(graph: ShownSliding, drafting: Drafting) -> Picture:
    """Measure the room of the graph."""
    return FORM.room(NAME, graph.length, ("l", "m"), drafting.word("involute sliding"), drafting.hand)


def draw(graph: ShownSliding, room: Picture, spot: Spot, drafting: Drafting) -> Part:
    """Draw it in its spot: abscissas at a scale of lengths."""
    hand = drafting.hand
    axes = standing(room, spot, (graph.low, ABOVE), (LAMBDA, "1"), drafting)
    drawn = Graph(NAME, axes, hand)
    head = heading(spot.box, drafting.word("involute sliding"), drafting.scale(spot.scale, axes.up), hand)
    lines: list[Stroke] = [head, *axes.lines((0.0, graph.length), (graph.low, ABOVE), hand, NAME)]
    for (name, (x, y)), style in zip(graph.curves.items(), (hand.result, hand.relative), strict=True):
        lines.append(drawn.stated(name, drawn.curve(x, y, style)))
    for name, foot in graph.feet.items():
        lines += drawn.ordinate(*foot, name)
    lines += (drawn.tick(x) for x in graph.places.values())
    sizes = [*_dimensions(graph, drawn, drafting)]
    lines += (stroke for size in sizes for stroke in size.draw(hand))
    letters = (Letter(size.middle, size.letter, hand.number, math.pi / 2) for size in sizes)
    return Part(NAME, tuple(lines), (*_letters(graph, drawn), *letters))


def _dimensions(graph: ShownSliding, drawn: Graph, drafting: Drafting) -> Iterator[Dimension]:
    """Dimension the active part and the base pitch over the graph."""
    start = graph.places["B_1"]
    for name, size in graph.sizes.items():
        foot, end = drawn.axes.on(start), drawn.axes.on(start + size)
        up = drawn.axes.on(0.0, LEVELS[name]) - drawn.axes.zero
        text = joined("", (f"{with_index(name)} = ", drafting.slot(Slot(name, 1e3 * size))))
        yield Dimension(text, foot, end, up, Statement(Kind.LENGTH, NAME, name, scale=drawn.axes.across.mu))


def _letters(graph: ShownSliding, drawn: Graph) -> Iterator[Letter]:
    size, axes = drawn.hand.letter, drawn.axes
    yield from drawn.ends((graph.length, "l"), (ABOVE, LAMBDA))
    for name, x in graph.places.items():
        yield Letter(axes.on(x), with_index(name), size, -math.pi / 2, 2.0)
    yield from (Letter(axes.on(*foot), with_index(name), size, -math.pi / 2) for name, foot in graph.feet.items())
    for name, (along, y) in graph.curves.items():
        k = int(np.argmin(np.abs(y - 0.55)))
        yield Letter(axes.on(float(along[k]), float(y[k])), with_index(name), size, math.pi / 2)
