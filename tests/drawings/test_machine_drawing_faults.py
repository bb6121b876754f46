"""Faults planted into the drawing of rotors, cyclograms and a machine's motion withhold their sheets.

The tables are tests/cases/{rotor,cyclogram,dynamics}_drawing_faults.toml.
"""

from __future__ import annotations

import re
from functools import cache, partial
from importlib import import_module
from pathlib import Path

import pytest

from drawings.checks.verify import SelfCheckFailed, verify
from drawings.lettering.lettering import lettered
from drawings.pens.svg import svg
from plans.scene.scene import parse_scene, read_scene
from plans.study import Study
from plans.words.words import said
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.drawings.test_cyclogram_sheet import CAM, TOLD
from tests.parts import first
from tests.plans.cyclograms import scene_text
from tests.plans.dynamics_scenes import study as machine

CASES, GALLERY = ROOT / "tests" / "cases", ROOT / "drawings" / "gallery"
KINDS = ("cyclogram",)
FAULTS = {kind: drawing_faults(CASES / f"{kind}_drawing_faults.toml") for kind in KINDS}
EVERY_DAY = [fault for kind in KINDS for fault in FAULTS[kind]]
ASKED = 'fluctuation = "1/25"\nflywheel.diameter = "1.2 m"\n'
SHEET = 'positions = 12\n[sheet]\nformat = "A1"\nlanguage = "ru"\n'


@cache
def study_of(kind: str, scene: str) -> Study:
    """Give what is drawn: a rotor of the gallery, a linkage of it with a cyclogram, the planer."""
    if kind == "rotor":
        return Study(read_scene(GALLERY / f"{scene}.toml"))
    if kind == "cyclogram":
        return Study(parse_scene(scene_text(scene, TOLD + CAM)))
    return machine(asked=ASKED, drive=SHEET)


def checked(kind: str, scene: str, folder: Path) -> None:
    study, path = study_of(kind, scene), folder / "sheet.svg"
    held = partial(import_module(f"drawings.checks.{kind}.verify_{kind}").faults, study=study)
    for leaf in import_module(f"drawings.sheets.{kind}").leaves(study):
        path.write_bytes(svg(lettered(leaf)))
        verify(path, leaf, held)


@pytest.mark.parametrize("fault", first(EVERY_DAY), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_the_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    study_of(fault.sheet, fault.scene).comparison(fault.sheet)
    with planted(fault), pytest.raises(SelfCheckFailed) as told:
        checked(fault.sheet, fault.scene, tmp_path)
    assert fault.says in str(told.value)
    unquoted = re.sub("«[^»]*»", "", said(told.value, "ru"))
    assert not re.search(r"\b(the|is|for|against)\b", unquoted)
