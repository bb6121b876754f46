"""The scene's own sheets go before any student's: with one value of them otherwise nobody is graded."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from drawings.commands import cli
from drawings.grading.allowance import Allowances
from drawings.grading.class_list import grade_own
from drawings.grading.graded import FAIL, PASS
from drawings.grading.sheet_task import SheetTask
from drawings.redrawn.originals import Original, Originals
from tests.drawings import (
    cell_students,
    curve_students,
    students,
    test_curve_grading,
    test_grading,
    test_grading_tables,
)
from tests.gallery import GALLERY
from tests.parts import some


def one_vector() -> tuple[Any, bytes]:
    own = students.task("slider-crank")
    return own, test_grading.made(own, next(row for row in test_grading.MISTAKES if row["scene"] == "slider-crank"))


def one_cell() -> tuple[Any, bytes]:
    own = cell_students.table_task("shaper")
    row = next(row for row in test_grading_tables.MISTAKES if row["scene"] == "shaper" and row["says"])
    return own, cell_students.made(own, row)


def one_ordinate() -> tuple[Any, bytes]:
    own = curve_students.curve_task("slider-crank")
    row = next(row for row in test_curve_grading.MISTAKES if row["scene"] == "slider-crank")
    return own, curve_students.made(own, row)


def graded(own: Any) -> str:
    task = SheetTask(*(getattr(own, name, ()) for name in ("plans", "figures", "tables")))
    return grade_own(own.originals, task, Allowances()).outcome


@pytest.mark.parametrize("broken", some([one_vector, one_cell, one_ordinate], 3))
def test_a_sheet_of_ours_with_one_value_otherwise_is_not_right(
    broken: Callable[[], tuple[Any, bytes]], monkeypatch: pytest.MonkeyPatch
) -> None:
    own, source = broken()
    assert graded(own) == PASS
    monkeypatch.setattr(own.originals, "drawn", lambda _: source)
    assert graded(own) == FAIL


@pytest.mark.rest
def test_nobody_is_graded_by_a_sheet_of_ours_that_is_wrong(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    drawn, (_, source) = Originals.drawn, one_vector()

    def broken(own: Originals, sheet: Original) -> bytes:
        return source if sheet.kind == "kinematics" else drawn(own, sheet)

    monkeypatch.setattr(Originals, "drawn", broken)
    assert cli.main(["grade", str(GALLERY / "slider-crank.toml"), "any.svg"]) == 1
    assert capsys.readouterr().out == ""
