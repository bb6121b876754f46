"""Legible lettering: texts in letters that the alphabet has, which alone can be measured (разборчивые надписи)."""

from __future__ import annotations

from drawings.eye.sheet import without
from drawings.lettering.lettering import UnknownLetter, text_width
from drawings.paper.strokes import Leaf, Text
from drawings.paper.walk import texts


def legible(leaf: Leaf) -> Leaf:
    """Give a leaf without texts in letters that no alphabet of ours has: none of them names a place of a plan."""
    return without(leaf, [one for one in texts(leaf.groups) if not _known(one)])


def _known(text: Text) -> bool:
    try:
        text_width(text)
    except UnknownLetter:
        return False
    return True
