"""The title block of ISO 7200:2004: its data fields in the arrangement of its example, 180 mm wide."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from drawings.lettering.words import word
from drawings.page.frame import NUMBERS, TitleCell, write_title
from drawings.paper.hand import BLOCKS, Hand
from drawings.paper.strokes import Group, Line, LineStyle, Polyline, Run, Stroke, Text

# The data fields: place from the block's lower left corner, mm, and the largest letters of what is filled in. Rows are
# 12 high, where the example has 9 with captions of 1.8; the title takes two lines, its subtitle two. Beside the
# standard's fields stand the one who checked, as courses want it, and the scale, which ISO 7200 leaves to the sheet.
CELLS = {
    "department": TitleCell(0, 40, 26, 12), "checked by": TitleCell(26, 40, 43, 12),
    "creator": TitleCell(69, 40, 44, 12),
    "approval": TitleCell(113, 40, 43, 12), "scale": TitleCell(156, 40, 24, 12), "owner": TitleCell(0, 0, 57, 40),
    "type": TitleCell(57, 28, 70, 12), "status": TitleCell(127, 28, 53, 12), "title": TitleCell(57, 0, 70, 28, 5.0),
    "number": TitleCell(127, 12, 53, 16, 5.0), "revision": TitleCell(127, 0, 8, 12),
    "issued": TitleCell(135, 0, 24, 12),
    "code": TitleCell(159, 0, 9.5, 12), "sheet": TitleCell(168.5, 0, 11.5, 12),
}  # fmt: skip
# The entry of the scene that each field shows as it is.
GIVEN = {
    "department": "group", "checked by": "checked", "creator": "drawn", "approval": "approved", "scale": "scale",
    "owner": "organisation", "number": "designation", "issued": "date",
}  # fmt: skip
CAPTION, PAD = 2.5, 1.2
UNDER = 3.6  # mm from the top of a field to the room of its entry, which keeps clear of the caption's tails


def block(corner: complex, entries: Mapping[str, str], hand: Hand, language: str) -> Iterator[Stroke]:
    """Draw the block, filled."""
    width, height = BLOCKS["ISO"]
    for key, cell in CELLS.items():
        yield from _walls(corner, cell, hand)
        at = corner + complex(cell.left + PAD, cell.bottom + cell.height - CAPTION - 0.6)
        yield Text(at, (Run(word(language, f"{key} field")),), CAPTION, "start", True)
    outline = (corner, corner + width, corner + complex(width, height), corner + 1j * height)
    yield Polyline(outline, True, LineStyle(hand.main))
    for key, text in _values(entries, language):
        yield from _room(key).letter(corner, text) if text else ()
    yield Group(tuple(numbers(corner, entries.get("sheet", ""), entries.get("sheets", ""))), NUMBERS)
    area = _room("title")._replace(width=CELLS["title"].width - PAD)  # clear of the ruling on its right as on its left
    yield from write_title(area, corner, entries.get("title", ""), entries.get("subtitle", ""))


def numbers(corner: complex, sheet: str, sheets: str) -> Iterator[Stroke]:
    """Fill the field of the sheet's number, which is mandatory, of one sheet too."""
    yield from _room("sheet").letter(corner, f"{sheet or '1'}/{sheets or '1'}")


def _room(key: str) -> TitleCell:
    """Give what the caption of a field leaves of it."""
    cell = CELLS[key]
    return cell._replace(height=cell.height - UNDER, anchor="start", pad=PAD)


def _values(entries: Mapping[str, str], language: str) -> Iterator[tuple[str, str]]:
    """Give what is filled in beside title and numbers."""
    yield from ((key, entries.get(entry, "")) for key, entry in GIVEN.items())
    yield "type", entries.get("type") or word(language, "document type")
    yield "code", language


def _walls(corner: complex, cell: TitleCell, hand: Hand) -> Iterator[Line]:
    """Draw the left and the upper side of a field; the others belong to its neighbours and to the outline."""
    at = corner + complex(cell.left, cell.bottom)
    top = at + 1j * cell.height
    thin = LineStyle(hand.thin)
    if cell.left:
        yield Line(at, top, thin)
    if cell.bottom + cell.height < BLOCKS["ISO"][1]:
        yield Line(top, top + cell.width, thin)
