"""The law of symbols: each is a copy of its template at the size of its sheet (условные обозначения; ГОСТ 2.770)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from drawings.paper.hand import Hand
from drawings.paper.strokes import Circle, Fill, Group, Leaf, Line, Polyline
from drawings.paper.walk import flat, groups

HINGE, DOUBLE, MASS, POINT = 2.0, (2.8, 1.5), 1.7, 0.9  # mm, radii on A1
SLIDERS = ((12.0, 7.0), (10.0, 7.0))  # mm, length and width of a slider on the frame and of a stone
HATCH = 3.0  # mm, its length
FINE = 2e-3  # mm
FIGURES = ("positions", "scheme-", "lever-")  # of mechanisms


def breaches(leaf: Leaf, hand: Hand) -> Iterator[str]:
    """Name the figures with a slider, a hinge, a mass centre or a hatching of another shape or size."""
    for figure in (one for one in leaf.groups if one.name.startswith(FIGURES)):
        strokes = [*flat((figure,))]
        boxes = [one for one in strokes if isinstance(one, Polyline) and one.closed and len(one.points) == 4]
        if any(not _slider(box, hand.symbol) for box in boxes if box.style.fill != "none"):
            yield f"{figure.name}: a slider of another size or shape"
        sizes = {radius * hand.symbol for radius in (HINGE, *DOUBLE, MASS, POINT)}
        circles = [one for one in strokes if isinstance(one, Circle) and one.style.fill == "#ffffff"]
        if any(min(abs(one.radius - size) for size in sizes) > FINE for one in circles if one.style.width == hand.main):
            yield f"{figure.name}: a hinge of another size"
        yield from (f"{figure.name}: {wrong}" for wrong in _grounds(figure, hand))
        if any(not _quarter(one, strokes, hand) for one in strokes if isinstance(one, Fill) and len(one.points) == 8):
            yield f"{figure.name}: a mass centre of another shape"


def _slider(box: Polyline, factor: float) -> bool:
    """Tell whether a box is a rectangle of a slider's or a stone's sides."""
    a, b, c, d = box.points
    sides = abs(a - b), abs(b - c)
    square = abs(a - b + c - d) <= FINE and abs(((a - b) * (b - c).conjugate()).real) <= FINE * max(sides)
    return square and any(
        all(abs(side - factor * own) <= FINE for side, own in zip(sides, size, strict=True)) for size in SLIDERS
    )


def _quarter(one: Fill, strokes: list[object], hand: Hand) -> bool:
    """Tell whether a filled quarter lies in a circle of a mass centre; another filling is none."""
    at, *rim = one.points
    if max(abs(abs(spot - at) - abs(rim[0] - at)) for spot in rim) > FINE:
        return True
    turn = abs(cmath.phase((rim[-1] - at) / (rim[0] - at)))
    own = abs(abs(rim[0] - at) - MASS * hand.symbol) <= FINE and abs(turn - math.pi / 2) <= 1e-3
    return own and any(isinstance(two, Circle) and abs(two.centre - at) <= FINE for two in strokes)


def _grounds(figure: Group, hand: Hand) -> Iterator[str]:
    """Name hatchings that are not alike: all of a ground are parallel, of one length, evenly apart."""
    for group in (one for one in groups((figure,)) if one.name == "grounds"):
        lines = [one for one in group.strokes if isinstance(one, Line) and one.style.width == hand.construction]
        if any(abs(abs(one.end - one.start) - HATCH * hand.symbol) > FINE for one in lines):
            yield "a hatching of another length"
