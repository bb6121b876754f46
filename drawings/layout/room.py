"""The room of a sheet: what is left inside the frame for figures, tables and notes (рабочее поле)."""

from __future__ import annotations

from drawings.layout.slicing import Size
from drawings.page.page import Field, Page

PAD = 6.0  # mm between the frame and what stands inside it


def room_of(page: Page) -> Field:
    """Give the field that figures may fill: inside the frame, beside or under what else the standard has there."""
    room = page.field
    for place in page.taken:
        if place != page.block and place.width >= place.height:
            room = room._replace(top=min(room.top, place.bottom))
        elif place != page.block:
            room = room._replace(right=min(room.right, place.left))
    return room.inset(PAD)


def corner_of(page: Page) -> Size:
    """Give what the title block takes of the room, mm: it stands at the frame itself."""
    room, block = room_of(page), page.block
    return min(room.right - block.left, room.width), block.top - room.bottom
