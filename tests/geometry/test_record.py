"""The record of a drawing: replayed from other givens and in 50 digits, followed, and with bounds that hold."""

from __future__ import annotations

import cmath
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given

from geometry.board import Arc, Board, Line, Mark
from geometry.meet import EPS
from geometry.precision import errors
from geometry.replay import exact, redraw
from geometry.tracing import Tracing
from tests.geometry.constructions import Construction, constructions
from tests.parts import examples

MP = mpmath.mp.clone()
MP.dps = 60


def numbers(value: Any) -> tuple[complex, ...]:
    return tuple(complex(x) for x in value) if isinstance(value, tuple) else (complex(value),)


@examples(6)
@given(constructions())
def test_any_record_drawn_again_from_its_own_givens_is_itself(drawn: Construction) -> None:
    again = redraw(drawn.marks, {})
    for mark in drawn.marks:
        assert repr(numbers(again[mark].value)) == repr(numbers(mark.value))


def test_a_given_may_be_exact_where_no_double_is() -> None:
    board = Board("positions")
    o, turn = board.given("O", 0j), board.given("φ", cmath.rect(1, 0.1))
    a = board.divide("A", board.arc("OA", o, 1.0), turn)
    tenth = MP.expj(MP.mpf(1) / 10)
    assert abs(exact([a], givens={turn: tenth})[a] - tenth) < MP.mpf(10) ** -48
    assert abs(exact([a])[a] - tenth) > MP.mpf(10) ** -20


def test_given_lines_and_arcs_are_read_in_fifty_digits() -> None:
    board = Board("positions")
    line, arc = board.given("l", Line(1j, 3 + 4j)), board.given("k", Arc(2 + 0j, 0.5))
    found = exact([line, arc])
    assert (complex(found[line].point), complex(found[line].measure)) == (1j, 3 + 4j)
    assert (complex(found[arc].point), float(found[arc].measure)) == (2 + 0j, 0.5)


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


def notch(gap: float) -> Mark:
    """Two arcs about A and C that touch but for a share of the base."""
    board = Board("positions")
    a, c = board.given("A", 0j), board.given("C", 3.0 * (1 - gap) + 0j)
    return board.meet("B", board.arc("AB", a, 1.0), board.arc("CB", c, 2.0), side=+1)


@examples(20, 300)
@given(constructions())
def test_every_mark_lies_within_its_bound_of_the_exact_construction(drawn: Construction) -> None:
    marks = drawn.marks
    bounds, truth = errors(*marks), exact(marks)
    for mark in marks:
        place, turn = (float(np.max(bound)) for bound in bounds[mark])
        exactly = truth[mark]
        if isinstance(mark.value, Line):
            through, direction = complex(mark.value.through), complex(mark.value.direction)
            assert abs(through - exactly.point) <= place
            sine = (exactly.measure.conjugate() * direction).imag / abs(exactly.measure) / abs(direction)
            assert abs(sine) <= turn * (1 + EPS)
        elif isinstance(mark.value, Arc):
            assert abs(complex(mark.value.centre) - exactly.point) <= place
        elif drawn.sure(mark):
            assert abs(complex(mark.value) - exactly) <= place, mark.name


def test_a_line_square_to_a_short_vector_is_turned_by_its_error_over_its_length() -> None:
    board = Board("positions")
    b = notch(0.1)
    end = board.given("E", complex(b.point) + 1e-6)
    short = board.join("BE", b, end)
    line = board.square("n", end, short)
    bounds = errors(line)
    assert float(bounds[line].turn.item()) == pytest.approx(float(bounds[short].place.item()) / 1e-6, rel=1e-3, abs=0)
