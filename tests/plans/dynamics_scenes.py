"""Machines whose motion is known in figures: the slider-crank of methods 4.2 with the planing load of 4.7 (задачи)."""

from __future__ import annotations

from functools import cache

from plans.scene.scene import parse_scene
from plans.study import Study
from tests.plans.scenes import scene

CRANK = scene(
    'title = "Slider-crank"; sheets = ["dynamics"]', frame="O = [0, 0]", links="OA AB B",
    lengths="OA = 0.1; AB = 0.4", slides=["link = 3; along = { through = [0, 0], angle = 0 }"],
    sketch="B = [0.45, 0]",
    masses="1 = { mass = 3, inertia = 0.01, centre = [0.04, 0] }; "
    "2 = { mass = 4, inertia = 0.06, centre = [0.15, 0] }; 3 = { mass = 8 }",
)  # fmt: skip
PUSHED = scene(loads="gravity = 9.81", forces=['on = 3; point = "B"; value = 1200; direction = 0'])
PLANING = scene(
    forces=['on = 3; point = "B"; value = 2000; against = "motion"; overrun = 0.05; during = "working stroke"']
)


def text(loads: str = PLANING, drive: str = "positions = 24", asked: str = 'fluctuation = "1/25"') -> str:
    """Write the scene of the slider-crank at 120 rpm."""
    return f'{CRANK}{loads}[drive]\nlink = 1\nspeed = "120 rpm"\n{drive}\n[dynamics]\n{asked}\n'


@cache  # a study is a memo: whoever asks for the same machine shares what was made of it
def study(loads: str = PLANING, drive: str = "positions = 24", asked: str = 'fluctuation = "1/25"') -> Study:
    """Make the study of the slider-crank."""
    return Study(parse_scene(text(loads, drive, asked)))
