"""The gallery's mechanisms beside the hand formulas of textbooks, which know neither plans nor joint equations."""

from __future__ import annotations

import cmath
import tomllib
from functools import cache
from math import acos, asin, pi, radians, sqrt
from pathlib import Path

import numpy as np
import pytest

from plans.linkage.quantities import compare, compare_extremes, notches
from plans.linkage.study import LinkageStudy
from plans.model.motion import Motion
from plans.scene.scene import read_scene
from tests import parts
from tests.gallery import LINKAGES
from tests.rows import over

GALLERY = Path(__file__).parents[2] / "drawings" / "gallery"
ROUNDING = 1e-12  # m and rad for mechanisms of about a metre; rates are larger by omega, and its square
# Kappa from which a report warns: 0.01 mm in a length moves a point by more than half a millimetre.
WARNING = 60


@cache
def study(name: str) -> LinkageStudy:
    return LinkageStudy(read_scene(GALLERY / f"{name}.toml"))


@cache
def motion(name: str) -> Motion:
    return study(name).motion()


def crank(name: str) -> np.ndarray:
    return study(name).turn.phi


def circles_meet(first: complex, near: float, second: complex, far: float, side: int) -> complex:
    """Give the point at a distance near from the first centre and far from the second, left (+1) of first to second."""
    apart = abs(second - first)
    angle = acos((near**2 + apart**2 - far**2) / (2 * near * apart))
    return first + near * cmath.exp(1j * (cmath.phase(second - first) + side * angle))


def ratio_of(overlap: float) -> float:
    return (pi + overlap) / (pi - overlap)


@pytest.mark.part
@over("scene", LINKAGES if parts.whole else LINKAGES[1::6])
def test_construction_and_analysis_agree_in_every_position(scene: Path) -> None:
    comparison = compare_extremes(study(scene.stem), compare(study(scene.stem)))
    assert comparison.agrees
    assert comparison.construction.gaps == () and study(scene.stem).met == ()
    assert np.nanmax(notches(study(scene.stem))) < WARNING


def test_the_shaper_s_slotted_link_swings_by_the_angle_that_its_strokes_differ_by() -> None:
    found = study("shaper").extreme_positions
    assert found is not None
    swing = 2 * asin(0.120 / 0.350)
    assert found.extremes.overlap == pytest.approx(swing, abs=ROUNDING)
    assert found.extremes.ratio == pytest.approx(ratio_of(swing), abs=ROUNDING)
    assert found.extremes.stroke == pytest.approx(2 * 0.700 * 0.120 / 0.350, abs=ROUNDING)


R, L, E = 0.045, 0.160, 0.010  # crank, rod, offset of the cylinder


def test_the_piston_of_the_offset_engine() -> None:
    phi, omega, found = crank("slider-crank"), -3000 * pi / 30, motion("slider-crank")
    across = R * np.cos(phi) - E
    height = np.sqrt(L**2 - across**2)
    speed = omega * (R * np.cos(phi) + across * R * np.sin(phi) / height)
    assert found.points["B"].r.real == pytest.approx(E, abs=ROUNDING)
    assert found.points["B"].r.imag == pytest.approx(R * np.sin(phi) + height, abs=ROUNDING)
    assert found.points["B"].v.imag == pytest.approx(speed, abs=ROUNDING * abs(omega))
    share = 0.050 / L  # of the mass centre along the rod
    place = (1 - share) * found.points["A"].r + share * found.points["B"].r
    assert found.points["S2"].r == pytest.approx(place, abs=ROUNDING)


def rocker_extremes(
    crank_length: float, rod: float, rocker: float, pivot: complex, side: int = 1
) -> tuple[complex, complex]:
    """Place the rocker's end with crank and rod in one line, stretched and folded."""
    return (
        circles_meet(0, rod + crank_length, pivot, rocker, side),
        circles_meet(0, rod - crank_length, pivot, rocker, side),
    )


def overlap_of(out: complex, back: complex) -> float:
    """Give the angle between the crank's lines in both extremes: by so much the strokes differ from half a turn."""
    return abs(cmath.phase(out / back))


def test_the_crank_rocker_obeys_grashof_and_draws_its_coupler_curve() -> None:
    assert 0.100 + 0.400 < 0.300 + 0.350
    found = motion("crank-rocker").points
    for a, b, e in zip(found["A"].r, found["B"].r, found["E"].r, strict=True):
        assert circles_meet(a, 0.400, 0.350, 0.300, 1) == pytest.approx(b, abs=ROUNDING)
        assert e == pytest.approx(a + (0.200 + 0.093j) * (b - a) / 0.400, abs=ROUNDING)


def test_khurmi_5_4_whitworth_s_time_ratio_and_stroke() -> None:
    found = study("whitworth").extreme_positions
    assert found is not None
    quick = 2 * acos(50 / 75)
    assert found.extremes.ratio == pytest.approx((2 * pi - quick) / quick, abs=ROUNDING)
    assert round(found.extremes.ratio, 3) == 2.735  # as it is printed
    assert found.extremes.stroke == pytest.approx(2 * 0.140, abs=ROUNDING)


def test_the_oscillating_cylinder_s_swing_time_ratio_and_stroke() -> None:
    found, moved = study("oscillating-cylinder").extreme_positions, motion("oscillating-cylinder").points["A"].r
    assert found is not None
    swing = 2 * asin(110 / 400)
    assert found.extremes.stroke == pytest.approx(swing, abs=ROUNDING)
    assert found.extremes.ratio == pytest.approx(ratio_of(swing), abs=ROUNDING)
    phi = crank("oscillating-cylinder")
    length = np.sqrt(0.400**2 + 0.110**2 + 2 * 0.400 * 0.110 * np.sin(phi))  # of the rod above the trunnions
    assert abs(moved + 0.400j) == pytest.approx(length, abs=ROUNDING)


def test_the_knuckle_joint_press_s_stroke_by_triangles() -> None:
    top = 0.580 + 0.250j
    down, up = rocker_extremes(0.070, 0.500, 0.250, top, side=-1)
    ram = [knee.imag - sqrt(0.250**2 - (knee.real - 0.580) ** 2) for knee in (down, up)]
    found = study("toggle-press").extreme_positions
    assert found is not None
    assert found.extremes.stroke == pytest.approx(ram[1] - ram[0], abs=ROUNDING)
    assert found.extremes.ratio == pytest.approx(ratio_of(overlap_of(down, up)), abs=ROUNDING)
    assert len(found.rests) == 2  # the knee does not pass its straight line
    assert np.degrees(asin((0.580 - down.real) / 0.250)) == pytest.approx(2.3, abs=0.05)


def test_the_jaw_crusher_s_swing_by_triangles() -> None:
    rear, jaw = 0.370 - 0.480j, -0.480 + 0.200j
    low, high = rocker_extremes(0.045, 0.600, 0.390, rear, side=-1)
    ends = [circles_meet(knee, 0.390, jaw, 0.690, 1) for knee in (low, high)]
    found = study("jaw-crusher").extreme_positions
    assert found is not None
    assert found.extremes.stroke == pytest.approx(abs(cmath.phase((ends[1] - jaw) / (ends[0] - jaw))), abs=ROUNDING)
    assert found.extremes.overlap == pytest.approx(overlap_of(low, high), abs=ROUNDING)
    assert ends[1].real < ends[0].real  # the eccentric's rise closes the jaw


def test_both_pistons_of_the_v_twin_and_the_quarter_of_a_turn_between_them() -> None:
    phi, found = crank("v-engine"), motion("v-engine").points
    for piston, bank in (("B", radians(135)), ("D", radians(45))):
        turned = phi - bank
        out = R * np.cos(turned) + np.sqrt(L**2 - (R * np.sin(turned)) ** 2)
        assert found[piston].r == pytest.approx(out * cmath.exp(1j * bank), abs=ROUNDING)
    assert 1j * np.roll(found["D"].r, 3) == pytest.approx(found["B"].r, abs=ROUNDING)


def test_the_conveyor_s_stroke_by_triangles() -> None:
    pivot = 0.260 - 0.050j
    out, back = rocker_extremes(0.090, 0.280, 0.200, pivot)
    trough = []
    for end in (out, back):
        upper = pivot + (end - pivot) * 320 / 200
        trough.append(upper.real + sqrt(0.340**2 - (upper.imag - 0.260) ** 2))
    found = study("conveyor").extreme_positions
    assert found is not None
    assert found.extremes.stroke == pytest.approx(trough[0] - trough[1], abs=ROUNDING)
    assert found.extremes.overlap == pytest.approx(overlap_of(out, back), abs=ROUNDING)


def test_jansen_s_leg_by_triangles() -> None:
    frame = -0.038 - 0.0078j
    for phi, foot in zip(crank("walking-leg"), motion("walking-leg").points["G"].r, strict=True):
        pin = 0.015 * cmath.exp(1j * phi)
        b = circles_meet(pin, 0.050, frame, 0.0415, -1)
        d = circles_meet(frame, 0.0401, b, 0.0558, 1)
        e = circles_meet(pin, 0.0619, frame, 0.0393, 1)
        f = circles_meet(d, 0.0394, e, 0.0367, -1)
        assert circles_meet(e, 0.0490, f, 0.0657, 1) == pytest.approx(foot, abs=ROUNDING)


def test_the_published_lengths_of_jansen_s_leg_stand_in_its_scene() -> None:
    published = [38, 41.5, 39.3, 40.1, 55.8, 39.4, 36.7, 65.7, 49, 50, 61.9, 7.8, 15]  # a to m
    tables = tomllib.loads((GALLERY / "walking-leg.toml").read_text("utf-8"))["mechanism"]
    given = [float(length.removesuffix(" mm")) for length in tables["lengths"].values()]
    place = [abs(float(part.removesuffix(" mm"))) for part in tables["frame"]["C"]]
    assert sorted(given + place) == sorted(published)
