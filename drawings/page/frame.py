"""What every sheet has outside its figures: paper, frame, folding marks and the control bar (рамка)."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.lettering.words import word
from drawings.paper.formats import Field
from drawings.paper.hand import Hand
from drawings.paper.strokes import Group, Line, LineStyle, Polyline, Stroke, Text

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
