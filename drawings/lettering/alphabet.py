"""The alphabet as a value: single-stroke letters of our own on the grid of GOST 2.304-81, type B, from alphabet.json.

The unit is d, a tenth of the height of capitals and the width of the pen: small letters are 7d high, tails hang 3d low.
"""

import json
import math
import unicodedata
from collections.abc import Iterator
from functools import cache
from itertools import pairwise
from operator import add
from pathlib import Path
from typing import Final, NamedTuple, TypeAlias

from drawings.paper.walk import MARGIN, tied

# Slanted letters stand at 75 degrees to the line of writing.
SLANT: Final = math.tan(math.radians(15))
# Between letters; halved where the neighbouring lines are not parallel, as in ГА or AT.
GAP: Final = 2.0
# A curve may miss its chords by so much: 0.01 mm in letters of 5 mm.
FLATNESS: Final = 0.02

# From the corner of a letter's cell to the middle of the pen there; the middle of the pen on top of small letters.
MIDDLE, _SMALL = 0.5 + 0.5j, 6.0
# Angles are written with two decimals: an arc ends so near to where its notation says.
SAME = 1e-3
_DOTLESS = {"i": "ı", "і": "ı", "j": "ȷ"}
_STOPS = ".,′″’"
# Letters are compared in strips half a d high, each of which counts for its two neighbours above and below too.
_STRIP, _LOWEST, _STRIPS, _NEIGHBOURS = 0.5, -5.0, 40, 2

Points: TypeAlias = tuple[complex, ...]
Profile: TypeAlias = tuple[float, ...]


class PenChain(NamedTuple):
    """One stroke of a letter, from pen down to pen up."""

    points: Points
    closed: bool = False


class Glyph(NamedTuple):
    """A letter: its width between the outer edges, and its strokes from the lower left corner of its cell."""

    width: float
    strokes: tuple[PenChain, ...]


def letters(plain: str) -> Iterator[str]:
    """Split lettering into letters, each with its accents.

    >>> list(letters("Й" + "φ\u0308"))
    ['Й', 'φ̈']
    """
    if plain.isascii():  # and so without accents
        yield from plain
        return
    letter = ""
    for character in unicodedata.normalize("NFC", plain):
        if letter and unicodedata.combining(character):
            letter += character
            continue
        if letter:
            yield letter
        letter = character
    if letter:
        yield letter


@cache
def known(letter: str) -> bool:
    """Tell whether the alphabet has a letter, or its parts: a letter and accents."""
    parts = unicodedata.normalize("NFD", letter)
    return letter in notations() or (len(parts) > 1 and all(part in notations() for part in parts))


@cache
def level(letter: str) -> tuple[str, int]:
    """Give a letter and the level it is written on: ² is a raised 2.

    >>> level("²"), level("₀"), level("a")
    (('2', 1), ('0', -1), ('a', 0))
    """
    notation = notations().get(letter, "")
    moved = {"^": 1, "_": -1}.get(notation[:1], 0)
    return (notation[1], moved) if moved else (letter, 0)


@cache
def glyph(letter: str) -> Glyph:
    """Give a letter of the alphabet, under its accents if it has any.

    >>> glyph("Г")
    Glyph(width=5.0, strokes=(PenChain(points=((0.5+0.5j), (0.5+9.5j), (4.5+9.5j)), closed=False),))
    """
    notation = notations().get(letter)
    if notation is None:
        return _accented(*unicodedata.normalize("NFD", letter))
    if notation[0] in "=^_":
        return glyph(notation[1])
    return Glyph(float(notation.partition(":")[0]), tuple(_chain(stroke) for stroke in strokes(notation)))


@cache
def leaning(letter: str) -> tuple[PenChain, ...]:
    """Give a letter's strokes slanted: every point moves along the line of writing by tan 15 degrees of its height."""
    return tuple(
        PenChain(tuple(point + SLANT * point.imag for point in points), closed)
        for points, closed in glyph(letter).strokes
    )


@cache
def gap(left: str, right: str) -> float:
    """Give the gap between two letters: half of it between lines that are not parallel.

    >>> gap("Г", "А"), gap("L", "T"), gap("A", "V"), gap("Н", "О"), gap("А", "А")
    (1.0, 1.0, 1.0, 2.0, 2.0)
    """
    pair = left[0], right[0]
    if not (any(letter.isalpha() for letter in pair) and all(letter.isalpha() or letter in _STOPS for letter in pair)):
        return GAP
    room = min(map(add, _profiles(left)[1], _profiles(right)[0]))
    return GAP / 2 if tied(room) >= GAP / 2 else GAP


@cache
def notations() -> dict[str, str]:
    """Give the notation of every letter."""
    read: dict[str, str] = json.loads(Path(__file__).with_name("alphabet.json").read_bytes())
    del read[""]  # the key to the notation, for its readers
    return read


def strokes(notation: str) -> list[str]:
    """Split a letter's notation into its strokes."""
    return [stroke for stroke in notation.partition(":")[2].split("|") if stroke.strip()]


def numbers(token: str) -> list[float]:
    """Read the numbers of a token; a circle's arc has one radius for both."""
    numbers = [float(number) for number in token.lstrip("@~").split(",")] if token != "z" else []
    return [*numbers[:3], *numbers[2:]] if token[0] == "@" and len(numbers) == 5 else numbers


def _chain(notation: str) -> PenChain:
    points: list[complex] = []
    for token in notation.split():
        values = numbers(token)
        if token[0] == "@":
            points += _arc(*values)
        elif token[0] == "~":
            points += _cubic(points[-1], *map(complex, values[::2], values[1::2]))
        elif token != "z":
            points.append(complex(*values))
    closed = notation.rstrip().endswith("z")
    kept = [points[0]] + [b for a, b in pairwise(points) if abs(b - a) > SAME]
    if closed and abs(kept[-1] - kept[0]) <= SAME:
        kept.pop()
    return PenChain(tuple(point + MIDDLE for point in kept), closed)


def _arc(x: float, y: float, across: float, up: float, start: float, end: float) -> list[complex]:
    """Divide an arc of an ellipse into chords, at its quarters first, so that it reaches the lines of the grid."""
    step = 2 * math.degrees(math.acos(1 - FLATNESS / max(across, up)))
    low, high = sorted((start, end))
    cuts = [low, *range(90 * (math.floor(low / 90) + 1), math.ceil(high), 90), high]
    angles = [low]
    for a, b in pairwise(cuts):
        pieces = math.ceil((b - a) / step)
        angles += [a + (b - a) * k / pieces for k in range(1, pieces + 1)]
    turns = map(math.radians, angles if start <= end else reversed(angles))
    return [complex(x + across * math.cos(turn), y + up * math.sin(turn)) for turn in turns]


def _cubic(a: complex, b: complex, c: complex, d: complex) -> list[complex]:
    """Divide a cubic curve into chords, all but its start."""
    bend = max(abs(a - 2 * b + c), abs(b - 2 * c + d))
    pieces = max(1, math.ceil(math.sqrt(0.75 * bend / FLATNESS)))
    shares = (k / pieces for k in range(1, pieces + 1))
    return [(1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t * t * c + t**3 * d for t in shares]


def _accented(base: str, *accents: str) -> Glyph:
    """Write accents over a letter."""
    width, parts = stacked(base, *accents)
    return Glyph(width, tuple(chain for part, way in parts for chain in _moved(glyph(part), way)))


def stacked(base: str, *accents: str) -> tuple[float, list[tuple[str, complex]]]:
    """Place accents over a letter, higher over a tall one; the cell widens if they need it."""
    above = [accent for accent in accents if unicodedata.combining(accent) == 230]
    base = _DOTLESS.get(base, base) if above else base
    body = glyph(base)
    width = max(body.width, *(glyph(accent).width for accent in accents))
    parts = [(base, (width - body.width) / 2 + 0j)]
    rise = max(point.imag for chain in body.strokes for point in chain.points) - MIDDLE.imag - _SMALL
    for accent in accents:
        parts.append((accent, complex((width - glyph(accent).width) / 2, rise if accent in above else 0)))
        rise += 3 if accent in above else 0
    return width, parts


def _moved(body: Glyph, way: complex) -> tuple[PenChain, ...]:
    return tuple(PenChain(tuple(point + way for point in points), closed) for points, closed in body.strokes)


@cache
def _profiles(letter: str) -> tuple[Profile, Profile]:
    """Give the empty room to the left and to the right of a letter in each strip of its height."""
    body = glyph(letter)
    left, right = [math.inf] * _STRIPS, [math.inf] * _STRIPS
    for point in _samples(body):
        place = int((point.imag - _LOWEST) / _STRIP + MARGIN)
        strip = min(place, _STRIPS - 1)  # a tower of accents is as high as it may be
        left[strip] = min(left[strip], point.real - MIDDLE.real)
        right[strip] = min(right[strip], body.width - point.real - MIDDLE.real)
    return _widened(left), _widened(right)


def _widened(rooms: list[float]) -> Profile:
    """Give each strip the least room of its neighbours too."""
    return tuple(min(rooms[max(k - _NEIGHBOURS, 0) : k + _NEIGHBOURS + 1]) for k in range(_STRIPS))


def _samples(body: Glyph) -> Iterator[complex]:
    for points, closed in body.strokes:
        for a, b in pairwise((*points, points[0]) if closed else points):
            pieces = math.ceil(abs(b - a) / _STRIP)
            yield from (a + (b - a) * k / pieces for k in range(pieces + 1))
