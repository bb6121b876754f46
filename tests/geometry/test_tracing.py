"""A record that is followed: the same words, and the numbers that drawing it again would give."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from geometry.board import Board, Mark
from geometry.precision import errors
from geometry.replay import redraw
from geometry.tracing import Tracing
from tests.geometry.constructions import Construction, constructions
from tests.parts import examples


def words(mark: Mark) -> tuple[object, ...]:
    step = mark.step
    return mark.subject, mark.number, mark.name, step.op, [source.name for source in step.inputs], step.why


@examples(10, 150)
@given(constructions(), st.floats(-0.01, 0.01))
def test_a_record_that_is_followed_is_the_one_that_is_drawn_again(drawn: Construction, moved: float) -> None:
    free = drawn.board["A"]
    for place in (complex(free.point), complex(free.point) + moved):
        tracing = Tracing(drawn.marks, free)
        _, followed = tracing.boards(tracing.follow(place))
        again = redraw(drawn.marks, {free: place})
        bounds = errors(*again.values())
        for mark in drawn.marks:
            one, other = followed[mark], again[mark]
            assert words(one) == words(mark)
            assert [origin for origin, _ in one.rays] == [followed[origin] for origin, _ in mark.rays]
            if not isinstance(one.value, tuple):
                bound = 2 * bounds[other].place.max()
                assert complex(one.point) == pytest.approx(complex(other.point), abs=bound, rel=0, nan_ok=True)


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


def test_what_is_drawn_over_a_record_is_followed_on_from_its_numbers() -> None:
    board, over = Board("positions"), Board("forces")
    o, phi = board.given("O", 0j), board.given("φ", 1j)
    a = board.lay_off("A", o, phi)
    below = Tracing(board, phi)
    force, weight = over.given("F", 0j), over.given("G", -2j)
    moment = over.moment("M", o, a, over.lay_off("sum", force, weight))
    above = below.over([*board, *over], [force])
    turn, loads = np.array([1j, 1 + 0j]), np.array([3 + 0j, 5j])
    numbers = below.follow(turn)
    followed = above.follow_on(numbers, {force: loads})
    assert list(followed[above.place(moment)]) == [-3.0, 3.0]
    assert len(numbers) < len(followed)  # the row below is as it was
    assert list(below.follow(turn)[below.place(a)]) == list(turn)
    _, made = above.boards(followed)
    assert list(made[moment].point) == [-3.0, 3.0]
