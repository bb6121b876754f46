"""Cams by both roads at many turns, derivatives of their values, and peaks of their laws."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from geometry.meet import EPS
from plans.analytic.cam.contour import contour
from plans.analytic.cam.findings import cam_found as analysed
from plans.cam.course import FollowerCourse, positions
from plans.cam.profile.contact import Contact, pressure, pressure_slope
from plans.cam.profile.findings import cam_found
from plans.cam.profile.profile import curvature, curvature_slope, profile, slip, slip_slope
from plans.cam.profile.touch import FaceTouch, Tip, Value
from plans.model.cam import LAWS, Cam, FollowerLoad, Law, Phase
from plans.model.cam_motion import BEND, SLOPE, CamFound, CamSizes
from tests.parts import some
from tests.plans.law_cams import LIFT, LINES, RISING, usual
from tests.plans.textbook_cams import FLAT_BASE, START, cam, offset_sizes, pivot, rocker

TURNS = 3600
FACE = complex(0.06, -0.15)  # O - O1 of a rocker with a flat face


def flat_rocker(sense: int, turns: int) -> tuple[Cam, CamSizes]:
    own = rocker("flat", sense, turns, face=0.005)
    return own, pivot(own, FACE)


def every() -> list[object]:
    made = []
    for sense in (1, -1):
        for offset in (0.012, -0.012, 0.0):
            for end in ("pointed", "roller"):
                made.append((f"{end} e={offset} {sense}", cam(end=end, sense=sense), offset_sizes(offset, START)))
        made.append((f"flat {sense}", cam(end="flat", sense=sense), CamSizes(FLAT_BASE)))
        for turns in (1, -1):
            own = rocker("roller", sense, turns)
            made.append((f"rocker {sense} {turns}", own, pivot(own, complex(0.12, -0.07))))
            made.append((f"flat rocker {sense} {turns}", *flat_rocker(sense, turns)))
        slow = tuple(Phase(p.kind, p.angle / 10, p.start / 10, p.level, p.change, p.law) for p in cam().phases)
        made.append((f"bar {sense}", replace(cam(slow, end="roller", sense=sense), translates=True), CamSizes(0.0)))
        own = rocker("roller", sense, 1)
        slow = tuple(Phase(p.kind, p.angle / 10, p.start / 10, p.level, p.change, p.law) for p in own.phases)
        made.append((f"bar rocker {sense}", replace(own, phases=slow, translates=True), CamSizes(0.0)))
    return [pytest.param(own, sizes, id=name) for name, own, sizes in made]


OWN = 4  # roundings of the law and of sums, beside those of a notch, in eps of the longest length


@pytest.mark.parametrize(("own", "sizes"), every())
def test_both_roads_agree_at_3600_turns(own, sizes):
    """To 4 kappa eps of the longest length: kappa of the notch, and of the normal, which is short where OD is."""
    roller = 0.01 if own.follower.end == "roller" else 0.0
    turned = np.linspace(0, own.turn, TURNS)
    drawn = profile(FollowerCourse(own), sizes, roller, turned)
    one, other = drawn.contour, contour(own, sizes, roller, turned)
    long = max(*(np.abs(z).max() for z in (one.tip, one.pitch, one.lever)), abs(sizes.pivot), own.follower.length or 0)
    sharp = drawn.drawing.board["P"].sharpness
    bound = (4 / (1.0 if sharp is None else np.asarray(sharp)) + OWN) * EPS * long
    for name in ("tip", "pitch", "lever", "sliding"):
        assert (np.abs(getattr(one, name) - getattr(other, name)) <= 2 * bound).all(), name
    turning = bound * (1 + long / np.abs(one.lever))
    assert (np.abs(one.profile - other.profile) <= turning).all()
    assert (one.outer is None) == (other.outer is None) == own.flat
    if one.outer is not None:
        assert (np.abs(one.outer - other.outer) <= turning).all()
    assert (np.abs(one.pressure - other.pressure) <= 2 * bound / np.abs(one.lever)).all()
    assert bends_alike(own, one, other, long)


def bends_alike(own, one, other, long) -> bool:
    """Tell whether the radii agree: to the roundings of S'' and of the lengths, over what the radius is found from."""
    big, size = np.abs(one.travel.bend).max() * (own.follower.length or 1.0) + long, np.abs(one.lever)
    if not own.flat:
        return bool((np.abs(1 / one.radius - 1 / other.radius) <= 16 * EPS * big / size**2 * (1 + big / size)).all())
    lead = 1 - own.follower.sense * one.travel.slope if own.rocks else 1.0
    return bool((np.abs(one.radius - other.radius) <= 16 * EPS * big / np.abs(lead) ** 3).all())


STEP = 1e-5  # rad: differences are then good to about nine digits of the third derivative
ROLLER = 0.01
LOADED = Contact(FollowerLoad(2.0, 100.0, 50.0, 2000.0), 20.0, ROLLER)
CAMS = {
    "guide": (cam(), offset_sizes()),
    "rocker": (rocker(), pivot(rocker())),
    "rocker against": (rocker(sense=-1, turns=-1), pivot(rocker(sense=-1, turns=-1), complex(0.12, -0.07))),
    "flat": (cam(end="flat"), CamSizes(FLAT_BASE)),
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
    "place": (lambda tip: FaceTouch(tip).place, lambda tip: FaceTouch(tip).place_slope),
    "radius": (lambda tip: FaceTouch(tip).radius, lambda tip: FaceTouch(tip).radius_slope),
    "slip": (lambda tip: FaceTouch(tip).slip, lambda tip: FaceTouch(tip).slip_slope),
}


@pytest.mark.parametrize("name", CAMS)
def test_a_derivative_is_that_of_its_value(name: str) -> None:
    own, sizes = CAMS[name]
    turned = np.radians([7.0, 31.0, 52.0, 88.0, 113.0, 157.0, 171.0, 196.0, 229.0])
    for told, (value, slope) in (VALUES | (FLAT if own.flat else ROUND)).items():
        rise = (at(own, sizes, turned + STEP, value) - at(own, sizes, turned - STEP, value)) / (2 * STEP)
        assert at(own, sizes, turned, slope) == pytest.approx(rise, rel=1e-6, abs=1e-7 * np.abs(rise).max()), told


def at(own: Cam, sizes: CamSizes, turned: np.ndarray, value: Callable[[Tip], np.ndarray]) -> np.ndarray:
    return value(Tip(FollowerCourse(own), sizes, turned))


SIZES = CamSizes(0.05, 0.01)
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
    return cam_found(FollowerCourse(cam), SIZES, positions(cam))


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
@pytest.mark.parametrize("law", [Law("constant velocity"), LINES])
def test_at_a_hard_shock_the_acceleration_has_no_largest_value(road, law):
    assert road(usual(law)).peaks.keys() == {SLOPE}
