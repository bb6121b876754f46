"""Form 1 of GOST 2.104 and its extra graphs: the standard's own numbers, and which graphs are filled."""

from __future__ import annotations

import itertools

import pytest

from drawings.lettering.words import word
from drawings.page.page import Page
from drawings.paper.strokes import Group, Line
from tests.drawings.pages import (
    every_page,
    flat,
    inked,
    inside,
    place_of,
    said,
    texts,
)


def crossings(block: Group, page: Page, at: float, upright: bool) -> list[tuple[float, float]]:
    """Where lines of the block cross a level (or an upright) through it, from its left (or its foot); their widths."""
    found = set()
    for one in flat(block):
        if isinstance(one, Line):
            start, end = (p - complex(page.block.left, page.block.bottom) for p in (one.start, one.end))
            if not upright:
                start, end = (complex(p.imag, p.real) for p in (start, end))
            if start.real == end.real and min(start.imag, end.imag) < at < max(start.imag, end.imag):
                found.add((start.real, one.style.width))
    return sorted(found)


def steps(places: list[tuple[float, float]], end: float) -> list[float]:
    ends = [*(place for place, _ in places), end]
    return [b - a for a, b in itertools.pairwise(ends)]


@pytest.mark.parametrize(
    ("level", "widths"),
    [  # from the foot of the block: the widths of its graphs from the left, GOST 2.104 form 1
        (52, [7, 10, 23, 15, 10, 120]),
        (38, [7, 10, 23, 15, 10, 70, 15, 17, 18]),
        (32, [7, 10, 23, 15, 10, 70, 5, 5, 5, 17, 18]),
        (22, [17, 23, 15, 10, 70, 5, 5, 5, 17, 18]),
        (17, [17, 23, 15, 10, 70, 20, 30]),
        (7, [17, 23, 15, 10, 70, 50]),
    ],
)
def test_the_graphs_of_form_1_are_as_wide_as_the_standard_has_them(level: float, widths: list[float]) -> None:
    page = Page("A3")
    block = page.title_block({}, "ru")
    assert steps(crossings(block, page, level, True), 185) == widths
    assert sum(widths) == 185


@pytest.mark.parametrize(
    ("across", "heights"),
    [(30, [5] * 11), (100, [15, 25, 15]), (137, [15, 5, 15, 5, 15]), (160, [15, 5, 15, 5, 15])],
)
def test_the_graphs_of_form_1_are_as_high_as_the_standard_has_them(across: float, heights: list[float]) -> None:
    page = Page("A3")
    places = crossings(page.title_block({}, "ru"), page, across, False)
    assert steps([(0.0, 0.5), *places], 55.0)[: len(heights)] == heights  # the foot is the frame's own line
    assert sum(heights) == 55


def test_thin_in_form_1_are_the_rows_and_the_cells_of_the_letter() -> None:
    page = Page("A3")
    block = page.title_block({}, "ru")
    main_line = page.hand.main
    rows = {place for place, width in crossings(block, page, 30, False) if width == main_line}
    assert rows == {30, 35, 55}
    letter = {place for place, width in crossings(block, page, 32, True) if width != main_line}
    assert letter == {140, 145}


def test_graph_7_is_empty_on_a_single_sheet_and_graph_8_on_the_following_ones() -> None:
    page = Page("A1")

    def numbers(sheet: str, sheets: str) -> list[str]:
        block = page.title_block({"sheet": sheet, "sheets": sheets}, "ru")
        return [plain for plain in said(block) if plain.isdigit()]

    assert numbers("1", "1") == ["1"]
    assert numbers("1", "4") == ["1", "4"]
    assert numbers("3", "4") == ["3"]


def test_names_stand_in_graph_11_beside_their_roles_in_graph_10() -> None:
    page = Page("A1", language="ru")
    block = page.title_block({"drawn": "Иванов", "checked": "Петров", "approved": "Сидоров", "date": "1.12"}, "ru")
    for role, name, row in (("Разраб.", "Иванов", 25), ("Пров.", "Петров", 20), ("Утв.", "Сидоров", 0)):
        assert 0 < place_of(block, page, role).real < 17 and 17 < place_of(block, page, name).real < 40
        assert all(row < place_of(block, page, plain).imag < row + 5 for plain in (role, name))
    assert {"Т.контр.", "Н.контр."} <= set(said(block))
    date = place_of(block, page, "1.12")
    assert 55 < date.real < 65 and 25 < date.imag < 30


def test_a_date_is_written_as_gost_writes_it_and_by_iso_as_it_is_given() -> None:
    assert "21.11.26" in said(Page("A1").title_block({"date": "2026-11-21"}, "ru"))
    assert "2026-11-21" in said(Page("A1", standard="ISO").title_block({"date": "2026-11-21"}, "en"))


@pytest.mark.parametrize(
    ("page", "left", "top", "turn"),
    [
        (Page("A1", designation="X.1"), 20, 589, 180), (Page("A4", designation="X.1"), 20, 292, 180),
        (Page("A3", "portrait", designation="X.1"), 297 - 5 - 14, 415, -90),
    ],
)  # fmt: skip
def test_graph_26_repeats_the_designation_in_the_upper_corner_turned(
    page: Page, left: float, top: float, turn: float
) -> None:
    place = page.taken[1]
    assert {place.width, place.height} == {70, 14} and (place.left, place.top) == (left, top)
    again = next(text for text in texts(page.frame()) if text.plain == "X.1")
    assert again.rotation == turn and inside(inked(again), place)


@every_page
def test_the_extra_graphs_are_gost_s_and_say_format_and_copied(page: Page) -> None:
    plain = set(said(page.frame()))
    mine = {word(page.language, "copied"), word(page.language, "format", format=page.name)}
    strip = {word(page.language, key) for key in ("original", "signed", "replaces", "duplicate")}
    assert (mine | strip <= plain) if page.standard == "GOST" else not ((mine | strip) & plain)
    if page.standard == "GOST":
        words_of_strip = [text for text in texts(page.frame()) if text.plain in strip]
        assert len(words_of_strip) == 5 and {text.rotation for text in words_of_strip} == {90}
        assert all(inked(text)[0] > 8 and inked(text)[2] < 13 for text in words_of_strip)
        assert all(inked(text)[3] < 5 + 145 for text in words_of_strip)
