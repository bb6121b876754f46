"""The poles of a law's diagrams: their distances against the scales, their rays against mean ordinates (полюсы)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from drawings.checks.cam.cam_expected import Expected
from drawings.checks.cam.cam_law_rows import means
from drawings.checks.cam.cam_laws import FLUSH, LawGraph, named
from drawings.checks.cam.cam_strokes import NEAR, FigureStrokes, figure, read
from drawings.checks.reading import reads
from drawings.checks.wrong import Wrong, on
from drawings.figures.cam.law_pole import APART
from drawings.paper.strokes import Leaf
from plans.words.words import message

DIGITS = 4
_DISTANCE = re.compile(r"(H\d) = (\d+(?:[.,]\d+)?)\s")


def poles(leaf: Leaf, graphs: tuple[LawGraph, ...], expected: Expected) -> Iterator[Wrong]:
    """Hold both poles: that of the upper row from which the middle one is drawn, that of the middle one."""
    for number, (above, below) in enumerate(pairwise(graphs), 1):
        strokes = figure(leaf, named(expected.cam, f"{above.row.key}-pole"))
        flat = not above.row.most
        if strokes is None:
            yield from () if flat else (message("wrong.missing", name=f"P_{number}"),)
        else:
            yield from _pole(strokes, number, above, below, means(expected, above.row.key))


def _pole(
    strokes: FigureStrokes, number: int, above: LawGraph, below: LawGraph, ordinates: np.ndarray
) -> Iterator[Wrong]:
    """Hold a pole: its place, its letters, its distance as it is told over the row below, its rays."""
    distance = below.mu / (above.mu * above.along)
    pole, letter = above.zero - distance, f"H_{number}"
    if not any(abs(one.centre - pole) <= FLUSH for one in strokes.circles):
        yield on("differs_on", above.name, name=f"P_{number}")
    if not strokes.lettered(f"P_{number}", [pole]):
        yield on("letter", above.name, name=f"P_{number}")
    sizes = [one for one in strokes.lines if _level(one.start, one.end, pole.real, above.zero.real)]
    if not any(strokes.lettered(letter, [(one.start + one.end) / 2]) for one in sizes):
        yield on("letter", above.name, name=letter)
    told = [match for text in below.strokes.texts for match in _DISTANCE.finditer(text)]
    if [one[1] for one in told] != [read(letter)] or not reads(told[0][2], distance, FLUSH, DIGITS):
        yield message("wrong.scale", text=told[0][0] if told else letter)
    yield from _rays(strokes, pole, above, ordinates)


def _level(start: complex, end: complex, left: float, right: float) -> bool:
    """Tell whether a level line goes from one upright to another."""
    xs = sorted((start.real, end.real))
    return abs((end - start).imag) <= NEAR and abs(xs[0] - left) <= FLUSH and abs(xs[1] - right) <= FLUSH


def _rays(strokes: FigureStrokes, pole: complex, above: LawGraph, ordinates: np.ndarray) -> Iterator[Wrong]:
    """Hold the rays: each leads to a mean ordinate, which is carried from the middle of its strip."""
    edges = above.expected.edges
    middles = (edges[:-1] + edges[1:]) / 2
    tips = np.array([above.on(0.0, float(one)) for one in ordinates])
    feet = np.array([above.on(float(x), float(y)) for x, y in zip(middles, ordinates, strict=True)])
    rays = [one for one in strokes.lines if abs(one.start - pole) <= FLUSH and abs(one.end.imag - pole.imag) > FLUSH]
    rays = [one for one in rays if abs(one.end.real - pole.real) > FLUSH]
    for one in rays:
        carried = feet[np.abs(tips - one.end) <= FLUSH].tolist()
        if not any(strokes.joins(one.end, foot, FLUSH) for foot in carried):
            yield on("ray", above.name)
    if not rays and np.abs(tips - above.zero).max() > APART * above.drafting.hand.letter + FLUSH:
        yield message("wrong.missing", name="P")
