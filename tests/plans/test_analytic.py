"""The analytic road: worked mechanisms, extremes, derivatives by differences, and rounding."""

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
from tests.parts import examples, several
from tests.plans import linkages
from tests.plans.studies import study_of

EPS = float(np.finfo(float).eps)
TURN = np.arange(12) * (pi / 6)


def crank_rocker(**kinds: float) -> Mechanism:
    coupler = {"S": cmath.rect(0.22, radians(25))}
    return linkages.four_bar(0.1, 0.4, 0.3, 0.35, sketch={"B": 0.4 + 0.3j}, coupler=coupler, **kinds)


# Extreme positions


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


WORKED = {**{name: ALL[name] for name in ALL if name != "triad"}, "tangent": linkages.tangent_mechanism(0.15)}
WORKED["crossed"] = replace(crank_rocker(), sketch={"B": 0.2 - 0.3j})


@pytest.mark.parametrize("name", WORKED)
def test_the_worked_mechanisms_move_as_they_are_constructed(name):
    """What the construction finds of them is held to the last printed digit in test_construction."""
    drawn = study_of(WORKED[name], positions=[20, 60]).motion()
    motion = solve(WORKED[name], drawn.phi)
    for ours, theirs in ((motion.points, drawn.points), (motion.links, drawn.links)):
        assert ours.keys() == theirs.keys()
        for key, found in ours.items():
            for row, expected in zip(found, theirs[key], strict=True):
                assert row == pytest.approx(expected, rel=1e-13, abs=1e-12), key


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
