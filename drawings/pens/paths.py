"""The commands of a path: lines, arcs and fills one after another, y turned downward (команды пути)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from functools import lru_cache
from itertools import pairwise
from typing import TypeAlias

from drawings.paper.limits import CURVE_DECIMALS, DECIMALS, REACH
from drawings.paper.strokes import Arc, Curve, Fill, Line, Polyline, SheetError
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
            _trace(Polyline(_counter_clockwise(points), closed=True), height, template, values)
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


def _counter_clockwise(points: tuple[complex, ...]) -> tuple[complex, ...]:
    """Fills of one path that turn one way cover each other where they overlap; else they would make holes."""
    doubled_area = sum((a.conjugate() * b).imag for a, b in pairwise((*points, points[0])))
    return points if doubled_area >= 0 else points[::-1]
