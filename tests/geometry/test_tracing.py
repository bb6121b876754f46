"""A record that is followed: the same words, and the numbers that drawing it again would give."""

from __future__ import annotations

import numpy as np
import pytest

from geometry.board import Board
from geometry.tracing import Tracing


def test_what_does_not_hang_on_the_free_mark_is_worked_out_once() -> None:
    board = Board("positions")
    a, c, phi = board.given("A", 0j), board.given("C", 5 + 0j), board.given("φ", 1j)
    b = board.meet("B", board.arc("AB", a, 3.0), board.arc("CB", c, 4.0), side=+1)
    end = board.lay_off("D", b, phi)
    tracing = Tracing(board, phi)
    assert tracing.acts.fixed(tracing.place(b)) == pytest.approx(1.8 + 2.4j)
    assert tracing.acts.fixed(tracing.place(end)) is None
    numbers = tracing.follow(np.array([0j, 1 + 1j]))
    assert list(numbers[tracing.place(end)]) == pytest.approx([1.8 + 2.4j, 2.8 + 3.4j])


def test_a_gap_leaves_a_record_in_doubt() -> None:
    board = Board("positions")
    a, c = board.given("A", 0j), board.given("C", 5 + 0j)
    board.meet("B", board.arc("AB", a, 3.0), board.arc("CB", c, 4.0), side=+1)
    tracing = Tracing(board, c)
    assert board.clear
    assert tracing.clear(tracing.follow(np.array([5j, 6j])))
    assert not tracing.clear(tracing.follow(np.array([5j, 8j])))
    board.meet("D", board.arc("AD", a, 1.0), board.arc("CD", c, 2.0), side=+1)
    assert not board.clear
