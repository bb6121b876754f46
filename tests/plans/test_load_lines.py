"""Forces along lines of points and between two links: their directions, both ends, and both roads."""

from __future__ import annotations

import cmath
from math import radians, tan
from pathlib import Path

import numpy as np
import pytest

from plans.forces.drive import pushing
from plans.linkage.reading.linkage import mechanism_of
from plans.model.machine import GEAR, Transmission
from plans.scene.faults import SceneError, dotted
from plans.scene.scene import parse_scene
from tests.plans.force_cases import ROADS, compared, of_road, statics_of
from tests.plans.scenes import scene
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


GEARED = scene(
    frame="O = [0, 0]", links="OA AB B", lengths="OA = 0.1; AB = 0.35",
    slides=["link = 3; along = { through = [0, 0.02] }"], sketch="B = [0.449, 0.02]",
    drive="link = 1; speed = -8; positions = [0, 35, 80, 120, 200, 250, 310]",
    drive_gear="radius = 0.15; at = 210; pressure_angle = 20",
    forces=['on = 3; point = "B"; value = [-300, 0]'],
)  # fmt: skip


@pytest.mark.parametrize("road", ROADS)
@pytest.mark.parametrize(("on", "point"), [(3, "B"), (1, "O")])
def test_the_tooth_of_a_massless_slider_crank_pushes_with_what_its_free_bodies_leave(
    road: str, on: int, point: str
) -> None:
    """The rod bears along AB what holds the slider, the tooth turns the crank against it; a load in O asks no tooth."""
    comparison = compared(GEARED.replace('on = 3\npoint = "B"', f'on = {on}\npoint = "{point}"'))
    phi, towards, tangent = np.radians([0, 35, 80, 120, 200, 250, 310]), cmath.rect(1, radians(210)), tan(radians(20))
    crank = 0.1 * np.exp(1j * phi)
    rod = np.sqrt(0.35**2 - (0.02 - crank.imag) ** 2) + 1j * (0.02 - crank.imag)
    pin = -300 * rod / rod.real if on == 3 else np.zeros(7)  # of the rod on the crank
    turning = -(crank.conjugate() * pin).imag / 0.15  # of the tooth, along the pitch circle
    tooth = turning * 1j * towards - np.abs(turning) * tangent * towards  # and into the wheel
    assert {*np.sign(turning)} == ({-1, 1} if on == 3 else {0})
    assert of_road(comparison, road).reactions["0-1"].force == pytest.approx(
        -pin - tooth - (0 if on == 3 else -300), abs=1e-9
    )


def test_a_tooth_has_a_flank_where_its_moment_is_none_or_not_known() -> None:
    gear = Transmission(GEAR, 0.15, radians(210), radians(20))
    drive = mechanism_of(parse_scene(GEARED)).drive
    asked = pushing(gear, drive, np.array([np.nan, 0.0, -1.0]))
    assert asked == pytest.approx(np.full(3, asked[2]))
