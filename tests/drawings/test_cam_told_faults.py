"""Faults of reports, and of what all sheets together bear, of cams, cyclograms, rotors: each is seen.

The table is tests/cases/cam_told_faults.toml; a scene may have its format after its name.
"""

from __future__ import annotations

from typing import cast

import pytest

from drawings.checks.verify import SelfCheckFailed, verify_report, verify_set
from drawings.measure.measure import Measured
from drawings.report.report import faults, report
from drawings.sheets.table import SHEETS
from plans.study import Study
from plans.techniques import named
from plans.words.words import said
from tests.drawings import test_cam_faults, test_machine_drawing_faults
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.parts import first

FAULTS = drawing_faults(ROOT / "tests" / "cases" / "cam_told_faults.toml")


def study_of(fault: DrawingFault) -> Study:
    """Give what is drawn: a linkage with a cyclogram, cams and rotors of the gallery."""
    if fault.sheet in ("cyclogram", "rotor"):
        return test_machine_drawing_faults.study_of(fault.sheet, fault.scene)
    return test_cam_faults.study_of(*fault.scene.split())


def checked(study: Study, sheet: str) -> None:
    """Check the report beside the sheets of a kind, and these as a set."""
    leaves = {sheet: named(SHEETS[sheet].leaves)(study)}
    verify_report(faults(report(study, leaves), study, leaves))
    unmeasured = cast(Measured, None)  # of a set only what its sheets bear is looked at
    verify_set(named(SHEETS[sheet].together)([(unmeasured, leaf) for leaf in leaves[sheet]], study))


@pytest.mark.parametrize("fault", first(FAULTS), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_the_report_or_the_set(fault: DrawingFault) -> None:
    study = study_of(fault)
    assert study.comparison("cam" if fault.sheet == "profile" else fault.sheet).worst <= 1.0
    with planted(fault), pytest.raises(SelfCheckFailed) as told:
        checked(study, fault.sheet)
    assert fault.says in str(told.value)
    assert "against the analysis" not in said(told.value, "ru")


@pytest.mark.parametrize("scene", first([("cyclogram", "shaper"), ("cam", "feed-cam A4"), ("profile", "feed-cam")]))
def test_reports_and_sets_agree_with_the_analysis(scene: tuple[str, str]) -> None:
    sheet, name = scene
    checked(study_of(DrawingFault("", name, "", "", "", "", sheet)), sheet)
