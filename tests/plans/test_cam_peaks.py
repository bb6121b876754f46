"""The largest S' and S'' over a turn: those of every handbook, at their places, by both roads."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plans.analytic.cam.findings import cam_found as analysed
from plans.cam.course import Course, positions
from plans.cam.profile.findings import cam_found
from plans.model.cam import DWELL, LAWS, RETURN, RISE, Cam, Law
from plans.model.cam_motion import BEND, SLOPE, CamFound, Sizes
from tests.parts import some
from tests.plans.law_cams import BLOCKS, LIFT, LINES, RISING, STEADY, law_cam, usual

SIZES = Sizes(0.05, 0.01)
PI = math.pi
TRAPEZOID, SINE = 8 * PI / (2 + PI), 4 * PI**2 / (4 + PI)  # accelerations of the modified trapezoid and sine
# Largest s' and s'' of a phase of length 1 and lift 1 (M2.2).
BOOK = {
    "constant acceleration": (2, 4),
    "cosine": (PI / 2, PI**2 / 2),
    "sine": (2, 2 * PI),
    "3-4-5": (1.875, 10 / math.sqrt(3)),
    "4-5-6-7": (2.1875, 84 * math.sqrt(5) / 25),
    "trapezoid": (2, 16 / 3),
    "modified trapezoid": (2, TRAPEZOID),
    "modified sine": (4 * PI / (4 + PI), SINE),
}


def draw(cam: Cam) -> CamFound:
    return cam_found(Course(cam), SIZES, positions(cam))


def analyse(cam: Cam) -> CamFound:
    return analysed(cam, SIZES, positions(cam))


ROADS = pytest.mark.parametrize("road", [draw, analyse])


@ROADS
@pytest.mark.parametrize("name", some([name for name in LAWS if name != "constant velocity"], 2))
def test_peaks_are_those_of_the_handbook(road, name):
    """Of a return three quarters as long as the rise: there both are larger, the slope below 0."""
    peaks = road(usual(Law(name))).peaks
    slope, bend = BOOK[name]
    back = 0.75 * RISING
    assert peaks[SLOPE].value == pytest.approx(-slope * LIFT / back, rel=1e-14)
    assert peaks[SLOPE].turned == pytest.approx(1.25 * RISING + back / 2, rel=1e-9)
    assert abs(peaks[BEND].value) == pytest.approx(bend * LIFT / back**2, rel=1e-13)


@ROADS
def test_peaks_between_samples_are_found_at_their_places(road):
    """3-4-5: the acceleration is largest at (3 - sqrt 3)/6 of the phase, here at no whole part of a degree."""
    cam = law_cam((RISE, 100, Law("3-4-5")), (RETURN, 137, Law("sine")), (DWELL, 123, None))
    found = road(cam).peaks[BEND]
    places = np.radians(100) * (3 + np.array([-1, 1]) * math.sqrt(3)) / 6
    assert np.abs(found.turned - places).min() < 1e-11
    assert abs(found.value) == pytest.approx(10 / math.sqrt(3) * LIFT / math.radians(100) ** 2, rel=1e-14)


@ROADS
@pytest.mark.parametrize(("law", "peak"), [(STEADY, 2 / 0.3), (BLOCKS, None)])
def test_a_peak_may_be_a_corner_or_a_jump(road, law, peak):
    found = road(law_cam((RISE, 90, law), (RETURN, 200, Law("sine")), (DWELL, 70, None))).peaks
    if peak is None:  # of a shape the last ordinate, three halves of the first ones
        assert abs(found[BEND].turned - math.radians(90)) < 1e-15
        return
    assert found[BEND].value == pytest.approx(peak * LIFT / math.radians(90) ** 2, rel=1e-14)
    assert found[SLOPE].turned == pytest.approx(0.3 * math.radians(90), rel=1e-14)


@ROADS
@pytest.mark.parametrize("law", [Law("constant velocity"), LINES])
def test_at_a_hard_shock_the_acceleration_has_no_largest_value(road, law):
    assert road(usual(law)).peaks.keys() == {SLOPE}
