"""The pole of a graph on a sheet: its place, its distance as it is told, its letters and its rays (полюс и лучи)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from drawings.checks.graphs.figure_strokes import FLUSH, NEAR, FigureStrokes, read
from drawings.checks.graphs.graph import Graph
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong, on
from plans.model.motion import Floats
from plans.words.words import message

DIGITS = 4
_DISTANCE = re.compile(r"(H\d) = (\d+(?:[.,]\d+)?)\s")


class DuePole(NamedTuple):
    """A pole as it must be: its number, its distance mm, the values of its rays at their places, true units.

    Values are `near` mm to where they belong, and none misses that is more than `apart` mm from those that have rays.
    """

    number: int
    distance: float
    places: Floats
    values: Floats
    apart: float
    near: float = FLUSH

    @property
    def letter(self) -> str:
        """The letter of its distance."""
        return f"H_{self.number}"


def pole(strokes: FigureStrokes, graph: Graph, due: DuePole, told: FigureStrokes) -> Iterator[Wrong]:
    """Hold a pole beside a graph: its place, its letters, its distance as another graph tells it, its rays."""
    at, name = graph.zero - due.distance, f"P_{due.number}"
    if not any(abs(one.centre - at) <= FLUSH for one in strokes.circles):
        yield on("differs_on", graph.name, name=name)
    if not strokes.lettered(name, [at]):
        yield on("letter", graph.name, name=name)
    if not strokes.joins(at, graph.zero, FLUSH):
        yield on("line", graph.name)
    sizes = [one for one in strokes.lines if level(one.start, one.end, at.real, graph.zero.real)]
    if not any(strokes.lettered(due.letter, [(one.start + one.end) / 2]) for one in sizes):
        yield on("letter", graph.name, name=due.letter)
    tips = {one.points[0] for one in strokes.heads}
    ends = [(one.start, one.end) for one in sizes]
    if not any(all(min(abs(end - tip) for tip in tips) <= FLUSH for end in own) for own in ends if tips):
        yield on("line_named", graph.name, name=due.letter)
    seen = [match for text in told.texts for match in _DISTANCE.finditer(text)]
    if [one[1] for one in seen] != [read(due.letter)] or not reads(seen[0][2], due.distance, FLUSH, DIGITS):
        yield message("wrong.scale", text=seen[0][0] if seen else due.letter)
    yield from _rays(strokes, at, graph, due)


def level(start: complex, end: complex, left: float, right: float) -> bool:
    """Tell whether a level line goes from one upright to another."""
    xs = sorted((start.real, end.real))
    return abs((end - start).imag) <= NEAR and abs(xs[0] - left) <= FLUSH and abs(xs[1] - right) <= FLUSH


def _rays(strokes: FigureStrokes, at: complex, graph: Graph, due: DuePole) -> Iterator[Wrong]:
    """Hold the rays: each cuts a value off the axis, which is carried to where it belongs; none may miss."""
    tips = np.array([graph.on(0.0, float(one)) for one in due.values])
    feet = np.array([graph.on(float(x), float(y)) for x, y in zip(due.places, due.values, strict=True)])
    rays = [one for one in strokes.lines if abs(one.start - at) <= FLUSH and abs(one.end.imag - at.imag) > FLUSH]
    rays = [one for one in rays if abs(one.end.real - at.real) > FLUSH]
    for one in rays:
        carried = feet[np.abs(tips - one.end) <= due.near].tolist()
        if not any(strokes.joins(one.end, foot, due.near) for foot in carried):
            yield on("ray", graph.name)
    ends = np.array([graph.zero, *(one.end for one in rays)])
    if (np.abs(tips[:, None] - ends).min(axis=1) > due.apart + due.near).any():
        yield on("ray", graph.name)
