"""Sheets as they are handed in: ours graded by nobody's mistake, pages in the units of their programs."""

from __future__ import annotations

import base64
import re
from pathlib import Path
from typing import Any

import pytest

from drawings.commands import cli
from drawings.grading.allowance import Allowances
from drawings.grading.feedback import feedback
from drawings.grading.graded import PASS, grade
from drawings.grading.sheet_task import SheetTask
from drawings.grading.units import stated
from drawings.reading.transform import PIXEL, viewport
from drawings.redrawn import Original, Originals
from tests import parts
from tests.drawings import (
    students,
    test_grading,
)
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
    assert (graded.outcome, graded.paper) == (PASS, (841.0, 594.0))


@pytest.mark.parametrize(
    ("root", "unit", "paper"),
    [
        ({"width": "210mm", "height": "297mm"}, PIXEL, (210.0, 297.0)),
        ({"width": "744.09448", "height": "1052.3622"}, 25.4 / 90, (210.0, 297.0)),
        ({"width": "794", "height": "1123", "viewBox": "0 0 794 1123"}, PIXEL, (210.0, 297.0)),
        ({"width": "595px", "height": "842px", "viewBox": "0 0 595 842"}, 25.4 / 72, (210.0, 297.0)),
        ({"width": "1200", "height": "900"}, PIXEL, (317.5, 238.1)),
        ({"width": "100%", "viewBox": "0 0 420 297"}, 1.0, (420.0, 297.0)),
        ({"width": "210mm", "height": "297mm", "viewBox": "0 0 2100 2970"}, 0.1, (210.0, 297.0)),
    ],
)
def test_a_page_of_a_standard_tells_of_its_units(root: dict[str, str], unit: float, paper: tuple[float, float]) -> None:
    read = viewport(stated(root))
    assert (read.width, read.height) == pytest.approx(paper, abs=0.2)
    assert abs(read.placing(1 + 0j) - read.placing(0j)) == pytest.approx(unit, rel=1e-3)


def test_an_old_inkscape_draws_ninety_units_to_the_inch() -> None:
    root = {"width": "210mm", "height": "297mm", "http://www.inkscape.org/namespaces/inkscape version": "0.48.4 r9939"}
    read = viewport(stated(root))
    assert abs(read.placing(90 + 0j) - read.placing(0j)) == pytest.approx(25.4)


def test_the_feedback_sheet_shows_it_as_it_was_read() -> None:
    own, source = own_sheet()
    source = WAYS["in mm without a viewBox"](source)
    text = feedback(Path("ann.svg"), source, grade(source, SheetTask(own.plans), Allowances()), {}, "en").decode()
    shown = base64.b64decode(re.findall(r"base64,([^\"]*)", text)[0])
    assert b'viewBox="0 0 841 594"' in shown
