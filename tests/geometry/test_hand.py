"""A hand that slips: what it makes of a record, and what it may be out by."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest

from geometry import hand_error, precision
from geometry.board import Board, Mark
from geometry.hand_error import EDGE, EVEN, POINT, SlippingHand, number_error, size_error, slopes
from tests import draughtsman
from tests.draughtsman import Draughtsman, copies

MU = 0.002  # m a mm


def pin() -> tuple[Mark, Mark]:
    """Draw a crank OA that is carried off the board: its pin, and where its end lies from the datum."""
    board = Board("positions")
    start, way = board.given("O", 0j), board.given("φ", np.exp(0.5j) * np.ones(1))
    return board.divide("A", board.arc("OA", start, 0.1), way), start


def hand(slip: float, drawings: int = 4000) -> Draughtsman:
    return Draughtsman(slip, {"positions": np.full(1, MU)}, drawings)


def test_a_hand_that_does_not_slip_draws_the_construction() -> None:
    mark, _ = pin()
    assert copies(hand(0.0, 1), mark)[mark][0] == pytest.approx(np.asarray(mark.point), abs=1e-16)


def test_the_crank_pin_is_out_by_the_compass_and_by_the_prick() -> None:
    """Evenly within the slip along the crank, in x and in y: a third of its square each, together a whole one."""
    mark, start = pin()
    drawn = copies(hand(0.2), mark)
    off = np.abs(drawn[mark] - mark.point) / MU
    assert off.max() <= 0.2 * (1 + sqrt(2))
    assert sqrt(np.mean(off**2)) == pytest.approx(0.2, rel=0.02)
    assert np.all(drawn[start] == 0)  # the datum is where the sheet begins


def test_a_hand_is_the_same_hand_again() -> None:
    mark, _ = pin()
    assert np.array_equal(copies(hand(0.1), mark)[mark], copies(hand(0.1), mark)[mark])


def test_a_notch_that_misses_is_no_number_and_loses_no_other_drawing() -> None:
    """Just within reach: some hands' arcs miss each other."""
    board = Board("positions")
    arcs = (board.arc(name, board.given(name, at), 0.1) for name, at in (("O", 0j), ("C", 0.1999 + 0j)))
    meeting = board.meet("B", *arcs, side=1.0)
    missed = np.isnan(copies(hand(0.5), meeting)[meeting])
    assert 0 < missed.sum() < missed.size


def test_a_vector_longer_than_the_set_square_is_carried_worse() -> None:
    vectors = np.array([0.5 * EDGE, 3j * EDGE]) * MU
    off = np.abs(Draughtsman(0.2, {"positions": np.full(2, MU)}, 2000).carried("positions", vectors)) / MU
    assert off[:, 0].max() == pytest.approx(0.2 * sqrt(2), rel=0.05)
    assert off[:, 1].max() == pytest.approx(3 * 0.2 * sqrt(2), rel=0.05)


def test_the_hand_knows_every_verb_that_precision_knows() -> None:
    assert set(draughtsman._RULES) | {"given"} == set(precision._RULES)


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


def test_a_square_meeting_adds_both_lines_and_its_prick() -> None:
    """Two lines ruled square to each other: each pushes the meeting along the other, and the prick is its own."""
    board = Board("positions")
    start = board.given("P", 0j)  # a datum is where it is
    lines = [board.parallel(name, start, board.given(name, way)) for name, way in (("x", 40 + 0j), ("y", 40j))]
    assert deviation(board.meet("M", *lines)) == pytest.approx(SLIP * np.sqrt(2 + 2))
