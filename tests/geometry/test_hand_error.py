"""What a hand may be out: slopes of single acts by plain geometry, and how chance adds them."""

from __future__ import annotations

import numpy as np
import pytest

from geometry import draughtsman, hand_error, precision
from geometry.board import Board, Mark
from geometry.hand_error import EDGE, EVEN, SlippingHand, slopes
from geometry.scatter import POINT, number_error, size_error

HAND = SlippingHand(0.2, {"positions": np.ones(1), "velocities": np.full(1, 0.5)})
SLIP = 0.2 * EVEN


def deviation(mark: Mark, hand: SlippingHand = HAND) -> float:
    """Give the root of the mean square of a mark's error."""
    return float(np.sqrt((np.abs(slopes(hand, mark)[mark]) ** 2).sum()))


def test_every_verb_that_rounds_slips_or_is_reckoned() -> None:
    assert set(hand_error._RULES) | {"given"} == set(precision._RULES)


def test_a_square_meeting_adds_both_lines_and_its_prick() -> None:
    """Two lines ruled square to each other: each pushes the meeting along the other, and the prick is its own."""
    board = Board("positions")
    start = board.given("P", 0j)  # a datum is where it is
    lines = [board.parallel(name, start, board.given(name, way)) for name, way in (("x", 40 + 0j), ("y", 40j))]
    assert deviation(board.meet("M", *lines)) == pytest.approx(SLIP * np.sqrt(2 + 2))


def test_a_sharp_meeting_magnifies_along_its_lines() -> None:
    """At 30 degrees each line's push is twice as long along the other."""
    board = Board("positions")
    start = board.given("P", 0j)
    ways = board.given("x", 40 + 0j), board.given("y", 40 * np.exp(1j * np.pi / 6))
    lines = [board.parallel(way.name, start, way) for way in ways]
    assert deviation(board.meet("M", *lines)) == pytest.approx(SLIP * np.sqrt(4 + 4 + 2))


def test_arcs_that_barely_meet_tell_nothing() -> None:
    board = Board("positions")
    a, c = board.given("A", 0j), board.given("C", 100 + 0j)
    b = board.meet("B", board.arc("AB", a, 50.0), board.arc("CB", c, 50.001), side=+1)
    assert np.isnan(slopes(HAND, b)[b]).all()


def test_one_slip_that_comes_by_two_ways_is_added_as_it_is() -> None:
    """A vector laid off and taken back by what stands on the same prick: the prick is not in their difference."""
    board = Board("positions")
    vector = board.given("v", 30 + 0j)
    b = board.lay_off("B", board.given("A", 0j), vector)
    c = board.lay_off("C", b, vector)
    assert deviation(board.join("BC", b, c)) == pytest.approx(SLIP * np.sqrt(2))
    assert deviation(board.join("AC", board["A"], c)) == pytest.approx(SLIP * 2)


def test_of_nothing_laid_off_each_slip_tried_says_the_same() -> None:
    """Two points pricked at one place differ by their pricks; what joins them is nothing, and is not laid off."""
    board = Board("positions")
    nothing = board.join("AB", board.given("A", 30 + 0j), board.given("B", 30 + 0j))
    end = board.lay_off("D", board.lay_off("C", board["A"], nothing), board.given("v", 40j))
    tried, ruled = (road(HAND, end)[end] for road in (draughtsman.slopes, slopes))
    assert np.abs(tried).sum() == pytest.approx(np.abs(ruled).sum(), rel=1e-6)


def test_a_plan_without_a_scale_is_known() -> None:
    other = Board("forces")
    end = other.lay_off("B", other.given("A", 0j), other.given("v", 30 + 0j))
    assert deviation(end) == 0.0


@pytest.mark.parametrize(("length", "times"), [(0.3 * EDGE, 1.0), (3 * EDGE, 3.0)])
def test_a_carried_vector_slips_on_the_plan_that_it_is_taken_from(length: float, times: float) -> None:
    """Of one longer than the set square's edge the angle is out, not the end alone."""
    base, above = Board("positions"), Board("velocities")
    end = base.lay_off("B", base.given("A", 0j), base.given("v", length + 0j))
    own = 2 * SLIP**2  # of the end itself
    assert deviation(above.transfer("v", base.join("AB", base["A"], end))) == pytest.approx(
        np.sqrt(own + 2 * (times * SLIP) ** 2)
    )


def test_a_number_of_many_slips_is_out_by_two_deviations() -> None:
    slips = np.full((40, 1), 0.1 + 0j)
    assert number_error(slips)[0] == pytest.approx(POINT * 0.1 * np.sqrt(40), rel=0.02)


def test_a_number_of_one_slip_is_never_out_by_more_than_it() -> None:
    """Evenly within its bounds: 95 per cent lie within 95 per cent of them."""
    assert number_error(np.array([[EVEN + 0j]]))[0] == pytest.approx(0.95, rel=0.01)


def test_a_long_vector_is_out_along_itself_and_one_of_nothing_by_its_place() -> None:
    slips = np.concatenate([np.full((30, 1), 0.1 + 0j), np.full((30, 1), 0.3j)])
    along, across = POINT * 0.1 * np.sqrt(30), POINT * 0.3 * np.sqrt(30)
    assert size_error(np.array([1e4 + 0j]), slips)[0] == pytest.approx(along, rel=0.03)
    assert size_error(np.array([1e4j]), slips)[0] == pytest.approx(across, rel=0.03)
    # Of a round cloud 95 per cent lie within the root of -2 ln 0.05, 2.448 deviations.
    assert size_error(np.array([0j]), np.concatenate([slips[:30], 1j * slips[:30]]))[0] == pytest.approx(
        2.4477 * 0.1 * np.sqrt(30), rel=0.03
    )
