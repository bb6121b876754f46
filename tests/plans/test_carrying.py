"""Linkages that something carries through their change points: a locomotive's coupling rod, and what hangs on it."""

from __future__ import annotations

import numpy as np
import pytest

from plans.linkage.quantities import MotionComparison, compare, compare_extremes
from plans.linkage.study import LinkageStudy
from plans.scene.scene import SceneError, parse_scene
from tests.parts import some
from tests.plans.scenes import scene

COUPLING_ROD = scene(
    mechanism="{through}", frame="O = [0, 0]; C = [1.6, 0]", links="OA AB CB",
    lengths="OA = 0.3; AB = 1.6; CB = 0.3", sketch="B = [1.75, 0.26]",
    drive="link = 1; speed = {speed}; start = {start}; positions = 12",
    masses='2 = {{ mass = 20, inertia = 3, centre = "middle" }}', loads="gravity = 9.81",
    moments=["on = 3; value = -50"],
)  # fmt: skip


def study(text: str, through: str = 'through = "parallel"', speed: float = 20.0, start: float = 60.0) -> LinkageStudy:
    return LinkageStudy(parse_scene(text.format(through=through, speed=speed, start=start), "rod.toml"))


def compared(one: LinkageStudy) -> MotionComparison:
    comparison = compare_extremes(one, compare(one))
    assert comparison.agrees and not comparison.alone
    return comparison


@pytest.mark.parametrize("speed", some([20.0, -20.0], 2))
@pytest.mark.parametrize("through", ["parallel", "inertia"])
def test_a_coupling_rod_stays_parallel_to_the_frame_all_the_turn(through: str, speed: float) -> None:
    comparison = compared(study(COUPLING_ROD, f'through = "{through}"', speed))
    for motion in (comparison.construction, comparison.analysis):
        rod = motion.points["B"].r - motion.points["A"].r
        assert rod == pytest.approx(np.full(12, 1.6), abs=1e-8)  # half the digits at a change point itself
        flat = [4, 10] if speed > 0 else [2, 8]
        omega, known = motion.links[3].omega, [k for k in range(12) if k not in flat]
        assert omega is not None and omega[known] == pytest.approx(speed, rel=1e-9)
        assert [(gap.position, gap.plan, gap.reason) for gap in motion.gaps] == [
            (k, "velocities", "change point") for k in flat
        ]


def test_without_a_word_the_gap_is_told_with_what_to_write() -> None:
    comparison = compared(study(COUPLING_ROD, ""))
    beyond = [gap for gap in comparison.construction.gaps if gap.reason == "beyond a change point"]
    assert [gap.position for gap in beyond] == [5, 6, 7, 8, 9]
    assert all('through = "parallel"' in str(gap.advice) for gap in beyond)


def test_nothing_else_carries_a_linkage() -> None:
    with pytest.raises(SceneError, match="through"):
        study(COUPLING_ROD, 'through = "magic"')
