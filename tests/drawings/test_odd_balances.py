"""Odd scenes of balancing and of banks are drawn, and what is drawn agrees with the analysis.

The scenes are tests/cases/odd_balances/*.toml, each with what is odd about it.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from drawings.commands.draw import draw
from plans.balance.study import NoPosition
from plans.scene.scene import parse_scene
from plans.study import Study
from plans.words.words import said
from tests.drawings.planting import ROOT
from tests.parts import some
from tests.plans.banks import FOUR_BAR, counterweight

SCENES = sorted((ROOT / "tests" / "cases" / "odd_balances").glob("*.toml"))


@pytest.mark.parametrize("scene", some(SCENES, 4), ids=lambda path: path.stem)
def test_it_is_drawn(scene: Path, tmp_path: Path) -> None:
    sheets = draw(scene, tmp_path)
    assert all(path.exists() for path in sheets.paths)
    assert all(comparison.worst <= 1.0 for comparison in sheets.study.comparisons)


def test_a_linkage_that_reaches_no_position_has_no_balance() -> None:
    text = FOUR_BAR.replace("AB = 0.4", "AB = 0.01").replace("speed = 10", "speed = 10\nstart = 180\npositions = 1")
    study = Study(parse_scene(text + '[balance]\naim = "full"\n' + counterweight("on = 1", "mass = 1")))
    with pytest.raises(NoPosition) as told:
        _ = study["balance"]
    assert "no position has a mass centre: out of reach at B, in position 0" in str(told.value)
    assert "ни в одном положении нет центра масс" in said(told.value, "ru")
