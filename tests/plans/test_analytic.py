"""The analytic road: worked values, textbook cases, derivatives by differences, and rounding."""

from __future__ import annotations

import cmath
from dataclasses import replace
from math import asin, cos, pi, radians, sin, sqrt, tan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plans.analytic.kinematics import Analysis, solve
from plans.model.mechanism import Mechanism, Output
from plans.model.motion import Motion
from tests.parts import examples, several
from tests.plans import linkages

EPS = float(np.finfo(float).eps)
INCH, FOOT = 0.0254, 0.3048
DIGITS = 5e-10  # values printed with ten digits: half a unit of the tenth of a value that begins with 1
TURN = np.arange(12) * (pi / 6)


def crank_rocker(**kinds: float) -> Mechanism:
    coupler = {"S": cmath.rect(0.22, radians(25))}
    return linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j}, coupler=coupler, **kinds)


def at(mechanism: Mechanism, *degrees: float) -> Motion:
    return solve(mechanism, np.radians(degrees))


def rva(motion: Motion, point: str) -> tuple[complex, complex, complex]:
    found = motion.points[point]
    return complex(found.r[0]), complex(found.v[0]), complex(found.a[0])


def spin(motion: Motion, link: int) -> tuple[float, float, float]:
    found = motion.links[link]
    return float(np.degrees(found.angle[0])), float(found.omega[0]), float(found.epsilon[0])


def printed(*values: complex) -> object:
    return pytest.approx(values, rel=DIGITS, abs=1e-12)


# The worked values of the method descriptions


def test_four_bar_position():
    motion = at(crank_rocker(), 60)
    assert rva(motion, "A")[:1] == printed(0.05 + 0.08660254038j)
    assert rva(motion, "B")[:1] == printed(0.3899961058 + 0.2973218988j)
    assert (spin(motion, 2)[0], spin(motion, 3)[0]) == printed(31.78938948, 82.33849477)
    crossed = replace(crank_rocker(), sketch={"B": 0.2 - 0.3j})
    assert rva(at(crossed, 60), "B")[:1] == printed(0.2253885096 - 0.2728955413j)


def test_four_bar_plans():
    motion = at(crank_rocker(), 60)
    assert rva(motion, "A")[1:] == printed(-0.8660254038 + 0.5j, -5.433012702 - 8.410254038j)
    assert rva(motion, "B")[1:] == printed(-0.6067243978 + 0.08161730877j, -11.53882903 + 0.2917119375j)
    assert spin(motion, 2)[1:] == printed(-1.230551421, 26.53280153)
    assert spin(motion, 3)[1:] == printed(2.040631384, 38.24904333)
    expected = 0.1704979981 + 0.2706683777j, -0.6395229261 + 0.3517210172j, -10.49925994 - 5.491827515j
    assert rva(motion, "S") == printed(*expected)


def test_slider_crank_plans():
    motion = at(linkages.slider_crank(0.06, 0.20, 0.02), 60)
    r, v, a = rva(motion, "B")
    assert (r, v.real, a.real) == printed(0.2274296355 + 0.02j, -0.5681816961, -2.91070085)
    assert (v.imag, a.imag) == pytest.approx((0, 0), abs=16 * EPS)
    assert spin(motion, 2)[1:] == printed(-1.519528713, 25.18545045)


def test_slotted_link_plans():
    motion = at(linkages.slotted_link(0.12, 0.35, 0.70), 60)
    assert spin(motion, 3) == printed(82.47023729, 2.421846089, 6.375934305)
    assert spin(motion, 2) == spin(motion, 3)
    under = (rva(motion, "A")[0] - rva(motion, "C")[0]) * (1j * 6.375934305 - 2.421846089**2)
    assert under == pytest.approx(-3.246103845 - 2.279856265j, rel=1e-9)


def test_scotch_yoke():
    r, v, a = rva(at(linkages.scotch_yoke(0.1), 60), "D")
    assert (r.imag, v.imag, a.imag) == printed(0.08660254038, 0.5, -8.410254038)
    assert (r.real, v.real, a.real) == pytest.approx((0, 0, 0), abs=16 * EPS)


def test_tangent_mechanism():
    r, v, a = rva(at(linkages.tangent_mechanism(0.15), 20), "A")
    assert (r.imag, v.imag, a.imag) == printed(0.05459553514, 0.3397422994, -0.01498911189)
    assert r.real == pytest.approx(0.15, abs=EPS)


def test_six_link_shaper():
    motion = at(linkages.shaper(), 60)
    assert rva(motion, "A")[:1] == printed(0.06 + 0.1039230485j)
    expected = 0.09172883154 + 0.3439638474j, -1.68067363 + 0.2221531119j, -4.962688547 - 3.485475855j
    assert rva(motion, "B") == printed(*expected)
    r, v, a = rva(motion, "D")
    assert (r, v.real, a.real) == printed(0.2911520553 + 0.3287856445j, -1.697581816, -4.946314486)
    assert spin(motion, 3)[1:] == printed(2.421846089, 6.375934305)
    assert spin(motion, 4)[1:] == printed(-1.113978141, 17.383334)
    assert rva(motion, "S3")[2:] == printed(-2.481344273 - 1.742737927j)
    assert rva(motion, "S4")[2:] == printed(-4.954501516 - 1.742737927j)


# Extreme positions


def test_extremes_of_the_crank_rocker():
    found = Analysis(crank_rocker()).extremes(Output(3, None))
    assert found is not None and not found.sliding
    assert np.degrees(found.phi) == printed(36.18228722, 234.3146653)
    assert (np.degrees(found.overlap), np.degrees(found.stroke)) == printed(18.13237807, 45.97189532)
    assert found.ratio == pytest.approx(1.224039593, rel=DIGITS)
    backward = Analysis(crank_rocker(omega=-1.0)).extremes(Output(3, None))
    assert backward is not None
    assert backward.phi == found.phi[::-1] and backward.overlap == found.overlap


def test_extremes_of_the_slider_crank():
    found = Analysis(linkages.slider_crank(0.06, 0.20, 0.02)).extremes(Output(3, "B"))
    assert found is not None and found.sliding
    assert found.reach == printed(0.2592296279, 0.1385640646)
    assert (found.stroke, np.degrees(found.overlap)) == printed(0.1206655633, 3.801484916)
    assert found.ratio == pytest.approx(1.043150022, rel=DIGITS)


def test_extremes_of_the_slotted_link():
    found = Analysis(linkages.slotted_link(0.12, 0.35, 0.70)).extremes(Output(3, None))
    assert found is not None
    assert np.degrees(found.phi) == pytest.approx((360 - 20.05104257, 360 - 159.9489574), rel=1e-9)
    assert np.degrees(found.stroke) == pytest.approx(40.10208513, rel=DIGITS)
    assert found.overlap == pytest.approx(found.stroke, rel=8 * EPS)
    assert found.ratio == pytest.approx(1.573304973, rel=DIGITS)


def test_extremes_are_exact():
    a, b, e = 0.06, 0.20, 0.02
    found = Analysis(linkages.slider_crank(a, b, e)).extremes(Output(3, "B"))
    assert found is not None
    assert found.phi[0] == pytest.approx(asin(e / (a + b)), abs=8 * EPS)
    assert found.phi[1] == pytest.approx(pi + asin(e / (b - a)), abs=8 * EPS)
    assert found.stroke == pytest.approx(sqrt((b + a) ** 2 - e**2) - sqrt((b - a) ** 2 - e**2), abs=4 * EPS)


def test_equal_strokes_begin_at_the_smaller_crank_angle():
    found = Analysis(linkages.slider_crank(0.1, 0.3)).extremes(Output(3, "B"))
    assert found is not None
    assert found.phi == pytest.approx((0, pi), abs=8 * EPS)
    assert found.overlap == pytest.approx(0, abs=16 * EPS)


@pytest.mark.parametrize(
    ("mechanism", "link"),
    several(
        [
            (linkages.slotted_link(0.30, 0.10, 0.50), 3),  # turns fully: Whitworth's
            (linkages.four_bar(0.3, 0.2, 0.25, 0.4, sketch={"B": 0.45 + 0.25j}), 3),  # the crank rocks
            (linkages.four_bar(0.2, 0.1, 0.25, 0.3, sketch={"B": 0.25 + 0.2j}), 1),  # the crank itself
            (linkages.parallelogram(0.1, 0.3), 2),  # stands still, and passes change points
        ],
        2,
    ),
)
def test_an_output_without_extremes(mechanism, link):
    assert Analysis(mechanism).extremes(Output(link, None)) is None


# Textbook cases; the values are computed independently of any drawing


def speed(motion: Motion, point: str, other: str = "O") -> float:
    return abs(rva(motion, point)[1] - rva(motion, other)[1])


def tangential(motion: Motion, link: int, length: float) -> float:
    return abs(spin(motion, link)[2]) * length


def test_khurmi_8_4():
    motion = at(linkages.four_bar(0.0625, 0.175, 0.1125, 0.2, sketch={"B": 0.2 + 0.1j}, omega=10, epsilon=0), 60)
    assert (speed(motion, "B", "A"), speed(motion, "B")) == pytest.approx((0.3465046, 0.4260456), abs=1e-7)
    assert np.abs([spin(motion, k)[1] for k in (2, 3)]) == pytest.approx((1.98002602, 3.78707234), abs=1e-8)
    assert np.abs([spin(motion, k)[2] for k in (2, 3)]) == pytest.approx((23.3675698, 46.1434599), abs=1e-7)
    assert (tangential(motion, 2, 0.175), tangential(motion, 3, 0.1125)) == pytest.approx(
        (4.089325, 5.191139), abs=1e-6
    )


def test_khurmi_8_1():
    mechanism = linkages.slider_crank(0.15, 0.6, rod={"D": 0.3}, omega=300 * pi / 30, epsilon=0)
    motion = at(mechanism, 45)
    assert speed(motion, "B", "A") == pytest.approx(3.38548, abs=1e-5)
    assert (speed(motion, "B"), speed(motion, "D")) == pytest.approx((3.9306362, 3.995358), abs=1e-6)
    assert [abs(rva(motion, p)[2]) for p in "BD"] == pytest.approx((105.28947, 117.3104), abs=5e-5)
    assert np.abs(spin(motion, 2)[1:]) == pytest.approx((5.642467, 171.54516), abs=5e-6)
    assert tangential(motion, 2, 0.6) == pytest.approx(102.9271, abs=5e-5)


def test_khurmi_8_5():
    motion = at(linkages.four_bar(0.3, 0.36, 0.36, 0.6, sketch={"B": 0.45 + 0.3j}, omega=-10, epsilon=-30), 60)
    assert speed(motion, "B") == pytest.approx(2.166945, abs=1e-6)
    assert np.abs([spin(motion, k)[1] for k in (2, 3)]) == pytest.approx(6.01929265, abs=1e-8)
    assert np.abs([spin(motion, k)[2] for k in (2, 3)]) == pytest.approx((38.0185545, 77.4514993), abs=1e-7)
    assert abs(rva(motion, "B")[2]) == pytest.approx(30.7826, abs=5e-5)


def test_khurmi_7_1():
    omega = 120 * pi / 30
    motion = at(linkages.four_bar(0.04, 0.15, 0.08, 0.15, sketch={"B": 0.15 + 0.08j}, omega=omega, epsilon=0), 60)
    assert (speed(motion, "B"), speed(motion, "B", "A")) == pytest.approx((0.3827657, 0.1962938), abs=1e-7)
    assert spin(motion, 2)[1:] == pytest.approx((-1.30862513, 31.385444), rel=1e-7)
    assert spin(motion, 3)[1:] == pytest.approx((4.78457095, 56.884349), rel=1e-7)


def test_khurmi_7_2():
    mechanism = linkages.slider_crank(0.5, 2.0, rod={"E": 0.5}, omega=180 * pi / 30, epsilon=0)
    motion = at(mechanism, 45)
    found = speed(motion, "B"), speed(motion, "B", "A"), abs(spin(motion, 2)[1]), speed(motion, "E")
    assert found == pytest.approx((7.8612724, 6.77096, 3.3854802, 8.571676), abs=5e-7)


def test_khurmi_15_1():
    motion = at(linkages.slider_crank(0.2, 0.7, rod={"D": 0.35}, omega=120, epsilon=0), 30)
    assert (speed(motion, "B"), speed(motion, "D")) == pytest.approx((15.0, 17.03673), abs=5e-6)
    assert [abs(rva(motion, p)[2]) for p in "BD"] == pytest.approx((2922.8357, 2802.56), abs=5e-3)
    assert np.abs(spin(motion, 2)[1:]) == pytest.approx((30.0, 1948.5572), abs=5e-5)


def test_khurmi_15_2():
    motion = at(linkages.slider_crank(0.15, 0.6, rod={"D": 0.15}, omega=450 * pi / 30, epsilon=0), 60)
    assert (speed(motion, "B"), speed(motion, "D")) == pytest.approx((6.9053599, 6.851085), abs=5e-7)
    assert [abs(rva(motion, p)[2]) for p in "BD"] == pytest.approx((124.94934, 266.818), abs=5e-4)
    assert np.abs(spin(motion, 2)[1:]) == pytest.approx((6.0335958, 484.39471), abs=5e-6)


def test_bevan_3_5():
    a, b, c, d = (length * INCH for length in (2.5, 7, 4.5, 8))
    omega = 100 * pi / 30
    motion = at(linkages.four_bar(a, b, c, d, sketch={"B": 0.2 + 0.1j}, omega=omega, epsilon=0), 60)
    assert speed(motion, "B") / FOOT == pytest.approx(1.48718, abs=5e-6)
    assert speed(motion, "B", "A") / FOOT == pytest.approx(1.20953, abs=5e-6)
    assert np.abs([spin(motion, k)[2] for k in (2, 3)]) == pytest.approx((25.6254078, 50.6019661), abs=1e-7)
    found = tangential(motion, 2, b) / FOOT, tangential(motion, 3, c) / FOOT
    assert found == pytest.approx((14.94816, 18.97573), abs=1e-5)  # printed from lengths already rounded


# Derivatives and rounding

ALL = {
    "four-bar": crank_rocker(),
    "slider-crank": linkages.slider_crank(0.06, 0.20, 0.02),
    "slotted link": linkages.slotted_link(0.12, 0.35, 0.70),
    "Whitworth": linkages.slotted_link(0.30, 0.10, 0.50),
    "yoke": linkages.scotch_yoke(0.1),
    "shaper": linkages.shaper(),
    "triad": linkages.triad(),
}


@pytest.mark.parametrize("name", ALL)
def test_rates_are_the_derivatives_of_positions(name):
    mechanism, step = ALL[name], EPS ** (1 / 5)
    omega, epsilon = mechanism.drive.omega, mechanism.drive.epsilon
    phi = 1.0 + np.array([-2, -1, 0, 1, 2]) * step
    motion = solve(mechanism, phi)
    assert not motion.gaps
    for point, found in motion.points.items():
        first = (found.r[0] - 8 * found.r[1] + 8 * found.r[3] - found.r[4]) / (12 * step)
        second = (found.v[0] - 8 * found.v[1] + 8 * found.v[3] - found.v[4]) / (12 * step)
        error = 1e-9 * max(1.0, abs(found.v).max(), abs(found.a).max() / omega)  # of order step^4 = eps^(4/5) = 3e-13
        assert abs(found.v[2] - omega * first) < error, point
        assert abs(found.a[2] - omega * second - epsilon / omega * found.v[2]) < omega * error, point


@examples(3)
@given(phi=st.floats(-20, 20))
def test_slider_crank_to_rounding_level(phi):
    a, b, e = 0.06, 0.20, 0.02
    motion = solve(linkages.slider_crank(a, b, e), np.array([phi]), 1)
    exact = a * cos(phi) + sqrt(b**2 - (e - a * sin(phi)) ** 2)
    # Errors of a few roundings of the largest length, magnified by the condition (6 at most here).
    assert motion.points["B"].r[0] == pytest.approx(complex(exact, e), abs=8 * EPS * (a + b))
    assert -pi < motion.links[2].angle[0] <= pi


def test_tangent_mechanism_over_its_stroke():
    phi = np.radians([-80, -45, 0, 45, 80])
    found = solve(linkages.tangent_mechanism(0.15), phi, 0).points["A"].r
    assert found.imag == pytest.approx([0.15 * tan(angle) for angle in phi], rel=64 * EPS, abs=EPS)


@pytest.mark.parametrize("scale", [1e-6, 1e6])
def test_size_changes_nothing(scale):
    small = solve(crank_rocker(), TURN).points["B"]
    sketch = {"B": (0.4 + 0.3j) * scale}
    large = solve(linkages.four_bar(0.1 * scale, 0.4 * scale, 0.3 * scale, 0.35 * scale, sketch=sketch), TURN).points[
        "B"
    ]
    assert large.r / scale == pytest.approx(small.r, rel=16 * EPS)
    assert large.a / scale == pytest.approx(small.a, rel=1e4 * EPS)


def test_many_positions_agree_with_few():
    few = solve(ALL["shaper"], TURN)
    many = solve(ALL["shaper"], np.arange(3000) * (2 * pi / 3000))
    for point, found in few.points.items():
        assert many.points[point].r[::250] == pytest.approx(found.r, abs=16 * EPS)


def test_turns_and_sense_do_not_matter():
    forth = solve(crank_rocker(), 1.0 + TURN).points["B"].r
    back = solve(crank_rocker(), 1.0 - TURN).points["B"].r
    later = solve(crank_rocker(), 1.0 + TURN + 6 * pi).points["B"].r
    assert back[1:] == pytest.approx(forth[:0:-1], abs=8 * EPS)
    assert later == pytest.approx(forth, abs=64 * EPS)


def test_only_what_is_asked_for():
    motion = solve(crank_rocker(), TURN, order=1)
    assert motion.by == "analysis" and motion.order == 1
    assert len(motion.points["B"]) == len(motion.links[3]) == 2
    positions = solve(crank_rocker(), TURN, order=0)
    assert len(positions.points["B"]) == len(positions.links[3]) == 1


def test_frame_points_stand():
    found = solve(crank_rocker(), TURN).points["C"]
    assert np.array_equal(found.r, np.full(12, 0.35)) and not np.any(found.v) and not np.any(found.a)


def test_blocks_turn_with_their_slot_and_never_end_for_end():
    motion = solve(ALL["Whitworth"], TURN)
    assert motion.links[2].angle == pytest.approx(motion.links[3].angle, abs=8 * EPS)
