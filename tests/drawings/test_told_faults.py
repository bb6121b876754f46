"""Tables and notes of a machine's motion are held to the analysis: faults planted into what writes them are seen.

The table is tests/cases/dynamics_told_faults.toml.
"""

from __future__ import annotations

from functools import cache, partial
from pathlib import Path

import pytest

from drawings.checks.verify import SelfCheckFailed, verify
from drawings.checks.verify_dynamics import faults
from drawings.lettering.lettering import lettered
from drawings.pens.svg import svg
from drawings.sheets.dynamics import leaves
from plans.scene.scene import read_scene
from plans.study import Study
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.parts import some

FAULTS = drawing_faults(ROOT / "tests" / "cases" / "dynamics_told_faults.toml")


@cache
def study_of(name: str) -> Study:
    return Study(read_scene(ROOT / "drawings" / "gallery" / f"{name}.toml"))


@pytest.mark.parametrize("fault", some(FAULTS, 3), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_the_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    study, path = study_of(fault.scene), tmp_path / "sheet.svg"
    with planted(fault), pytest.raises(SelfCheckFailed, match=fault.says):
        for leaf in leaves(study):
            path.write_bytes(svg(lettered(leaf)))
            verify(path, leaf, partial(faults, study=study))
