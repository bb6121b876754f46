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
from tests.parts import first

LARGEST, LAST = 0.15, 0.30  # shares of the field that an empty rectangle may take, on the last sheet of a set
FORMATS = ("A2", "A3", "A1")
ROWS = [*product(LINKAGES, (*FORMATS, "A4"))]
KINDS = {"kinematics": kinematics, "forces": forces}


@pytest.mark.parametrize("row", first(ROWS), ids=lambda row: f"{row[0].stem}-{row[1]}")
def test_no_sheet_is_left_empty(row: tuple[Path, str]) -> None:
    path, size = row
    scene = read_scene(path)
    study = Study(scene.changed(sheet=scene.sheet.changed(format=size, orientation=None)))
    for kind in KINDS.keys() & set(scene.sheets):
        found = [emptiness(leaf, page_of(study.scene)) for leaf in KINDS[kind].leaves(study)]
        assert all(one <= LARGEST for one in found[:-1]) and found[-1] <= LAST, (kind, found)
