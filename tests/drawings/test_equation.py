"""Equations in lettering: bars, lines under terms, breaking at a width; and the words and letters of a force sheet."""

import pytest

from drawings.layout.equation import BAR, DIRECTION, FULL, UNKNOWN, Passage, Term, forces, moments, plain
from drawings.lettering.extent import bounds
from drawings.lettering.lettering import lacking
from drawings.lettering.words import letter, word
from drawings.page.page import Field
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Group, Line, Text

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


def test_vectors_bear_bars_and_moments_none() -> None:
    said = " ".join(stroke.plain for stroke in drawn(300.0) if isinstance(stroke, Text))
    assert said == (
        f"R{BAR}n34 + R{BAR}t34 + Φ{BAR}4 + G{BAR}4 + F{BAR}us + Φ{BAR}5 + G{BAR}5 + R{BAR}05 = 0 "
        "ΣMD: Rt34·BD + G4·h1 − Φ4·h2 + MΦ4 = 0"
    )


@pytest.mark.parametrize(("known", "count"), [(UNKNOWN, 0), (DIRECTION, 1), (FULL, 2)])
def test_one_line_under_a_direction_and_two_under_a_whole_force(known: int, count: int) -> None:
    strokes = drawn(100.0, Passage("one", (forces([Term("R_{34}", known)]),), 5.0))
    term = next(stroke for stroke in strokes if isinstance(stroke, Text))
    lines = [stroke for stroke in strokes if isinstance(stroke, Line)]
    assert len(lines) == count
    for line in lines:
        assert line.start.real == term.at.real and line.end.real <= bounds(term)[2]
        assert line.start.imag < bounds(term)[1]  # under the tail of the index


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


@pytest.mark.parametrize("size", [0, 1, -1])
def test_a_passage_drawn_in_its_block_stays_in_it(size: int) -> None:
    wide, high = PASSAGE.block().sizes[size]
    box = Field(20.0, 30.0, 20.0 + wide, 30.0 + high)
    left, bottom, _, top = bounds(PASSAGE.write(box, HAND))
    assert left >= 20.0 - LEANS and bottom >= 30.0 and top <= box.top


def test_narrower_blocks_are_higher() -> None:
    sizes = PASSAGE.block().sizes
    assert len(sizes) > 1
    assert sizes == tuple(sorted(sizes)) and [high for _, high in sizes] == sorted(
        (high for _, high in sizes), reverse=True
    )


def test_a_broken_line_begins_with_its_sign() -> None:
    rows = Passage("equations", (GROUP,), 5.0).rows(60.0)
    assert len(rows) > 1 and all(row[0].sign in "+−=" and row[0].sign for row in rows[1:])


def test_lines_of_letters_keep_clear_of_the_lines_under_terms() -> None:
    strokes = drawn(60.0)
    lines = [stroke for stroke in strokes if isinstance(stroke, Line)]
    for text in (stroke for stroke in strokes if isinstance(stroke, Text)):
        left, bottom, right, top = bounds(text)
        for line in lines:
            over = line.start.real < right and line.end.real > left
            assert not (over and bottom - 0.3 < line.start.imag < top + 0.3), (text.plain, line)


def test_a_minus_before_the_first_term_is_written() -> None:
    said = [piece.sign for piece in forces([Term("G_4", sign="−"), Term("R_{05}", sign="−")]).pieces]
    assert said == ["−", "−", "="]


def test_a_solution_is_written_as_it_is() -> None:
    (row,) = Passage("x", (plain("R^t_{34} =", "12.3 N"),), 5.0).rows(200.0)
    assert [piece.text for piece in row] == ["R^t_{34} =", "12.3 N"]


def test_every_letter_of_an_equation_can_be_written() -> None:
    assert lacking(f"R{BAR}Φ{BAR}G{BAR}F{BAR}ΣτμM·−+=⊥∥°:0") == ()


def test_the_words_are_those_of_the_courses() -> None:
    assert word("ru", "force plan", group="4-5") == "План сил группы 4-5"
    assert word("en", "loading scheme", group="2-3") == "Loading scheme of group 2-3"
    assert (word("ru", "N"), word("ru", "N*m"), word("ru", "lever")) == ("Н", "Н·м", "Рычаг Жуковского")


@pytest.mark.parametrize(
    ("ours", "theirs"),
    [("R^t_{34}", "R^τ_{34}"), ("R^n_{34}", "R^n_{34}"), ("F_{bal}", "F_{ур}"), ("F_{us}", "F_{п.с}"), ("Φ_4", "Φ_4")],
)
def test_letters_of_russian_sheets_are_those_of_russian_courses(ours: str, theirs: str) -> None:
    assert letter("ru", ours) == theirs and letter("en", ours) == ours


def test_drawing_is_one_named_group() -> None:
    assert isinstance(PASSAGE.write(Field(0, 0, 100, 100), HAND), Group)


def test_the_right_side_is_never_a_line_of_its_own() -> None:
    for width, _ in PASSAGE.block().sizes:
        assert ["="] not in [[piece.sign for piece in row] for row in PASSAGE.rows(width)]
