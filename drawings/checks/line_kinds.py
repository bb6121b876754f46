"""The kinds of lines of plans, polygons and schemes: main, thin, dashed, dash-dot (типы линий; ГОСТ 2.303, ISO 128-2).

A place tells where a line lies; what it means is told by its pen and its dashes alone.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from itertools import permutations
from typing import NamedTuple, TypeAlias

from drawings.checks.line_kind import DASH_DOT, DASHED, FINE, MAIN, MEDIUM, THIN, TWO_DOTS, Kind
from drawings.checks.wrong import Wrong, on
from drawings.paper.hand import Hand
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Arc, Curve, Fill, Group, Leaf, Line, Polyline, Stroke
from drawings.paper.walk import groups
from plans.forces.cut import indices
from plans.linkage.letters import POLES
from plans.model.order import ORDERS, POSITIONS

VECTOR, FORCE, COUPLE = "vector", "force", "couple"  # kinds of marks
REACTION = "R"  # by which marks name it, whatever letter is written
PLANS = tuple(order.plan for order in ORDERS[1:])


Kinds: TypeAlias = Callable[[Group], Kind]  # of a vector by its group

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
        yield from _vectors(figure, Sides.of(figure).kind)
    elif figure.name.startswith(("scheme-", "lever-")):
        yield from _arrows(figure)


def _vectors(figure: Group, kind: Kinds) -> Iterator[tuple[Stroke, Kind]]:
    """Give the vectors of a figure by their names; all other lines serve to find them, or stand beside."""
    for group in _groups(figure):
        own = kind(group) if group.data.get("kind") == VECTOR else THINNER
        yield from ((stroke, own) for stroke in _drawn(group) if isinstance(stroke, Line))


def _of_plan(vector: Group) -> Kind:
    """A vector from the pole is a result, one to a mass centre thinner; one between two images is never so thick."""
    name = vector.data.get("name", "")
    return Kind((MAIN, MEDIUM)) if name.partition(" ")[0] in POLES.values() else Kind((MEDIUM, THIN))


class Sides(NamedTuple):
    """The vectors of a force plan or of a detail of one, by their names, and the links whose plan it is."""

    names: Collection[str]
    links: Collection[int]
    whole: bool  # whether all sides are shown: a detail shows some

    @classmethod
    def of(cls, figure: Group) -> Sides:
        """Read them off a figure: forces-4-5-2 is the plan of links 4 and 5 in position 2."""
        names = {one.data.get("name", "") for one in _groups(figure) if one.data.get("kind") == VECTOR}
        plan, *told = figure.name.split("-")
        return cls(names, [int(one) for one in told[:-1] if one.isdigit()], plan == "forces")

    def kind(self, vector: Group) -> Kind:
        """A side is a result; a reaction that is the sum of its parts, or that between both links, is thinner."""
        letter, _, pair = vector.data.get("name", "").partition("_")
        if letter != REACTION:
            return Kind((MAIN,))
        if {f"{REACTION}^{part}_{pair}" for part in "nt"} & {*self.names}:
            return Kind((MEDIUM,))
        split = f"{REACTION}^u_{pair}" in self.names  # on a slide a part may be the whole
        inner = pair in {indices(*both) for both in permutations(self.links, 2)}
        short = all(abs(one.end - one.start) < 2 * SEEN for one in vector.strokes if isinstance(one, Line))
        either = inner or split or short or not self.whole  # parts that are too short stand away
        return Kind((MAIN, MEDIUM)) if either else Kind((MAIN,))


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
