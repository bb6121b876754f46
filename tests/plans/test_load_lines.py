"""Forces along lines of points and between two links: their directions, both ends, and both roads."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from plans.scene.faults import SceneError, dotted
from tests.plans.force_cases import ROADS, compared, of_road, statics_of
from tests.plans.test_loading import ENGINE, loaded

PUMP = (Path(__file__).parents[1] / "cases/loads/pump.toml").read_text("utf-8")
FORCE = "[[loads.forces]]\n"


@pytest.mark.parametrize("road", ROADS)
def test_the_pump_by_both_roads(road: str) -> None:
    """The power of the pressure is P times the speed at which AC shortens: M = P d(AC)/d phi (virtual work)."""
    comparison = compared(PUMP)
    assert comparison.agrees
    phi = np.radians(np.arange(12) * 30)
    far = np.sqrt(0.12**2 + 0.6**2 - 2 * 0.12 * 0.6 * np.cos(phi))
    assert of_road(comparison, road).balancing.moment == pytest.approx(3000 * 0.12 * 0.6 * np.sin(phi) / far, abs=1e-10)


def test_a_line_off_the_points_of_the_force_is_refused() -> None:
    with pytest.raises(SceneError) as refused:
        _ = statics_of(PUMP.replace('"AB"\nvalue', '"OB"\nvalue')).machine
    (fault,) = refused.value.faults
    assert dotted(fault.path) == "loads.forces[0].direction"
    assert "a line that both points of the force lie on in every position, but OB is off" in str(fault)


@pytest.mark.parametrize(
    ("written", "where", "said"),
    [
        ("value = 3\n", "loads.forces[0]", 'Fix: add on = 2 and point = "B", or between = ["B", "C"]'),
        ("on = 2\nvalue = [1, 0]\n", "loads.forces[0].point", 'Fix: add it: point = "B"'),
        ('point = "B"\nvalue = [1, 0]\n', "loads.forces[0].on", "Fix: add it: on = 2"),
        ('on = 2\nbetween = ["O", "B"]\nvalue = 1\n', "loads.forces[0]", "either on or between, not both"),
        ('between = ["O"]\nvalue = 1\n', "loads.forces[0].between", "the two ends, points of two links, but found 1"),
        ('between = ["O", "B"]\nvalue = 1\n', "loads.forces[0].between[1]", "links 2, 3 have B"),
        ('between = ["O", "E"]\nvalue = 1\n', "loads.forces[0].between[1]", "no point E"),
        (
            'between = ["O", { on = 3, point = "B" }]\nvalue = [1, 2]\n',
            "loads.forces[0].value",
            "because it acts between two points",
        ),
        (
            'between = ["O", { on = 3, point = "B" }]\ndirection = 90\nvalue = 1\n',
            "loads.forces[0].direction",
            "the letters of two points, because a force between two links turns with them",
        ),
        ('on = 2\npoint = "B"\ndirection = "AE"\nvalue = 1\n', "loads.forces[0].direction", "no point E"),
        ('on = 2\npoint = "B"\ndirection = "AA"\nvalue = 1\n', "loads.forces[0].direction", "A"),
        ('on = 2\npoint = "B"\ndirection = "ABO"\nvalue = 1\n', "loads.forces[0].direction", "two points"),
        ('on = 2\npoint = "B"\ndirection = "90 mm"\nvalue = 1\n', "loads.forces[0].direction", "a unit of angle"),
        (
            'on = 2\npoint = "B"\ndirection = "AB"\nagainst = "motion"\nvalue = 1\n',
            "loads.forces[0]",
            "either against or direction",
        ),
    ],
)
def test_a_wrong_use_is_told_with_what_to_write(written: str, where: str, said: str) -> None:
    with pytest.raises(SceneError) as refused:
        loaded('sheets = ["forces"]\n' + ENGINE + FORCE + written)
    (fault,) = refused.value.faults
    assert (dotted(fault.path), said in str(fault)) == (where, True), str(fault)
