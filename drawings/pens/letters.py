"""Letters as path data: each letter of a size is traced once, and then only set in its place.

The points of a letter are written in hundredths of a millimetre, each measured from the end of the piece before it as
that is written, so that no rounding adds up; the place of a letter in thousandths.
"""

from __future__ import annotations

import cmath
import math
import unicodedata
from functools import cache, lru_cache
from itertools import pairwise
from typing import NamedTuple

from drawings.lettering.alphabet import MIDDLE, SAME, SLANT, Points, notations, numbers, stacked, strokes
from drawings.lettering.lettering import letters_of, text_width
from drawings.paper.limits import REACH
from drawings.paper.strokes import SheetError, Text


class LetterStroke(NamedTuple):
    """One stroke of a letter as it is meant: from its start by pieces, straight (one point) or cubic (three)."""

    start: complex
    pieces: tuple[Points, ...]
    closed: bool = False


@cache
def curves(letter: str) -> tuple[LetterStroke, ...]:
    """Give a letter's strokes before they are divided into chords.

    >>> curves("Г")
    (LetterStroke(start=(0.5+0.5j), pieces=(((0.5+9.5j),), ((4.5+9.5j),)), closed=False),)
    """
    notation = notations().get(letter)
    if notation is None:
        _, parts = stacked(*unicodedata.normalize("NFD", letter))
        return tuple(_shifted(curve, way) for part, way in parts for curve in curves(part))
    if notation[0] in "=^_":
        return curves(notation[1])
    return tuple(_shifted(_curve(stroke), MIDDLE) for stroke in strokes(notation))


def _curve(notation: str) -> LetterStroke:
    pieces: list[Points] = []
    for token in notation.split():
        values = numbers(token)
        if token[0] == "@":
            pieces += _quarters(*values)
        elif token[0] == "~":
            pieces.append(tuple(map(complex, values[::2], values[1::2])))
        elif token != "z":
            pieces.append((complex(*values),))
    ends = [piece[-1] for piece in pieces]
    kept = [piece for end, piece in zip(ends, pieces[1:], strict=False) if abs(piece[-1] - end) > SAME]
    return LetterStroke(ends[0], tuple(kept), notation.rstrip().endswith("z"))


def _quarters(x: float, y: float, across: float, up: float, start: float, end: float) -> list[Points]:
    """Lead to the start of an arc of an ellipse, and follow it by cubics: a quarter misses it by 0.03% at most."""
    count = math.ceil(abs(end - start) / 90)
    turns = [math.radians(start + (end - start) * k / count) for k in range(count + 1)]
    handle = 4 / 3 * math.tan((turns[1] - turns[0]) / 4)
    places = [complex(x + across * math.cos(turn), y + up * math.sin(turn)) for turn in turns]
    ways = [handle * complex(-across * math.sin(turn), up * math.cos(turn)) for turn in turns]
    arc = [(p + v, q - w, q) for (p, v), (q, w) in pairwise(zip(places, ways, strict=True))]
    return [(places[0],), *arc]


def _shifted(curve: LetterStroke, way: complex) -> LetterStroke:
    return LetterStroke(
        curve.start + way, tuple(tuple(point + way for point in piece) for piece in curve.pieces), curve.closed
    )


HUNDREDTH = 100  # of a millimetre: a tenth of what a thin line is wide


def lettering(text: Text, height: float) -> dict[float, str]:
    """Write a text as path data, one path for each width of the pen (mm), y downward from the sheet's `height`."""
    turn = cmath.rect(1, math.radians(text.rotation)) if text.rotation else 1 + 0j
    start = text.at - {"start": 0.0, "middle": 0.5, "end": 1.0}[text.anchor] * text_width(text) * turn
    lean = SLANT if text.slanted else 0.0
    paths: dict[float, str] = {}
    for letter, along, rise, unit in letters_of(text):
        first, traced = _traced(letter, turn * unit, text.slanted)
        if traced:
            at = start + turn * complex(along + lean * rise, rise) + first
            paths[unit] = f"{paths.get(unit, '')}M{_thousandths(at.real)} {_thousandths(height - at.imag)}{traced}"
    return paths


@lru_cache(maxsize=4096)
def _traced(letter: str, scale: complex, slanted: bool) -> tuple[complex, str]:
    """Give the first point of a letter from its origin (mm), and its strokes as path data from there."""
    lean = SLANT if slanted else 0.0
    first, written, here = 0j, "", (0, 0)

    def placed(point: complex) -> tuple[int, int]:
        place = scale * (point + lean * point.imag) - first
        return round(HUNDREDTH * place.real), round(-HUNDREDTH * place.imag)

    for start, pieces, closed in curves(letter):
        if not written:
            first = scale * (start + lean * start.imag)
        begun = placed(start)
        written += _step("m", here, [begun]) if written else ""
        here, before = begun, "m" if written else ""
        for piece in pieces:
            there = [placed(point) for point in piece]
            command = "l" if len(piece) == 1 else "c"
            # Steps after a move are straight without being called so, and a command is not repeated.
            written += _step("" if command == before or (before, command) == ("m", "l") else command, here, there)
            here, before = there[-1], command
        written += "z" * closed
        here = begun if closed else here
    return first, written


def _step(command: str, here: tuple[int, int], points: list[tuple[int, int]]) -> str:
    """Write steps from a point as short as SVG reads them: no zero before a point, no gap before a minus.

    >>> _step("l", (100, 0), [(105, -120)]), _step("", (0, 0), [(30, 700)])
    ('l.05-1.2', ' .3 7')
    """
    steps = "".join([_hundredths(x - here[0]) + _hundredths(y - here[1]) for x, y in points])
    return command + (steps.removeprefix(" ") if command else steps)


@lru_cache(maxsize=4096)
def _hundredths(count: int) -> str:
    digits = f"{abs(count) / HUNDREDTH:.2f}".rstrip("0").rstrip(".").removeprefix("0") or "0"
    return f"-{digits}" if count < 0 else f" {digits}"


def _thousandths(place: float) -> str:
    if not abs(place) <= REACH:
        raise SheetError(f"no place on paper: {place} mm")
    return str(round(1000 * place) / 1000).removesuffix(".0")


def forget() -> None:
    """Forget the letters that were traced, so that the first sheet of a process can be timed again."""
    _traced.cache_clear()
    _hundredths.cache_clear()
