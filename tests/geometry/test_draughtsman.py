"""The draughtsman: what a hand that slips makes of a record, by what is known of chance."""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest

from geometry import precision
from geometry.board import Board, Mark
from geometry.hand_error import EDGE
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
