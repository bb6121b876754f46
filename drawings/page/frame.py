"""The frame of a sheet with its zones, and a graph of its title block (рамка, зоны, графы основной надписи)."""

import cmath
import math
from bisect import bisect
from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

from drawings.lettering.lettering import SIZES, outline
from drawings.lettering.words import word
from drawings.paper.hand import Field, Hand
from drawings.paper.strokes import INK, Anchor, Fill, Group, Line, LineStyle, Polyline, Run, Stroke, Text

CLEAR = 0.55  # mm from the middle of a line to the lettering: half of the widest line, and paper between
AIR = 1.0  # mm the same of several lines of lettering, which fill their graph and would seem to touch its lines
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
        return (self.height, self.width) if self.rotation % 180 else (self.width, self.height)

    def _takes(self, lines: list[str], size: float) -> bool:
        """Tell whether lines of a size stand clear of the graph's own, above and below."""
        low, high = _heights(lines, size)
        return high - low <= self._room[1] - 2 * (AIR if len(lines) > 1 else CLEAR)


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
    if _long(line, size) <= room:
        return line
    kept = bisect(range(1, len(line) + 1), room, key=lambda count: _long(f"{line[:count]}{ELLIPSIS}", size))
    return f"{line[:kept].rstrip()}{ELLIPSIS}"


# Where a sheet is folded to A4, from its left edge, by its width: form A of DIN 824, for a file with 20 mm of margin,
# its title block on the cover. A custom: neither GOST 2.104 nor ISO 5457 asks for the marks.
FOLDS: dict[float, tuple[float, ...]] = {
    841.0: (210.0, 335.5, 461.0, 651.0), 594.0: (210.0, 402.0), 420.0: (125.0, 230.0), 297.0: (63.5, 107.0), 210.0: (),
}  # fmt: skip
FOLD_HEIGHT = 297.0  # of A4, from the bottom up
FOLD_MARK = 3.0  # mm from the edge
# The control bar stands in the filing margin, clear of the strip of graphs 19 to 23 and of the holes of a punch.
BAR = 100.0
BAR_FROM, BAR_X = 160.0, 7.0
BAR_ENDS, BAR_TICKS = 1.5, 0.8  # mm to each side, at its ends and every 10 mm


def paper(size: tuple[float, float], hand: Hand) -> Polyline:
    """Draw the paper and its edge: white, so that a dark screen shows it as it prints."""
    return rectangle(Field(0, 0, *size), LineStyle(hand.construction, fill="#ffffff"))


def rectangle(field: Field, style: LineStyle) -> Polyline:
    """Draw a rectangle."""
    left, bottom, right, top = field
    corners = (complex(left, bottom), complex(right, bottom), complex(right, top), complex(left, top))
    return Polyline(corners, True, style)


def folds(size: tuple[float, float], hand: Hand) -> Iterator[Stroke]:
    """Mark at the edges where the sheet is folded to A4."""
    width, height = size
    style = LineStyle(hand.construction)
    for x in FOLDS[width]:
        yield Line(complex(x, 0), complex(x, FOLD_MARK), style)
        yield Line(complex(x, height), complex(x, height - FOLD_MARK), style)
    for k in range(1, int(height / FOLD_HEIGHT) + 1):
        y = k * FOLD_HEIGHT
        if y < height:
            yield Line(complex(0, y), complex(FOLD_MARK, y), style)
            yield Line(complex(width, y), complex(width - FOLD_MARK, y), style)


def control_bar(hand: Hand, language: str) -> Group:
    """Draw 100 mm of paper, divided by tens, by which a print can be measured (контрольный отрезок)."""
    foot = complex(BAR_X, BAR_FROM)
    strokes: list[Stroke] = [Line(foot, foot + 1j * BAR, LineStyle(hand.thin))]
    for k in range(11):
        half = BAR_ENDS if k in (0, 10) else BAR_TICKS
        at = foot + 1j * BAR * k / 10
        strokes.append(Line(at - half, at + half, LineStyle(hand.thin)))
    label = Text(foot + complex(5.5, BAR / 2), f"100 {word(language, 'mm')}", 3.5, "middle", True, 90.0)
    return Group((*strokes, label), "control-bar", {"length": f"{BAR:.0f}"})


# How many fields along the short and the long side; the ones at the corners take what 50 mm leave over.
FIELDS = {"A1": (12, 16), "A2": (8, 12), "A3": (6, 8), "A4": (4, 6)}
LENGTH, DEPTH = 50.0, 5.0
FRAME, GRID, LETTER = 0.7, 0.35, 3.5  # mm: line of the frame and of the centring marks, of the grid, its letters
CENTRING = 5.0  # mm that a centring mark reaches into the drawing space
TRIMMING = (10.0, 5.0)
LETTERS = "ABCDEFGHJKLMNPQRSTUVWXYZ"  # without I and O


def borders(name: str, size: tuple[float, float], field: Field, block: Field) -> Iterator[Stroke]:
    """Draw all that the border of a sheet holds, and the name of its format."""
    yield rectangle(_outer(field), LineStyle(GRID))
    yield from _grid(name, size, field)
    yield from _centring(size, field, block)
    yield from _trimming(size)
    yield Text(complex(size[0] - TRIMMING[0] - 2, 0.75), name, LETTER, "end")


def divisions(middle: float, count: int, low: float, high: float) -> list[float]:
    """Give the ends of the fields of a side: the frame's, and every 50 mm from the axis of symmetry.

    >>> divisions(148.5, 6, 10.0, 287.0)
    [10.0, 48.5, 98.5, 148.5, 198.5, 248.5, 287.0]
    """
    inner = [middle + LENGTH * k for k in range(1 - count // 2, count // 2)]
    return [low, *inner, high]


def _outer(field: Field) -> Field:
    return field.inset(-DEPTH)


def _grid(name: str, size: tuple[float, float], field: Field) -> Iterator[Stroke]:
    """Divide the border: letters downward, numerals to the right; A4 has them at the top and on the right only."""
    short, long = FIELDS[name]
    across, up = (long, short) if size[0] > size[1] else (short, long)
    columns = divisions(size[0] / 2, across, field.left, field.right)
    rows = divisions(size[1] / 2, up, field.bottom, field.top)[::-1]
    whole = name != "A4"
    for y in (field.top, field.bottom - DEPTH) if whole else (field.top,):
        yield from (Line(complex(x, y), complex(x, y + DEPTH), LineStyle(GRID)) for x in columns[1:-1])
        for k, (a, b) in enumerate(pairwise(columns)):
            yield _sign(complex((a + b) / 2, y + DEPTH / 2), str(k + 1))
    for x in (field.right, field.left - DEPTH) if whole else (field.right,):
        yield from (Line(complex(x, y), complex(x + DEPTH, y), LineStyle(GRID)) for y in rows[1:-1])
        for k, (a, b) in enumerate(pairwise(rows)):
            yield _sign(complex(x + DEPTH / 2, (a + b) / 2), LETTERS[k])


def _sign(centre: complex, sign: str) -> Text:
    return Text(centre - 1j * LETTER / 2, sign, LETTER, "middle")


def _centring(size: tuple[float, float], field: Field, block: Field) -> Iterator[Line]:
    """Mark the ends of both axes of symmetry; where the title block stands, to the frame only."""
    middle, outer, style = complex(*size) / 2, _outer(field), LineStyle(FRAME)
    depth = 0.0 if block.left < middle.real else CENTRING
    x, y = middle.real, middle.imag
    yield Line(complex(x, outer.top), complex(x, field.top - CENTRING), style)
    yield Line(complex(x, outer.bottom), complex(x, field.bottom + depth), style)
    yield Line(complex(outer.left, y), complex(field.left + CENTRING, y), style)
    yield Line(complex(outer.right, y), complex(field.right - CENTRING, y), style)


def _trimming(size: tuple[float, float]) -> Iterator[Fill]:
    """Fill two overlapping rectangles in each corner, for the knife."""
    wide, high = size
    for corner, way in ((0j, 1 + 1j), (wide + 0j, -1 + 1j), (complex(wide, high), -1 - 1j), (1j * high, 1 - 1j)):
        for long, short in (TRIMMING, TRIMMING[::-1]):
            across, up = way.real * long, 1j * way.imag * short
            yield Fill((corner, corner + across, corner + across + up, corner + up), INK)
