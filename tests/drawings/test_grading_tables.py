"""Grading of tables: a scene's own are right, what a student writes in a cell is read, a mistake is named."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from drawings.grading.allowance import EXACT, Allowances
from drawings.grading.graded import PASS, grade
from drawings.pens.svg import svg
from tests.drawings.cell_students import TableTask, made, table_task, tables_of
from tests.rows import over

HAND = Allowances()
CASES = Path(__file__).parents[1] / "cases"
MISTAKES = tomllib.loads((CASES / "table_mistakes.toml").read_text("utf-8"))["mistake"]


def said(own: TableTask, source: bytes) -> list[str]:
    wrong = grade(source, (), HAND, (), own.tables).wrong
    return sorted(" ".join(filter(None, (one.name, one.kind, one.of))) for one in wrong)


@pytest.mark.parametrize("by", [HAND, Allowances(EXACT)])
def test_our_own_tables_are_right(by: Allowances) -> None:
    own = table_task("shaper")
    graded = grade(svg(tables_of(own.originals.sheets[0])), (), by, (), own.tables)
    assert (graded.outcome, graded.wrong) == (PASS, ())
    assert len(graded.verdicts) == 2 * 2 * 22 + 12 * 4


@over("row", MISTAKES)
def test_a_mistake_in_a_table_is_named(row: dict[str, Any]) -> None:
    own = table_task(row["scene"])
    assert said(own, made(own, row)) == sorted(row["says"]), row["name"]
