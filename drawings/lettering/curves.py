"""The strokes of the letters as curves, for pens that draw them: shorter than chords, and smooth at any size."""

from __future__ import annotations

import math
import unicodedata
from functools import cache
from itertools import pairwise
from typing import NamedTuple

from drawings.lettering.alphabet import MIDDLE, SAME, Points, notations, numbers, stacked, strokes


class Curve(NamedTuple):
    """One stroke of a letter as it is meant: from its start by pieces, straight (one point) or cubic (three)."""

    start: complex
    pieces: tuple[Points, ...]
    closed: bool = False


@cache
def curves(letter: str) -> tuple[Curve, ...]:
    """Give a letter's strokes before they are divided into chords.

    >>> curves("Г")
    (Curve(start=(0.5+0.5j), pieces=(((0.5+9.5j),), ((4.5+9.5j),)), closed=False),)
    """
    notation = notations().get(letter)
    if notation is None:
        _, parts = stacked(*unicodedata.normalize("NFD", letter))
        return tuple(_shifted(curve, way) for part, way in parts for curve in curves(part))
    if notation[0] in "=^_":
        return curves(notation[1])
    return tuple(_shifted(_curve(stroke), MIDDLE) for stroke in strokes(notation))


def _curve(notation: str) -> Curve:
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
    return Curve(ends[0], tuple(kept), notation.rstrip().endswith("z"))


def _quarters(x: float, y: float, across: float, up: float, start: float, end: float) -> list[Points]:
    """Lead to the start of an arc of an ellipse, and follow it by cubics: a quarter misses it by 0.03% at most."""
    count = math.ceil(abs(end - start) / 90)
    turns = [math.radians(start + (end - start) * k / count) for k in range(count + 1)]
    handle = 4 / 3 * math.tan((turns[1] - turns[0]) / 4)
    places = [complex(x + across * math.cos(turn), y + up * math.sin(turn)) for turn in turns]
    ways = [handle * complex(-across * math.sin(turn), up * math.cos(turn)) for turn in turns]
    arc = [(p + v, q - w, q) for (p, v), (q, w) in pairwise(zip(places, ways, strict=True))]
    return [(places[0],), *arc]


def _shifted(curve: Curve, way: complex) -> Curve:
    return Curve(
        curve.start + way, tuple(tuple(point + way for point in piece) for piece in curve.pieces), curve.closed
    )
