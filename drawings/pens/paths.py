"""The data of a path, y turned downward: lines, arcs and fills, and letters that are traced once and set (пути).

The points of a letter are written in hundredths of a millimetre, each measured from the end of the piece before it as
that is written, so that no rounding adds up; the place of a letter in thousandths.
"""

from __future__ import annotations

import cmath
import math
import re
import unicodedata
from collections.abc import Iterable
from functools import cache, lru_cache
from itertools import pairwise
from typing import NamedTuple, TypeAlias

from drawings.lettering import alphabet
from drawings.lettering.alphabet import MIDDLE, SAME, SLANT, Points, notations, stacked, strokes
from drawings.lettering.lettering import letters_of, text_width
from drawings.paper.limits import CURVE_DECIMALS, DECIMALS, REACH
from drawings.paper.strokes import Arc, Curve, Fill, Line, Polyline, SheetError, Text
from drawings.paper.walk import tied
from geometry.curve import CubicPiece, Piece

_ZEROS = re.compile(r"0+(?![\d.!])")


def numbers(template: str, values: Iterable[float], decimals: int = DECIMALS) -> str:
    """Write coordinates into a template of `%s`: fixed decimals without needless zeros, no exponent, no -0.

    >>> numbers("M%s %sL%s %s", (10, -0.0, 1e-7, 100.25))
    'M10 0L0 100.25'
    """
    values = tuple(values)
    if values and not (math.isfinite(sum(values)) and max(values) <= REACH and min(values) >= -REACH):
        raise SheetError(f"no place on paper: {[value for value in values if not abs(value) <= REACH][:2]} mm")
    written = template.replace("%s", f"%.{decimals}f") % values
    return _ZEROS.sub("", written.replace("." + "0" * decimals, "!").replace("-0!", "0!")).replace("!", "")


@lru_cache(maxsize=1024)
def number(value: float) -> str:
    """Write one number.

    >>> number(-0.00001), number(594), number(0.35)
    ('0', '594', '0.35')
    """
    return numbers("%s", (value,))


Plain: TypeAlias = Line | Polyline | Arc | Fill

# A flag that is rounded with the ends decides the wrong half of a large arc; a quarter turn leaves no doubt.
_QUARTER = math.pi / 2
# An arc's flags stand as one letter in a template, so that every zero before a gap there is a needless decimal.
_FLAGS, _CLOCKWISE_FLAGS = ("F", "0 0 0 "), ("G", "0 0 1 ")


def commands(strokes: Iterable[Plain], height: float) -> str:
    """Give the commands of one path through all strokes, on a sheet of a height in mm."""
    template: list[str] = []
    values: list[float] = []
    for stroke in strokes:
        _trace(stroke, height, template, values)
    return numbers("".join(template), values).replace(*_FLAGS)


def curve(stroke: Curve, height: float) -> str:
    """Give the commands of the path of a curve, with more decimals than other paths have."""
    start = stroke.pieces[0].start
    template, values = ["M%s %s"], [start.real, height - start.imag]
    for piece in stroke.pieces:
        _piece(piece, height, template, values)
    written = numbers("".join(template) + "Z" * stroke.closed, values, CURVE_DECIMALS)
    return written.replace(*_FLAGS).replace(*_CLOCKWISE_FLAGS)


def _trace(stroke: Plain, height: float, template: list[str], values: list[float]) -> None:
    """Add a stroke to a path: the form of its commands and its coordinates, y turned."""
    match stroke:
        case Line(start, end):
            template.append("M%s %sL%s %s")
            values += (start.real, height - start.imag, end.real, height - end.imag)
        case Polyline(points, closed):
            template.append("M%s %s" + "L%s %s" * (len(points) - 1) + "Z" * closed)
            for point in points:
                values += (point.real, height - point.imag)
        case Fill(points):
            # Fills of one path that turn one way cover each other where they overlap; else they would make holes.
            doubled_area = sum((a.conjugate() * b).imag for a, b in pairwise((*points, points[0])))
            _trace(Polyline(points if doubled_area >= 0 else points[::-1], closed=True), height, template, values)
        case Arc():
            pieces = max(1, math.ceil(tied(stroke.sweep / _QUARTER)))
            template.append("M%s %s" + "A%s %s F%s %s" * pieces)
            values += (stroke.at(0).real, height - stroke.at(0).imag)
            for piece in range(1, pieces + 1):
                end = stroke.at(piece / pieces)
                values += (stroke.radius, stroke.radius, end.real, height - end.imag)


def _piece(piece: Piece, height: float, template: list[str], values: list[float]) -> None:
    """Add a piece of a curve to a path that has come to its start."""
    if isinstance(piece, CubicPiece):
        template.append("C%s %s %s %s %s %s")
        for point in piece[1:]:
            values += (point.real, height - point.imag)
        return
    count = max(1, math.ceil(tied(abs(piece.sweep) / _QUARTER)))
    template.append(f"A%s %s {'F' if piece.sweep >= 0 else 'G'}%s %s" * count)
    for share in range(1, count + 1):
        end = piece.at(share / count)
        values += (piece.radius, piece.radius, end.real, height - end.imag)


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
        values = alphabet.numbers(token)
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
    pieces = tuple(tuple(point + way for point in piece) for piece in curve.pieces)
    return LetterStroke(curve.start + way, pieces, curve.closed)


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


@lru_cache(maxsize=4096)  # letters of a line stand as high
def _thousandths(place: float) -> str:
    if not abs(place) <= REACH:
        raise SheetError(f"no place on paper: {place} mm")
    return str(round(1000 * place) / 1000).removesuffix(".0")


def forget() -> None:
    """Forget the letters that were traced, so that the first sheet of a process can be timed again."""
    _traced.cache_clear()
    _hundredths.cache_clear()
