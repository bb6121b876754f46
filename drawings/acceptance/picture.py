"""Pictures of places on a sheet: what is wrong in red, and what is about it, to be seen in a report (вырезка).

The sheet is a picture in them: nothing of it is written anew, or runs.
"""

from __future__ import annotations

import base64
import textwrap
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from drawings.grading.feedback import RADIUS, RED, WIDTH, safe

MOST = 12  # places in one picture
ACROSS = 3  # places side by side
TILE, GAP, LETTER = 60.0, 6.0, 3.2  # mm: a place's side on the picture, what is left between, letters under it
ROOM = 15.0  # mm of the sheet about what is wrong
LEAST = 40.0  # mm of the sheet that a place shows at the least: what is wrong is told by what is about it
LETTERS, LINES = 34, 2  # of a line under a place, and lines
UNDER = 1.5 * LETTER * LINES  # mm


class Spot(NamedTuple):
    """What is wrong at a place of a sheet: in words, and from where to where it lies, mm, y up."""

    told: str
    start: complex
    end: complex


def picture(source: bytes, paper: tuple[float, float], spots: Sequence[Spot]) -> bytes:
    """Draw the places of a sheet side by side."""
    shown, (width, height) = spots[:MOST], paper
    columns, rows = min(ACROSS, len(shown)), -(-len(shown) // ACROSS)
    wide, high = GAP + columns * (TILE + GAP), GAP + rows * (TILE + UNDER + GAP)
    sheet = base64.b64encode(source).decode("ascii")
    tiles = "".join(_tile(k, spot, height) for k, spot in enumerate(shown))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide:g}mm" height="{high:g}mm" '
        f'viewBox="0 0 {wide:g} {high:g}"><defs><image id="sheet" width="{width:g}" height="{height:g}" '
        f'href="data:image/svg+xml;base64,{sheet}"/></defs>'
        f'<rect width="100%" height="100%" fill="#ffffff"/>{tiles}</svg>\n'
    ).encode("ascii")


def _tile(number: int, spot: Spot, height: float) -> str:
    """Draw one place, with what it is under it."""
    x, y = GAP + number % ACROSS * (TILE + GAP), GAP + number // ACROSS * (TILE + UNDER + GAP)
    told = textwrap.wrap(spot.told, LETTERS, max_lines=LINES, placeholder="…")
    lines = "".join(
        f'<text x="{x:g}" y="{y + TILE + 1.5 * LETTER * (k + 1):g}">{safe(line)}</text>' for k, line in enumerate(told)
    )
    box = f'x="{x:g}" y="{y:g}" width="{TILE:g}" height="{TILE:g}"'
    return (
        f'<svg {box} viewBox="{" ".join(_window(spot, height))}"><use href="#sheet"/>{_mark(spot, height)}</svg>'
        f'<rect {box} fill="none" stroke="#808080" stroke-width="0.2"/>'
        f'<g font-family="sans-serif" font-size="{LETTER:g}" fill="{RED}">{lines}</g>'
    )


def _window(spot: Spot, height: float) -> Iterator[str]:
    """Give what a place shows of the sheet: left, top and both sides, mm, y down."""
    middle, reach = (spot.start + spot.end) / 2, spot.end - spot.start
    side = max(LEAST, abs(reach.real) + 2 * ROOM, abs(reach.imag) + 2 * ROOM)
    yield from (f"{size:.3f}" for size in (middle.real - side / 2, height - middle.imag - side / 2, side, side))


def _mark(spot: Spot, height: float) -> str:
    look = f'fill="none" stroke="{RED}" stroke-width="{WIDTH}" stroke-opacity="0.7"'
    if spot.start == spot.end:
        return f'<circle cx="{spot.end.real:.3f}" cy="{height - spot.end.imag:.3f}" r="{RADIUS}" {look}/>'
    ends = (spot.start.real, height - spot.start.imag, spot.end.real, height - spot.end.imag)
    return "<line {} {}/>".format(
        " ".join(f'{name}="{size:.3f}"' for name, size in zip(("x1", "y1", "x2", "y2"), ends, strict=True)), look
    )
