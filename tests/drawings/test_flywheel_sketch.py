"""The flywheel's sketch: the outline of a wheel, the cut hatched within its outline and nowhere else."""

from __future__ import annotations

import cmath
import math

import pytest

from drawings.dynamics.flywheel_sketch import Outlines
from drawings.paper.hand import hand_of
from drawings.symbols.dashes import hatching
from plans.model.dynamics import Rim, Wheel
from tests.plans.test_run_table import sized

WIDE, THICK = sized(36.70337073, Rim(1.0, 1.2, 7200.0, 1.5)), sized(36.70337073, Rim(1.0, 0.55, 7200.0, 1.5))


@pytest.mark.parametrize("rim", [WIDE, THICK])
def test_the_outline_is_that_of_a_wheel(rim: Wheel) -> None:
    """Bore within hub, hub within rim; the half of the cut has the rim's full section at its top."""
    wheel = Outlines(rim)
    assert 0 < wheel.bore < wheel.hub < wheel.inner < wheel.outer
    top = [corner for corner in wheel.half if corner.imag == wheel.outer]
    assert sorted(corner.real for corner in top) == pytest.approx([-rim.breadth / 2, rim.breadth / 2])
    assert wheel.outer - wheel.inner == pytest.approx(rim.thickness)


def test_hatching_is_as_long_as_the_area_asks() -> None:
    """Lines at 45 degrees, a step apart: their length times the step is about the area within."""
    hand = hand_of("A1")
    outline = [complex(*xy) for xy in ((0, 0), (40, 0), (40, 10), (25, 10), (25, 30), (40, 30), (40, 40), (0, 40))]
    lines = list(hatching(outline, hand))
    assert {round(math.degrees(cmath.phase(line.end - line.start))) for line in lines} == {45}
    assert sum(abs(line.end - line.start) for line in lines) * 2.0 == pytest.approx(1300.0, rel=0.01)
    assert not any(
        (line.start + line.end).real / 2 > 25 and 10 < (line.start + line.end).imag / 2 < 30 for line in lines
    )
