"""Faults planted into force sheets and their report withhold them: tests/cases/force_sheet_faults.toml."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from drawings.checks import verify_forces
from drawings.checks.verify import SelfCheckFailed, verify, verify_report, verify_set
from drawings.lettering.lettering import lettered
from drawings.pens.svg import svg
from drawings.report.report import faults as faults_of
from drawings.report.report import report
from drawings.sheets import forces
from drawings.sheets.documents import bind
from plans.scene.scene import parse_scene
from plans.study import Study
from plans.words.words import said
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.drawings.test_force_drawing_faults import SPRING
from tests.parts import first
from tests.plans.force_cases import text_of
from tests.plans.test_load_lines import PUMP

FAULTS = drawing_faults(ROOT / "tests" / "cases" / "force_sheet_faults.toml")
RUSSIAN = '\n[sheet]\nlanguage = "ru"\nreactions = "P"\nforces = [2]\nhodographs = ["0-3"]\n'
GEAR = "[drive.gear]\nradius = 0.18\nat = 210\npressure_angle = 20\n"
TEXTS = {
    "shaper": (
        ("positions = [60]", 'positions = 12\nbalancing = "coupling"'),
        (GEAR, ""),
        ('radius = "20 mm"', 'radius = "90 mm"'),
        ("4 = { mass = 3,", "4 = { mass = 0.3,"),
        ("[friction]", SPRING),
    ),
    "станок": (("positions = [60]", "positions = 12"),),
}
ONCE = 'during = "working stroke"\nworking = "together"\ndirection'
PUMPS = PUMP.replace("direction", ONCE) + "forces = [2, 8]\n"  # the piston presses in position 2 and rests in 8


@cache
def study(scene: str) -> Study:
    if scene == "насос":
        return Study(parse_scene(PUMPS))
    text = text_of("shaper", *TEXTS[scene])
    return Study(parse_scene(text if scene == "shaper" else text + RUSSIAN))


def check(scene: str, folder: Path) -> None:
    """Draw the force sheets and the report of a scene, and check both as they are checked when they are drawn."""
    own, sheets = study(scene), []
    leaves = bind({"forces": forces.leaves(own)}, own.scene)
    for leaf in leaves["forces"]:
        path = folder / "sheet.svg"
        path.write_bytes(svg(lettered(leaf)))
        seen = verify(path, leaf, lambda one, other: verify_forces.faults(one, other, own))
        sheets.append((seen.measured, leaf))
    text = report(own, leaves)
    verify_set(verify_forces.set_faults(sheets, own))
    verify_report(faults_of(text, own, leaves))


@pytest.mark.rest
@pytest.mark.parametrize("scene", first([*TEXTS, "насос"]))
def test_what_is_drawn_as_it_should_be_passes(scene: str, tmp_path: Path) -> None:
    check(scene, tmp_path)


@pytest.mark.parametrize("fault", first(FAULTS), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_the_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    with planted(fault), pytest.raises(SelfCheckFailed) as told:
        check(fault.scene, tmp_path)
    assert fault.says in str(told.value)
    own = re.sub("«[^»]*»", "", said(told.value, "ru"))  # what it quotes of the sheet is in the sheet's language
    assert not re.search(r"\b(the|is|against|missing)\b", own.replace(fault.says, ""))
