"""The law of the control bar: a hundred millimetres long in all, with a tick at every ten (контрольный отрезок)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from drawings.paper.hand import Hand
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Leaf, Line
from drawings.paper.walk import flat, group_named

NAME, WHOLE, STEP = "control-bar", 100.0, 10.0  # mm


def breaches(leaf: Leaf, hand: Hand) -> Iterator[str]:
    """Name a bar that has another length, or ticks elsewhere; a leaf without one has no ruler on it."""
    bar = group_named(leaf.groups, NAME)
    if bar is None:
        return
    lines = [one for one in flat((bar,)) if isinstance(one, Line)]
    level = max(lines, key=lambda one: abs(one.end - one.start))
    along = level.end - level.start
    if abs(abs(along) - WHOLE) > QUANTUM:
        yield f"a control bar of {abs(along)} mm"
    places = sorted(_place(one, level, along) for one in lines if one is not level)
    if len(places) != WHOLE / STEP + 1 or abs(places[0]) > QUANTUM:
        yield f"a control bar with {len(places)} ticks"
    yield from (f"ticks {b - a} mm apart" for a, b in pairwise(places) if abs(b - a - STEP) > QUANTUM)


def _place(tick: Line, level: Line, along: complex) -> float:
    """Give how far along the bar a tick crosses it."""
    return (((tick.start + tick.end) / 2 - level.start) * along.conjugate()).real / abs(along)
