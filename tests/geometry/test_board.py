"""The board: each verb does what a draughtsman means by it, and the record keeps what was constructed."""

from __future__ import annotations

import cmath
from collections.abc import Callable

import numpy as np
import pytest

from geometry.board import CONSTRUCTION, GIVEN, RESULT, Arc, Board, Line, Mark, at, behind, between
from geometry.meet import EPS

FAR = 1e8 + 3e8j  # a frame far from the origin: its last digit is worth 6e-8


def board_with(**points: complex) -> tuple[Board, list[Mark]]:
    board = Board("positions")
    return board, [board.given(name, value) for name, value in points.items()]


# The verbs, on points A = 1 + 1j and C = 4 + 5j, 5 apart, and vectors v = 3 + 1j and w = 2j; turning counter-clockwise
VERBS: dict[str, tuple[Callable[[Board, Mark, Mark, Mark, Mark], Mark], object]] = {
    "the end of a vector is its start plus the vector": (lambda b, a, c, v, w: b.lay_off("x", a, v), 4 + 2j),
    "a vector leads from the first point to the second": (lambda b, a, c, v, w: b.join("x", a, c), 3 + 4j),
    "a parallel runs along the vector": (lambda b, a, c, v, w: b.parallel("x", a, v), Line(1 + 1j, 3 + 1j)),
    "a square line a quarter turn on from it": (lambda b, a, c, v, w: b.square("x", a, v), Line(1 + 1j, -1 + 3j)),
    "an arc is struck about its centre": (lambda b, a, c, v, w: b.arc("x", a, 5.0), Arc(1 + 1j, 5.0)),
    "two arcs meet on the left of their centres": (
        lambda b, a, c, v, w: b.meet("x", b.arc("1", a, 3.0), b.arc("2", c, 4.0), +1),
        1 + 1j + (3 + 4j) / 5 * (1.8 + 2.4j),
    ),
    "or on the right": (
        lambda b, a, c, v, w: b.meet("x", b.arc("1", a, 3.0), b.arc("2", c, 4.0), -1),
        1 + 1j + (3 + 4j) / 5 * (1.8 - 2.4j),
    ),
    "a line and an arc meet ahead of the foot": (
        lambda b, a, c, v, w: b.meet("x", b.parallel("1", a, b.given("e", 1j)), b.arc("2", c, 5.0), +1),
        1 + 9j,
    ),
    "an arc and a line behind it": (
        lambda b, a, c, v, w: b.meet("x", b.arc("2", c, 5.0), b.parallel("1", a, b.given("e", 1j)), -1),
        1 + 1j,
    ),
    "two lines meet on both": (lambda b, a, c, v, w: b.meet("x", b.square("1", a, w), b.parallel("2", c, w)), 4 + 1j),
    "a slot passes the pivot and holds the pin": (lambda b, a, c, v, w: b.tangent("x", a, c, 0.0, +1), (3 + 4j) / 5),
    "the pin is to the left by the offset": (lambda b, a, c, v, w: b.tangent("x", a, c, 3.0, +1), 0.96 + 0.28j),
    "to turn is to stretch too": (lambda b, a, c, v, w: b.turn("x", v, 2j), -2 + 6j),
    "a vector is carried unchanged": (lambda b, a, c, v, w: Board("velocities").transfer("x", v), 3 + 1j),
    "similar to its shape as the image to its vector": (
        lambda b, a, c, v, w: b.similar("x", w, v, a, 2.0),
        -0.8 + 1.6j,
    ),
    "a circle is divided at a direction": (
        lambda b, a, c, v, w: b.divide("x", b.arc("1", c, 2.0), b.given("φ", 1j)),
        4 + 7j,
    ),
    "what closes a chain leads back to its start": (lambda b, a, c, v, w: b.close("x", v, w, v), -6 - 4j),
    "a moment is force by arm": (lambda b, a, c, v, w: b.moment("x", a, c, w), 3 * 2),
    "and negative clockwise": (lambda b, a, c, v, w: b.moment("x", c, a, w), -3 * 2),
    "a couple is of the part square to the arm": (lambda b, a, c, v, w: b.couple("x", w, v, -0.5), -0.5 * -1.5),
    "what balances a moment has the opposite one": (
        lambda b, a, c, v, w: b.balance("x", a, b.parallel("l", c, w), b.moment("M", a, c, w)),
        -2j,
    ),
}


@pytest.mark.parametrize("what", VERBS)
def test_a_verb_does_what_a_draughtsman_means_by_it(what: str) -> None:
    act, expected = VERBS[what]
    board, (a, c, v, w) = board_with(A=1 + 1j, C=4 + 5j, v=3 + 1j, w=2j)
    mark = act(board, a, c, v, w)
    if isinstance(expected, complex | float | int):
        assert complex(mark.point) == pytest.approx(expected, rel=16 * EPS)
    else:
        assert mark.value == expected


def test_an_arc_and_a_line_are_met_in_either_order() -> None:
    board, (a, c, v) = board_with(A=1 + 1j, C=4 + 5j, e=1j)
    line, arc = board.parallel("l", a, v), board.arc("k", c, 5.0)
    turned = board.meet("B", arc, line, +1)
    assert turned.point == board.meet("B", line, arc, +1).point
    assert turned.step.inputs == (line, arc)


def test_similar_with_its_own_image_is_the_normal_acceleration() -> None:
    omega, radius = 3.0, 2 + 1j
    board, (velocity, arm) = board_with(ab=1j * omega * radius, AB=radius)
    assert board.similar("n", velocity, arm, velocity).point == pytest.approx(-(omega**2) * radius, rel=8 * EPS, abs=0)


def test_a_moment_is_told_from_a_vector() -> None:
    board, (o, a, f) = board_with(O=1 + 1j, A=4 + 1j, F=5 + 2j)
    assert board.moment("M", o, a, f).is_moment and not f.is_moment
    assert board.moment("M0", a, a, f).point == 0


# What is kept


def test_far_from_the_origin_vectors_and_rays_are_those_that_were_constructed() -> None:
    board, (o, turn) = board_with(O=FAR, φ=cmath.rect(1, 0.7))
    a = board.divide("A", board.arc("OA", o, 0.1), turn)
    exactly = 0.1 * cmath.rect(1, 0.7)
    assert (board.join("OA", o, a).point, board.join("AO", a, o).point) == (exactly, -exactly)
    assert abs(complex(a.point) - complex(o.point) - exactly) > 1e-9  # the difference of the points lost it
    found = []
    for origin in (0j, FAR):
        board, (a, c) = board_with(A=origin, C=origin + (4 + 1j))
        b = board.meet("B", board.arc("AB", a, 3.0), board.arc("CB", c, 2.0), +1)
        assert [origin for origin, _ in b.rays] == [a, c]
        assert board.join("BA", b, a).point == -between(a, b)
        found.append((between(a, b), between(c, b)))
    assert found[0] == found[1]


def test_points_of_no_common_construction_are_joined_by_their_difference() -> None:
    board, (a, c, v) = board_with(A=1 + 0j, C=5 + 1j, v=1j)
    assert between(a, board.lay_off("D", c, v)) == 4 + 2j


def test_the_record_is_as_long_for_many_positions_as_for_one() -> None:
    lengths = set()
    for count in (1, 10_000):
        board, (o, c) = board_with(O=0j, C=4 + 0j)
        turn = board.given("φ", np.exp(1j * np.linspace(0, 6, count)))
        a = board.divide("A", board.arc("OA", o, 1.0), turn)
        b = board.meet("B", board.arc("AB", a, 4.0), board.arc("CB", c, 3.0), +1)
        lengths.add((len(board), len(behind(b))))
        assert np.shape(b.point) == (count,)
    assert lengths == {(8, 8)}


def test_a_mark_knows_its_role_its_number_and_its_step_and_the_first_of_a_name_keeps_it() -> None:
    board, (v,) = board_with(v=1 + 0j)
    a = board.given("A", 0j, "the hinge")
    marks = [board.arc("AB", a, 1.0), line := board.parallel("l", a, v), board.lay_off("D", a, v)]
    marks.append(board.meet("B", line, marks[0], +1))
    assert [mark.role for mark in (a, *marks)] == [GIVEN, CONSTRUCTION, CONSTRUCTION, RESULT, RESULT]
    assert list(board) == [v, a, *marks] and [mark.number for mark in board] == [*range(6)]
    assert (a.step.op, a.step.inputs, a.step.why) == ("given", (), "the hinge")
    again = board.given("A", 2j)
    assert board["A"] is a is not again
    assert "A" in board and "X" not in board
    assert len({a, again, board.given("A1", 0j)}) == 3 and a != board["A1"]  # marks on one place stay apart


# What a mark rests on


def test_a_chain_of_many_steps_is_followed_to_its_start() -> None:
    board, (end, v) = board_with(A=0j, v=1 + 0j)
    for k in range(5000):
        end = board.lay_off(f"A{k}", end, v)
    assert len(behind(end)) == 5002


def test_a_value_is_read_at_one_position_whether_or_not_it_changes() -> None:
    assert (at(np.array([1, 2j]), 1), at(3 + 1j, 7)) == (2j, 3 + 1j)


# Misuse


@pytest.mark.parametrize(
    ("act", "said"),
    [
        (lambda b, a, v, line: b.join("x", a, line), "guide is a line, not a point or a vector"),
        (lambda b, a, v, line: b.lay_off("x", b.arc("AB", a, 1.0), v), "AB is a arc"),
        (lambda b, a, v, line: b.divide("x", line, v), "guide is not a circle"),
        (lambda b, a, v, line: b.meet("x", b.lay_off("B", a, v), b.lay_off("C", a, v)), "are not two lines or arcs"),
        (lambda b, a, v, line: b.balance("x", a, v, b.moment("M", a, v, v)), "v is no line of action"),
    ],
)
def test_a_verb_on_a_mark_of_another_kind_says_so(act: Callable[..., Mark], said: str) -> None:
    board, (a, v) = board_with(A=0j, v=1 + 0j)
    with pytest.raises(TypeError, match=said):
        act(board, a, v, board.parallel("guide", a, v))


def test_what_is_on_the_board_cannot_be_changed_and_what_is_not_not_asked_for() -> None:
    board, (a,) = board_with(A=0j)
    with pytest.raises(AttributeError):
        a.value = 1j
    with pytest.raises(KeyError):
        board["B"]
