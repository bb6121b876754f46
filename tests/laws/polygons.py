"""The law of polygons: what is drawn of the sides of a closed one has no sum, as it is on paper (многоугольники)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from drawings.paper.hand import Hand
from drawings.paper.limits import SEEN
from drawings.paper.strokes import Group, Leaf, Line
from drawings.paper.walk import groups

CLOSED = ("forces-", "couples", "unbalances")  # plans whose sides have no sum
PARTS = ("n", "t", "u")  # a reaction beside its parts is no side
REACTION = re.compile(r"R_(\d)(\d)|R_\{?(\d+),(\d+)")


def breaches(leaf: Leaf, hand: Hand) -> Iterator[str]:
    """Name the polygons whose sides do not close, but for what is too short to be drawn."""
    for figure in (one for one in leaf.groups if f"{one.name}-".startswith(CLOSED)):
        sides = _sides(figure)
        left = abs(sum(line.end - line.start for line in sides.values()))
        if left > 2 * SEEN:
            yield f"{figure.name}: {left:.3f} mm are left of its sides"


def _sides(figure: Group) -> Mapping[str, Line]:
    """Give the sides by their names, without sums of others and without what acts between links of the polygon."""
    own = {
        group.data["name"]: group.strokes[0]
        for group in groups((figure,))
        if group.data.get("kind") == "vector" and isinstance(group.strokes[0], Line)
    }
    links = set(figure.name.split("-")[1:-1])
    return {name: line for name, line in own.items() if not (_is_sum(name, own) or _is_inner(name, links))}


def _is_sum(name: str, own: Mapping[str, Line]) -> bool:
    letter, _, pair = name.partition("_")
    return letter == "R" and any(f"R^{part}_{pair}" in own for part in PARTS)


def _is_inner(name: str, links: set[str]) -> bool:
    found = REACTION.fullmatch(name)
    return found is not None and {one for one in found.groups() if one} <= links
