"""Graphical calculus: what chords and tangents give, how fast it nears the truth, and what must not change it."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import strategies as st

from geometry.board import Board, Mark
from geometry.calculus import Derivative, Integral, derivative_by_chords, derivative_by_tangents, integral
from geometry.meet import EPS
from geometry.precision import errors
from geometry.replay import exact
from geometry.strips import Floats, middles, strips
from plans.words.calculus import REASONS
from tests import parts
from tests.rows import over

LIFT, PHASE = 0.03, math.radians(120)  # of a follower: m, rad


def printed(value: float, digits: int) -> str:
    return f"{value:.{digits}g}"


def cosine_law(phi: Any) -> Any:
    """S'' of the cosine law, m/rad2."""
    return LIFT * math.pi**2 / (2 * PHASE**2) * np.cos(np.pi * phi / PHASE)


def drawn(edges: Any, means: Any, **further: Any) -> Integral:
    return integral(Board("works"), "A", edges, means, **further)


# Worked values


def test_the_cosine_law_integrated_on_paper_is_read_with_its_scale() -> None:
    """120 degrees are 120 mm; S'' in mm at 0.001 a mm, poles at 40 and 30 mm."""
    mu_phi = PHASE / 120
    first, second = 0.001 * mu_phi * 40, 0.001 * mu_phi**2 * 40 * 30
    assert [printed(mu, 10) for mu in (mu_phi, first, second)] == [
        "0.01745329252",
        "0.0006981317008",
        "0.0003655409037",
    ]
    edges = strips(0, 120, 8)
    curve = drawn(edges, cosine_law(middles(edges) * mu_phi) / 0.001, pole=40.0)
    assert printed(curve.points[4].point.imag * first, 10) == "0.02264522721"
    assert curve.values[4] == pytest.approx(curve.points[4].point.imag * 40, rel=4 * EPS, abs=0)


# Orders


# Rounding


def true_sums(edges: Floats, means: Floats, start: float) -> list[Fraction]:
    x = [Fraction(one) for one in edges.tolist()]
    found = [Fraction(start)]
    for k, mean in enumerate(means.tolist()):
        found.append(found[-1] + Fraction(mean) * (x[k + 1] - x[k]))
    return found


FAR = 6.0 + 1e-6 * np.arange(4)
EXTREME = [
    (FAR, np.array([1e9, -1e9, 1e9]), 0.0),  # strips that a place on the axis would cost ten digits
    (FAR, np.array([1e9, -1e9, 1e9]), 1e-3),
    (1e-9 * np.arange(5), np.array([1e-9, 1e9, -1.0, 3.0]), 7e8),
    (np.array([-5.0, -5.0 + 1e-6, 1e3]), np.array([-1e9, 1e-9]), 0.0),
    (np.linspace(0, 1e6, 4097), 1e9 * np.cos(np.arange(4096.0)), 0.0),
    (np.linspace(0, 4096e-6, 4097), 10.0 ** (18 * np.sin(np.arange(4096.0)) ** 2 - 9), -1e-5),
]


@pytest.mark.part
@over("pole", [1.0, 25.0, 3e-3, 1e9] if parts.whole else [25.0])
@over("edges, means, start", EXTREME)
def test_values_lie_within_a_few_roundings_a_strip_of_the_true_sums(
    edges: Floats, means: Floats, start: float, pole: float
) -> None:
    curve = drawn(edges, means, pole=pole, start=start)
    true = true_sums(edges, means, start)
    off = [abs(float(Fraction(value) - sum_)) for value, sum_ in zip(curve.values.tolist(), true, strict=True)]
    assert np.all(np.array(off) <= curve.slacks)
    areas = np.abs(means * np.diff(edges)).sum() + abs(start)
    assert curve.slacks[-1] <= EPS * (len(means) + 8) * areas


@over("pole", [1.0, 25.0, 3e-3, 1e9])
@over("scale", [1e-9, 1.0, 1e9])
def test_slopes_lie_within_a_few_roundings_of_the_true_ones(pole: float, scale: float) -> None:
    xs = np.array([6.0, 6.0 + 1e-6, 7.3, 100.0])
    ys = scale * np.array([0.1, 0.1000003, -4.7, 3.9])
    curve = derivative_by_chords(Board("slopes"), "S", xs, ys, pole=pole)
    x, y = ([Fraction(one) for one in row.tolist()] for row in (xs, ys))
    true = [(y[k + 1] - y[k]) / (x[k + 1] - x[k]) for k in range(3)]
    off = [abs(float(Fraction(a) - b)) for a, b in zip(curve.values.tolist(), true, strict=True)]
    assert np.all(np.array(off) <= curve.slacks)
    tangent = derivative_by_tangents(Board("slopes"), "S", xs, ys, ys, pole=pole)
    assert np.all(np.abs(tangent.values - ys) <= tangent.slacks)


# What must not change the values


means = st.floats(-1e3, 1e3)
# The record


def diagram() -> tuple[Integral, Derivative, Derivative]:
    edges = strips(0, 2.0, 6, [0.5])
    curve = integral(Board("works"), "A", edges, np.exp(middles(edges)), pole=2.0, start=0.3, why=REASONS)
    chords = derivative_by_chords(Board("slopes"), "v", edges, np.exp(edges), 2.0, [0.5], REASONS)
    tangents = derivative_by_tangents(Board("tangents"), "v", edges, np.exp(edges), np.exp(edges), 2.0, REASONS)
    return curve, chords, tangents


def records() -> list[tuple[Mark, ...]]:
    return [one.points for one in diagram()]


def test_fifty_digits_agree_and_the_bounds_of_the_record_hold() -> None:
    for points in records():
        bounds, truth = errors(*points), exact(list(points))
        for one in points:
            off = abs(complex(one.point) - complex(truth[one]))
            assert off <= float(bounds[one].place.item()) <= 1e-11


def test_a_corner_has_the_tangents_of_both_its_sides() -> None:
    curve = derivative_by_tangents(Board("slopes"), "v", [0, 1, 1, 2], [0, 1, 1, 0], [1, 3, -2, -1])
    assert [curve.values[piece].tolist() for piece in curve.pieces] == [[1, 3], [-2, -1]]
    assert curve.middles.tolist() == [complex(one.point).real for one in curve.points] == [0, 1, 1, 2]


# What cannot be drawn


@pytest.mark.parametrize("edges", [[0.0], [0, 0], [0, 1, 1], [1, 0], [0, math.nan]])
def test_edges_that_do_not_rise_are_refused(edges: list[float]) -> None:
    with pytest.raises(ValueError, match="each beyond the last"):
        drawn(edges, [1.0] * (len(edges) - 1))
    with pytest.raises(ValueError, match="each beyond the last"):
        derivative_by_chords(Board("slopes"), "v", edges, edges)


def test_strips_and_means_that_differ_in_number_are_refused() -> None:
    with pytest.raises(ValueError, match="each of 2 strips, found 3"):
        drawn([0, 1, 2], [1, 2, 3])


@pytest.mark.parametrize("pole", [0.0, -1.0, math.nan, math.inf])
def test_a_pole_that_is_not_on_the_left_is_refused(pole: float) -> None:
    with pytest.raises(ValueError, match="more than 0"):
        drawn([0, 1], [1], pole=pole)


def test_a_corner_inside_a_part_is_refused() -> None:
    with pytest.raises(ValueError, match="every break must be an edge"):
        derivative_by_chords(Board("slopes"), "v", [0, 1, 2], [0, 1, 0], breaks=[0.5])


def test_a_line_too_steep_to_be_told_from_an_ordinate_is_refused() -> None:
    with pytest.raises(ValueError, match="greater pole distance"):
        drawn([0, 1], [1e9], pole=1e-4)
    assert drawn([0, 1], [1e9], pole=1e-3).values.tolist() == [0, 1e9]
    with pytest.raises(ValueError, match="larger unit"):
        derivative_by_chords(Board("slopes"), "v", [0, 1e-6], [0, 1e7])
    with pytest.raises(ValueError, match="larger unit"):
        derivative_by_tangents(Board("slopes"), "v", [0], [0], [-1e13])


def test_a_ray_of_a_derivative_is_parallel_to_its_chord_and_its_point_stands_over_the_middle() -> None:
    curve = diagram()[1]
    for k, point in enumerate(curve.points):
        assert curve.rays[k].step.inputs == (curve.pole, curve.directions[k])
        assert complex(point.point).real == pytest.approx(curve.middles[k], rel=8 * EPS, abs=0)
