"""Grading over all techniques: a scene's own sheets are right, each mistake of the tables is named and costs once."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import pytest

from drawings.grading.allowance import EXACT, Allowance, Allowances
from drawings.grading.graded import PASS, SheetTask, grade, sheet_task
from drawings.reading.alphabet import folded
from drawings.redrawn import Original, Originals
from tests import parts
from tests.drawings import cell_students, curve_students
from tests.drawings import test_curve_grading as curves
from tests.drawings import test_grading as plans
from tests.drawings import test_grading_tables as tables
from tests.drawings import test_grading_vectors as polygons
from tests.drawings.students import task
from tests.gallery import GALLERY, SCENES
from tests.parts import first
from tests.rows import over

WAYS = (Allowances(), Allowances(EXACT), Allowances(Allowance(share=0.02)))


class Table(NamedTuple):
    """A table of mistakes: how one is made and told; the scene and share of every day."""

    rows: list[dict[str, Any]]
    made: Callable[..., bytes]
    said: Callable[..., list[str]]
    scene: str
    every: int

    @property
    def daily(self) -> list[dict[str, Any]]:
        """The rows of every day, or with --whole all."""
        return self.rows if parts.whole else [row for row in self.rows if row["scene"] == self.scene][:: self.every]


TABLES = {
    "plans": Table(plans.MISTAKES, plans.made, plans.said, "shaper", 12),
    "polygons": Table(polygons.MISTAKES, polygons.made, polygons.said, "fan", 1),
    "tables": Table(tables.MISTAKES, cell_students.made, tables.said, "shaper", 3),
    "curves": Table(curves.MISTAKES, curve_students.made, curves.said, "slider-crank", 9),
}


@pytest.mark.part
@pytest.mark.parametrize("name", TABLES)
def test_a_mistake_is_named_and_costs_once(name: str) -> None:
    own = TABLES[name]

    @over("row", own.daily)
    def named(row: dict[str, Any]) -> None:
        given = task(row["scene"])
        assert own.said(given, own.made(given, row)) == sorted(row["says"])

    named()


ANALYSIS = (folded("by analysis"), folded("аналитически"))  # which is one column with the plan among the values


def due(task: SheetTask, sheet: Original) -> int:
    """Count what a sheet is asked for."""
    drawn = [plan for plan in task.plans if plan.sheet == sheet.name]
    cells = [
        key for table in task.tables for key, cell in table.cells.items()
        if cell.sheet == sheet.name and not (table.sought[1] == "values" and key[2] in ANALYSIS)
    ]  # fmt: skip
    shown = sum(len(plan.vectors) + len(plan.ways) for plan in drawn)
    return shown + len(cells) + sum(len(one.items) for one in task.curves if one.sheet == sheet.name)


@pytest.mark.parametrize("scenes", first([["slider-crank"], [path.stem for path in SCENES]], ["one", "all"]))
def test_our_own_sheets_are_right(scenes: list[str]) -> None:
    for scene in scenes:
        originals = Originals(GALLERY / f"{scene}.toml")
        task = sheet_task(originals)
        for sheet in (one for one in originals.sheets if one.name in task.sheets):
            for by in WAYS:
                graded = grade(originals.drawn(sheet), task, by)
                assert (graded.outcome, graded.wrong) == (PASS, ()), sheet.name
                assert len(graded.verdicts) == due(task, sheet) > 0, sheet.name
