"""Sheets as they are handed in: ours graded by nobody's mistake, pages in the units of their programs."""

from __future__ import annotations

import re
from typing import Any

import pytest

from drawings.commands import cli
from drawings.grading.allowance import Allowances
from drawings.grading.graded import PASS, SheetTask, grade
from drawings.redrawn import Original, Originals
from tests import parts
from tests.drawings import students, test_grading
from tests.drawings.students import Task, task
from tests.gallery import GALLERY


def one_vector() -> tuple[Any, bytes]:
    own = students.task("slider-crank")
    return own, test_grading.made(own, next(row for row in test_grading.MISTAKES if row["scene"] == "slider-crank"))


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


BOX = re.compile(rb' viewBox="[^"]*"')
MM = re.compile(rb'(width|height)="([\d.]+)mm"')
WAYS = {
    "in mm without a viewBox": lambda source: BOX.sub(b"", source, 1),
    "in px of as many mm": lambda source: MM.sub(rb'\1="\2px"', source, 2),
    "in px without a viewBox": lambda source: BOX.sub(b"", MM.sub(rb'\1="\2"', source, 2), 1),
    "with a viewBox alone": lambda source: MM.sub(rb'\1="100%"', source, 2),
}


def own_sheet() -> tuple[Task, bytes]:
    own = task("slider-crank")
    return own, own.originals.drawn(own.originals.sheets[0])


@pytest.mark.parametrize("how", parts.first(WAYS, WAYS))
def test_a_sheet_of_ours_is_right_however_its_root_is_written(how: str) -> None:
    own, source = own_sheet()
    graded = grade(WAYS[how](source), SheetTask(own.plans), Allowances())
    assert graded.outcome == PASS
