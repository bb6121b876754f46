"""Capacity: how many positions of how many links one run has room for (вместимость)."""

from __future__ import annotations

from geometry.errors import LimitError
from plans.words.words import message, placed

# Links times positions of one run. Their numbers, and the text of them, take 1.0 to 1.6 kB each, and those of forces
# by both roads up to 3.8 kB: a run stays under 2 GB.
LINK_POSITIONS_LIMIT = 1_000_000
FORCE_POSITIONS_LIMIT = 500_000


def check_capacity(links: int, positions: int, forces: bool) -> None:
    """See that the numbers of some links in some positions, with their forces or without, have room."""
    name, limit = "LINK_POSITIONS_LIMIT", LINK_POSITIONS_LIMIT
    if forces:
        name, limit = "FORCE_POSITIONS_LIMIT", FORCE_POSITIONS_LIMIT
    if links * positions > limit:
        counts = {"links": links, "positions": positions, "name": name, "limit": limit, "most": limit // links}
        raise LimitError(placed(f"drive.positions = {positions}", message("limit.link_positions", **counts)))
