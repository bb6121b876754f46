"""Title block and borders of ISO 7200 and ISO 5457: fields, grid, centring and trimming marks."""

from __future__ import annotations

import itertools

import pytest

from drawings.lettering.words import word
from drawings.page.blocks.iso7200 import CELLS, MANDATORY
from drawings.page.page import Page
from drawings.paper.strokes import Line
from tests.drawings.pages import (
    ENTRIES,
    apart,
    flat,
    inked,
    inside,
    named,
    place_of,
    said,
    texts,
)


@pytest.mark.parametrize("language", ["en", "ru"])
def test_the_fields_of_iso_7200_fill_the_block_and_have_their_captions(language: str) -> None:
    assert sum(cell.width * cell.height for cell in CELLS.values()) == 180 * 48
    fields = [(c.left, c.bottom, c.left + c.width, c.bottom + c.height) for c in CELLS.values()]
    assert all(apart(a, b) for a, b in itertools.combinations(fields, 2))
    assert all(inside(field, (0, 0, 180, 48)) for field in fields)
    page = Page("A3", standard="ISO", language=language)
    block = page.title_block(ENTRIES[language], language)
    corner = complex(page.block.left, page.block.bottom)
    for key, (left, bottom, right, top) in zip(CELLS, fields, strict=True):
        caption = word(language, f"{key} field")
        assert caption != f"{key} field"
        box = inked(next(text for text in texts(block) if text.plain == caption))
        own = (left + corner.real, bottom + corner.imag, right + corner.real, top + corner.imag)
        assert inside(box, own), caption


def test_every_mandatory_field_of_iso_7200_is_filled() -> None:
    page = Page("A3", standard="ISO")
    given = {
        "organisation": "Owner", "designation": "ID-7", "date": "2026-11-21", "sheet": "2", "sheets": "4",
        "title": "Name", "approved": "Boss", "drawn": "Maker", "type": "Diagram",
    }  # fmt: skip
    block = page.title_block(given, "en")
    shown = {
        "owner": "Owner", "number": "ID-7", "issued": "2026-11-21", "sheet": "2/4", "title": "Name",
        "approval": "Boss", "creator": "Maker", "type": "Diagram",
    }  # fmt: skip
    assert set(shown) == set(MANDATORY)
    for key, plain in shown.items():
        cell, at = CELLS[key], place_of(block, page, plain)
        assert cell.left < at.real < cell.left + cell.width and cell.bottom < at.imag < cell.bottom + cell.height


@pytest.mark.parametrize(("name", "long", "short"), [("A1", 16, 12), ("A2", 12, 8), ("A3", 8, 6), ("A4", 6, 4)])
def test_the_grid_of_iso_5457_has_the_standard_s_number_of_fields_of_50_mm(name: str, long: int, short: int) -> None:
    page = Page(name, standard="ISO")
    columns, rows = (short, long) if name == "A4" else (long, short)
    plain = said(named(page.frame(), "borders"))
    sides = 1 if name == "A4" else 2  # A4 has letters on the right and numerals at the top only
    numerals, letters = [p for p in plain if p.isdigit()], [p for p in plain if len(p) == 1 and p.isalpha()]
    assert sorted(map(int, numerals)) == sorted(sides * list(range(1, columns + 1)))
    assert sorted(letters) == sorted(sides * "ABCDEFGHJKLM"[:rows])
    ticks = sorted(
        {one.start.real for one in flat(named(page.frame(), "borders")) if isinstance(one, Line) and _top(one, page)}
    )
    assert len(ticks) == columns - 1
    assert {b - a for a, b in itertools.pairwise(ticks)} == {50} and ticks[columns // 2 - 1] == page.size[0] / 2


def _top(line: Line, page: Page) -> bool:
    return line.style.width == 0.35 and line.start.real == line.end.real and line.start.imag == page.field.top
