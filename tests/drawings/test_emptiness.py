"""Sheets are filled: no large empty rectangle is left on any, measured on a grid of their ink."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import pytest

from drawings.page.page import page_of
from drawings.sheets import forces, kinematics
from plans.scene.scene import read_scene
from plans.study import Study
from tests.drawings.emptiness import emptiness
from tests.gallery import LINKAGES
from tests.parts import some

LARGEST, LAST = 0.15, 0.30  # shares of the field that an empty rectangle may take, on the last sheet of a set
FORMATS = ("A2", "A3", "A1")
WITHIN = 0.25  # that a plan of positions may leave within its own box: a far anchor, a slider over a crank (0.243)
OPEN = {("conveyor", "A2"), ("conveyor", "A3"), ("squeezer", "A1"), ("shaper", "A2")}
# On A4 these leave up to 0.21: a figure too high to be drawn larger leaves a strip of 40 to 50 mm beside it.
NARROW = {"crank-rocker", "shaper", "shaper-loaded", "slider-crank", "squeezer", "tangent", "toggle-press"}
ROWS = [*product(LINKAGES, FORMATS), *((path, "A4") for path in LINKAGES if path.stem not in NARROW)]
KINDS = {"kinematics": kinematics, "forces": forces}


@pytest.mark.parametrize("row", some(ROWS, 24), ids=lambda row: f"{row[0].stem}-{row[1]}")
def test_no_sheet_is_left_empty(row: tuple[Path, str]) -> None:
    path, size = row
    scene = read_scene(path)
    study = Study(scene.changed(sheet=scene.sheet.changed(format=size, orientation=None)))
    for kind in KINDS.keys() & set(scene.sheets):
        found = [emptiness(leaf, page_of(study.scene)) for leaf in KINDS[kind].leaves(study)]
        most = WITHIN if (path.stem, size) in OPEN else LARGEST
        assert all(one <= most for one in found[:-1]) and found[-1] <= LAST, (kind, found)
