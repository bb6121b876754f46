"""The analytic road: worked mechanisms, extremes, derivatives by differences, and rounding."""

from __future__ import annotations

import cmath
from dataclasses import replace
from math import asin, pi, radians, sqrt

import numpy as np
import pytest

from plans.analytic.kinematics import Analysis, solve
from plans.model.mechanism import Mechanism, Output
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


@pytest.mark.parametrize("scale", [1e-6, 1e6])
def test_size_changes_nothing(scale):
    small = solve(crank_rocker(), TURN).points["B"]
    sketch = {"B": (0.4 + 0.3j) * scale}
    large = solve(linkages.four_bar(0.1 * scale, 0.4 * scale, 0.3 * scale, 0.35 * scale, sketch=sketch), TURN).points[
        "B"
    ]
    assert large.r / scale == pytest.approx(small.r, rel=16 * EPS)
    assert large.a / scale == pytest.approx(small.a, rel=1e4 * EPS)
