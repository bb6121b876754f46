"""Capacity: how many positions of how many links one run has room for (вместимость)."""

from __future__ import annotations

from geometry.errors import LimitError
from plans.words.words import message, placed

# Links times positions of one run. Their numbers and the text of them take 1.0 to 1.6 kB each: a run stays under 2 GB.
LINK_POSITIONS_LIMIT = 1_000_000


def check_capacity(links: int, positions: int, limit: int, name: str) -> None:
    """See that the numbers of some links in some positions have room within a limit, which has a name."""
    if links * positions > limit:
        counts = {"links": links, "positions": positions, "name": name, "limit": limit, "most": limit // links}
        raise LimitError(placed(f"drive.positions = {positions}", message("limit.link_positions", **counts)))
