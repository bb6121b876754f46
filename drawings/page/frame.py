"""The frame of a sheet and its reference zones (рамка, зоны)."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from drawings.lettering.words import word
from drawings.paper.formats import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import INK, Fill, Group, Line, LineStyle, Polyline, Stroke, Text

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
    for corner, way in (
        (0j, 1 + 1j),
        (complex(size[0], 0), -1 + 1j),
        (complex(*size), -1 - 1j),
        (1j * size[1], 1 - 1j),
    ):
        for wide, high in (TRIMMING, TRIMMING[::-1]):
            across, up = way.real * wide, 1j * way.imag * high
            yield Fill((corner, corner + across, corner + across + up, corner + up), INK)
