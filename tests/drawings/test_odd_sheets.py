"""Sheets of every technique that the gallery has not: both roads agree, every statement is due, nothing is at fault."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from drawings.sheets.documents import leaves_of
from plans.scene.scene import parse_scene
from plans.study import Study
from tests.drawings.conftest import Run
from tests.drawings.held import wrongs
from tests.drawings.odd_scenes import EVERY, Odd
from tests.parts import first, some
from tests.plans.banks import ENGINE, counterweight


@pytest.mark.parametrize("odd", some(EVERY, 30, [one.name for one in EVERY]))
def test_an_odd_scene_is_drawn_as_the_analysis_has_it(odd: Odd) -> None:
    study = Study(parse_scene(odd.text))
    leaves = leaves_of(study)
    assert leaves
    assert all(comparison.agrees for comparison in study.comparisons)
    assert [str(wrong) for kind, own in leaves.items() for wrong in wrongs(study, kind, own)] == []
    told = "".join(f"{leaf.description}{leaf.groups}" for own in leaves.values() for leaf in own)
    assert [said for said in odd.says if said not in told] == []


@pytest.mark.rest
@pytest.mark.parametrize("aim", first(["full", "share"]))
def test_a_linkage_that_reaches_no_position_has_numbers_but_no_sheet(aim: str, run: Run, tmp_path: Path) -> None:
    path, engine = tmp_path / "lost.toml", ENGINE.replace("AB = 0.4", "AB = 0.05").replace("B = [0.5, 0]", "B = [0, 0]")
    weights = counterweight("on = 1", "mass = 5") + (counterweight("on = 2", "mass = 2") if aim == "full" else "")
    path.write_text(
        f'sheets = ["balancing"]\n{engine}positions = [80, 90]\n[balance]\naim = "{aim}"\n{weights}', "utf-8"
    )
    code, out, _ = run("solve", path)
    found = json.loads(out)["balance"]
    assert (code, found["before"]["force"], found["after"]["path"]) == (4, None, None)
    assert found["counterweights"][0]["mass"] == 5
    code, _, err = run("draw", path, "-o", tmp_path)
    assert code == 3
    assert "no position has forces: out of reach at B, in position 0" in err
