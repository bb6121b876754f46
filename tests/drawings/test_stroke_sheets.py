"""Force sheets of drives over a stroke are held to the analysis: what is drawn passes, planted faults withhold it.

The table is tests/cases/stroke_faults.toml.
"""

from __future__ import annotations

from functools import cache, partial
from pathlib import Path

import pytest

from drawings.checks import verify_kinematics
from drawings.checks.verify import SelfCheckFailed, verify, verify_report, verify_set
from drawings.checks.verify_forces import faults, set_faults
from drawings.lettering.lettering import lettered
from drawings.measure.measure import Measured, measure_file
from drawings.paper.strokes import Leaf
from drawings.pens.svg import svg
from drawings.report.report import faults as faults_of
from drawings.report.report import report
from drawings.sheets import kinematics
from drawings.sheets.forces import leaves
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from tests.drawings.collisions import collisions
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.parts import first

CASES = ROOT / "tests" / "cases"
FAULTS = drawing_faults(CASES / "stroke_faults.toml")


@cache
def study_of(name: str) -> Study:
    return Study(read_scene(CASES / "strokes" / f"{name}.toml"))


def check(study: Study, folder: Path) -> None:
    """Check the force sheets and the report of a study as they are checked when they are drawn."""
    sheets = {"forces": leaves(study)}
    read = [(checked(leaf, study, folder), leaf) for leaf in sheets["forces"]]
    verify_set(set_faults(read, study))
    verify_report(faults_of(report(study, sheets), study, sheets))


def checked(leaf: Leaf, study: Study, folder: Path) -> Measured:
    path = folder / "sheet.svg"
    path.write_bytes(svg(lettered(leaf)))
    return verify(path, leaf, partial(faults, study=study)).measured


@pytest.mark.rest
@pytest.mark.parametrize("name", first(["cylinder", "ram", "scissor"]))
def test_what_is_drawn_agrees_with_the_analysis_and_touches_no_letter(name: str, tmp_path: Path) -> None:
    check(study_of(name), tmp_path)
    for leaf in leaves(study_of(name)):
        assert collisions(leaf) == []


@pytest.mark.rest
def test_ticks_close_to_the_drawn_position_may_lie_under_its_block(tmp_path: Path) -> None:
    text = (CASES / "strokes" / "ram.toml").read_text(encoding="utf-8").replace('"forces"', '"kinematics"', 1)
    study = Study(parse_scene(text.replace("positions = 6", "positions = 60")))
    leaf = kinematics.leaves(study)[0]
    path = tmp_path / "sheet.svg"
    path.write_bytes(svg(lettered(leaf)))
    assert list(verify_kinematics.faults(measure_file(path), leaf, study)) == []


@pytest.mark.parametrize("fault", first(FAULTS), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_the_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    study = study_of(fault.scene)
    assert study.comparison("forces").agrees
    with planted(fault), pytest.raises(SelfCheckFailed) as told:
        check(study, tmp_path)
    assert fault.says in str(told.value)
