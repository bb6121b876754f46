"""Tables, notes and figures of a machine's motion are held to the analysis: faults planted into their code are seen.

The tables are tests/cases/dynamics_{told,figure}_faults.toml.
"""

from __future__ import annotations

from functools import cache, partial
from itertools import chain
from pathlib import Path

import pytest

from drawings.checks.documents_old import compared
from drawings.checks.dynamics.report_told import faults as report_faults
from drawings.checks.dynamics.verify_dynamics import faults, set_faults
from drawings.checks.verify import SelfCheckFailed, verify, verify_report, verify_set
from drawings.lettering.lettering import lettered
from drawings.pens.svg import svg
from drawings.report.report import report
from drawings.sheets.dynamics import leaves
from plans.scene.scene import read_scene
from plans.study import Study
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.parts import first

CASES = ROOT / "tests" / "cases"
FAULTS = [one for kind in ("told", "figure") for one in drawing_faults(CASES / f"dynamics_{kind}_faults.toml")]


@cache
def study_of(name: str) -> Study:
    return Study(read_scene(ROOT / "drawings" / "gallery" / f"{name}.toml"))


@pytest.mark.parametrize("fault", first(FAULTS), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_the_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    study, path = study_of(fault.scene), tmp_path / "sheet.svg"
    study.comparison("dynamics")
    with planted(fault), pytest.raises(SelfCheckFailed, match=fault.says):
        checked(study, path)


def checked(study: Study, path: Path) -> None:
    """Draw the sheets of a machine's motion, and check each of them and all together."""
    laid, seen = leaves(study), []
    for leaf in laid:
        path.write_bytes(svg(lettered(leaf)))
        seen.append(verify(path, leaf, partial(faults, study=study)))
    verify_set(set_faults([(one.measured, one.leaf) for one in seen], study))
    text = report(study, {"dynamics": laid})
    told = report_faults(text, study, {}), compared.faults(text, study.comparisons, study.scene.sheet.language)
    verify_report([*chain(*told)])


@pytest.mark.rest
@pytest.mark.parametrize("scene", first(["press", "planer", "compressor"]))
def test_what_is_drawn_as_it_should_be_passes(scene: str, tmp_path: Path) -> None:
    checked(study_of(scene), tmp_path / "sheet.svg")
