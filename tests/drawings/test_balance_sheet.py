"""The sheet of balancing is held to the analysis: what is drawn passes, faults planted into the drawing withhold it.

The tables are tests/cases/balance_faults.toml and, line by line, balance_line_faults.toml.
"""

from __future__ import annotations

import re
from functools import cache, partial
from pathlib import Path

import pytest
from drawings.checks.balance.verify_balancing import faults, set_faults

from drawings.bench import balance_sheet
from drawings.checks.verify import SelfCheckFailed, verify
from drawings.lettering.lettering import lettered
from drawings.measure.measure import Measured
from drawings.paper.strokes import Leaf
from drawings.pens.svg import svg
from drawings.sheets.balancing import leaves
from plans.bench.balance import PLACE, SHAKING, ground
from plans.scene.scene import parse_scene
from plans.study import Study
from plans.words.words import message, said
from tests.drawings.balance_scenes import SCENES, scene
from tests.drawings.conftest import Run
from tests.drawings.planting import ROOT, DrawingFault, drawing_faults, planted
from tests.parts import first

FAULTS = drawing_faults(ROOT / "tests" / "cases" / "balance_faults.toml")
LINES = drawing_faults(ROOT / "tests" / "cases" / "balance_line_faults.toml")
PAPERS = (("A1", "en", "GOST"), ("A3", "ru", "ISO"), ("A2", "ru", "GOST"), ("A2", "en", "ISO"))


@cache
def study_of(name: str, size: str = "A2", language: str = "en", standard: str = "GOST") -> Study:
    return Study(parse_scene(scene(name, size, language, standard)))


def checked(leaf: Leaf, study: Study, folder: Path) -> None:
    path = folder / "sheet.svg"
    path.write_bytes(svg(lettered(leaf)))
    verify(path, leaf, partial(faults, study=study))


@pytest.mark.rest
@pytest.mark.parametrize("case", first([(name, *paper) for paper in PAPERS for name in SCENES]))
def test_what_is_drawn_agrees_with_the_analysis(case: tuple[str, str, str, str], tmp_path: Path) -> None:
    study = study_of(*case)
    assert study.comparison("balance").worst <= 1.0
    for leaf in leaves(study):
        checked(leaf, study, tmp_path)


@pytest.mark.rest
def test_a_parallelogram_is_drawn_past_its_change_points(tmp_path: Path) -> None:
    """Balanced in full it has no load on the frame's hinges: what is beside a change point is rounding, on any road."""
    study = study_of("parallel", "A3")
    comparison = study.comparison("balance")
    for road in (comparison.construction, comparison.analysis):
        assert road.after is not None
        assert road.before.reactions["0-3"] > 1
        zeros = [road.after.path, road.after.shaking, road.after.rocking, road.after.balancing]
        assert [*zeros, road.after.reactions["0-1"], road.after.reactions["0-3"]] == [0] * 6
    for leaf in leaves(study):
        checked(leaf, study, tmp_path)


@pytest.mark.parametrize("fault", first([*FAULTS, *LINES]), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_the_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    study = study_of(fault.scene, "A1")
    assert study.comparison("balance").worst <= 1.0
    with planted(fault), pytest.raises(SelfCheckFailed) as told:
        for leaf in leaves(study):
            checked(leaf, study, tmp_path)
    assert fault.says in str(told.value)
    assert told.value.exit_code == 5
    own = re.sub("«[^»]*»|: .* в пояснениях", "", said(told.value, "ru"))  # what a sheet says is quoted
    unread = "не удаётся измерить" in own  # why a sheet cannot be read is told in English
    assert unread or not re.search(r"\b(the|is|on|in|for|against)\b", own)


@pytest.mark.rest
@pytest.mark.parametrize("fault", first(LINES), ids=lambda fault: fault.name)
def test_a_planted_fault_withholds_a_russian_sheet(fault: DrawingFault, tmp_path: Path) -> None:
    study = study_of(fault.scene, "A2", "ru", "ISO")
    assert study.comparison("balance").worst <= 1.0
    with planted(fault), pytest.raises(SelfCheckFailed):
        for leaf in leaves(study):
            checked(leaf, study, tmp_path)


@pytest.mark.rest
def test_what_is_on_no_sheet_of_a_set_is_missed() -> None:
    study, seen = study_of("engine", "A4"), Measured((), ())
    own = [(seen, leaf) for leaf in leaves(study)]
    assert len(own) > 1
    assert list(set_faults(own, study)) == []
    told = [[str(fault) for fault in set_faults(own[:k] + own[k + 1 :], study)] for k in range(len(own))]
    lost = {fault for faults_of_one in told for fault in faults_of_one}
    figures = ("scheme-before", "scheme-after", "static-moments", "shaking", "rocking", "shares")
    due = [message("wrong.figure_missing", name=name) for name in figures]
    due += [message("wrong.missing", name=name) for name in ("costs", "counterweights")]
    assert all(told) and lost == {str(one) for one in (*due, message("wrong.notes_on", count=0))}
    assert list(set_faults([*own, own[-1]], study))


def test_every_fault_still_finds_the_text_that_it_replaces() -> None:
    assert len(FAULTS) >= 15
    for fault in (*FAULTS, *LINES):
        assert fault.text


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


@pytest.mark.rest
def test_a_fault_withholds_the_sheet_at_the_command(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "bar.toml"
    path.write_text(scene("bar", "A1"), "utf-8")
    with planted(FAULTS[0]):
        code, _, err = run("draw", path, "-o", tmp_path / "out")
    assert code == 5
    assert FAULTS[0].says in err
    assert not list((tmp_path / "out").glob("*.svg"))
