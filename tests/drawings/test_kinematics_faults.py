"""The kinematics sheet is held to the analysis: what is drawn passes, faults planted into the drawing withhold it.

The tables are tests/cases/kinematics_faults.toml and kinematics_strokes_faults.toml.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache, partial
from pathlib import Path

import pytest

from drawings.checks.verify import SelfCheckFailed, verify, verify_set
from drawings.checks.verify_kinematics import faults, set_faults
from drawings.eye.sheet import SeenSheet
from drawings.lettering.lettering import lettered
from drawings.measure.measure import measure
from drawings.paper.strokes import Leaf
from drawings.pens.svg import svg
from drawings.sheets.kinematics import leaves
from plans.checks.compare import compare
from plans.checks.parts import spans
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from plans.words.words import said
from tests.drawings.collisions import collisions
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.parts import first

CASES = ROOT / "tests" / "cases"
FAULTS = drawing_faults(CASES / "kinematics_faults.toml")
STROKES = drawing_faults(CASES / "kinematics_strokes_faults.toml")
PLANS = ("positions", "velocities", "accelerations", "extremes", "diagrams")
SCENES = sorted(path.stem for path in (CASES / "kinematics").glob("*.toml"))


@cache
def study_of(name: str) -> Study:
    own = CASES / "kinematics" / f"{name}.toml"
    return Study(read_scene(own if own.exists() else ROOT / "drawings" / "gallery" / f"{name}.toml"), PLANS)


def checked(leaf: Leaf, study: Study, folder: Path) -> SeenSheet:
    path = folder / "sheet.svg"
    path.write_bytes(svg(lettered(leaf)))
    return verify(path, leaf, partial(faults, study=study))


def checked_set(study: Study, folder: Path) -> None:
    seen = [checked(leaf, study, folder) for leaf in leaves(study)]
    verify_set(set_faults([(one.measured, one.leaf) for one in seen], study))


@pytest.mark.rest
@pytest.mark.parametrize("name", first(SCENES))
def test_what_is_drawn_agrees_with_the_analysis_and_touches_no_letter(name: str, tmp_path: Path) -> None:
    for leaf in leaves(study_of(name)):
        checked(leaf, study_of(name), tmp_path)
        assert collisions(leaf) == []


@pytest.mark.parametrize("fault", first([*FAULTS, *STROKES]), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_the_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    study = study_of(fault.scene)
    assert study.comparison("linkage").worst <= 1.0
    with planted(fault), pytest.raises(SelfCheckFailed) as told:
        checked_set(study, tmp_path)
    assert fault.says in str(told.value)
    assert "against the analysis" not in said(told.value, "ru")


def test_a_position_has_both_its_plans_on_some_sheet_of_the_set() -> None:
    """No small sheet holds both: the plan of accelerations may follow that of velocities on the next one."""
    study = study_of(SCENES[0])
    whole = leaves(study)
    measured = measure(svg(lettered(whole[0])))
    plans = [plan for leaf in whole for plan in leaf.metadata["vectors"]]
    apart = [(measured, replace(whole[0], metadata={"vectors": [plan]})) for plan in plans]
    assert list(set_faults(apart, study)) == []
    assert [str(fault) for fault in set_faults(apart[1:], study)] == [
        f"p on velocities in position {plans[0][1]} is missing"
    ]


def test_a_pin_lettered_as_the_direction_of_its_slot_is_no_other_thing() -> None:
    """The point of the slotted link under a pin U is u3; the slot's direction is then another letter."""
    text = (ROOT / "drawings" / "gallery" / "whitworth.toml").read_text(encoding="utf-8")
    for old, new in (('"OA"', '"OU"'), ("OA =", "OU ="), ('2 = "A"', '2 = "U"'), ("\nA = [", "\nU = [")):
        text = text.replace(old, new)
    told = [LinkageStudy(parse_scene(one)) for one in (text, text.replace("U", "A"))]
    lettered_u, lettered_a = (spans(one, one.drafts(), compare(one).analysis) for one in told)
    assert [name.replace("U", "A") for name in lettered_u] == list(lettered_a)
