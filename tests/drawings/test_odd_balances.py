"""Odd scenes of balancing and of banks are drawn, and what is drawn agrees with the analysis.

The scenes are tests/cases/odd_balances/*.toml, each with what is odd about it.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from drawings.commands.draw import draw
from tests.drawings.conftest import Run
from tests.drawings.planting import ROOT
from tests.parts import first
from tests.plans.banks import ENGINE, counterweight

SCENES = sorted((ROOT / "tests" / "cases" / "odd_balances").glob("*.toml"))


@pytest.mark.parametrize("scene", first(SCENES), ids=lambda path: path.stem)
def test_it_is_drawn(scene: Path, tmp_path: Path) -> None:
    sheets = draw(scene, tmp_path)
    assert all(path.exists() for path in sheets.paths)
    assert all(comparison.worst <= 1.0 for comparison in sheets.study.comparisons)


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
