"""The board: each verb does what a draughtsman means by it, and the record keeps what was constructed."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest

from geometry.board import CONSTRUCTION, GIVEN, RESULT, Arc, Board, Line, Mark, at, between
from geometry.meet import EPS, cross, dot
from geometry.steps import behind

FAR = 1e8 + 3e8j  # a frame far from the origin: its last digit is worth 6e-8


def board_with(**points: complex) -> tuple[Board, list[Mark]]:
    board = Board("positions")
    return board, [board.given(name, value) for name, value in points.items()]


# The verbs


def test_given_puts_a_known_mark_on_the_board() -> None:
    board = Board("positions")
    a = board.given("A", 1 + 2j, "the hinge")
    assert a.point == 1 + 2j
    assert (a.step.op, a.step.inputs, a.step.why) == ("given", (), "the hinge")
    assert board["A"] is a
    assert "A" in board
    assert "B" not in board


def test_lay_off_puts_the_end_of_a_vector_at_its_start_plus_the_vector() -> None:
    board, (a, v) = board_with(A=1 + 2j, v=3 - 1j)
    end = board.lay_off("B", a, v)
    assert end.point == 4 + 1j
    assert end.rays == ((a, 3 - 1j),)


def test_join_gives_the_vector_from_the_first_point_to_the_second() -> None:
    board, (a, b) = board_with(A=1 + 2j, B=4 + 1j)
    assert board.join("AB", a, b).point == 3 - 1j
    assert board.join("BA", b, a).point == -3 + 1j


def test_parallel_runs_along_the_vector_and_square_a_quarter_turn_counter_clockwise_from_it() -> None:
    board, (a, v) = board_with(A=1 + 2j, v=3 + 1j)
    along, across = board.parallel("p", a, v).value, board.square("s", a, v).value
    assert along == Line(1 + 2j, 3 + 1j)
    assert across == Line(1 + 2j, -1 + 3j)
    assert cross(3 + 1j, -1 + 3j) > 0


def test_arc_is_struck_about_its_centre() -> None:
    board, (a,) = board_with(A=1 + 2j)
    assert board.arc("AB", a, 5.0).value == Arc(1 + 2j, 5.0)


@pytest.mark.parametrize("side", [+1, -1])
def test_two_arcs_meet_at_both_distances_on_the_chosen_side(side: int) -> None:
    board, (a, c) = board_with(A=1 + 1j, C=5 + 2j)
    b = board.meet("B", board.arc("AB", a, 3.0), board.arc("CB", c, 4.0), side)
    assert abs(b.point - a.point) == pytest.approx(3, rel=8 * EPS, abs=0)
    assert abs(b.point - c.point) == pytest.approx(4, rel=8 * EPS, abs=0)
    assert np.sign(cross(c.point - a.point, b.point - a.point)) == side
    assert [origin for origin, _ in b.rays] == [a, c]


@pytest.mark.parametrize("side", [+1, -1])
def test_a_line_and_an_arc_meet_on_the_line_ahead_of_the_foot_or_behind(side: int) -> None:
    board, (k, u, c) = board_with(K=1 + 1j, u=0.6 + 0.8j, C=5 + 2j)
    line, arc = board.parallel("guide", k, u), board.arc("CB", c, 4.0)
    b = board.meet("B", line, arc, side)
    assert abs(b.point - c.point) == pytest.approx(4, rel=8 * EPS, abs=0)
    assert cross(u.point, b.point - k.point) == pytest.approx(0, abs=16 * EPS)
    assert np.sign(dot(u.point, b.point - c.point)) == side
    turned = board.meet("B'", arc, line, side)
    assert turned.point == b.point
    assert turned.step.inputs == (line, arc)


def test_two_lines_meet_on_both() -> None:
    board, (k, u, m, w) = board_with(K=1 + 1j, u=3 + 4j, M=5 + 2j, w=-1 + 2j)
    p = board.meet("P", board.parallel("l", k, u), board.square("m", m, w))
    assert cross(u.point, p.point - k.point) == pytest.approx(0, abs=64 * EPS)
    assert dot(w.point, p.point - m.point) == pytest.approx(0, abs=64 * EPS)


def test_a_meeting_of_loci_that_miss_is_a_gap_that_says_by_how_much() -> None:
    board, (a, c) = board_with(A=0j, C=10 + 0j)
    b = board.meet("B", board.arc("AB", a, 3.0), board.arc("CB", c, 4.0), +1)
    assert cmath.isnan(b.point)
    assert b.miss == 3
    assert b.sharpness == 0


@pytest.mark.parametrize("side", [+1, -1])
@pytest.mark.parametrize("offset", [0.0, 2.0, -2.0])
def test_a_tangent_passes_the_pivot_at_the_offset_and_holds_the_pin(offset: float, side: int) -> None:
    board, (c, a) = board_with(C=1 + 1j, A=4 + 5j)
    unit = board.tangent("u", c, a, offset, side).point
    assert abs(unit) == pytest.approx(1, abs=4 * EPS)
    assert cross(unit, a.point - c.point) == pytest.approx(offset, abs=32 * EPS)
    assert np.sign(dot(unit, a.point - c.point)) == side


def test_turn_turns_and_stretches() -> None:
    board, (v,) = board_with(v=3 + 1j)
    assert board.turn("w", v, 2j).point == -2 + 6j
    assert list(np.asarray(board.turn("x", v, np.array([1j, -1])).point)) == [-1 + 3j, -3 - 1j]


def test_transfer_carries_a_vector_unchanged_to_another_board() -> None:
    _, (v,) = board_with(v=3 + 1j)
    velocities = Board("velocities")
    carried = velocities.transfer("v", v)
    assert carried.point == v.point
    assert (carried.subject, carried.step.inputs) == ("velocities", (v,))


def test_similar_is_to_its_shape_as_the_image_is_to_its_vector() -> None:
    board, (ab, big_ab, ae) = board_with(ab=-2 + 4j, AB=4 + 2j, AE=1 + 3j)
    image = board.similar("ae", ab, big_ab, ae)
    assert image.point / ae.point == pytest.approx(ab.point / big_ab.point, rel=8 * EPS, abs=0)
    assert board.similar("2ae", ab, big_ab, ae, times=2.0).point == pytest.approx(2 * image.point, rel=8 * EPS, abs=0)


def test_similar_with_its_own_image_is_the_normal_acceleration() -> None:
    omega, radius = 3.0, 2 + 1j
    board, (velocity, arm) = board_with(ab=1j * omega * radius, AB=radius)
    assert board.similar("n", velocity, arm, velocity).point == pytest.approx(-(omega**2) * radius, rel=8 * EPS, abs=0)


def test_divide_gives_the_points_of_a_circle_at_the_directions() -> None:
    board, (o,) = board_with(O=1 + 1j)
    turn = board.given("φ", np.exp(1j * np.radians([0, 90, 225])))
    points = board.divide("A", board.arc("OA", o, 2.0), turn)
    assert list(np.asarray(points.point)) == pytest.approx([3 + 1j, 1 + 3j, (1 - math.sqrt(2)) * (1 + 1j)])
    assert points.rays[0][0] is o


def test_close_leads_from_the_end_of_the_chain_back_to_its_start() -> None:
    board, vectors = board_with(a=3 + 1j, b=-1 + 4j, c=2 - 2j)
    assert board.close("d", *vectors).point == -4 - 3j


def test_a_moment_is_force_by_arm_positive_counter_clockwise() -> None:
    board, (o, a, f) = board_with(O=1 + 1j, A=4 + 1j, F=5 + 2j)
    assert board.moment("M", o, a, f).point == 3 * 2
    assert board.moment("M'", a, o, f).point == -3 * 2
    assert board.moment("M0", a, a, f).point == 0
    assert board.moment("M", o, a, f).is_moment
    assert not f.is_moment


def test_a_couple_is_taken_from_the_part_of_the_turning_vector_square_to_the_arm() -> None:
    board, (ab, turning) = board_with(AB=2j, t=-6 + 5j)  # the part along AB turns nothing
    assert board.couple("M", ab, turning, -0.5).point == -0.5 * 3


def test_the_force_that_balances_moments_lies_along_its_line_and_has_the_opposite_moment() -> None:
    board, (o, a, b, f, u) = board_with(O=0j, A=2 + 1j, B=3 - 1j, F=4 - 3j, u=3 + 4j)
    moments = [board.moment("M", o, a, f), board.couple("M'", u, f, 2.0)]
    found = board.balance("R", o, board.parallel("line", b, u), *moments)
    assert cross(u.point, found.point) == pytest.approx(0, abs=16 * EPS)
    held = board.moment("M''", o, b, found)
    assert held.point + sum(one.point for one in moments) == pytest.approx(0, abs=64 * EPS)


def test_a_line_of_action_through_the_fulcrum_balances_nothing() -> None:
    board, (o, a, f, u) = board_with(O=0j, A=2 + 1j, F=4 - 3j, u=2 + 1j)
    found = board.balance("R", o, board.parallel("line", a, u), board.moment("M", o, a, f))
    assert cmath.isnan(found.point)
    assert found.sharpness == 0
    assert not board.clear


def test_only_along_a_line_can_moments_be_balanced() -> None:
    board, (o, a, f) = board_with(O=0j, A=2 + 1j, F=4 - 3j)
    with pytest.raises(TypeError, match="A is no line of action"):
        board.balance("R", o, a, board.moment("M", o, a, f))


# What is kept


def test_far_from_the_origin_a_joined_vector_is_the_one_that_was_constructed() -> None:
    board, (o, turn) = board_with(O=FAR, φ=cmath.rect(1, 0.7))
    a = board.divide("A", board.arc("OA", o, 0.1), turn)
    exactly = 0.1 * cmath.rect(1, 0.7)
    assert board.join("OA", o, a).point == exactly
    assert board.join("AO", a, o).point == -exactly
    assert abs(complex(a.point) - complex(o.point) - exactly) > 1e-9  # the difference of the points lost it


def test_far_from_the_origin_the_rays_of_a_meeting_are_kept_to_the_last_digits() -> None:
    near, (a, c) = board_with(A=0j, C=4 + 1j)
    b = near.meet("B", near.arc("AB", a, 3.0), near.arc("CB", c, 2.0), +1)
    far, (a1, c1) = board_with(A=FAR, C=FAR + (4 + 1j))
    b1 = far.meet("B", far.arc("AB", a1, 3.0), far.arc("CB", c1, 2.0), +1)
    assert between(a1, b1) == between(a, b)
    assert between(c1, b1) == between(c, b)
    assert far.join("BA", b1, a1).point == -between(a, b)


def test_points_of_no_common_construction_are_joined_by_their_difference() -> None:
    board, (a, c, v) = board_with(A=1 + 0j, C=5 + 1j, v=1j)
    d = board.lay_off("D", c, v)
    assert between(a, d) == 4 + 2j


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


def test_the_role_of_a_mark_is_what_the_line_weight_says() -> None:
    board, (a, v) = board_with(A=0j, v=1 + 0j)
    arc, line = board.arc("AB", a, 1.0), board.parallel("l", a, v)
    roles = [mark.role for mark in (a, arc, line, board.meet("B", line, arc, +1), board.lay_off("D", a, v))]
    assert roles == [GIVEN, CONSTRUCTION, CONSTRUCTION, RESULT, RESULT]


def test_marks_stand_in_the_order_in_which_they_were_drawn() -> None:
    board, (a, v) = board_with(A=0j, v=1 + 0j)
    end = board.lay_off("B", a, v)
    assert list(board) == [a, v, end]
    assert [mark.number for mark in board] == [0, 1, 2]


def test_the_first_mark_of_a_name_keeps_it() -> None:
    board = Board("positions")
    first, second = board.given("A", 1j), board.given("A", 2j)
    assert board["A"] is first
    assert list(board) == [first, second]


def test_two_marks_on_one_place_stay_two() -> None:
    _, (a, b) = board_with(A=1j, B=1j)
    assert a != b
    assert len({a, b}) == 2
    assert a == a  # noqa: PLR0124  (a mark is itself)


# What a mark rests on


def test_behind_a_mark_stand_all_it_rests_on_each_once_and_before_its_use() -> None:
    board, (a, c, unused) = board_with(A=0j, C=4 + 0j, X=9j)
    on_2, on_3 = board.arc("AB", a, 3.0), board.arc("CB", c, 3.0)
    b = board.meet("B", on_2, on_3, +1)
    board.join("AX", a, unused)
    ab, cb = board.join("AB", a, b), board.join("CB", c, b)
    velocities = Board("velocities")
    carried = velocities.transfer("AB", ab)
    order = behind(carried, cb)
    assert set(order) == {a, c, on_2, on_3, b, ab, cb, carried}
    assert len(order) == 8
    for mark in order:
        assert all(order.index(source) < order.index(mark) for source in mark.step.inputs)


def test_a_chain_of_many_steps_is_followed_to_its_start() -> None:
    board, (end, v) = board_with(A=0j, v=1 + 0j)
    for k in range(5000):
        end = board.lay_off(f"A{k}", end, v)
    assert len(behind(end)) == 5002


def test_a_value_is_read_at_one_position_whether_or_not_it_changes() -> None:
    assert at(np.array([1, 2j]), 1) == 2j
    assert at(3 + 1j, 7) == 3 + 1j
    assert at(0.5, 0) == 0.5


# Misuse


def test_a_line_has_no_point_and_says_so() -> None:
    board, (a, v) = board_with(A=0j, v=1 + 0j)
    line = board.parallel("guide", a, v)
    with pytest.raises(TypeError, match="guide is a line, not a point or a vector"):
        board.join("x", a, line)
    with pytest.raises(TypeError, match="AB is a arc"):
        board.lay_off("x", board.arc("AB", a, 1.0), v)


def test_only_a_circle_can_be_divided() -> None:
    board, (a, v) = board_with(A=0j, v=1 + 0j)
    with pytest.raises(TypeError, match="l is not a circle"):
        board.divide("x", board.parallel("l", a, v), v)


def test_points_do_not_meet() -> None:
    board, (a, v) = board_with(A=0j, v=1 + 0j)
    with pytest.raises(TypeError, match="are not two lines or arcs"):
        board.meet("x", board.lay_off("B", a, v), board.lay_off("C", a, v))


def test_a_name_that_was_never_drawn_is_not_on_the_board() -> None:
    with pytest.raises(KeyError):
        Board("positions")["B"]


def test_what_is_on_the_board_cannot_be_changed() -> None:
    _, (a,) = board_with(A=0j)
    with pytest.raises(AttributeError):
        a.value = 1j
