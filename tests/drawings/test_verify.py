"""The self-check of a written sheet sees what a careless draughtsman would do: each fault withholds the sheet."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from drawings.checks import verify
from drawings.lettering.lettering import lettered
from drawings.paper.strokes import Leaf, Stroke, Text
from drawings.paper.walk import texts
from drawings.pens.svg import svg
from drawings.sheets.kinematics import leaves
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from tests.drawings.held import faults_on
from tests.drawings.slips import Change, changed, rewritten
from tests.parts import first

SHAPER = Path(__file__).parents[2] / "drawings" / "gallery" / "shaper.toml"


@pytest.fixture(scope="module")
def checked() -> tuple[Study, Leaf]:
    study = Study(read_scene(SHAPER))
    return study, leaves(study)[0]


FAULTS: dict[str, Change] = {
    "the letters d and b are exchanged": lambda stroke: exchanged(stroke, "d", "b"),
    "a letter of the plan of positions is missing": rewritten("B", "E"),
}


def exchanged(stroke: Stroke, one: str, other: str) -> Stroke:
    swap = {one: other, other: one}
    if isinstance(stroke, Text) and isinstance(stroke.content, str):
        return replace(stroke, content=swap.get(stroke.content, stroke.content))
    return stroke


@pytest.mark.parametrize("fault", first(FAULTS.values(), FAULTS))
def test_a_fault_is_told(checked: tuple[Study, Leaf], fault: Change) -> None:
    study, leaf = checked
    wrong = changed(leaf, fault)
    assert wrong != leaf, "the fault must be there to be seen"
    assert faults_on(study, "kinematics", [wrong]) != []


@pytest.mark.rest
def test_a_scale_may_be_written_as_k() -> None:
    study = Study(parse_scene(SHAPER.read_text("utf-8").replace("[sheet]", '[sheet]\nnotation = "K"')))
    leaf, *others = leaves(study)
    assert "K_v = 100 mm/(m/s)" in {one.content for one in texts(leaf.groups)}
    assert faults_on(study, "kinematics", [leaf, *others]) == []
    other = changed(leaf, rewritten("K_v = 100 mm/(m/s)", "K_v = 50 mm/(m/s)"))
    assert any("scale" in one for one in faults_on(study, "kinematics", [other, *others]))


def test_a_sheet_that_cannot_be_read_is_our_failure_not_the_user_s(checked: tuple[Study, Leaf], tmp_path: Path) -> None:
    study, leaf = checked
    (tmp_path / "sheet.svg").write_bytes(svg(lettered(leaf))[:-500])
    ((told,),) = verify.wrongs([verify.written(tmp_path / "sheet.svg", leaf)], {}, study.scene.sheet)
    assert "cannot be measured" in str(told)
