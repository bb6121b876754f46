"""The two ends of a spring, or of a force between links, as the scene gives them (концы)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from plans.forces.reading import fields as h
from plans.forces.reading.load import ON_LINK, POINT_OF_LINK
from plans.linkage.reading import fields as g
from plans.model.mechanism import FRAME
from plans.scene import fields as f
from plans.scene.readers import Check, either, many
from plans.scene.tables import Table, key, table


class EndTable(Table):
    """An end of a spring or a force between links: a point of one of the links that have it."""

    on: int = key(g.ANY_LINK, meaning="The link, where several have the point.", missing=ON_LINK)
    point: str = key(f.POINT, meaning="Point of the link.", missing=POINT_OF_LINK)


Ends = tuple[str | EndTable, ...]
ENDS = many(either(dict, table(EndTable), f.POINT), first=Check(h.check_ends, least=2, most=2))


def holders(end: str | EndTable, points_of: Mapping[int, Iterable[str]]) -> tuple[int, ...]:
    """Give the links that an end may be of: the frame alone where the point is fixed.

    >>> holders("O", {0: "OC", 1: "OA", 2: "A"}), holders("A", {0: "OC", 1: "OA", 2: "A"})
    ((0,), (1, 2))
    """
    if isinstance(end, EndTable):
        return (end.on,)
    found = tuple(link for link, points in points_of.items() if end in points)
    return (FRAME,) if FRAME in found else found


def point_of(end: str | EndTable) -> str:
    """Give the point that an end is at."""
    return end if isinstance(end, str) else end.point
