"""The law of lines: each is drawn by a pen of the sheet's hand, results by the main one (ГОСТ 2.303, ISO 128-2)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from drawings.paper.hand import Hand
from drawings.paper.strokes import Arc, Circle, Curve, Fill, Group, Kind, Leaf, Line, Polyline, Stroke
from drawings.paper.walk import flat, groups
from tests.laws.arrows import parts_of

MAIN, MEDIUM, THIN, FINE = "main", "medium", "thin", "construction"  # pens, by their names in a hand
LINES = Line | Polyline | Arc | Curve | Circle
FORM = ("frame", "extra-graphs", "folding-marks", "control-bar", "title-block")  # of the page
DASHES = {0, 2, 4, 6}  # parts of full lines, dashes, dash-dot, dash-two-dots


class Role(NamedTuple):
    """By which pens the lines of a role are drawn, and of how many parts their dashes are."""

    pens: Sequence[str]
    dashes: Sequence[int] = (0,)


# The layers of a plan of positions; what is too short for dashes is full.
LAYERS: Mapping[str, Role] = {
    "all-positions": Role((THIN, FINE)),
    "extremes": Role((THIN,), (0, 6)),
    "guides": Role((FINE,), (0, 4)),
    "notches": Role((FINE,)),
    "paths": Role((THIN,), (0, 2)),
    "path-ticks": Role((FINE,)),
    "shown-position": Role((MAIN,)),
    "rotation": Role((THIN,)),
    "phases": Role((FINE,)),
    "swing": Role((FINE,)),
    "stroke": Role((FINE,)),
}
# What is stated, by its kind: an axis, a graph or a path, what is dimensioned.
STATED: Mapping[Kind, Role] = {
    Kind.AXIS: Role((THIN,)),
    Kind.CURVE: Role((MAIN, MEDIUM, THIN, FINE), (0, 2, 4, 6)),
    Kind.LENGTH: Role((FINE, THIN)),
    Kind.ANGLE: Role((FINE, THIN)),
}
CRANK = ("shaft", "r ")  # whose own outline states how long it is on the view across a bank
# Vectors by the plan that they are on: results of a plan of velocities, sides of a polygon of forces or of moments.
PLANS: Mapping[str, Role] = {
    "velocities": Role((MAIN, MEDIUM, THIN)),
    "accelerations": Role((MAIN, MEDIUM, THIN)),
    "forces": Role((MAIN, MEDIUM)),
    "couples": Role((MAIN, MEDIUM)),
    "unbalances": Role((MAIN, MEDIUM)),
    "loop": Role((MEDIUM, FINE)),
}


def breaches(leaf: Leaf, hand: Hand) -> Iterator[str]:
    """Name what is drawn by no pen of the hand, or by another than its role has."""
    for figure in (one for one in leaf.groups if one.name not in FORM):
        if any(not _of_hand(stroke, hand) for stroke in flat((figure,)) if isinstance(stroke, LINES)):
            yield f"{figure.name}: a line by no pen of the hand"
        for group, role in _roles(figure):
            if any(not _is(stroke, role, hand) for stroke in _drawn(group)) and not _is_fine(group, hand):
                yield f"{figure.name}: {group.name or group.data.get('name') or group.states} by another pen"
    yield from _results(leaf, hand)


def _roles(figure: Group) -> Iterator[tuple[Group, Role]]:
    for group in groups((figure,)):
        if figure.name == "positions" and group.name in LAYERS:
            yield group, LAYERS[group.name]
        if group.states is not None and group.states.kind in STATED:
            crank = figure.name == CRANK[0] and group.states.name.startswith(CRANK[1])
            yield group, Role((MAIN,)) if crank else STATED[group.states.kind]
        if group.data.get("kind") == "vector" and group.data["plan"].partition("-")[0] in PLANS:
            yield group, PLANS[group.data["plan"].partition("-")[0]]


def _results(leaf: Leaf, hand: Hand) -> Iterator[str]:
    """Name the figures whose only curve is no result, and schemes of thin links."""
    for figure in leaf.groups:
        own = [one for one in groups((figure,)) if one.states is not None and one.states.kind is Kind.CURVE]
        widths = {stroke.style.width for one in own for stroke in flat((one,)) if isinstance(stroke, LINES)}
        if len(own) == 1 and own[0].states is not None and widths and max(widths) < hand.medium:
            yield f"{figure.name}: its only curve is thin"
        if figure.name.startswith("scheme-") and not any(
            isinstance(one, Line) and one.style.width == hand.main for one in flat((figure,))
        ):
            yield f"{figure.name}: no link is drawn thick"


def _is(stroke: Stroke, role: Role, hand: Hand) -> bool:
    assert isinstance(stroke, LINES)
    return stroke.style.width in {getattr(hand, pen) for pen in role.pens} and len(stroke.style.dash) in role.dashes


def _is_fine(group: Group, hand: Hand) -> bool:
    """Tell whether it is a thin vector with a head so small that a thicker line would be half as wide as it."""
    heads = (one for one in group.strokes if isinstance(one, Fill))
    small = group.data.get("kind") == "vector" and all(half < hand.medium for *_, half in map(parts_of, heads))
    return small and all(_is(line, Role((THIN,)), hand) for line in _drawn(group))


def _of_hand(stroke: LINES, hand: Hand) -> bool:
    widths = {0.0, hand.main, hand.medium, hand.thin, hand.construction}
    return stroke.style.width in widths and len(stroke.style.dash) in DASHES


def _drawn(group: Group) -> Iterator[Stroke]:
    """Give the lines of a group itself, or of what does nothing but state within it."""
    return (one for one in group.strokes if isinstance(one, Line | Polyline | Arc | Curve))
