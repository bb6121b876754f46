"""The table of the usual engines on the gallery's page: as the program finds it, and as handbooks have it."""

from __future__ import annotations

import pytest

from drawings.gallery import index
from drawings.gallery import index as page
from plans.bank.engines import ENGINES
from plans.words.words import word
from tests.gallery import GALLERY

# Bosch, Automotive Handbook, free forces and moments; orders 4 and 6 of cylinders in line likewise by their stars.
ROWS = {
    "four": "| four in line | 0, 180, 180, 0 | 0 | 2: 4; 4: 4; 6: 4 | none |",
    "three": "| three in line | 0, 120, 240 | 0 | 6: 3 | 1: 1.732; 2: 1.732; 4: 1.732 |",
    "vee_two": "| V2, 90° | 0 | 45 and −45 | 1: 1 ↻; 2: 1.414; 4: 1.414; 6: 1.414 | none |",
    "vee_eight": "| V8, 90°, crossed crankshaft | 0, 90, 270, 180 | 45 and −45 | 4: 5.657 | 1: 3.162 ↻ |",
}


@pytest.mark.parametrize("key", ROWS)
def test_a_row_says_what_is_left(key: str) -> None:
    (engine,) = (one for one in ENGINES if one.key == key)
    assert page.engine_row(engine) == f"{ROWS[key]}\n"


def test_the_page_has_the_table_before_its_end() -> None:
    text = (GALLERY / index.PAGE).read_text("utf-8")
    assert text.endswith(page.engines() + index.CLOSING)


def test_every_engine_has_a_name_in_both_languages() -> None:
    for language in ("en", "ru"):
        assert len({word(language, f"engine.{one.key}") for one in ENGINES}) == len(ENGINES)
