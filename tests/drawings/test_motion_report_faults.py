"""The report on a linkage is held to the analysis: faults planted into it are told (motion_report_faults.toml)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache

import pytest

from drawings.original.edition import leaves_of
from drawings.paper.strokes import Leaf
from drawings.report.report import faults, report
from plans.scene.scene import read_scene
from plans.study import Study
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.parts import first

FOLDERS = (ROOT / "drawings" / "gallery", ROOT / "tests" / "cases" / "alarms")
FAULTS = drawing_faults(ROOT / "tests" / "cases" / "motion_report_faults.toml")


@cache
def drawn(scene: str) -> tuple[Study, Mapping[str, Sequence[Leaf]]]:
    study = Study(read_scene(next(one for folder in FOLDERS if (one := folder / f"{scene}.toml").exists())))
    study.construct()
    return study, leaves_of(study)


def told(scene: str) -> list[str]:
    study, leaves = drawn(scene)
    return [str(fault) for fault in faults(report(study, leaves), study, leaves)]


@pytest.mark.rest
@pytest.mark.parametrize("scene", first(["shaper", "conveyor", "oscillating-cylinder", "walking-leg"]))
def test_a_report_says_what_the_analysis_gives(scene: str) -> None:
    assert told(scene) == []


@pytest.mark.parametrize("fault", first(FAULTS), ids=lambda fault: fault.name)
def test_a_fault_planted_into_the_report_is_told(fault: DrawingFault) -> None:
    drawn(fault.scene)
    with planted(fault):
        wrong = told(fault.scene)
    assert any(fault.says in one for one in wrong), wrong
