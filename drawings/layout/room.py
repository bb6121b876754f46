"""The room of a sheet: what is left inside the frame for figures, tables and notes (рабочее поле)."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from drawings.layout.slicing import Size
from drawings.layout.units import CORNER, HEAD
from drawings.page.page import Field, Page

PAD = 6.0  # mm between the frame and what stands inside it


@cache
def room_of(page: Page) -> Field:
    """Give the field that figures may fill: inside the frame, beside what stands in its upper right corner."""
    room = page.field
    for place in page.taken:
        if place != page.block and place.left > room.left:
            room = room._replace(right=min(room.right, place.left))
    return room.inset(PAD)


@cache
def corner_of(page: Page) -> Size:
    """Give what the title block takes of the room, mm: it stands at the frame itself."""
    room, block = room_of(page), page.block
    return min(room.right - block.left, room.width), block.top - room.bottom


@cache
def head_of(page: Page) -> Size | None:
    """Give what the standard has in the upper left corner of the room, mm, if anything."""
    room = room_of(page)
    for place in page.taken:
        if place != page.block and place.left <= room.left:
            return place.right - room.left, room.top - place.bottom
    return None


@cache
def ends_of(page: Page) -> Mapping[int, Size]:
    """Give the sizes of what stands in the corners of the room, by their numbers."""
    head = head_of(page)
    return {CORNER: corner_of(page)} | ({} if head is None else {HEAD: head})
