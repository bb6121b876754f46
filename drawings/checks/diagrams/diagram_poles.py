"""The poles of the kinematic diagrams: their distances against the scales, their rays along the chords (полюсы)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from drawings.checks.cam.cam_strokes import NEAR, FigureStrokes, figure, read
from drawings.checks.diagrams.diagram_rows import FLUSH, RowGraph, named
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong, on
from drawings.figures.diagrams.row_pole import APART
from drawings.paper.strokes import Leaf
from plans.words.words import message

DIGITS = 4
_DISTANCE = re.compile(r"(H\d) = (\d+(?:[.,]\d+)?)\s")


def poles(leaf: Leaf, graphs: tuple[RowGraph, ...], omega: float) -> Iterator[Wrong]:
    """Hold both poles: that from which v is drawn to the chords of S, that from which a is to those of v."""
    for number, (above, own) in enumerate(pairwise(graphs), 1):
        strokes = figure(leaf, named(f"{own.row.key}-pole"))
        if own.row.flat:
            yield from () if strokes is None else (on("stranger_on", own.name, name=f"P_{number}"),)
        elif strokes is None:
            yield message("wrong.missing", name=f"P_{number}")
        else:
            yield from _pole(strokes, number, own, above.mu * omega / (own.mu * own.along))


def _pole(strokes: FigureStrokes, number: int, own: RowGraph, distance: float) -> Iterator[Wrong]:
    """Hold a pole: its place, its letters, its distance as it is told, its rays."""
    pole, letter = own.zero - distance, f"H_{number}"
    if not any(abs(one.centre - pole) <= FLUSH for one in strokes.circles):
        yield on("differs_on", own.name, name=f"P_{number}")
    if not strokes.lettered(f"P_{number}", [pole]):
        yield on("letter", own.name, name=f"P_{number}")
    if not strokes.joins(pole, own.zero, FLUSH):
        yield on("line", own.name)
    sizes = [one for one in strokes.lines if _level(one.start, one.end, pole.real, own.zero.real)]
    if not any(strokes.lettered(letter, [(one.start + one.end) / 2]) for one in sizes):
        yield on("letter", own.name, name=letter)
    told = [match for text in own.strokes.texts for match in _DISTANCE.finditer(text)]
    if [one[1] for one in told] != [read(letter)] or not reads(told[0][2], distance, FLUSH, DIGITS):
        yield message("wrong.scale", text=told[0][0] if told else letter)
    yield from _rays(strokes, pole, own)


def _level(start: complex, end: complex, left: float, right: float) -> bool:
    """Tell whether a level line goes from one upright to another."""
    xs = sorted((start.real, end.real))
    return abs((end - start).imag) <= NEAR and abs(xs[0] - left) <= FLUSH and abs(xs[1] - right) <= FLUSH


def _rays(strokes: FigureStrokes, pole: complex, own: RowGraph) -> Iterator[Wrong]:
    """Hold the rays: each cuts a value by chords off the axis, which is carried to where it belongs; none may miss."""
    tips = np.array([own.on(0.0, float(one)) for one in own.row.values])
    places = np.array([own.on(float(x), float(y)) for x, y in zip(own.row.places, own.row.values, strict=True)])
    near = FLUSH + own.slack / own.mu
    rays = [one for one in strokes.lines if abs(one.start - pole) <= FLUSH and abs(one.end.imag - pole.imag) > FLUSH]
    rays = [one for one in rays if abs(one.end.real - pole.real) > FLUSH]
    for one in rays:
        carried = places[np.abs(tips - one.end) <= near].tolist()
        if not any(strokes.joins(one.end, foot, near) for foot in carried):
            yield on("ray", own.name)
    ends = np.array([own.zero, *(one.end for one in rays)])
    if (np.abs(tips[:, None] - ends).min(axis=1) > APART * own.drafting.hand.letter + near).any():
        yield on("ray", own.name)
