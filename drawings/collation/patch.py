"""Patches: what an area in the colour of paper, laid over a drawing, hides of it (закрытое белым)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from drawings.collation.items import Ink, Item
from drawings.collation.spots import middle, spots
from drawings.eye.covering import crosses
from drawings.paper.strokes import Circle, Text


def covered(patch: Ink, drawn: Sequence[Item]) -> list[Item]:
    """List what has its middle under an area; nothing is under what is not filled."""
    if isinstance(patch, Text) or patch.style.fill == "none":
        return []
    return [item for item in drawn if _holds(patch, middle(item.stroke))]


def _holds(patch: Ink, spot: complex) -> bool:
    """Tell whether a place lies within an outline: a ray to the right of it crosses that an odd number of times."""
    if isinstance(patch, Circle):
        return abs(spot - patch.centre) < patch.radius
    own = spots(patch)
    return sum(crosses(a - spot, b - spot) for a, b in pairwise((*own, own[0]))) % 2 == 1
