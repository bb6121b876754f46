"""Repeats: a mark, a thick line or a letter that a figure has twice in one place, to the eye but once (повторы)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterator

from drawings.checks.wrong import Wrong
from drawings.collation.edit import lone
from drawings.collation.figures import Figures
from drawings.collation.items import Item, items
from drawings.collation.spots import spots
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Arc, Circle, Leaf, Line, Text


def faults(leaf: Leaf, thick: float) -> Iterator[Wrong]:
    """Tell each stroke that stands twice in its figure; of lines that bear no mark, those that are so thick, mm.

    Thin lines may fall on one another: a link that stands still in two positions, two blocks that go along one guide.
    Vectors of two names may be one on paper: a mark is looked at by its name.
    """
    figures = Figures(leaf)
    own = [(_place(item), item) for item in items(leaf) if _is_held(item, thick)]
    count = Counter(place for place, _ in own)
    first = dict(reversed(own))
    yield from (lone("copied", first[place], figures).told for place, times in count.items() if times > 1)


def _is_held(item: Item, thick: float) -> bool:
    stroke = item.stroke
    return bool(item.home.mark) or isinstance(stroke, Text) or stroke.style.width >= thick


def _place(item: Item) -> Hashable:
    """Give what tells a stroke from all others: its mark, what it is, where it lies to the paper's resolution."""
    stroke, mark = item.stroke, item.home.mark
    own = [_rounded(spot) for spot in spots(stroke)]
    ends = tuple(sorted(own)) if isinstance(stroke, Line) else tuple(own)
    size = stroke.radius if isinstance(stroke, Circle | Arc) else 0.0
    said = stroke.plain if isinstance(stroke, Text) else ""
    name = mark.get("name", ""), mark.get("position", ""), mark.get("quantity", "")
    return item.home.top, type(stroke).__name__, name, ends, round(size / QUANTUM), said, stroke.style


def _rounded(spot: complex) -> tuple[int, int]:
    return round(spot.real / QUANTUM), round(spot.imag / QUANTUM)
