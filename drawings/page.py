"""The page: format, frame and title block (ESKD: GOST 2.301-68, GOST 2.104-2006 form 1; основная надпись)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

from drawings.hand import Hand
from drawings.strokes import (
    INK,
    Anchor,
    Circle,
    Group,
    Line,
    LineStyle,
    Polyline,
    Run,
    Stroke,
    Text,
    stated,
    text_width,
)
from drawings.words import word

# Width and height in mm with the long side across, and the line widths for it; GOST 2.301-68 and 2.303-68.
FORMATS = {"A1": (841.0, 594.0), "A2": (594.0, 420.0)}
HANDS = {"A1": Hand(0.7, 0.35, 0.25), "A2": Hand(0.7, 0.35, 0.25)}
LEFT, OTHER = 20.0, 5.0  # mm of the frame from the edges
BLOCK = (185.0, 55.0)

# The lines of form 1, from the block's lower left corner; checked against three public drawings of the form.
THICK = (
    ((0, 55), (185, 55)), ((0, 0), (0, 55)), ((65, 40), (185, 40)), ((0, 35), (65, 35)), ((135, 35), (185, 35)),
    ((0, 30), (65, 30)), ((135, 20), (185, 20)), ((65, 15), (185, 15)), ((7, 30), (7, 55)), ((17, 0), (17, 55)),
    ((40, 0), (40, 55)), ((55, 0), (55, 55)), ((65, 0), (65, 55)), ((135, 0), (135, 40)), ((150, 20), (150, 40)),
    ((167, 20), (167, 40)), ((155, 15), (155, 20)),
)  # fmt: skip
THIN = (
    *(((0, y), (65, y)) for y in (40, 45, 50, 5, 10, 15, 20, 25)),
    ((140, 20), (140, 35)),
    ((145, 20), (145, 35)),
)
CAPTION, VALUE, NAME, DESIGNATION = 2.5, 3.5, 5.0, 7.0
SIZES = (7.0, 5.0, 3.5, 2.5)  # standard letter sizes of GOST 2.304-81
# Width of each graph of the block that is filled from the scene, mm.
WIDTHS = {
    "designation": 118.0, "title": 68.0, "subtitle": 68.0, "group": 68.0, "organisation": 48.0, "scale": 17.0,
    "sheet": 8.0, "sheets": 12.0, "drawn": 22.0, "checked": 22.0,
}  # fmt: skip


class Field(NamedTuple):
    """A rectangle of paper, mm."""

    left: float
    bottom: float
    right: float
    top: float

    @property
    def width(self) -> float:
        """Width, mm."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """Height, mm."""
        return self.top - self.bottom

    @property
    def centre(self) -> complex:
        """Centre."""
        return complex(self.left + self.right, self.bottom + self.top) / 2

    def inset(self, by: float) -> Field:
        """Give the rectangle without a border."""
        return Field(self.left + by, self.bottom + by, self.right - by, self.top - by)


class Page(NamedTuple):
    """A format with its frame and line widths."""

    name: str

    @property
    def size(self) -> tuple[float, float]:
        """Width and height, mm."""
        return FORMATS[self.name]

    @property
    def hand(self) -> Hand:
        """Line widths."""
        return HANDS[self.name]

    @property
    def field(self) -> Field:
        """The field inside the frame."""
        width, height = self.size
        return Field(LEFT, OTHER, width - OTHER, height - OTHER)

    @property
    def block(self) -> Field:
        """The place of the title block."""
        field = self.field
        return Field(field.right - BLOCK[0], field.bottom, field.right, field.bottom + BLOCK[1])

    def frame(self) -> Group:
        """Draw the paper, its edge, and the frame; white, so that a dark screen shows it as it prints."""
        width, height = self.size
        edge = _rectangle(Field(0, 0, width, height), LineStyle(self.hand.construction, fill="#ffffff"))
        return Group((edge, _rectangle(self.field, LineStyle(self.hand.main))), "frame")

    def corners(self) -> Group:
        """Mark three corners of the frame, by which a reader finds the sheet's own millimetres again."""
        field = self.field
        places = (
            complex(field.left, field.bottom), complex(field.right, field.bottom), complex(field.left, field.top),
        )  # fmt: skip
        marks = tuple(
            Group((Circle(at, 0.35, INK),), f"corner-{k + 1}", {"kind": "corner", "value": stated(at)})
            for k, at in enumerate(places)
        )
        return Group(marks, "corners")

    def title_block(self, fields: Mapping[str, str], language: str) -> Group:
        """Draw form 1, filled: title, designation, names, organisation, scale, sheet numbers."""
        at = complex(self.block.left, self.block.bottom)
        lines: list[Stroke] = [
            Line(at + complex(*start), at + complex(*end), LineStyle(width))
            for segments, width in ((THICK, self.hand.main), (THIN, self.hand.construction))
            for start, end in segments
        ]
        return Group((*lines, *_captions(at, language), *_entries(at, fields)), "title-block")


def _rectangle(field: Field, style: LineStyle) -> Polyline:
    corners = (
        (field.left, field.bottom),
        (field.right, field.bottom),
        (field.right, field.top),
        (field.left, field.top),
    )
    return Polyline(tuple(complex(*corner) for corner in corners), True, style)


def _captions(at: complex, language: str) -> list[Stroke]:
    places = {
        "change": (0.5, 31.2), "page": (7.6, 31.2), "document": (18, 31.2), "signature": (41, 31.2),
        "date": (55.8, 31.2), "drawn": (0.8, 26.2), "checked": (0.8, 21.2), "technical": (0.8, 16.2),
        "norms": (0.8, 6.2), "approved": (0.8, 1.2), "letter": (136.5, 36.2), "mass": (151.5, 36.2),
        "scale": (168.5, 36.2), "sheet": (136.5, 16.2), "sheets": (156.5, 16.2),
    }  # fmt: skip
    return [Text(at + complex(*place), word(language, key), CAPTION, "start", True) for key, place in places.items()]


def _entries(at: complex, fields: Mapping[str, str]) -> list[Stroke]:
    places: dict[str, tuple[float, float, float, str]] = {
        "designation": (125, 44.5, DESIGNATION, "middle"),
        "title": (100, 29.5, NAME, "middle"),
        "subtitle": (100, 20.5, VALUE, "middle"),
        "group": (100, 5.8, VALUE, "middle"),
        "organisation": (160, 5.8, VALUE, "middle"),
        "scale": (176, 25.5, VALUE, "middle"),
        "sheet": (150, 16.2, VALUE, "middle"),
        "sheets": (178, 16.2, VALUE, "middle"),
        "drawn": (17.6, 26.2, CAPTION, "start"),
        "checked": (17.6, 21.2, CAPTION, "start"),
    }
    return [
        _fitted(at + complex(x, y), fields[key], size, "middle" if anchor == "middle" else "start", WIDTHS[key])
        for key, (x, y, size, anchor) in places.items()
        if fields.get(key)
    ]


def _fitted(at: complex, plain: str, size: float, anchor: Anchor, width: float) -> Text:
    """Letter a graph of the title block in the largest standard size that its width takes; a longer text is cut."""
    for smaller in (s for s in SIZES if s <= size):
        trial = Text(at, (Run(plain),), smaller, anchor, True)
        if text_width(trial) <= width:
            return trial
    while text_width(trial) > width:
        plain = plain.removesuffix("…")[:-1] + "…"
        trial = replace(trial, content=(Run(plain),))
    return trial
