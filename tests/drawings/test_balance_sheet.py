"""The sheet of balancing, of many mechanisms on many papers: what is drawn is what the analysis gives."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from drawings.bench import balance_sheet
from plans.bench.balance import PLACE, SHAKING, ground
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.balance_scenes import SCENES, scene
from tests.drawings.held import faults_of
from tests.parts import first

PAPERS = (("A1", "en", "GOST"), ("A3", "ru", "ISO"), ("A2", "ru", "GOST"), ("A2", "en", "ISO"))


@cache
def study_of(name: str, size: str = "A2", language: str = "en", standard: str = "GOST") -> Study:
    return Study(parse_scene(scene(name, size, language, standard)))


@pytest.mark.rest
@pytest.mark.parametrize("case", first([(name, *paper) for paper in PAPERS for name in SCENES]))
def test_what_is_drawn_agrees_with_the_analysis(case: tuple[str, str, str, str]) -> None:
    study = study_of(*case)
    assert study.comparison("balance").worst <= 1.0
    assert faults_of(study) == []


@pytest.mark.rest
def test_a_parallelogram_is_drawn_past_its_change_points() -> None:
    """Balanced in full it has no load on the frame's hinges: what is beside a change point is rounding, on any road."""
    study = study_of("parallel", "A3")
    comparison = study.comparison("balance")
    for road in (comparison.construction, comparison.analysis):
        assert road.after is not None
        assert road.before.reactions["0-3"] > 1
        zeros = [road.after.path, road.after.shaking, road.after.rocking, road.after.balancing]
        assert [*zeros, road.after.reactions["0-1"], road.after.reactions["0-3"]] == [0] * 6
    assert faults_of(study) == []


@pytest.mark.rest
def test_the_bench_judges_what_is_measured_back(tmp_path: Path) -> None:
    """A sheet is as sharp as its last decimal; the truth is the record in 50 digits."""
    study = study_of("engine", "A1")
    on = ground(study["balance"].linkage, study["balance"].points())
    marks = balance_sheet.measured(study.scene)
    errors = balance_sheet.judge(marks, on)
    assert errors.kinds.keys() == {PLACE, SHAKING}
    assert 0 < max(errors.kinds.values()) < 1e-5
    off = balance_sheet.judge({key: 1.01 * value for key, value in marks.items()}, on)
    assert off.kinds[SHAKING] == pytest.approx(0.01, rel=1e-3)
