"""Shapes of letters: the alphabet's data read by the eye itself, and which letters look alike (начертания букв).

The unit is d, the width of the pen. A shape is what a pen goes through, from the corner of the letter's cell.
"""

from __future__ import annotations

import cmath
import json
import math
import unicodedata
from collections.abc import Iterator, Mapping
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple, TypeAlias

from geometry.curve import CubicPiece

DATA = Path(__file__).parents[1] / "lettering" / "alphabet.json"
# From the corner of a cell to the middle of the pen there.
_MIDDLE = 0.5 + 0.5j
# The notation writes angles with two decimals: ends that are nearer than this are one.
_SAME = 1e-3
_SMALL = 6.0  # d, how high the pen goes in small letters, over which accents stand
DOTLESS = {"i": "ı", "j": "ȷ"}
_STEPS = 32
ABOVE = 230  # the class of accents over a letter, as Unicode counts them

# Of each stroke its pieces, "l" straight and "c" cubic, and "z" if it is closed.
Signature: TypeAlias = tuple[str, ...]


class LetterShape(NamedTuple):
    """A letter as it is drawn: the first of those that look alike, the width of its cell, d, and its points."""

    letter: str
    width: float
    signature: Signature
    points: tuple[complex, ...]


@cache
def shapes() -> Mapping[Signature, tuple[LetterShape, ...]]:
    """Give all letters that are seen, without accents, by the kinds of their strokes."""
    found: dict[Signature, list[LetterShape]] = {}
    for letter in notations():
        one = shape(letter)
        if one.signature and one.letter == letter and not unicodedata.combining(letter):
            found.setdefault(one.signature, []).append(one)
    return {signature: tuple(own) for signature, own in found.items()}


@cache
def accented(signature: Signature) -> tuple[LetterShape, ...]:
    """Give the letters with an accent whose strokes are of these kinds."""
    accents = [shape(one) for one in notations() if unicodedata.combining(one)]
    bases = [one for own in shapes().values() for one in own]
    pairs = ((base, accent) for accent in accents for base in bases if base.letter.isalpha())
    return tuple(_stacked(base, accent) for base, accent in pairs if base.signature + accent.signature == signature)


@cache
def notations() -> Mapping[str, str]:
    """Give the notation of every letter of the alphabet."""
    read: dict[str, str] = json.loads(DATA.read_bytes())
    return {letter: notation for letter, notation in read.items() if letter}


@cache
def shape(letter: str) -> LetterShape:
    """Give the shape of a letter, by the name of the first that is drawn so.

    >>> shape("Г")
    LetterShape(letter='Г', width=5.0, signature=('ll',), points=((0.5+0.5j), (0.5+9.5j), (4.5+9.5j)))
    >>> shape("Т").letter
    'T'
    """
    notation = notations()[letter]
    if notation[0] in "=^_":
        return shape(notation[1])
    width, _, drawn = notation.partition(":")
    strokes = [tuple(_pieces(stroke)) for stroke in drawn.split("|") if stroke.strip()]
    signature = tuple(
        "".join("l" if len(piece) == 1 else "c" for piece in own[1:]) + "z" * stroke.rstrip().endswith("z")
        for own, stroke in zip(strokes, drawn.split("|"), strict=False)
    )
    return LetterShape(letter, float(width), signature, tuple(p + _MIDDLE for own in strokes for q in own for p in q))


def _pieces(stroke: str) -> Iterator[tuple[complex, ...]]:
    """Give the start of a stroke, then its pieces: one point for a straight one, three for a cubic."""
    here: complex | None = None
    for piece in _read(stroke):
        if here is None or abs(piece[-1] - here) > _SAME:
            yield piece
        here = piece[-1]


def _read(stroke: str) -> Iterator[tuple[complex, ...]]:
    for token in stroke.split():
        if token[0] == "@":
            yield from _arc(*map(float, token[1:].split(",")))
        elif token != "z":
            values = [float(number) for number in token.lstrip("~").split(",")]
            yield tuple(map(complex, values[::2], values[1::2]))


def _arc(x: float, y: float, across: float, *rest: float) -> Iterator[tuple[complex, ...]]:
    """Go to the start of an arc of an ellipse, then along it by cubics of a quarter at the most."""
    up, first, last = rest if len(rest) == 3 else (across, *rest)
    count = math.ceil(abs(last - first) / 90)
    step = math.radians(last - first) / count
    handle = 4 / 3 * math.tan(step / 4)
    turns = [cmath.exp(1j * (math.radians(first) + k * step)) for k in range(count + 1)]

    def placed(turn: complex) -> complex:
        return complex(x + across * turn.real, y + up * turn.imag)

    yield (placed(turns[0]),)
    for a, b in pairwise(turns):
        yield placed(a + handle * 1j * a), placed(b - handle * 1j * b), placed(b)


def _stacked(base: LetterShape, accent: LetterShape) -> LetterShape:
    """Set an accent over a letter, or under it: in the middle of the wider of both cells."""
    above = unicodedata.combining(accent.letter) == ABOVE
    width = max(base.width, accent.width)
    rise = _top(base) - _MIDDLE.imag - _SMALL if above else 0.0
    shifted = [point + (width - base.width) / 2 for point in base.points]
    over = [point + complex((width - accent.width) / 2, rise) for point in accent.points]
    return LetterShape(base.letter + accent.letter, width, base.signature + accent.signature, (*shifted, *over))


def _top(letter: LetterShape) -> float:
    """Give how high the pen goes in a letter: beside the handles of its cubics, in steps that miss it by 0.001 d."""
    high, place = -math.inf, 0
    for stroke in letter.signature:
        here, place = letter.points[place], place + 1
        for kind in stroke.rstrip("z"):
            count = 1 if kind == "l" else 3
            piece, place = letter.points[place : place + count], place + count
            high = max(high, here.imag, piece[-1].imag)
            if count > 1:
                curve = CubicPiece(here, *piece)
                high = max(high, *(curve.at(k / _STEPS).imag for k in range(_STEPS)))
            here = piece[-1]
    return high
