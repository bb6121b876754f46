"""Tables of values and equations on a sheet: decimals, widths, lines under terms."""

from __future__ import annotations

import numpy as np
import pytest

from drawings.balance.costs import change
from drawings.layout import value_table
from drawings.layout.equation import DIRECTION, EquationBlock, Term, forces, moments
from drawings.layout.table import Later, table
from drawings.layout.value_table import by_hand, value_row
from drawings.lettering.lettering import bounds, text_width
from drawings.lettering.words import letter
from drawings.page.page import Drafting, Field
from drawings.paper.hand import hand_of
from drawings.paper.strokes import Line, Text
from plans.linkage.parts import alike
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene, read_scene
from tests.catalogue.scenes import TEXTS
from tests.gallery import GALLERY

DEAD_CENTRE = TEXTS["f04_zero_vector"]


def test_a_zero_vector_is_written_with_the_decimals_of_its_row() -> None:
    """At its dead centre the slider stands: v_B is 0 there by both roads, to the last decimal."""
    comparison = compare(LinkageStudy(parse_scene(DEAD_CENTRE)))
    found = {finding.name: finding for finding in comparison.of("velocities")}
    assert value_row(found["v_B"], "v", (0,), "en").cells[:2] == ("0.00000", "0.00000")
    assert value_row(found["v_B"], "v", (1,), "en").cells[:2] == ("0.60000", "0.60000")


def test_what_a_hand_may_be_out_is_told_to_two_digits_and_in_the_decimals_of_its_row() -> None:
    errors = {("v_B", k): error for k, error in enumerate((0.012345, 123.4, 0.00123, 7.0, np.nan, 0.0998))}
    write = by_hand(errors, "ru")
    assert [write(Later("v_B", k, "", 3, most)) for k, most in enumerate((9.0, 999.0, 9.0, 6.9, 9.0, 9.0, 9.0))] == [
        "±0,012", "±120", "±0,001", "—", "—", "±0,10", "—",
    ]  # fmt: skip


def test_a_cell_that_is_written_later_keeps_the_width_that_was_measured() -> None:
    comparison = compare(LinkageStudy(parse_scene(DEAD_CENTRE)))
    finding = next(one for one in comparison.of("velocities") if one.name == "v_B")
    measured = table([value_row(finding, "v", (0, 1), "en")], "quantity", ("a", "b", "c"), 2.5, (0, 1))
    for text in ("±0.00001", "±0.088", f"±{finding.largest:.5f}"):
        filled = measured.filled(lambda _, text=text: text)  # type: ignore[misc]
        assert filled.cell == measured.cell
        assert text_width(Text(0j, text, 2.5)) <= measured.cell
        assert [cell for cell in filled.lines[0].cells if cell == text] == [text, text]


def test_what_is_one_by_its_cause_has_one_row() -> None:
    """The shaper's stone turns with its slotted link; its ram never turns."""
    shaper = LinkageStudy(read_scene(GALLERY / "shaper.toml"))
    assert shaper.mechanism.turning_with == {0: 0, 1: 1, 2: 2, 3: 2, 4: 4, 5: 0}
    told = value_table.listed(compare(shaper), given=("ω_1", "ε_1"))
    names = [tuple(one.name for one in same) for same in alike(told, shaper.mechanism)]
    speeds = [("v_A",), ("v_B",), ("v_D",), ("ω_2", "ω_3"), ("ω_4",)]
    assert names == [*speeds, ("a_A",), ("a_B",), ("a_D",), ("ε_2", "ε_3"), ("ε_4",)]


@pytest.mark.parametrize(
    ("before", "after", "told"), [(50.0, 75.0, "+50"), (50.0, 0.0, "−100"), (0.0, 1.0, "—"), (1.0, 1.0, "0")]
)
def test_a_change_is_told_in_per_cent(before: float, after: float, told: str) -> None:
    assert change(before, after, Drafting(hand_of("A1"))) == told


HAND = hand_of("A1")
GROUP = forces([
    Term("R^n_{34}", DIRECTION), Term("R^t_{34}"), Term("Φ_4"), Term("G_4"), Term("F_{us}"), Term("Φ_5"), Term("G_5"),
    Term("R_{05}", DIRECTION),
])  # fmt: skip
ABOUT_D = moments("D", [("+", "R^t_{34}·BD"), ("+", "G_4·h_1"), ("−", "Φ_4·h_2"), ("+", "M^Φ_4")])
PASSAGE = EquationBlock("equations", (GROUP, ABOUT_D), 5.0)


def drawn(width: float, passage: EquationBlock = PASSAGE) -> list[Text | Line]:
    strokes = passage.write(Field(0.0, 0.0, width, 200.0), HAND).strokes
    return [stroke for stroke in strokes if isinstance(stroke, Text | Line)]


def test_two_lines_under_a_term_stay_apart_by_the_least_that_the_standard_allows() -> None:
    for size in (2.5, 3.5, 5.0):
        lines = [
            stroke
            for stroke in drawn(100.0, EquationBlock("one", (forces([Term("G_4")]),), size))
            if isinstance(stroke, Line)
        ]
        assert abs(lines[0].start.imag - lines[1].start.imag) >= 0.8 - 1e-9


@pytest.mark.parametrize(
    ("ours", "theirs"),
    [("R^t_{34}", "R^τ_{34}"), ("R^n_{34}", "R^n_{34}"), ("F_{bal}", "F_{ур}"), ("F_{us}", "F_{п.с}"), ("Φ_4", "Φ_4")],
)
def test_letters_of_russian_sheets_are_those_of_russian_courses(ours: str, theirs: str) -> None:
    assert letter("ru", ours) == theirs and letter("en", ours) == ours


def test_lines_of_letters_keep_clear_of_the_lines_under_terms() -> None:
    strokes = drawn(60.0)
    lines = [stroke for stroke in strokes if isinstance(stroke, Line)]
    for text in (stroke for stroke in strokes if isinstance(stroke, Text)):
        left, bottom, right, top = bounds(text)
        for line in lines:
            over = line.start.real < right and line.end.real > left
            assert not (over and bottom - 0.3 < line.start.imag < top + 0.3), (text.plain, line)
