"""What a sheet itself covers, or has off the paper, is told as what cannot be read."""

from __future__ import annotations

import pytest

from drawings.checks.verify import obscured
from drawings.lettering.lettering import lettered
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Circle, Fill, Group, Leaf, Line, LineStyle, Stroke, Text
from drawings.pens.svg import svg
from drawings.reading.sheet import see
from drawings.symbols.symbols import block

WHITE = LineStyle(0.25, fill="#ffffff")
NUMBER = Text(20 + 20j, "12.5")
TURNED = block(10 + 10j, (0.6 + 0.8j), hand_of("A1"))  # its box reaches further than it does itself
WIDER = Fill(tuple(2 * corner - 10 - 10j for corner in TURNED.points), WHITE)


def told(*strokes: Stroke) -> str:
    leaf = lettered(Leaf(100.0, 50.0, (Group(strokes, "figure"),)))
    return "; ".join(one.worded("en") for one in obscured(see(svg(leaf))))


@pytest.mark.parametrize(
    ("strokes", "says"),
    [
        ((NUMBER, Fill((15 + 15j, 40 + 15j, 40 + 30j, 15 + 30j), WHITE)), "not seen (covered)"),
        ((NUMBER, Circle(27 + 21j, 3, WHITE)), "12.5"),
        ((Text(97 + 20j, "12.5"),), "not seen (off the paper)"),
        ((Line(10 + 10j, 10 + 99j),), "not seen (off the paper)"),
        ((Circle(27 + 21j, 3, WHITE), NUMBER), ""),
        ((Line(10 + 10j, 12 + 10j), Circle(10 + 10j, 3, WHITE)), ""),
        ((Line(10 + 10j, 12 + 10j), TURNED), ""),
        ((Line(10 + 10j, 12 + 10j), WIDER), "not seen (covered)"),
        ((Line(10 + 10j, 40 + 10j), Fill((8 + 8j, 42 + 8j, 42 + 12j, 8 + 12j), WHITE)), "not seen (covered)"),
    ],
)
def test_lettering_under_an_area_and_lines_off_the_paper_are_told(strokes: tuple[Stroke, ...], says: str) -> None:
    assert says in told(*strokes)
    assert bool(told(*strokes)) is bool(says)
