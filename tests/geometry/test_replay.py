"""Replay: a record drawn again from other givens is the new drawing, and in 50 digits the true one."""

from __future__ import annotations

import cmath
from typing import Any

import mpmath
from hypothesis import given

from geometry.board import Arc, Board, Line
from geometry.replay import exact, redraw
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
