"""Graphical calculus: what chords and tangents give, how fast it nears the truth, and what must not change it."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from drawings.commands.explain import sentence
from geometry.board import Board, Mark
from geometry.calculus import (
    Derivative,
    Integral,
    derivative_by_chords,
    derivative_by_tangents,
    integral,
)
from geometry.meet import EPS
from geometry.precision import errors
from geometry.replay import exact
from geometry.steps import behind
from geometry.strips import Floats, middles, strips
from plans.explanation import Explanation
from plans.words.calculus import REASONS
from plans.words.words import message
from tests import parts
from tests.parts import examples
from tests.rows import over

Function = Callable[[Any], Any]
COUNTS = (12, 24, 96, 384, 1024, 4096)
LIFT, PHASE = 0.03, math.radians(120)  # of a follower: m, rad
LOAD, FROM, TO = 2000.0, 0.3, 2.1  # of a planing machine's load over an angle, with both its jumps


def printed(value: float, digits: int) -> str:
    return f"{value:.{digits}g}"


def cosine_law(phi: Any) -> Any:
    """S'' of the cosine law, m/rad2."""
    return LIFT * math.pi**2 / (2 * PHASE**2) * np.cos(np.pi * phi / PHASE)


def cosine_law_first(phi: Any) -> Any:
    """S' of the cosine law, m/rad."""
    return LIFT * math.pi / (2 * PHASE) * np.sin(np.pi * phi / PHASE)


def sine_law(phi: Any) -> Any:
    """S of the sine law, m."""
    return LIFT * (phi / PHASE - np.sin(2 * np.pi * phi / PHASE) / (2 * np.pi))


def sine_law_first(phi: Any) -> Any:
    """S' of the sine law, m/rad."""
    return LIFT / PHASE * (1 - np.cos(2 * np.pi * phi / PHASE))


def drawn(edges: Any, means: Any, **further: Any) -> Integral:
    return integral(Board("works"), "A", edges, means, **further)


def order(errors: list[float], counts: tuple[int, ...] = COUNTS) -> float:
    return math.log(errors[0] / errors[-1]) / math.log(counts[-1] / counts[0])


# Worked values


def test_the_cosine_law_integrated_in_eight_parts() -> None:
    edges = strips(0, PHASE, 8)
    curve = drawn(edges, cosine_law(middles(edges)))
    middle = curve.values[4]
    assert printed(middle, 10) == "0.02264522721"
    assert printed(cosine_law_first(PHASE / 2), 10) == "0.0225"
    assert printed(middle / 0.0225 - 1, 8) == "0.0064545428"
    assert middle / 0.0225 - 1 == pytest.approx((math.pi / 16) / math.sin(math.pi / 16) - 1, rel=1e-12, abs=0)
    assert abs(curve.values[-1]) <= curve.slacks[-1]  # it closes


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


def test_the_sine_law_differentiated_by_chords_in_twelve_parts() -> None:
    edges = strips(0, PHASE, 12)
    curve = derivative_by_chords(Board("slopes"), "S", edges, sine_law(edges))
    true = float(sine_law_first(curve.middles[4]))
    assert (printed(curve.values[4], 10), printed(true, 10)) == ("0.02433719921", "0.02445250344")
    assert printed(curve.values[4] / true - 1, 9) == "-0.00471543641"
    assert complex(curve.points[4].point) == pytest.approx(complex(PHASE * 4.5 / 12, curve.values[4]), rel=1e-14)


def test_the_tangent_of_the_sine_law_on_paper_returns_its_slope() -> None:
    """S at 0.0005 m a mm, a degree a mm, the pole at 25 mm."""
    mu_phi, mu_s = PHASE / 120, 0.0005
    mu = mu_s / (mu_phi * 25)
    assert printed(mu, 9) == "0.00114591559"
    phi = 4 * PHASE / 12
    slope = float(sine_law_first(phi)) * mu_phi / mu_s  # on paper
    curve = derivative_by_tangents(Board("slopes"), "S", [40.0], [sine_law(phi) / mu_s], [slope], pole=25.0)
    assert printed(math.degrees(np.angle(curve.directions[0].point)), 10) == "36.86989765"
    assert curve.points[0].point.imag * mu == pytest.approx(sine_law_first(phi), rel=4 * EPS, abs=0)
    assert curve.points[0].point.real == pytest.approx(40, rel=EPS)


# Orders


def largest(edges: Floats, function: Function, whole: Function) -> float:
    curve = drawn(edges, function(middles(edges)))
    return float(np.max(np.abs(curve.values - (whole(edges) - whole(edges[0])))))


def planed(x: Any) -> Any:
    return np.where((x > FROM) & (x < TO), LOAD * np.sin(x), 0.0)


def planed_whole(x: Any) -> Any:
    return -LOAD * np.cos(np.clip(x, FROM, TO))


def test_with_its_jumps_on_edges_a_load_is_of_the_second_order() -> None:
    off = [largest(strips(0, 2 * math.pi, count, [FROM, TO]), planed, planed_whole) for count in COUNTS]
    assert order(off) == pytest.approx(2.0, abs=0.1)


def test_chords_differentiate_in_the_second_order() -> None:
    off = []
    for count in COUNTS:
        edges = strips(0, PHASE, count)
        curve = derivative_by_chords(Board("slopes"), "S", edges, sine_law(edges))
        off.append(float(np.max(np.abs(curve.values - sine_law_first(curve.middles)))))
    assert order(off) == pytest.approx(2.0, abs=0.1)


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


def test_an_unknown_mean_leaves_all_after_it_unknown() -> None:
    values = drawn([0, 1, 2, 3], [1.0, math.nan, 1.0]).values
    assert values[:2].tolist() == [0.0, 1.0]
    assert np.isnan(values[2:]).all()


# What must not change the values


means = st.floats(-1e3, 1e3)
diagrams = st.lists(st.tuples(st.floats(1e-3, 10), means), min_size=1, max_size=8).map(
    lambda rows: (np.cumsum([0.0, *(width for width, _ in rows)]), np.array([mean for _, mean in rows]))
)


@example((np.array([0.0, 1.0]), np.array([5e-324])), 2.0)
@examples(6)
@given(diagrams, st.floats(1e-3, 1e3))
def test_a_pole_elsewhere_changes_the_curve_and_not_the_values(diagram: tuple[Floats, Floats], pole: float) -> None:
    one, other = drawn(*diagram), drawn(*diagram, pole=pole)
    assert np.all(np.abs(one.values - other.values) <= one.slacks + other.slacks)
    heights = np.array([mark.point.imag for mark in other.points])
    assert heights * pole == pytest.approx(one.values, rel=1e-9, abs=1e-9)


@examples(6)
@given(diagrams)
def test_a_derivative_of_an_integral_is_the_diagram_again(diagram: tuple[Floats, Floats]) -> None:
    curve = drawn(*diagram)
    again = derivative_by_chords(Board("slopes"), "A", curve.edges, curve.values)
    slack = 2 * curve.slacks[1:] / np.diff(curve.edges) + again.slacks
    assert np.all(np.abs(again.values - curve.means) <= slack)


# The record


def diagram() -> tuple[Integral, Derivative, Derivative]:
    edges = strips(0, 2.0, 6, [0.5])
    curve = integral(Board("works"), "A", edges, np.exp(middles(edges)), pole=2.0, start=0.3, why=REASONS)
    chords = derivative_by_chords(Board("slopes"), "v", edges, np.exp(edges), 2.0, [0.5], REASONS)
    tangents = derivative_by_tangents(Board("tangents"), "v", edges, np.exp(edges), np.exp(edges), 2.0, REASONS)
    return curve, chords, tangents


def records() -> list[tuple[Mark, ...]]:
    return [one.points for one in diagram()]


def test_a_chord_is_parallel_to_its_ray_and_joins_two_points_of_the_curve() -> None:
    curve = diagram()[0]
    assert complex(curve.pole.point) == -2
    for k, ray in enumerate(curve.rays):
        assert complex(ray.point) == complex(2.0, curve.means[k])
        assert complex(curve.carried[k].point) == complex(0, curve.means[k])
        assert curve.chords[k].step.inputs == (curve.points[k], ray)
        chord = complex(curve.points[k + 1].point) - complex(curve.points[k].point)
        assert (chord / complex(ray.point)).imag == pytest.approx(0, abs=1e-15)
        assert complex(curve.points[k + 1].point).real == pytest.approx(curve.edges[k + 1], rel=4 * EPS, abs=0)


def test_a_ray_of_a_derivative_is_parallel_to_its_chord_and_its_point_stands_over_the_middle() -> None:
    curve = diagram()[1]
    for k, point in enumerate(curve.points):
        assert curve.rays[k].step.inputs == (curve.pole, curve.directions[k])
        assert complex(point.point).real == pytest.approx(curve.middles[k], rel=8 * EPS, abs=0)


def test_fifty_digits_agree_and_the_bounds_of_the_record_hold() -> None:
    for points in records():
        bounds, truth = errors(*points), exact(list(points))
        for one in points:
            off = abs(complex(one.point) - complex(truth[one]))
            assert off <= float(bounds[one].place.item()) <= 1e-11


@over("language", ["en", "ru"])
def test_every_step_can_be_told_with_its_reason(language: str) -> None:
    for points in records():
        steps = tuple(behind(*points))
        told = Explanation(message("explain.name", mark="A"), steps, {})
        for step in steps:
            assert step.step.why, step.name
            assert "step." not in sentence(step, told, language)
        assert len({step.name for step in steps}) == len(steps)


def test_a_derivative_is_not_joined_across_a_corner() -> None:
    curve = derivative_by_chords(Board("slopes"), "v", [0, 1, 2, 4], [0, 1, 0, -2], breaks=[1])
    assert curve.values.tolist() == [1, -1, -1]
    assert [curve.values[piece].tolist() for piece in curve.pieces] == [[1], [-1, -1]]


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
