"""The frames about the cells of a table that nobody has filled in, of each of its parts on paper (рамка таблицы)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from drawings.grading.cells.ruling import Box

Quad: TypeAlias = tuple[complex, ...]  # the corners of a cell on paper, mm, from the lower left on, counter-clockwise


def frames(cells: Sequence[Quad]) -> tuple[Quad, ...]:
    """Give the corners of the frames about some cells; those farther apart than one is wide have frames of their own.

    >>> frames([(0j, 2 + 0j, 2 + 1j, 1j), (1j, 2 + 1j, 2 + 2j, 2j), (9j, 2 + 9j, 2 + 10j, 10j)])
    ((0j, (2+0j), (2+2j), 2j), (9j, (2+9j), (2+10j), 10j))
    """
    if not cells:
        return ()
    along = cells[0][1] - cells[0][0]
    way, gap = along / abs(along), abs(along)
    found: list[Box] = []
    for cell in cells:
        own = _about([spot / way for spot in cell])
        beside = [one for one in found if _apart(one, own) <= gap]
        found = [one for one in found if one not in beside]
        found.append(_about([spot for one in (*beside, own) for spot in one.corners]))
    return tuple(tuple(spot * way for spot in one.corners) for one in found)


def _about(spots: Sequence[complex]) -> Box:
    wide, high = [spot.real for spot in spots], [spot.imag for spot in spots]
    return Box(min(wide), min(high), max(wide), max(high))


def _apart(one: Box, other: Box) -> float:
    """Give how far two boxes are from one another, across or up."""
    across = max(one.left - other.right, other.left - one.right, 0.0)
    return max(across, one.low - other.high, other.low - one.high)
