"""The flywheel's sketch: the outline of a wheel, the cut hatched within its outline and nowhere else."""

from __future__ import annotations

import pytest

from drawings.dynamics.flywheel_sketch import Outlines
from plans.model.dynamics import Rim, Wheel
from tests.plans.test_flywheel_rim import sized

WIDE, THICK = sized(36.70337073, Rim(1.0, 1.2, 7200.0, 1.5)), sized(36.70337073, Rim(1.0, 0.55, 7200.0, 1.5))


@pytest.mark.parametrize("rim", [WIDE, THICK])
def test_the_outline_is_that_of_a_wheel(rim: Wheel) -> None:
    """Bore within hub, hub within rim; the half of the cut has the rim's full section at its top."""
    wheel = Outlines(rim)
    assert 0 < wheel.bore < wheel.hub < wheel.inner < wheel.outer
    top = [corner for corner in wheel.half if corner.imag == wheel.outer]
    assert sorted(corner.real for corner in top) == pytest.approx([-rim.breadth / 2, rim.breadth / 2])
    assert wheel.outer - wheel.inner == pytest.approx(rim.thickness)
