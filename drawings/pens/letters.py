"""Letters as path data: each letter of a size is traced once, and then only set in its place.

The points of a letter are written in hundredths of a millimetre, each measured from the one before it as that is
written, so that no rounding adds up; the place of a letter in thousandths.
"""

from __future__ import annotations

import cmath
import math
from functools import lru_cache
from itertools import pairwise

from drawings.alphabet import SLANT, glyph, leaning
from drawings.lettering import letters_of, width
from drawings.limits import REACH
from drawings.strokes import SheetError, Text

HUNDREDTH = 100  # of a millimetre: a tenth of what a thin line is wide


def lettering(text: Text, height: float) -> dict[float, str]:
    """Write a text as path data, one path for each width of the pen (mm), y downward from the sheet's `height`."""
    turn = cmath.rect(1, math.radians(text.rotation)) if text.rotation else 1 + 0j
    start = text.at - {"start": 0.0, "middle": 0.5, "end": 1.0}[text.anchor] * width(text) * turn
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
    chains = leaning(letter) if slanted else glyph(letter).strokes
    if not chains:
        return 0j, ""
    first = scale * chains[0].points[0]
    written, (x, y) = "", (0, 0)
    for points, closed in chains:
        places = [_rounded(scale * point - first) for point in points]
        steps = [(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(places) if a != b]
        down = _moves("m", [(places[0][0] - x, places[0][1] - y)]) if written else "l"
        written += down + _moves("" if written else "l", steps or [(0, 0)]).removeprefix("l") + "z" * closed
        x, y = places[0] if closed else places[-1]
    return first, written


def _rounded(point: complex) -> tuple[int, int]:
    return round(HUNDREDTH * point.real), round(-HUNDREDTH * point.imag)


def _moves(command: str, steps: list[tuple[int, int]]) -> str:
    """Write steps as short as SVG reads them: no zero before a point, no gap before a minus.

    >>> _moves("l", [(5, -120), (-30, 700)])
    'l.05-1.2-.3 7'
    """
    return command + "".join([_hundredths(x) + _hundredths(y) for x, y in steps]).removeprefix(" " * bool(command))


@lru_cache(maxsize=4096)
def _hundredths(count: int) -> str:
    digits = f"{abs(count) / HUNDREDTH:.2f}".rstrip("0").rstrip(".").removeprefix("0") or "0"
    return f"-{digits}" if count < 0 else f" {digits}"


def _thousandths(place: float) -> str:
    if not abs(place) <= REACH:
        raise SheetError(f"no place on paper: {place} mm")
    return str(round(1000 * place) / 1000).removesuffix(".0")
