"""Extremes of a cam are where derivatives vanish: each is that of its own value, by differences."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from plans.cam.course import Course
from plans.cam.profile.contact import Contact, pressure, pressure_slope
from plans.cam.profile.profile import curvature, curvature_slope, slip, slip_slope
from plans.cam.profile.touch import Tip, Touch, Value
from plans.model.cam import Cam, Load
from plans.model.cam_motion import Sizes
from tests.plans.textbook_cams import FLAT_BASE, cam, offset_sizes, pivot, rocker

STEP = 1e-5  # rad: differences are then good to about nine digits of the third derivative
ROLLER = 0.01
LOADED = Contact(Load(2.0, 100.0, 50.0, 2000.0), 20.0, ROLLER)
FACE = complex(0.06, -0.15)
CAMS = {
    "guide": (cam(), offset_sizes()),
    "rocker": (rocker(), pivot(rocker())),
    "rocker against": (rocker(sense=-1, turns=-1), pivot(rocker(sense=-1, turns=-1), complex(0.12, -0.07))),
    "flat": (cam(end="flat"), Sizes(FLAT_BASE)),
    "flat rocker": (rocker("flat", face=0.005), pivot(rocker("flat"), FACE)),
    "flat rocker against": (rocker("flat", 1, -1, 0.005), pivot(rocker("flat", 1, -1), FACE)),
}
VALUES: dict[str, tuple[Value, Value]] = {
    "pressure": (pressure, pressure_slope),
    "resistance": (LOADED.resistance, LOADED.resistance_slope),
    "force": (LOADED.force, LOADED.force_slope),
}
ROUND: dict[str, tuple[Value, Value]] = {
    "curvature": (curvature, curvature_slope),
    "slip": (lambda tip: slip(tip, tip.lever, ROLLER), lambda tip: slip_slope(tip, ROLLER)),
}
FLAT: dict[str, tuple[Value, Value]] = {
    "place": (lambda tip: Touch(tip).place, lambda tip: Touch(tip).place_slope),
    "radius": (lambda tip: Touch(tip).radius, lambda tip: Touch(tip).radius_slope),
    "slip": (lambda tip: Touch(tip).slip, lambda tip: Touch(tip).slip_slope),
}


@pytest.mark.parametrize("name", CAMS)
def test_a_derivative_is_that_of_its_value(name: str) -> None:
    own, sizes = CAMS[name]
    turned = np.radians([7.0, 31.0, 52.0, 88.0, 113.0, 157.0, 171.0, 196.0, 229.0])
    for told, (value, slope) in (VALUES | (FLAT if own.flat else ROUND)).items():
        rise = (at(own, sizes, turned + STEP, value) - at(own, sizes, turned - STEP, value)) / (2 * STEP)
        assert at(own, sizes, turned, slope) == pytest.approx(rise, rel=1e-6, abs=1e-7 * np.abs(rise).max()), told


def at(own: Cam, sizes: Sizes, turned: np.ndarray, value: Callable[[Tip], np.ndarray]) -> np.ndarray:
    return value(Tip(Course(own), sizes, turned))
