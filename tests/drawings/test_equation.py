"""Equations in lettering: bars, lines under terms, breaking at a width; and the words and letters of a force sheet."""

import pytest

from drawings.layout.equation import DIRECTION, Passage, Term, forces, moments
from drawings.lettering.extent import bounds
from drawings.lettering.words import letter
from drawings.page.page import Field
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Line, Text

HAND = hand_of("A1")
LEANS = 1.5  # mm: slanted letters lean past the end of their line, and their tails before its start
GROUP = forces([
    Term("R^n_{34}", DIRECTION), Term("R^t_{34}"), Term("Φ_4"), Term("G_4"), Term("F_{us}"), Term("Φ_5"), Term("G_5"),
    Term("R_{05}", DIRECTION),
])  # fmt: skip
ABOUT_D = moments("D", [("+", "R^t_{34}·BD"), ("+", "G_4·h_1"), ("−", "Φ_4·h_2"), ("+", "M^Φ_4")])
PASSAGE = Passage("equations", (GROUP, ABOUT_D), 5.0)


def drawn(width: float, passage: Passage = PASSAGE) -> list[Text | Line]:
    strokes = passage.write(Field(0.0, 0.0, width, 200.0), HAND).strokes
    return [stroke for stroke in strokes if isinstance(stroke, Text | Line)]


def test_two_lines_under_a_term_stay_apart_by_the_least_that_the_standard_allows() -> None:
    for size in (2.5, 3.5, 5.0):
        lines = [
            stroke
            for stroke in drawn(100.0, Passage("one", (forces([Term("G_4")]),), size))
            if isinstance(stroke, Line)
        ]
        assert abs(lines[0].start.imag - lines[1].start.imag) >= 0.8 - 1e-9


@pytest.mark.parametrize("width", [60.0, 80.0, 100.0, 150.0, 300.0])
def test_no_line_is_wider_than_its_column(width: float) -> None:
    for stroke in drawn(width):
        assert bounds(stroke)[0] >= -LEANS and bounds(stroke)[2] <= width + LEANS


def test_lines_of_letters_keep_clear_of_the_lines_under_terms() -> None:
    strokes = drawn(60.0)
    lines = [stroke for stroke in strokes if isinstance(stroke, Line)]
    for text in (stroke for stroke in strokes if isinstance(stroke, Text)):
        left, bottom, right, top = bounds(text)
        for line in lines:
            over = line.start.real < right and line.end.real > left
            assert not (over and bottom - 0.3 < line.start.imag < top + 0.3), (text.plain, line)


@pytest.mark.parametrize(
    ("ours", "theirs"),
    [("R^t_{34}", "R^τ_{34}"), ("R^n_{34}", "R^n_{34}"), ("F_{bal}", "F_{ур}"), ("F_{us}", "F_{п.с}"), ("Φ_4", "Φ_4")],
)
def test_letters_of_russian_sheets_are_those_of_russian_courses(ours: str, theirs: str) -> None:
    assert letter("ru", ours) == theirs and letter("en", ours) == ours
