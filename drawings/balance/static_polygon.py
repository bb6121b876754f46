"""The polygon of static moments m_i·r_Si laid end to end from the datum, and their sum m·r_S (8.6) (рис. 8.5)."""

from __future__ import annotations

from collections.abc import Mapping

from drawings.kinds.polygon import RESULT, SIDE, Letters, Polygon, ShownVector, Sizes
from drawings.lettering.vector_letters import RESULT as SUM
from drawings.lettering.vector_letters import lowered
from drawings.page.scale import Drafting

NAME, SCALE = "static-moments", ("{mr}", "kg*m")
SIZES = Sizes(16.0, 0.0, 5.0, 4.2)
LETTERS = Letters(lowered, lambda _: "")


def polygon(position: int, moments: Mapping[str, complex], least: float, drafting: Drafting) -> Polygon:
    """Lay static moments kg*m end to end by their letters; what is no more than `least` has no direction."""
    vectors, end = list[ShownVector](), 0j
    for name, value in moments.items():
        if abs(value) > least:
            vectors.append(ShownVector(name, SIDE, end, value))
            end += value
    closed = abs(end) <= least
    vectors += [] if closed else [ShownVector(SUM, RESULT, 0j, end)]
    title = f"{drafting.word('polygon of static moments')}, {drafting.word('position', position=position)}"
    return Polygon(NAME, title, SCALE, tuple(vectors), closed, LETTERS, SIZES, position)
