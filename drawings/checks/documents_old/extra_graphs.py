"""The extra graphs of GOST 2.104 around the field: 19 to 23, 26, 31 and 32, held to the form (дополнительные графы)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import accumulate

from drawings.checks.wrong import Wrong
from drawings.lettering.words import word
from drawings.page.page import EXTRA
from drawings.paper.formats import PORTRAIT, Field, lies
from drawings.paper.limits import QUANTUM
from drawings.paper.strokes import Leaf, Line, Polyline, Text
from drawings.paper.walk import flat, groups
from plans.scene.sheet import SheetTable
from plans.words.words import message

# Graphs 19 to 23 from the bottom up: what is printed in each, and how high it is, mm.
STRIP = (("original", 25), ("signed", 35), ("replaces", 25), ("duplicate", 25), ("signed", 35))
PRINTED, WIDE = 5, 12  # mm: how wide what is printed stands, and the whole strip
LEVEL, RIGHT, LEFT, OVER = 0.0, 90.0, -90.0, 180.0  # deg: lettering is level, read from a side, upside down
WHOLE = 360.0  # deg
REPEATED = (70, 14)  # mm: graph 26
BELOW = {"copied": (110, 70), "format": (40, 40)}  # graphs 31 and 32: mm from the field's right end, and their width
CUT = "…"


def faults(leaf: Leaf, field: Field, sheet: SheetTable, designation: str) -> Iterator[Wrong]:
    """See that the lines of the extra graphs are drawn, and that each says what it must, turned as it must be."""
    strokes = [*flat(one for one in groups(leaf.groups) if one.name == EXTRA)]
    left, place = [one for one in strokes if isinstance(one, Text)], _repeated(field, sheet)
    yield from _ruled([one for one in strokes if isinstance(one, Line)], field)
    if not any(isinstance(one, Polyline) and _around(one, place) for one in strokes):
        yield message("wrong.title_line", place="26")
    corner = complex(field.left - WIDE, field.bottom)
    for (key, high), top in zip(STRIP, accumulate(high for _, high in STRIP), strict=True):
        foot = corner + 1j * (top - high)
        yield from _told(left, Field(foot.real, foot.imag, foot.real + PRINTED, foot.imag + high), sheet, key, RIGHT)
    turn = OVER if place.right - place.left > place.top - place.bottom else LEFT
    yield from _said(left, place, designation, turn)
    for key, (off, wide) in BELOW.items():
        yield from _told(left, Field(field.right - off, 0.0, field.right - off + wide, field.bottom), sheet, key, LEVEL)
    yield from (message("wrong.title_cell", text=one.plain, due="—") for one in left)


def _repeated(field: Field, sheet: SheetTable) -> Field:
    """Give the place of graph 26: upper left; upper right on an upright sheet above A4."""
    along, across = REPEATED
    upright = lies(sheet.format, sheet.standard, sheet.orientation) == PORTRAIT
    if upright and sheet.format != "A4":
        return Field(field.right - across, field.top - along, field.right, field.top)
    return Field(field.left, field.top - across, field.left + along, field.top)


def _ruled(lines: list[Line], field: Field) -> Iterator[Wrong]:
    """See that the strip has its two upright lines, and a line under, between and over its graphs."""
    corner, tops = complex(field.left - WIDE, field.bottom), [0, *accumulate(high for _, high in STRIP)]
    due = [(corner + x, corner + complex(x, tops[-1])) for x in (0, PRINTED)]
    due += [(corner + 1j * y, corner + complex(WIDE, y)) for y in tops]
    for start, end in due:
        ends = ((start, end), (end, start))
        if not any(max(abs(one.start - a), abs(one.end - b)) <= QUANTUM for one in lines for a, b in ends):
            at, to = start - corner, end - corner
            yield message("wrong.title_line", place=f"({at.real:g}, {at.imag:g})–({to.real:g}, {to.imag:g})")


def _around(one: Polyline, place: Field) -> bool:
    corners = [complex(x, y) for x in (place.left, place.right) for y in (place.bottom, place.top)]
    return one.closed and all(min(abs(spot - own) for own in one.points) <= QUANTUM for spot in corners)


def _told(left: list[Text], cell: Field, sheet: SheetTable, key: str, turn: float) -> Iterator[Wrong]:
    yield from _said(left, cell, Text(0j, word(sheet.language, key, format=sheet.format)).plain, turn)


def _said(left: list[Text], cell: Field, due: str, turn: float) -> Iterator[Wrong]:
    """Hold what stands in a graph, turned as it must be, and strike it off what is left; too long, it may be cut."""
    own = [one for one in left if (one.rotation - turn) % WHOLE == 0 and _in(cell, one.at)]
    left[:] = [one for one in left if one not in own]
    seen, whole = "".join(one.plain for one in own).replace(" ", ""), due.replace(" ", "")
    head, cut, _ = seen.partition(CUT)
    if seen != whole and not (cut and whole.startswith(head)):
        yield message("wrong.title_cell", text=seen or "—", due=due or "—")


def _in(cell: Field, spot: complex) -> bool:
    return cell.left <= spot.real < cell.right and cell.bottom <= spot.imag < cell.top
