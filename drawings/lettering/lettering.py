"""Lettering: texts as strokes of a pen, in sizes of GOST 2.304-81 and letters of our own alphabet.

Small letters are 7/10 of the size, the pen and d are 1/10; the gap between letters is 2d, between words 6d.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from typing import Final, NamedTuple

from drawings.lettering.alphabet import GAP, SLANT, gap, glyph, known, leaning, letters, level
from drawings.paper.strokes import (
    LEAN,
    LOWERED,
    RAISED,
    TURN,
    Arc,
    Box,
    Circle,
    Curve,
    Fill,
    Group,
    Leaf,
    Line,
    LineStyle,
    Polyline,
    Run,
    SheetError,
    Stroke,
    Text,
)
from drawings.paper.walk import flat, texts, tied
from geometry.curve import sampled
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
            if not known(sign):
                plain = "".join(piece.text for piece in pieces)
                raise UnknownLetter(plain, lacking(plain))
            letter, raised = level(sign)
            yield letter, run_level or raised


def every(least: float, whole: int) -> int:
    """Choose how many positions apart numbers stand: a divisor of the whole turn, if one is not much above the least.

    >>> every(1.4, 24), every(4.1, 24), every(2.0, 23)
    (2, 6, 2)
    """
    first = max(math.ceil(tied(least)), 1)
    return next((step for step in range(first, 2 * first) if whole % step == 0), first)


def numbered(places: Sequence[complex], length: float, apart: float, first: Iterable[int] = ()) -> tuple[int, ...]:
    """Choose which places on a curve of some length, mm, bear their numbers: those named first always.

    Where all have room, that is all; else every so many, and none nearer than `apart` mm to another. A gap has none.

    >>> numbered([0j, 5 + 0j, 10 + 0j, 15 + 0j], 20.0, 4.0), numbered([0j, 5 + 0j, 10 + 0j, 15 + 0j], 20.0, 8.0, (3,))
    ((0, 1, 2, 3), (3, 0))
    """
    free = [k for k, place in enumerate(places) if not math.isnan(abs(place))]
    kept = [k for k in first if k in set(free)]
    step = every(apart * len(places) / length, len(places)) if length and places else 1
    if step == 1:
        return tuple(free)
    return spaced(places, apart, [k for k in free if k % step == 0], kept)


def spaced(
    places: Sequence[complex], apart: float, order: Iterable[int] | None = None, first: Iterable[int] = ()
) -> tuple[int, ...]:
    """Choose places that are no nearer than `apart` to one another: those named first always, then in an order.

    >>> spaced([1.0, 1.2, 3.0, 2.9], 0.5), spaced([1.0, 1.2, 3.0, 2.9], 0.5, (3, 2, 1), (0,))
    ((0, 2), (0, 3))
    """
    kept = [*first]
    for k in range(len(places)) if order is None else order:
        if all(tied(abs(places[k] - places[other]) - apart) >= 0 for other in kept):
            kept.append(k)
    return tuple(kept)


TOGETHER = 0.5  # sizes of a number: places nearer than this have one number, of them all


def coinciding(places: Sequence[complex], near: float) -> list[list[int]]:
    """Gather places that fall together on paper, each with the first one that it is nearer to than `near` mm.

    >>> coinciding([0j, 5 + 0j, 0.1j, 9 + 0j], 1.0)
    [[0, 2], [1], [3]]
    """
    groups: list[list[int]] = []
    for k, place in enumerate(places):
        found = next((group for group in groups if abs(places[group[0]] - place) < near), None)
        groups.append([k]) if found is None else found.append(k)
    return groups


GRAIN = 0.01  # mm that a curve may reach beyond its box: a twentieth of the finest line


def bounds(stroke: Stroke) -> Box:
    """Give the box (left, bottom, right, top) around a stroke's geometry, line width not counted.

    >>> bounds(Group((Line(1 + 1j, 3 + 0j), Circle(0j, 1))))
    (-1.0, -1.0, 3.0, 1.0)
    """
    match stroke:
        case Line():
            return _around((stroke.start, stroke.end))
        case Polyline() | Fill():
            return _around(stroke.points)
        case Circle():
            reach = stroke.radius * (1 + 1j)
            return _around((stroke.centre - reach, stroke.centre + reach))
        case Arc():
            return _around(_extremes(stroke))
        case Curve(pieces):
            return _around(sampled(pieces, GRAIN))
        case Text():
            return _around(_corners(stroke))
        case Group():
            boxes = [bounds(inner) for inner in flat(stroke.strokes)]
            return _around([complex(*box[:2]) for box in boxes] + [complex(*box[2:]) for box in boxes])


def _around(points: tuple[complex, ...] | list[complex]) -> Box:
    if not points:
        raise SheetError("an empty group or chain has no bounds")
    across, up = [point.real for point in points], [point.imag for point in points]
    return min(across), min(up), max(across), max(up)


def _extremes(arc: Arc) -> list[complex]:
    """An arc reaches its box at its ends and at the quarter points that it passes."""
    first = math.ceil(arc.start_angle / (TURN / 4))
    last = math.floor((arc.start_angle + arc.sweep) / (TURN / 4))
    quarters = [arc.centre + arc.radius * 1j ** (k % 4) for k in range(first, last + 1)]
    return [arc.at(0), arc.at(1), *quarters]


def _corners(text: Text) -> tuple[complex, ...]:
    """Give the corners of a text's box; slanted letters lean past its end, their tails before its start."""
    width = text_width(text)
    left = {"start": 0.0, "middle": -width / 2, "end": -width}[text.anchor]
    bottom, top = text_reach(text)
    back, lean = (LEAN * bottom, LEAN * top) if text.slanted else (0.0, 0.0)
    turn = cmath.rect(1, math.radians(text.rotation))
    return tuple(text.at + complex(x, y) * turn for x in (left + back, left + width + lean) for y in (bottom, top))
