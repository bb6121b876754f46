"""Force sheets of drives over a stroke agree with the analysis, and their letters touch nothing."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from drawings.commands.draw import draw
from drawings.sheets.forces import leaves
from plans.scene.scene import read_scene
from plans.study import Study
from tests.drawings.collisions import collisions
from tests.drawings.planting import ROOT
from tests.parts import first

CASES = ROOT / "tests" / "cases"


@cache
def study_of(name: str) -> Study:
    return Study(read_scene(CASES / "strokes" / f"{name}.toml"))


@pytest.mark.rest
@pytest.mark.parametrize("name", first(["cylinder", "ram", "scissor"]))
def test_what_is_drawn_agrees_with_the_analysis_and_touches_no_letter(name: str, tmp_path: Path) -> None:
    draw(CASES / "strokes" / f"{name}.toml", tmp_path)
    for leaf in leaves(study_of(name)):
        assert collisions(leaf) == []


@pytest.mark.rest
def test_ticks_close_to_the_drawn_position_may_lie_under_its_block(tmp_path: Path) -> None:
    text = (CASES / "strokes" / "ram.toml").read_text(encoding="utf-8").replace('"forces"', '"kinematics"', 1)
    scene = tmp_path / "ram.toml"
    scene.write_text(text.replace("positions = 6", "positions = 60"), "utf-8")
    draw(scene, tmp_path / "out")
