"""Diagrams of a law by graphical calculus: worked values of M2.3 and M2.4, order, true means, closure, the record."""

from __future__ import annotations

import math

import numpy as np
import pytest

from plans.bench.trial import order
from plans.cam.diagrams import law_diagrams, strips_of
from plans.model.cam import DWELL, RETURN, RISE, SHAPE, TABLE, Cam, Law
from tests.parts import some
from tests.plans.digits import printed
from tests.plans.law_cams import BLOCKS, EVERY, LIFT, LINES, RISING, RULER, STEADY, law_cam, usual


def alone(law: Law, divisions: int = 8) -> Cam:
    return law_cam((RISE, 120, law), (DWELL, 240, None), divisions=divisions)


def titled(law: Law) -> str:
    return f"{law.name}-{law.through}-{law.first}-{law.tolerance}"


def test_worked_integration() -> None:
    """M2.3: cosine law, h = 0.03 m, 120 degrees in 8 parts: S' at mid-phase, its error, its closure."""
    found = law_diagrams(alone(Law("cosine")))
    middle = float(found.slope[1][3])
    assert printed(middle, middle / 0.0225 - 1) == (0.02264522721, 0.0064545428)
    assert middle / 0.0225 - 1 == pytest.approx(math.pi / 16 / math.sin(math.pi / 16) - 1, rel=1e-12)
    assert found.slope[1][7] == pytest.approx(0, abs=1e-16) and found.closure[0] == pytest.approx(0, abs=1e-16)
    assert found.slope_departure.share == pytest.approx(0.0064545428, rel=1e-9) and found.slope_departure.at == 3


@pytest.mark.parametrize("name", ["sine", "3-4-5", "4-5-6-7", "modified sine", "cosine"])
def test_three_ordinates_close_by_far_better(name: str) -> None:
    """Simpson's mean: of the fourth order, so that the diagrams close to the eye where mid ordinates leave a step."""
    counts = (16, 64)
    found = [law_diagrams(usual(Law(name), Law("sine"), divisions=count), means="three") for count in counts]
    for pair in ([one.slope_departure.share for one in found], [one.travel_departure.share for one in found]):
        assert order(pair, counts) == pytest.approx(4.0, abs=0.2)
    few = [law_diagrams(usual(Law(name), STEADY), means=way) for way in ("middle", "three")]
    assert max(map(abs, few[1].closure)) < 0.002 * LIFT and few[1].travel_departure.share < 0.005


@pytest.mark.parametrize("law", some(EVERY, 3), ids=titled)
def test_true_mean_ordinates_are_exact(law: Law) -> None:
    found = law_diagrams(usual(law), means="true")
    assert found.slope_departure.share <= 1e-13 and found.travel_departure.share <= 1e-13
    assert np.abs(found.closure).max() <= 1e-14


@pytest.mark.parametrize("law", [STEADY, Law("constant acceleration"), Law("constant velocity"), LINES], ids=titled)
def test_straight_pieces_are_exact_by_mid_ordinates(law: Law) -> None:
    """S'' is constant, and S' straight, in every strip: an edge stands on every jump."""
    found = law_diagrams(usual(law, divisions=7))
    assert found.slope_departure.share <= 1e-14 and found.travel_departure.share <= 1e-14


@pytest.mark.parametrize("law", [RULER, BLOCKS], ids=titled)
def test_of_a_law_by_points_the_true_means_are_drawn(law: Law) -> None:
    """Between its points S'' is straight: S' comes back to nothing, the dwells stay level."""
    assert law.name in (TABLE, SHAPE)
    found = law_diagrams(usual(law))
    assert found.slope_departure.share <= 1e-14
    assert found.travel.values[-1] == pytest.approx(found.travel.values[-2], abs=1e-16)


def test_edges_between_positions_have_primes_and_the_end_is_position_0() -> None:
    names = strips_of(law_cam((RISE, 120, STEADY), (RETURN, 240, Law("sine")), divisions=4)).names
    assert names == ("0", "1", "1'", "2", "3", "4", "5", "6", "7", "0")


def test_past_a_hard_shock_the_velocity_begins_anew() -> None:
    found = law_diagrams(usual(Law("constant velocity"), Law("sine")))
    assert found.strips.hard == (0, 8, 18) and [one.start for one in found.runs] == [0, 8]
    assert found.slopes[0].values == pytest.approx(np.full(9, LIFT / RISING))
    assert found.slopes[1].values[0] == 0.0
    assert len(law_diagrams(usual(Law("sine"))).slopes) == 1


@pytest.mark.parametrize("name", ["sine", "3-4-5", "4-5-6-7", "modified sine"])
def test_mid_ordinates_are_of_the_second_order(name: str) -> None:
    counts = (16, 64)
    found = [law_diagrams(usual(Law(name), divisions=count)) for count in counts]
    for pair in ([one.slope_departure.share for one in found], [one.travel_departure.share for one in found]):
        assert order(pair, counts) == pytest.approx(2.0, abs=0.1)
