"""Form 1 of GOST 2.104 and its extra graphs: the standard's own numbers, and which graphs are filled."""

from __future__ import annotations

import itertools

import pytest

from drawings.page.page import Page
from drawings.paper.strokes import Group, Line
from tests.drawings.pages import (
    flat,
    said,
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


def test_a_date_is_written_as_gost_writes_it_and_by_iso_as_it_is_given() -> None:
    assert "21.11.26" in said(Page("A1").title_block({"date": "2026-11-21"}, "ru"))
    assert "2026-11-21" in said(Page("A1", standard="ISO").title_block({"date": "2026-11-21"}, "en"))
