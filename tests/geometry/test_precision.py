"""Precision: the bounds carried from step to step hold the true errors, and are not idle."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given

from geometry.board import Arc, Board, Line, Mark
from geometry.meet import EPS
from geometry.precision import errors
from geometry.replay import exact
from tests.geometry.constructions import Construction, constructions
from tests.parts import examples


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
