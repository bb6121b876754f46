"""The poles of the kinematic diagrams: their distances against the scales, their rays along the chords (полюсы)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from drawings.checks.diagrams.diagram_rows import RowGraph, named
from drawings.checks.graphs.figure_strokes import FLUSH, figure
from drawings.checks.graphs.pole import DuePole, pole
from drawings.checks.wrong import Wrong, on
from drawings.figures.diagrams.row_pole import APART
from drawings.paper.strokes import Leaf
from plans.words.words import message


def poles(leaf: Leaf, graphs: tuple[RowGraph, ...], omega: float) -> Iterator[Wrong]:
    """Hold both poles: that from which v is drawn to the chords of S, that from which a is to those of v."""
    for number, (above, own) in enumerate(pairwise(graphs), 1):
        strokes = figure(leaf, named(f"{own.row.key}-pole"))
        if own.row.flat:
            yield from () if strokes is None else (on("stranger_on", own.name, name=f"P_{number}"),)
        elif strokes is None:
            yield message("wrong.missing", name=f"P_{number}")
        else:
            distance = above.mu * omega / (own.mu * own.along)
            apart, near = APART * own.drafting.hand.letter, FLUSH + own.slack / own.mu
            due = DuePole(number, distance, own.row.places, own.row.values, apart, near)
            yield from pole(strokes, own, due, own.strokes)
