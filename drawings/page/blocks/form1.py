"""The title block of GOST 2.104-2006, form 1, and the extra graphs of course work (основная надпись, форма 1)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from drawings.lettering.words import word
from drawings.page.frame import NUMBERS, TitleCell, rectangle, write_title
from drawings.paper.hand import Field, Hand
from drawings.paper.strokes import Group, Line, LineStyle, Stroke, Text

Segments = tuple[tuple[tuple[int, int], tuple[int, int]], ...]

# The lines of form 1, from the block's lower left corner; checked against three public drawings of the form.
THICK: Segments = (
    ((0, 55), (185, 55)), ((0, 0), (0, 55)), ((65, 40), (185, 40)), ((0, 35), (65, 35)), ((135, 35), (185, 35)),
    ((0, 30), (65, 30)), ((135, 20), (185, 20)), ((65, 15), (185, 15)), ((7, 30), (7, 55)), ((17, 0), (17, 55)),
    ((40, 0), (40, 55)), ((55, 0), (55, 55)), ((65, 0), (65, 55)), ((135, 0), (135, 40)), ((150, 20), (150, 40)),
    ((167, 20), (167, 40)), ((155, 15), (155, 20)),
)  # fmt: skip
THIN: Segments = (
    *(((0, y), (65, y)) for y in (40, 45, 50, 5, 10, 15, 20, 25)),
    *(((x, 20), (x, 35)) for x in (140, 145)),
)
ROLES = ("drawn", "checked", "technical", "norms", "approved")
# What is printed in the form; graphs 14 to 18 are the table of changes, 10 the roles.
CAPTIONS = {
    "change": TitleCell(0, 30, 7, 5, 2.5, pad=0.5), "page": TitleCell(7, 30, 10, 5, 2.5, pad=0.5),
    "document": TitleCell(17, 30, 23, 5, 2.5), "signature": TitleCell(40, 30, 15, 5, 2.5),
    "date": TitleCell(55, 30, 10, 5, 2.5),
    "drawn": TitleCell(0, 25, 17, 5, 2.5, "start"), "checked": TitleCell(0, 20, 17, 5, 2.5, "start"),
    "technical": TitleCell(0, 15, 17, 5, 2.5, "start"), "norms": TitleCell(0, 5, 17, 5, 2.5, "start"),
    "approved": TitleCell(0, 0, 17, 5, 2.5, "start"), "letter": TitleCell(135, 35, 15, 5, 2.5),
    "mass": TitleCell(150, 35, 17, 5, 2.5), "scale": TitleCell(167, 35, 18, 5, 2.5),
    "sheet": TitleCell(135, 15, 11, 5, 2.5, "start"), "sheets": TitleCell(155, 15, 14, 5, 2.5, "start"),
}  # fmt: skip
TITLE = TitleCell(65, 15, 70, 25, 5.0)  # graph 1
# What else is filled in: graph 3 has the group, 11 the names, 13 the date of the one who has drawn. In letters of 2.5 a
# date of eight signs is 12 mm long and a name of fourteen 25 mm, in graphs 10 and 23 mm wide: these may go down to 1.8,
# which GOST 2.304 has for type B.
ENTRIES = {
    "designation": TitleCell(65, 40, 120, 15, 7.0), "group": TitleCell(65, 0, 70, 15),
    "organisation": TitleCell(135, 0, 50, 15, 5.0), "scale": TitleCell(167, 20, 18, 15, 5.0),
    "date": TitleCell(55, 25, 10, 5, 2.5, least=1.8, pad=0.6),
    **{key: CAPTIONS[key]._replace(left=17, width=23, least=1.8) for key in ROLES},
}  # fmt: skip
SHEET, SHEETS = TitleCell(146, 15, 9, 5), TitleCell(169, 15, 16, 5)  # graphs 7 and 8
_YEAR_FIRST = re.compile(r"\d\d(\d\d)-(\d\d)-(\d\d)")
_YEAR_LAST = re.compile(r"(\d\d)\.(\d\d)\.\d\d(\d\d)")

# Extra graphs, outside the frame on the left, from the bottom up: 19 to 23, and how high each is.
STRIP = (("original", 25), ("signed", 35), ("replaces", 25), ("duplicate", 25), ("signed", 35))
STRIP_WIDTHS = (5.0, 7.0)  # for the caption, and for the entry
REPEATED = (70.0, 14.0)  # graph 26: the designation again, for one who leafs through a file
# Graphs 31 and 32, below the frame: how far from its right end.
BELOW = {"copied": 110.0, "format": 40.0}


def block(corner: complex, entries: Mapping[str, str], hand: Hand, language: str) -> Iterator[Stroke]:
    """Draw form 1, filled; following sheets have it too, which 2.104 allows beside form 2a."""
    for segments, width in ((THICK, hand.main), (THIN, hand.construction)):
        for start, end in segments:
            yield Line(corner + complex(*start), corner + complex(*end), LineStyle(width, cap="round"))
    for key, graph in CAPTIONS.items():
        yield from graph.letter(corner, word(language, key))
    filled = {key: text for key, text in {**entries, "date": short_date(entries.get("date", ""))}.items() if text}
    for key, graph in ENTRIES.items():
        yield from graph.letter(corner, filled[key]) if key in filled else ()
    yield Group(tuple(numbers(corner, entries.get("sheet", ""), entries.get("sheets", ""))), NUMBERS)
    yield from write_title(TITLE, corner, filled.get("title", ""), filled.get("subtitle", ""))


def numbers(corner: complex, sheet: str, sheets: str) -> Iterator[Stroke]:
    """Fill graphs 7 and 8: 7 is empty where a document has one sheet only, 8 is filled on its first sheet only."""
    if sheet and sheets not in ("", "1"):
        yield from SHEET.letter(corner, sheet)
    if sheets and sheet in ("", "1"):
        yield from SHEETS.letter(corner, sheets)


def short_date(date: str) -> str:
    """Write a date as graph 13 has it: day, month and the last two figures of the year; other text stays as it is.

    >>> short_date("2026-11-21"), short_date("21.11.2026"), short_date("November")
    ('21.11.26', '21.11.26', 'November')
    """
    first, last = _YEAR_FIRST.fullmatch(date), _YEAR_LAST.fullmatch(date)
    return ".".join(first.groups()[::-1] if first else last.groups() if last else [date])


def repeated(field: Field, upright: bool) -> Field:
    """Give the place of graph 26 within the frame: upper left, or upper right on an upright sheet above A4."""
    along, across = REPEATED
    if upright:
        return Field(field.right - across, field.top - along, field.right, field.top)
    return Field(field.left, field.top - across, field.left + along, field.top)


def extra(field: Field, place: Field, designation: str, name: str, hand: Hand, language: str) -> Iterator[Stroke]:
    """Draw the extra graphs around a field: 19 to 23, 26 at its place, 31 and 32."""
    yield from _strip(complex(field.left - sum(STRIP_WIDTHS), field.bottom), hand, language)
    yield rectangle(place, LineStyle(hand.main))
    corner = complex(place.left, place.bottom)
    turn = 180.0 if place.width > place.height else -90.0  # upside down, or read from the right
    if designation:
        yield from TitleCell(0, 0, place.width, place.height, 5.0, rotation=turn).letter(corner, designation)
    for key, off in BELOW.items():
        yield Text(complex(field.right - off, 1.4), word(language, key, format=name), 2.5, "start", True)


def _strip(corner: complex, hand: Hand, language: str) -> Iterator[Stroke]:
    """Draw graphs 19 to 23, captions read from the right."""
    narrow, wide = STRIP_WIDTHS
    height = sum(high for _, high in STRIP)
    main = LineStyle(hand.main, cap="round")
    yield from (Line(corner + x, corner + complex(x, height), main) for x in (0.0, narrow))
    at = corner
    yield Line(at, at + narrow + wide, main)
    for key, high in STRIP:
        yield from TitleCell(0, 0, narrow, high, 2.5, rotation=90.0).letter(at, word(language, key))
        at += 1j * high
        yield Line(at, at + narrow + wide, main)
