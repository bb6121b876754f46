"""What a hand may be out: slopes of single acts by plain geometry, and how chance adds them."""

from __future__ import annotations

import numpy as np
import pytest

from geometry import hand_error, precision
from geometry.board import Board, Mark
from geometry.hand_error import EDGE, EVEN, POINT, SlippingHand, number_error, size_error, slopes

HAND = SlippingHand(0.2, {"positions": np.ones(1), "velocities": np.full(1, 0.5)})
SLIP = 0.2 * EVEN


def deviation(mark: Mark, hand: SlippingHand = HAND) -> float:
    """Give the root of the mean square of a mark's error."""
    return float(np.sqrt((np.abs(slopes(hand, mark)[mark]) ** 2).sum()))


def test_every_verb_that_rounds_slips_or_is_reckoned() -> None:
    assert set(hand_error._RULES) | {"given"} == set(precision._RULES)


def test_one_slip_that_comes_by_two_ways_is_added_as_it_is() -> None:
    """A vector laid off and taken back by what stands on the same prick: the prick is not in their difference."""
    board = Board("positions")
    vector = board.given("v", 30 + 0j)
    b = board.lay_off("B", board.given("A", 0j), vector)
    c = board.lay_off("C", b, vector)
    assert deviation(board.join("BC", b, c)) == pytest.approx(SLIP * np.sqrt(2))
    assert deviation(board.join("AC", board["A"], c)) == pytest.approx(SLIP * 2)


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


def test_a_couple_is_out_by_its_arm_and_by_what_turns_it() -> None:
    """M = 6 T/L of a link of 30 mm whose end goes 12 mm square to it: dM = 6 (dT/L - T dL/L^2)."""
    board = Board("positions")
    arm = board.join("AB", board.given("A", 2 + 1j), board.given("B", 32 + 1j))
    turning = board.join("ab", board.given("a", 1 + 1j), board.given("b", 1 + 13j))
    assert deviation(board.couple("M", arm, turning, 6.0)) == pytest.approx(
        6 * SLIP * np.sqrt(2 / 30**2 + 2 * 12**2 / 30**4)
    )
