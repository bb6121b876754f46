"""The poles of a law's diagrams: their distances against the scales, their rays against mean ordinates (полюсы)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from drawings.checks.cam.cam_expected import Expected
from drawings.checks.cam.cam_law_rows import means
from drawings.checks.cam.cam_laws import LawGraph, named
from drawings.checks.graphs.figure_strokes import figure
from drawings.checks.graphs.pole import DuePole, pole
from drawings.checks.wrong import Wrong
from drawings.figures.cam.law_pole import APART
from drawings.paper.strokes import Leaf
from plans.words.words import message


def poles(leaf: Leaf, graphs: tuple[LawGraph, ...], expected: Expected) -> Iterator[Wrong]:
    """Hold both poles: that of the upper row from which the middle one is drawn, that of the middle one."""
    middles = (expected.edges[:-1] + expected.edges[1:]) / 2
    for number, (above, below) in enumerate(pairwise(graphs), 1):
        strokes = figure(leaf, named(expected.cam, f"{above.row.key}-pole"))
        if strokes is not None:
            distance, apart = below.mu / (above.mu * above.along), APART * above.drafting.hand.letter
            due = DuePole(number, distance, middles, means(expected, above.row.key), apart)
            yield from pole(strokes, above, due, below.strokes)
        elif above.row.most:
            yield message("wrong.missing", name=f"P_{number}")
