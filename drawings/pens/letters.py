"""Letters as path data: each letter of a size is traced once, and then only set in its place.

The points of a letter are written in hundredths of a millimetre, each measured from the end of the piece before it as
that is written, so that no rounding adds up; the place of a letter in thousandths.
"""

from __future__ import annotations

import cmath
import math
from functools import lru_cache

from drawings.lettering.alphabet import SLANT
from drawings.lettering.curves import curves
from drawings.lettering.lettering import letters_of, text_width
from drawings.paper.limits import REACH
from drawings.paper.strokes import SheetError, Text

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
