"""Lettering: texts as strokes of a pen, in sizes of GOST 2.304-81 and letters of our own alphabet.

Small letters are 7/10 of the size, the pen and d are 1/10; the gap between letters is 2d, between words 6d.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import Final, NamedTuple

from drawings.lettering.alphabet import GAP, SLANT, gap, glyph, known, leaning, letters, level
from drawings.paper.strokes import LOWERED, RAISED, Leaf, LineStyle, Polyline, Run, SheetError, Text
from drawings.paper.walk import texts
from plans.words.words import message

# Heights of capitals in mm, each the one before times the square root of two, rounded.
SIZES: Final = (1.8, 2.5, 3.5, 5.0, 7.0, 10.0, 14.0, 20.0, 28.0, 40.0)


class UnknownLetter(SheetError):  # noqa: N818  (a draughtsman's word for it)
    """Lettering with letters that the alphabet lacks."""

    def __init__(self, text: str, lacks: tuple[str, ...]) -> None:
        named = ", ".join(f"{letter!r} ({' '.join(f'U+{ord(sign):04X}' for sign in letter)})" for letter in lacks)
        super().__init__(message("refused.letters", text=repr(text), letters=named))
        self.text = text
        self.lacks = lacks


class PlacedLetter(NamedTuple):
    """A letter on its line of writing: how far along and how high it stands, and its d, all in mm."""

    letter: str
    along: float
    rise: float
    unit: float


def index_size(size: float) -> float:
    """Give the size of subscripts and superscripts: the next smaller one of the standard, the smallest keeps its own.

    >>> index_size(5.0), index_size(3.5), index_size(1.8), round(index_size(6.0), 2)
    (3.5, 2.5, 1.8, 4.24)
    """
    return SIZES[max(SIZES.index(size) - 1, 0)] if size in SIZES else size / math.sqrt(2)


def lacking(text: Text | str) -> tuple[str, ...]:
    """Give the letters of a text that the alphabet lacks, each once, in the order of reading.

    >>> lacking("Звено 2: ω₂ = 3,5 с⁻¹"), lacking("雪 и 雨")
    ((), ('雪', '雨'))
    """
    plain = text.plain if isinstance(text, Text) else text
    return tuple(dict.fromkeys(letter for letter in letters(plain) if not known(letter)))


def demand(texts: Iterable[Text]) -> None:
    """Refuse texts that the alphabet cannot write, before anything is drawn."""
    for text in texts:
        if lacks := lacking(text):
            raise UnknownLetter(text.plain, lacks)


def text_width(text: Text) -> float:
    """Give the length of a text along its line of writing in mm, from outer edge to outer edge, lean not counted.

    >>> text_width(Text(0j, "АТ", 10.0)), text_width(Text(0j, "ИН", 10.0)), text_width(Text(0j, "v_2", 10.0))
    (14.0, 14.0, 9.9)
    """
    return _line(text.runs, text.size)[1]


def text_reach(text: Text) -> tuple[float, float]:
    """Give how far the ink of a text reaches below and above its line of writing, mm: tails hang, indices stand.

    >>> text_reach(Text(0j, "НО", 10.0)), text_reach(Text(0j, "pq", 10.0))
    ((0.0, 10.0), (-3.0, 7.0))
    """
    low, high = 0.0, 0.0
    for letter, _, rise, unit in _line(text.runs, text.size)[0]:
        bottom, top = _span(letter)
        low, high = min(low, rise + unit * bottom), max(high, rise + unit * top)
    return low, high


@lru_cache(maxsize=1024)
def _span(letter: str) -> tuple[float, float]:
    """Give the lowest and the highest ink of a letter, in d."""
    heights = [point.imag for points, _ in glyph(letter).strokes for point in points]
    return (min(heights) - 0.5, max(heights) + 0.5) if heights else (0.0, 0.0)


def outline(text: Text) -> tuple[Polyline, ...]:
    """Write a text on paper with a pen of a tenth of the size, to be drawn round at ends and corners.

    >>> [stroke.points for stroke in outline(Text(3 + 1j, "Г", 10.0))]
    [((3.5+1.5j), (3.5+10.5j), (7.5+10.5j))]
    """
    places, length = _line(text.runs, text.size)
    turn = cmath.rect(1, math.radians(text.rotation)) if text.rotation else 1 + 0j
    start = text.at - {"start": 0.0, "middle": 0.5, "end": 1.0}[text.anchor] * length * turn
    lean = SLANT if text.slanted else 0.0
    chains: list[Polyline] = []
    for letter, along, rise, unit in places:
        origin, scale, style = start + turn * complex(along + lean * rise, rise), turn * unit, pen(unit, text.style)
        for points, closed in leaning(letter) if text.slanted else glyph(letter).strokes:
            chains.append(Polyline(tuple([origin + scale * point for point in points]), closed, style))
    return tuple(chains)


def letters_of(text: Text) -> tuple[PlacedLetter, ...]:
    """Give the letters of a text in their places on its line of writing, from its start."""
    return _line(text.runs, text.size)[0]


def lettered(leaf: Leaf, lettering: str = "strokes") -> Leaf:
    """Say how the texts of a sheet are written; either way the alphabet must have their letters."""
    demand(texts(leaf.groups))
    return leaf._replace(lettering=lettering)


@lru_cache(maxsize=256)
def pen(unit: float, ink: LineStyle) -> LineStyle:
    """Give the pen of a width in mm that writes in a text's ink."""
    return LineStyle(width=unit, colour=ink.fill if ink.colour == "none" else ink.colour, cap="round")


@lru_cache(maxsize=4096)
def _line(pieces: tuple[Run, ...], size: float) -> tuple[tuple[PlacedLetter, ...], float]:
    """Set a text on its line of writing: the letters in their places, and its length."""
    if lacks := lacking(plain := "".join(piece.text for piece in pieces)):
        raise UnknownLetter(plain, lacks)
    units = {0: size / 10, -1: index_size(size) / 10, 1: index_size(size) / 10}
    rises = {0: 0.0, -1: -LOWERED * size, 1: RAISED * size}
    places: list[PlacedLetter] = []
    along, last, before = 0.0, "", 0
    for letter, now in _levelled(pieces):
        if last:
            along += min(units[now], units[before]) * (gap(last, letter) if now == before else GAP)
        places.append(PlacedLetter(letter, along, rises[now], units[now]))
        along += glyph(letter).width * units[now]
        last, before = letter, now
    return tuple(places), along


def _levelled(pieces: tuple[Run, ...]) -> Iterator[tuple[str, int]]:
    """Give letters with their levels; a raised sign in a subscript stays in it."""
    for text, run_level in pieces:
        for sign in letters(text):
            letter, raised = level(sign)
            yield letter, run_level or raised
