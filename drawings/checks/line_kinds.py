"""The kinds of lines of plans, polygons and schemes: main, thin, dashed, dash-dot (типы линий; ГОСТ 2.303, ISO 128-2).

A place tells where a line lies; what it means is told by its pen and its dashes alone.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from itertools import pairwise
from typing import NamedTuple, TypeAlias

from drawings.checks.wrong import Wrong, on
from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Curve, Fill, Group, Leaf, Line, Polyline, Stroke
from drawings.paper.walk import groups
from plans.linkage.letters import POLES
from plans.model.order import ORDERS, POSITIONS

MAIN, MEDIUM, THIN, FINE = "main", "medium", "thin", "construction"  # pens, by their names in a hand
FULL, DASHED, DASH_DOT, TWO_DOTS = 0, 2, 4, 6  # kinds of lines by the parts that are drawn over and over
LEAST = {DASHED: 2.0, DASH_DOT: 5.0, TWO_DOTS: 5.0}  # mm: the shortest dash of GOST 2.303
VECTOR, FORCE, COUPLE = "vector", "force", "couple"  # kinds of marks
PLANS = tuple(order.plan for order in ORDERS[1:])


class Kind(NamedTuple):
    """What a line may be: by which pens, with which dashes; one too short for two dashes may be full."""

    pens: Collection[str]
    dashes: int = FULL

    def takes(self, stroke: Stroke, hand: Hand) -> bool:
        """Tell whether a stroke is such a line."""
        style = stroke.style  # type: ignore[union-attr]
        if all(style.width != getattr(hand, pen) for pen in self.pens):
            return False
        return len(style.dash) == self.dashes or (not style.dash and _length(stroke) <= _short(self.dashes, hand))


Kinds: TypeAlias = Callable[[str], Kind]  # of a vector by its name

# The lines of a plan of positions by the groups that they are in.
LAYERS: Mapping[str, Kind] = {
    "all-positions": Kind((THIN, FINE)),  # a cross where there is no position is thin
    "extremes": Kind((THIN,), TWO_DOTS),
    "guides": Kind((FINE,), DASH_DOT),
    "notches": Kind((FINE,)),
    "path-ticks": Kind((FINE,)),
    "shown-position": Kind((MAIN,)),
    "rotation": Kind((THIN,)),
    "phases": Kind((FINE,)),
    "swing": Kind((FINE,)),
    "stroke": Kind((FINE,)),
}
THINNER = Kind((THIN, FINE))
KNOWN, UNKNOWN = Kind((MAIN,)), Kind((THIN,), DASHED)  # a force with a filled head, and one with an open head


def faults(leaf: Leaf, hand: Hand) -> Iterator[Wrong]:
    """Hold the lines of each figure to what they mean: each figure is told once."""
    for group in leaf.groups:
        if not all(kind.takes(stroke, hand) for stroke, kind in _due(group)):
            yield on("line_kind", group.name)


def _due(figure: Group) -> Iterator[tuple[Stroke, Kind]]:
    """Give the lines of a figure, each with what it must be."""
    if figure.name == POSITIONS.plan:
        for layer in _groups(figure):
            if layer.name in LAYERS:
                yield from ((stroke, LAYERS[layer.name]) for stroke in _drawn(layer))
    elif figure.name.startswith(PLANS):
        yield from _vectors(figure, _of_plan)
    elif figure.name.startswith(("forces-", "detail-")):
        yield from _vectors(figure, _of_polygon)
    elif figure.name.startswith(("scheme-", "lever-")):
        yield from _arrows(figure)


def _vectors(figure: Group, kind: Kinds) -> Iterator[tuple[Stroke, Kind]]:
    """Give the vectors of a figure by their names; all other lines serve to find them, or stand beside."""
    for group in _groups(figure):
        own = kind(group.data.get("name", "")) if group.data.get("kind") == VECTOR else THINNER
        yield from ((stroke, own) for stroke in _drawn(group) if isinstance(stroke, Line))


def _of_plan(name: str) -> Kind:
    """A vector from the pole is a result, one to a mass centre thinner; one between two images is never so thick."""
    return Kind((MAIN, MEDIUM)) if name.partition(" ")[0] in POLES.values() else Kind((MEDIUM, THIN))


def _of_polygon(name: str) -> Kind:
    """A side is a result; a reaction that is the sum of its parts is thinner."""
    return Kind((MAIN, MEDIUM)) if name.partition("_")[0].isalpha() else Kind((MAIN,))


def _arrows(figure: Group) -> Iterator[tuple[Stroke, Kind]]:
    """Give the forces of a scheme or a lever, each by its head, and its couples."""
    for group in _groups(figure):
        if group.data.get("kind") == FORCE:
            known = any(isinstance(one, Fill) for one in group.strokes)
            yield from ((one, KNOWN if known else UNKNOWN) for one in group.strokes[:1])
        elif group.data.get("kind") == COUPLE:
            yield from ((one, Kind((MEDIUM,))) for one in group.strokes if isinstance(one, Arc))


def _groups(figure: Group) -> Iterator[Group]:
    return groups((figure,))


def _drawn(group: Group) -> Iterator[Stroke]:
    """Give the lines that stand in a group itself."""
    return (one for one in group.strokes if isinstance(one, Line | Polyline | Arc | Curve))


def _length(stroke: Stroke) -> float:
    """Give how long a line is, mm; of what is bent smoothly no account is needed."""
    match stroke:
        case Line():
            return abs(stroke.end - stroke.start)
        case Polyline(points):
            return sum(abs(end - start) for start, end in pairwise(points))
        case Arc():
            return stroke.radius * stroke.sweep
    return 0.0


def _short(dashes: int, hand: Hand) -> float:
    """Give the length of a line that has no room for two dashes, mm; a full line is never broken."""
    if dashes == FULL:
        return 0.0
    broken = {DASHED: hand.dashed, DASH_DOT: hand.dash_dot, TWO_DOTS: hand.dash_two_dots}[dashes]
    return 2 * LEAST[dashes] + sum(broken[1:])
