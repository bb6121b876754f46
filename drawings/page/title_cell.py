"""A graph of a title block (графа): a rectangle that is lettered in the largest standard size it takes."""

from __future__ import annotations

import cmath
import math
from bisect import bisect
from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

from drawings.lettering.lettering import SIZES, outline
from drawings.paper.strokes import Anchor, Run, Text

CLEAR = 0.55  # mm from the middle of a line to the lettering: half of the widest line, and paper between
STEP = 1.7  # from line to line in sizes, the least of GOST 2.304-81
ELLIPSIS = "…"
NUMBERS = "sheet-numbers"  # the name of what a title block says of the sheet among those of its document
SUBTITLE = 3.5  # mm, its least letters: nothing on a sheet that is read at a wall is less
FEET = (6.2, 11.95)  # mm at the foot of a title for its subtitle: a line, and two, of its least letters


class TitleCell(NamedTuple):
    """A rectangle from its block's lower left corner, mm, and how it is lettered.

    `least` is its smallest letter, `pad` the room in mm where its lines of writing begin or end.
    """

    left: float
    bottom: float
    width: float
    height: float
    size: float = 3.5
    anchor: Anchor = "middle"
    rotation: float = 0.0
    least: float = SIZES[0]
    pad: float = 0.8

    def letter(self, corner: complex, plain: str) -> Iterator[Text]:
        """Letter the graph: the largest size that it takes, in lines broken at spaces; a longer text is cut."""
        size, lines = self.fit(plain)
        length, depth = self._room
        low, high = _heights(lines, size)
        # A tail or an accent moves the lines from the middle.
        middle = (depth - size * (1 + STEP * (len(lines) - 1))) / 2
        first = max(min(middle, depth - CLEAR - high), CLEAR - low)
        turn = cmath.rect(1, math.radians(self.rotation))
        centre = corner + complex(self.left + self.width / 2, self.bottom + self.height / 2)
        for k, line in enumerate(lines):
            left, right, _, _ = _ink(line, size)
            across = {
                "start": self.pad - length / 2, "middle": -(left + right) / 2, "end": length / 2 - self.pad - right,
            }[self.anchor]  # fmt: skip
            up = first + STEP * size * (len(lines) - 1 - k) - depth / 2
            yield Text(centre + complex(across, up) * turn, (Run(line),), size, "start", True, self.rotation)

    def fit(self, plain: str) -> tuple[float, list[str]]:
        """Give the size of the lettering and its lines.

        >>> TitleCell(0, 0, 70, 14, 5.0).fit("Crank shaper"), TitleCell(0, 0, 20, 5).fit("a name that is too long")
        ((5.0, ['Crank shaper']), (1.8, ['a name that is…']))
        """
        sizes = [size for size in SIZES if self.least <= size <= self.size]
        room = self._room[0] - self.pad - (self.pad if self.anchor == "middle" else CLEAR)
        for size in reversed(sizes):
            lines = _broken(plain, size, room)
            if self._takes(lines, size) and all(_long(line, size) <= room for line in lines):
                return size, lines
        while len(lines) > 1 and not self._takes(lines, sizes[0]):
            lines[-2:] = [f"{lines[-2]} {lines[-1]}"]
        return sizes[0], [_cut(line, sizes[0], room) for line in lines]

    @property
    def _room(self) -> tuple[float, float]:
        """The graph along and across its line of writing, mm."""
        return (self.height, self.width) if self.rotation % 180 else (self.width, self.height)

    def _takes(self, lines: list[str], size: float) -> bool:
        """Tell whether lines of a size stand clear of the graph's own, above and below."""
        low, high = _heights(lines, size)
        return high - low <= self._room[1] - 2 * CLEAR


def write_title(area: TitleCell, corner: complex, title: str, subtitle: str) -> Iterator[Text]:
    """Letter a title, and its subtitle in smaller letters under it: whole if it can be, then as large as it can be."""
    splits = []
    for foot in FEET if subtitle else (0.0,):
        above = area._replace(bottom=area.bottom + foot, height=area.height - foot)
        size, lines = above.fit(title)
        below = area._replace(height=foot, size=max(s for s in SIZES if s < max(size, 5.0)), least=SUBTITLE)
        small, more = below.fit(subtitle) if subtitle else (0.0, [])
        whole = not any(ELLIPSIS in line for line in (*lines, *more))
        splits.append((whole, size, small, foot, above, below))
    *_, above, below = max(splits)
    yield from above.letter(corner, title) if title else ()
    yield from below.letter(corner, subtitle) if subtitle else ()


@lru_cache(maxsize=1024)
def _ink(line: str, size: float) -> tuple[float, float, float, float]:
    """Give the box of a line's ink about the start of its line of writing: left, right, low, high."""
    points = [point for stroke in outline(Text(0j, (Run(line),), size, "start", True)) for point in stroke.points]
    if not points:
        return 0.0, 0.0, 0.0, 0.0
    across, up, pen = [point.real for point in points], [point.imag for point in points], size / 20
    return min(across) - pen, max(across) + pen, min(up) - pen, max(up) + pen


def _long(line: str, size: float) -> float:
    left, right, _, _ = _ink(line, size)
    return right - min(left, 0.0)


def _heights(lines: list[str], size: float) -> tuple[float, float]:
    """Give the least and the greatest height of ink over the last line of writing: tails, accents."""
    return _ink(lines[-1], size)[2], _ink(lines[0], size)[3] + STEP * size * (len(lines) - 1)


def _broken(plain: str, size: float, room: float) -> list[str]:
    """Break a text at its spaces into lines for a room, mm."""
    lines: list[str] = []
    for part in filter(None, plain.split(" ")):
        if lines and _long(f"{lines[-1]} {part}", size) <= room:
            lines[-1] += f" {part}"
        else:
            lines.append(part)
    return lines or [""]


def _cut(line: str, size: float, room: float) -> str:
    """Cut a line that is too long, with an ellipsis."""
    if _long(line, size) <= room:
        return line
    kept = bisect(range(1, len(line) + 1), room, key=lambda count: _long(f"{line[:count]}{ELLIPSIS}", size))
    return f"{line[:kept].rstrip()}{ELLIPSIS}"
