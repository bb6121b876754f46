"""The parts of velocities and accelerations: read off the plans, and each by its own formula (составляющие)."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from plans.linkage.parts import findings
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.scene.scene import read_scene
from tests.parts import some

GALLERY = Path(__file__).parents[2] / "drawings" / "gallery"
SCENES = ("shaper", "oscillating-cylinder", "squeezer", "walking-leg", "planer", "v-engine", "tangent")


@pytest.mark.parametrize("name", some(SCENES, 3))
def test_every_part_is_what_its_formula_says(name: str) -> None:
    study = LinkageStudy(read_scene(GALLERY / f"{name}.toml"))
    told = findings(study, compare(study), {"S": (2, 0.03 + 0.02j)})
    assert {one.name.partition("_")[0] for one in told} >= {"v", "a", "a^n", "a^t"}
    for one in told:
        assert np.nanmax(one.excess) <= 1, one.name
