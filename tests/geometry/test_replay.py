"""Replay: a record drawn again from other givens is the new drawing, and in 50 digits the true one."""

from __future__ import annotations

import cmath
from collections.abc import Callable
from typing import Any

import mpmath
from hypothesis import given

from geometry.board import Arc, Board, Line, Mark
from geometry.meet import EPS
from geometry.replay import exact, redraw
from tests.geometry.constructions import Construction, constructions
from tests.parts import examples
from tests.rows import over

MP = mpmath.mp.clone()
MP.dps = 60

Act = Callable[[Board, list[Mark]], Mark]
GIVENS = (1 + 2j, 4 + 1j, 0.6 + 0.8j, 2 - 1j)
MOVED = (1.5 + 1j, 4.5 + 1.2j, 0.8 - 0.6j, -1 + 3j)

# Each verb on the givens A, C (points), e (of size 1) and v.
ACTS: dict[str, Act] = {
    "given": lambda _, m: m[0],
    "lay_off": lambda b, m: b.lay_off("x", m[0], m[3]),
    "join": lambda b, m: b.join("x", m[0], m[1]),
    "parallel": lambda b, m: b.parallel("x", m[0], m[3]),
    "square": lambda b, m: b.square("x", m[0], m[3]),
    "arc": lambda b, m: b.arc("x", m[1], 2.5),
    "meet of arcs": lambda b, m: b.meet("x", b.arc("1", m[0], 2.5), b.arc("2", m[1], 3.0), -1),
    "meet of a line and an arc": lambda b, m: b.meet("x", b.square("1", m[0], m[2]), b.arc("2", m[1], 6.0), +1),
    "meet of lines": lambda b, m: b.meet("x", b.parallel("1", m[0], m[3]), b.square("2", m[1], m[2])),
    "tangent": lambda b, m: b.tangent("x", m[0], m[1], -0.7, -1),
    "turn": lambda b, m: b.turn("x", m[3], 2 - 3j),
    "transfer": lambda b, m: Board("velocities").transfer("x", m[3]),
    "similar": lambda b, m: b.similar("x", m[3], m[2], m[1], 2.0),
    "divide": lambda b, m: b.divide("x", b.arc("1", m[1], 2.5), m[2]),
    "close": lambda b, m: b.close("x", m[0], m[1], m[3]),
    "moment": lambda b, m: b.moment("x", m[0], m[1], m[3]),
    "couple": lambda b, m: b.couple("x", m[1], m[3], -2.5),
    "balance": lambda b, m: b.balance("x", m[0], b.square("1", m[1], m[2]), b.moment("2", m[0], m[1], m[3])),
}


def draw(act: Act, values: tuple[complex, ...]) -> tuple[list[Mark], Mark]:
    board = Board("positions")
    marks = [board.given(name, value) for name, value in zip(("A", "C", "e", "v"), values, strict=True)]
    return marks, act(board, marks)


def numbers(value: Any) -> tuple[complex, ...]:
    return tuple(complex(x) for x in value) if isinstance(value, tuple) else (complex(value),)


@over("verb", ACTS)
def test_a_record_drawn_again_from_other_givens_is_the_new_drawing(verb: str) -> None:
    givens, old = draw(ACTS[verb], GIVENS)
    _, new = draw(ACTS[verb], MOVED)
    again = redraw([old], dict(zip(givens, MOVED, strict=True)))[old]
    assert numbers(again.value) == numbers(new.value)
    assert numbers(again.value) != numbers(old.value)
    assert (again.name, again.step.op, again.step.side, again.step.why) == (new.name, new.step.op, *new.step[3:])
    assert again.subject == old.subject


@over("verb", ACTS)
@over("values", [GIVENS, MOVED])
def test_fifty_digits_agree_with_each_verb(verb: str, values: tuple[complex, ...]) -> None:
    _, mark = draw(ACTS[verb], values)
    found = exact([mark])[mark]
    truth = (found.point, found.measure) if isinstance(mark.value, Line | Arc) else (found,)
    for ours, exactly in zip(numbers(mark.value), truth, strict=True):
        assert abs(ours - complex(exactly)) <= 64 * EPS * max(1.0, abs(ours))


@examples(6)
@given(constructions())
def test_any_record_drawn_again_from_its_own_givens_is_itself(drawn: Construction) -> None:
    again = redraw(drawn.marks, {})
    for mark in drawn.marks:
        assert repr(numbers(again[mark].value)) == repr(numbers(mark.value))


def test_fifty_digits_are_fifty() -> None:
    board = Board("positions")
    a, c = board.given("A", 0j), board.given("C", 1 + 0j)
    b = board.meet("B", board.arc("AB", a, 1.0), board.arc("CB", c, 1.0), +1)
    assert abs(exact([b])[b] - MP.mpc(MP.mpf("0.5"), MP.sqrt(3) / 2)) < MP.mpf(10) ** -48


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
