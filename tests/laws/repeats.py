"""The law of repeats: nothing stands twice in one place, to the eye but once (повторы).

Thin lines may fall on one another: a link that stands still in two positions, two blocks that go along one guide.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterator

from drawings.paper.hand import Hand
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Arc, Circle, Leaf, Line, Text
from drawings.paper.walk import unstated
from drawings.reading.items import Item, items, spots

TOGETHER = ("bank",)  # sheets whose machines may stand in one plane


def breaches(leaf: Leaf, hand: Hand) -> Iterator[str]:
    """Name each mark, thick line or lettering that its figure has twice in one place."""
    if leaf.metadata["sheet"] in TOGETHER:
        return
    count = Counter(_place(item) for item in items(unstated(leaf)) if _is_held(item, hand.main))
    yield from (f"{place} twice" for place, times in count.items() if times > 1)


def _is_held(item: Item, thick: float) -> bool:
    stroke = item.stroke
    return bool(item.home.mark) or isinstance(stroke, Text) or stroke.style.width >= thick


def _place(item: Item) -> Hashable:
    """Give what tells a stroke from all others: its mark, what it is, where it lies to the paper's resolution."""
    stroke, mark = item.stroke, item.home.mark
    own = [(round(spot.real / QUANTUM), round(spot.imag / QUANTUM)) for spot in spots(stroke)]
    ends = tuple(sorted(own)) if isinstance(stroke, Line) else tuple(own)
    size = stroke.radius if isinstance(stroke, Circle | Arc) else 0.0
    said = stroke.plain if isinstance(stroke, Text) else ""
    name = tuple(mark.get(key, "") for key in ("name", "position", "quantity"))
    return item.home.top, type(stroke).__name__, name, ends, round(size / QUANTUM), said, stroke.style
