"""Typeset texts: what is left to a viewer's fonts, by what stands in the elements (надписи шрифтом)."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

from drawings.eye import alike
from drawings.eye.ink import length
from drawings.measure.pathdata import number
from drawings.measure.transform import Affine
from drawings.measure.visibility import Look
from drawings.paper.strokes import LOWERED, RAISED, LineStyle, Text

EM = 1.4  # a font's size over the height of its capitals
FREE = 0.1  # sizes, which a font leaves free before its first letter
_WORDS = 0.4  # sizes: what is farther apart is two words
_EVEN = 0.01  # sizes: how far a level may be off
_RISES = {-1: -LOWERED, 1: RAISED}


class Typeset(NamedTuple):
    """One element of text: its characters, where its ink begins (mm, y up), its size and length, mm, how it stands."""

    plain: str
    at: complex
    size: float
    length: float
    rotation: float
    slanted: bool


def typeset(plain: str, place: Affine, look: Look, attributes: Mapping[str, str]) -> Typeset:
    """Read one element of text."""
    # A font stands on a line of writing that goes along x, and upward against y.
    along, up = place.p + place.q, (place.p - place.q) * -1j
    size = length(look.font_size) / EM * abs(up)
    turn = along / abs(along)
    at = place(complex(number(attributes.get("x", "0")), number(attributes.get("y", "0")))) + FREE * size * turn
    long = number(attributes.get("textLength", "0")) * abs(along) - 2 * FREE * size
    slanted = look.font_style in ("italic", "oblique")
    return Typeset(plain, at, size, long, round(math.degrees(cmath.phase(turn)) % 360, 6) % 360, slanted)


def joined(parts: Sequence[Typeset], said: str, ink: LineStyle) -> Text:
    """Read elements of text that stand together as one text with its levels."""
    size = max(part.size for part in parts)
    first = parts[0]
    turn = cmath.rect(1, math.radians(first.rotation))
    row = sorted(parts, key=lambda part: (part.at / turn).real)
    low = next((part.at / turn).imag for part in row if part.size == size)
    signs = [(sign, level) for plain, level in _levels(row, turn, low, size) for sign in alike.signs(plain)]
    seen = [(sign.seen, level or sign.level) for sign, level in signs]
    runs = alike.picked(seen, [sign.thin for sign, _ in signs], said, fonts=True)
    at = turn * complex((row[0].at / turn).real, low)
    return Text(at, runs, round(size, 4), "start", first.slanted, first.rotation, ink)


def _levels(row: Sequence[Typeset], turn: complex, low: float, size: float) -> Iterator[tuple[str, int]]:
    """Give parts and their levels, and the spaces between them where they are apart."""
    before = [""] + [" " if _apart(one, after, turn, size) else "" for one, after in pairwise(row)]
    for part, space in zip(row, before, strict=True):
        yield space + part.plain, _level(((part.at / turn).imag - low) / size)


def _apart(one: Typeset, after: Typeset, turn: complex, size: float) -> bool:
    return ((after.at - one.at) / turn).real - one.length > _WORDS * size


def _level(rise: float) -> int:
    return next((level for level, own in _RISES.items() if abs(rise - own) <= _EVEN), 0)
