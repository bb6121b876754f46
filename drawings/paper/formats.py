"""Formats: sizes of paper, borders, and which way a standard lays them (форматы; GOST 2.301-68, ISO 5457:1999)."""

from __future__ import annotations

from typing import NamedTuple

from drawings.paper.strokes import SheetError
from plans.words.words import message

# Width and height of a sheet that stands upright, mm; GOST 2.301-68 and ISO 216 agree.
SIZES = {"A1": (594.0, 841.0), "A2": (420.0, 594.0), "A3": (297.0, 420.0), "A4": (210.0, 297.0)}
# The border on the left, which is for filing, and on the other three sides.
BORDERS = {"GOST": (20.0, 5.0), "ISO": (20.0, 10.0)}
# Title blocks: form 1 of GOST 2.104-2006; ISO 7200:2004 sets the width only.
BLOCKS = {"GOST": (185.0, 55.0), "ISO": (180.0, 52.0)}
# Which way a format may lie, the customary way first. The block of ISO 5457 is at the lower right of a sheet that lies
# along its long side, and along the short side of an A4 only.
LANDSCAPE, PORTRAIT = "landscape", "portrait"
WAYS = {"GOST": (LANDSCAPE, PORTRAIT), "ISO": (LANDSCAPE,)}
WAYS_OF_A4 = (PORTRAIT,)
SAID_BY = {"GOST": "GOST 2.301-68", "ISO": "ISO 5457"}


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

    def holds(self, spot: complex) -> bool:
        """Tell whether a place lies in it."""
        return self.left <= spot.real <= self.right and self.bottom <= spot.imag <= self.top

    def inset(self, by: float) -> Field:
        """Give the rectangle without a border."""
        return Field(self.left + by, self.bottom + by, self.right - by, self.top - by)


def lies(name: str, standard: str, wanted: str | None = None) -> str:
    """Tell which way a format lies: as it is wanted if its standard has it so, or else its customary way.

    >>> lies("A1", "GOST"), lies("A4", "ISO"), lies("A3", "GOST", "portrait")
    ('landscape', 'portrait', 'portrait')
    """
    ways = WAYS_OF_A4 if name == "A4" else WAYS[standard]
    if wanted is None or wanted in ways:
        return wanted or ways[0]
    key = "refused.orientation_a4" if name == "A4" else "refused.orientation"
    raise SheetError(message(key, given=wanted, way=ways[0], standard=SAID_BY[standard], format=name))


def size_of(name: str, orientation: str) -> tuple[float, float]:
    """Give width and height of a format, mm.

    >>> size_of("A3", "landscape")
    (420.0, 297.0)
    """
    width, height = SIZES[name]
    return (width, height) if orientation == PORTRAIT else (height, width)
