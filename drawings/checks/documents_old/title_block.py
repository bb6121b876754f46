"""What the title block and the paper of a sheet must be, whatever it shows (основная надпись, формат)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from drawings.checks.documents_old import extra_graphs
from drawings.checks.wrong import Wrong
from drawings.lettering.words import word
from drawings.page.page import BLOCK
from drawings.paper.formats import BLOCKS, BORDERS, Field, lies, size_of
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Leaf, Line, Polyline, Text
from drawings.paper.walk import flat, groups, texts
from plans.scene.scene import Scene
from plans.words.words import message

# The cells that are filled in, from the lower left corner of the block: left, bottom, width, height, mm.
Cell = tuple[float, float, float, float]
CELLS: Mapping[str, Mapping[str, Cell]] = {
    "GOST": {
        "title": (65, 15, 70, 25), "scale": (167, 20, 18, 15), "drawn": (17, 25, 23, 5), "checked": (17, 20, 23, 5),
        "approved": (17, 0, 23, 5), "date": (55, 25, 10, 5), "group": (65, 0, 70, 15), "organisation": (135, 0, 50, 15),
        "designation": (65, 40, 120, 15),
    },
    "ISO": {
        "title": (69, 0, 58, 24), "scale": (156, 36, 24, 12), "drawn": (69, 36, 44, 12), "checked": (26, 36, 43, 12),
        "approved": (113, 36, 43, 12), "date": (135, 0, 24, 12), "group": (0, 36, 26, 12),
        "organisation": (0, 0, 69, 36), "designation": (127, 12, 53, 12),
    },
}  # fmt: skip
CAPTIONED = 2.5  # mm: letters of captions, which stand in the cells of ISO 7200 above what is filled in
UPPER = 0.6  # mm under the upper side of their cells
# The heavy lines of form 1 of GOST 2.104, from the block's lower left corner.
FORM = (
    (0, 55, 185, 55), (0, 0, 0, 55), (65, 40, 185, 40), (0, 35, 65, 35), (135, 35, 185, 35), (0, 30, 65, 30),
    (135, 20, 185, 20), (65, 15, 185, 15), (7, 30, 7, 55), (17, 0, 17, 55), (40, 0, 40, 55), (55, 0, 55, 55),
    (65, 0, 65, 55), (135, 0, 135, 40), (150, 20, 150, 40), (167, 20, 167, 40), (155, 15, 155, 20),
)  # fmt: skip
# Its thin lines: those of the table of changes, and of the marks of the document.
ROWS = (
    *((0, y, 65, y) for y in (5, 10, 15, 20, 25, 40, 45, 50)), (140, 20, 140, 35), (145, 20, 145, 35),
)  # fmt: skip
# What is printed in it, by the keys of its words.
PRINTED: Mapping[str, Cell] = {
    "change": (0, 30, 7, 5), "page": (7, 30, 10, 5), "document": (17, 30, 23, 5), "signature": (40, 30, 15, 5),
    "date": (55, 30, 10, 5), "drawn": (0, 25, 17, 5), "checked": (0, 20, 17, 5), "technical": (0, 15, 17, 5),
    "norms": (0, 5, 17, 5), "approved": (0, 0, 17, 5), "letter": (135, 35, 15, 5), "mass": (150, 35, 17, 5),
    "scale": (167, 35, 18, 5), "sheet": (135, 15, 11, 5), "sheets": (155, 15, 14, 5),
}  # fmt: skip
BAR = 100.0  # mm of the control bar, by which a print is measured
FRAME, RULER = "frame", "control-bar"  # the names of their groups
CUT = "…"
_DATE = re.compile(r"(?:(?P<y>\d{4})-(?P<m>\d\d)-(?P<d>\d\d)|(?P<dd>\d\d)\.(?P<mm>\d\d)\.(?P<yy>\d{4}))")


def faults(leaf: Leaf, scene: Scene, kind: str, subtitle: str, scale: str) -> Iterator[Wrong]:
    """Hold the paper, its frame, and all that is filled into the title block of a sheet of a kind."""
    sheet = scene.sheet
    way = lies(sheet.format, sheet.standard, sheet.orientation)
    size, (left, other) = size_of(sheet.format, way), BORDERS[sheet.standard]
    if max(abs(leaf.width - size[0]), abs(leaf.height - size[1])) > QUANTUM:
        yield message("wrong.paper", format=sheet.format)
    field = Field(left, other, size[0] - other, size[1] - other)
    if not _framed(leaf, field):
        yield message("wrong.frame")
    yield from _ruler(leaf, sheet.language)
    corner = complex(size[0] - other - BLOCKS[sheet.standard][0], other)
    due = {
        "title": f"{scene.heading(sheet.language)} {subtitle}",
        "scale": scale,
        "designation": sheet.designated(kind),
    }
    due |= {key: getattr(sheet, key) for key in ("drawn", "checked", "approved", "group", "organisation")}
    due["date"] = _short(sheet.date) if sheet.standard == "GOST" else sheet.date
    yield from _entries(leaf, corner, CELLS[sheet.standard], due)
    if sheet.standard == "GOST":
        yield from _form(leaf, corner)
        yield from _printed(leaf, corner, sheet.language)
        yield from extra_graphs.faults(leaf, field, sheet, sheet.designated(kind))


def _framed(leaf: Leaf, field: Field) -> bool:
    """Tell whether the frame is drawn."""
    corners = {complex(x, y) for x in (field.left, field.right) for y in (field.bottom, field.top)}
    strokes = flat(one for one in leaf.groups if one.name == FRAME)
    return any(
        isinstance(one, Polyline)
        and one.closed
        and one.style.width > 0
        and all(min(abs(corner - spot) for spot in one.points) <= QUANTUM for corner in corners)
        for one in strokes
    )


def _ruler(leaf: Leaf, language: str) -> Iterator[Wrong]:
    """See that the control bar is as long as it says."""
    strokes = [one for group in groups(leaf.groups) if group.name == RULER for one in flat((group,))]
    whole = any(isinstance(one, Line) and abs(abs(one.end - one.start) - BAR) <= QUANTUM for one in strokes)
    text = f"{BAR:.0f} {word(language, 'mm')}"
    if not (whole and any(isinstance(one, Text) and one.plain == text for one in strokes)):
        yield message("wrong.missing", name=text)


def _entries(leaf: Leaf, corner: complex, cells: Mapping[str, Cell], due: Mapping[str, str]) -> Iterator[Wrong]:
    """Hold what is written in each cell; what has no room may be cut at its end."""
    block = [one for one in groups(leaf.groups) if one.name == BLOCK]
    told = list(texts(block))
    for key, cell in cells.items():
        seen = _joined(text.plain for text in told if _in(cell, text.at - corner) and not _caption(text, corner, cell))
        whole = _joined([due[key]])
        head, cut, tail = seen.partition(CUT)
        if seen != whole and not (cut and whole.startswith(head) and (not tail or whole.endswith(tail))):
            yield message("wrong.title_cell", text=seen or "—", due=due[key] or "—")


def _joined(parts: Iterator[str] | list[str]) -> str:
    return "".join(parts).replace(" ", "").replace("\\N{NO-BREAK SPACE}", "")


def _in(cell: Cell, spot: complex) -> bool:
    left, bottom, width, height = cell
    return left <= spot.real < left + width and bottom <= spot.imag < bottom + height


def _caption(text: Text, corner: complex, cell: Cell) -> bool:
    """Tell whether a text is the caption of a cell of ISO 7200: small letters along its upper side."""
    return text.size == CAPTIONED and abs((text.at - corner).imag - (cell[1] + cell[3] - CAPTIONED - UPPER)) <= QUANTUM


def _short(date: str) -> str:
    """Write a date as form 1 has it: day, month and the last two figures of the year; other text stays as it is."""
    found = _DATE.fullmatch(date)
    if found is None:
        return date
    year, month, day = (found[a] or found[b] for a, b in (("y", "yy"), ("m", "mm"), ("d", "dd")))
    return f"{day}.{month}.{year[2:]}"


def _form(leaf: Leaf, corner: complex) -> Iterator[Wrong]:
    """See that the lines of form 1 are drawn, and no others."""
    drawn = [one for group in leaf.groups if group.name == BLOCK for one in flat((group,)) if isinstance(one, Line)]
    if len(drawn) > len(FORM) + len(ROWS):
        yield message("wrong.title_line", place=f"{len(drawn)} > {len(FORM) + len(ROWS)}")
    for x, y, right, top in (*FORM, *ROWS):
        start, end = corner + complex(x, y), corner + complex(right, top)
        if not any(_joins(one, start, end) for one in drawn):
            yield message("wrong.title_line", place=f"({x}, {y})–({right}, {top})")


def _printed(leaf: Leaf, corner: complex, language: str) -> Iterator[Wrong]:
    """See that what is printed in form 1 stands in its cells, each once."""
    told = list(texts(one for one in groups(leaf.groups) if one.name == BLOCK))
    for key, cell in PRINTED.items():
        due = Text(0j, word(language, key)).plain
        if [text.plain for text in told if _in(cell, text.at - corner)].count(due) != 1:
            yield message("wrong.title_cell", text="—", due=due)


def _joins(line: Line, start: complex, end: complex) -> bool:
    ends = ((start, end), (end, start))
    return any(max(abs(line.start - one), abs(line.end - other)) <= QUANTUM for one, other in ends)
