"""What a report says of friction beside a position that all but jams."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from drawings.forces.report import friction_lines
from plans.forces.quantities import compare_forces
from plans.forces.statics import Statics
from plans.linkage.quantities import compare
from plans.linkage.study import LinkageStudy
from plans.scene.scene import parse_scene

STEEP = """
title = "Steep rod"
sheets = ["forces"]
[mechanism.frame]
O = [0, 0]
[mechanism.links]
1 = "OA"
2 = "AB"
3 = "B"
[mechanism.lengths]
OA = 0.07
AB = 0.09
[[mechanism.slides]]
link = 3
along = { through = [0, 0], angle = 0 }
[mechanism.sketch]
B = [0.16, 0]
[drive]
link = 1
speed = 1
start = 7
positions = 12
[[loads.forces]]
on = 3
point = "B"
against = "motion"
value = 100
[friction]
coefficient = 1.0
radius = "1 mm"
[sheet]
language = "ru"
"""


def test_beside_a_position_that_all_but_jams_no_power_is_written_as_nothing() -> None:
    study = LinkageStudy(parse_scene(STEEP))
    comparison = compare_forces(Statics(study), compare(study))
    assert comparison.friction is not None
    found = comparison.friction[0]
    enormous = replace(found, lost=np.where(np.arange(len(found.lost)) == len(found.lost) - 1, 1e15, found.lost))
    tables = [
        [line.split(" | ")[1:-3] for line in friction_lines(comparison, one, "ru") if line[:3] == "| 0"]
        for one in (found, enormous)
    ]
    assert tables[0] == tables[1] and tables[0] != []
