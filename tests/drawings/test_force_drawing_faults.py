"""Faults planted into the drawing of the force sheet withhold it: tests/cases/force_drawing_faults.toml."""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from drawings.checks.verify import SelfCheckFailed, verify_set
from drawings.checks.verify_forces import set_faults
from drawings.lettering.lettering import lettered
from drawings.pens.svg import svg
from drawings.sheets import forces
from plans.checks.compare import compare
from plans.checks.force_comparison import ForceComparison, compare_forces
from plans.forces.statics import Statics
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene
from plans.words.words import said
from tests.drawings.exhibits import read_back
from tests.drawings.memo import loaded_memo, verify_loaded
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.parts import first
from tests.plans.force_cases import text_of

FAULTS = drawing_faults(ROOT / "tests" / "cases" / "force_drawing_faults.toml")
SPRING = '[[loads.springs]]\nbetween = [{ on = 3, point = "B" }, "O"]\nstiffness = 500\nfree = 0.3\n\n[friction]'


@cache
def shaper() -> tuple[Statics, ForceComparison]:
    text = text_of(
        "shaper",
        ("positions = [60]", 'positions = 12\nbalancing = "coupling"'),
        ("[drive.gear]\nradius = 0.18\nat = 210\npressure_angle = 20\n", ""),
        ('radius = "20 mm"', 'radius = "90 mm"'),
        ("4 = { mass = 3,", "4 = { mass = 0.3,"),
        ("[friction]", SPRING),
    )
    statics = Statics(LinkageStudy(parse_scene(text)))
    return statics, compare_forces(statics, compare(statics.study))


def check(folder: Path) -> None:
    statics, comparison = shaper()
    sheets = []
    for leaf in forces.sheets(statics.study, comparison, statics):
        path = folder / "sheet.svg"
        path.write_bytes(svg(lettered(leaf)))
        sheets.append((verify_loaded(path, leaf, statics, comparison), leaf))
    verify_set(set_faults(sheets, loaded_memo(statics, comparison)))


@pytest.mark.rest
def test_what_hangs_on_the_schemes_and_the_lever_passes(tmp_path: Path) -> None:
    check(tmp_path)


@pytest.mark.rest
def test_what_has_gone_on_to_another_sheet_of_its_position_is_found_there() -> None:
    """No small sheet holds a whole group: a detail may stand apart from its plan, an equation from its lever."""
    study = loaded_memo(*shaper())
    (leaf,) = forces.sheets(study["linkage"], study.comparison("forces"), study["forces"])
    apart = [one for one in leaf.groups if one.name.startswith(("detail-", "equations-lever"))]
    groups = [tuple(one for one in leaf.groups if one not in apart), *((one,) for one in apart)]
    sheets = [(read_back(one), one) for one in (replace(leaf, groups=own) for own in groups)]
    told = [[str(fault) for fault in set_faults(sheets[:k] + sheets[k + 1 :], study)] for k in range(1, len(sheets))]
    assert list(set_faults(sheets, study)) == []
    assert {"ΣMp: is missing", "Φ_4 on forces-4-5 is missing"} <= {fault for own in told for fault in own}
    assert all(told)


@pytest.mark.parametrize("fault", first(FAULTS), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_the_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    with planted(fault), pytest.raises(SelfCheckFailed) as told:
        check(tmp_path)
    assert fault.says in str(told.value)
    assert not re.search(r"\b(the|is|on|in|for|against)\b", said(told.value, "ru"))
